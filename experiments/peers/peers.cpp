#include "experiments/peers/peers.h"

#include "experiments/peers/peer.h"
#include "experiments/peers/peer_process.h"
#include "experiments/peers/peer_wire.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace tetracone::experiments {
namespace {

using verify::Object_case;
using verify::Outcome;

/// Of a body. Nothing but time speaks against more: FCL and CGAL take some 6 us a triangle to make it ready, anew for
/// each case, which for a mesh of 10^5 is more than for all others of its family together.
constexpr std::size_t most_faces = 30000;

/// A peer at work in a child process.
class Running_peer : public verify::Running_subject {
 public:
  Running_peer(std::string program, std::string name, bool solids_only, std::chrono::milliseconds limit)
      : program_(std::move(program)), name_(std::move(name)), solids_only_(solids_only), limit_(limit)
  {}

  Outcome operator()(const Object_case& c, kernel::Question question) override
  {
    if (solids_only_ && question == kernel::Question::surface) return Outcome::not_asked;
    if (!is_rigid(c.pose_a) || !is_rigid(c.pose_b)) return Outcome::not_asked;
    if (c.a->face_count() > most_faces || c.b->face_count() > most_faces) return Outcome::not_asked;
    if (!process_) {
      process_ = std::make_unique<Peer_process>(program_, name_);
      a_ = b_ = nullptr;
    }
    message_.clear();
    if (c.a != a_ || c.b != b_) {
      a_ = c.a;
      b_ = c.b;
      wire::append(message_, wire::Message::models);
      wire::append(message_, *a_);
      wire::append(message_, *b_);
    }
    wire::append(message_, wire::Message::question);
    wire::append(message_, wire::Asked{question, c.pose_a.entries(), c.pose_b.entries()});
    const auto answer = process_->ask(message_, std::chrono::steady_clock::now() + limit_);
    if (!answer) process_.reset();
    switch (static_cast<wire::Answer>(answer.value_or(static_cast<char>(wire::Answer::failed)))) {
      case wire::Answer::no: return Outcome::no;
      case wire::Answer::yes: return Outcome::yes;
      case wire::Answer::not_taken: return Outcome::not_asked;
      default: return Outcome::failed;
    }
  }

 private:
  std::string program_, name_;
  bool solids_only_;
  std::chrono::milliseconds limit_;
  std::unique_ptr<Peer_process> process_;
  std::shared_ptr<const covering::Polyhedron> a_, b_;  // what the process has
  std::string message_;
};

verify::Object_subject subject(const std::string& program, const std::string& name, const std::string& note,
                               bool solids_only, std::chrono::milliseconds limit)
{
  return {name, false, note, std::nullopt,
          [=] { return std::make_unique<Running_peer>(program, name, solids_only, limit); }};
}

}  // namespace

verify::Object_subject peer_subject(const std::string& program, const std::string& name,
                                    std::chrono::milliseconds limit)
{
  for (const Peer& peer : peers())
    if (peer.name == name) return subject(program, name, peer.note, peer.solids_only, limit);
  return subject(program, name, "", false, limit);  // for the worker to know
}

std::vector<verify::Object_subject> peer_subjects(const std::string& program)
{
  std::vector<verify::Object_subject> subjects;
  for (const Peer& peer : peers()) subjects.push_back(peer_subject(program, peer.name));
  return subjects;
}

}  // namespace tetracone::experiments
