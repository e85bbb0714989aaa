#include "experiments/peers/peers.h"

#include "experiments/peers/command_process.h"
#include "experiments/peers/fcl.h"
#include "experiments/peers/peer_wire.h"

#include <cerrno>
#include <cstring>

namespace tetracone::experiments {
namespace {

using verify::Object_case;
using verify::Outcome;

/// The largest number of faces of a body that peers are asked about. The limit is only for time: FCL and CGAL need some
/// 6 us per triangle to prepare a body, anew for each case. For a mesh of 10^5 triangles that exceeds the time of all
/// other cases of its family together.
constexpr std::size_t most_faces = 30000;

using Deadline = Command_process::Deadline;

/// Starts `program peer-worker NAME`. Throws std::runtime_error when it cannot be started, or does not report within
/// half a minute that it is ready.
std::unique_ptr<Command_process> started(const std::string& program, const std::string& name)
{
  const auto refuse = [&](const std::string& why) -> void {
    throw std::runtime_error("the peer '" + name + "' cannot be started as '" + program + " peer-worker': " + why);
  };
  if (::access(program.c_str(), X_OK) != 0) refuse(std::strerror(errno));
  auto process = std::make_unique<Command_process>(std::vector<std::string>{program, "peer-worker", name});
  const std::string ready(1, static_cast<char>(wire::Answer::ready));
  if (process->bytes(1, std::chrono::steady_clock::now() + std::chrono::seconds(30)) != ready)
    refuse("it is not ready");
  return process;
}

std::optional<double> take_double(Command_process& process, Deadline deadline)
{
  const auto bytes = process.bytes(sizeof(double), deadline);
  if (!bytes) return std::nullopt;
  double value;
  std::memcpy(&value, bytes->data(), sizeof value);
  return value;
}

/// Asks, and takes what answers: the byte, and after `yes` and `no` the times. Without an answer by the deadline the
/// process is ended, and `failure` says how.
wire::Answer take_answer(std::unique_ptr<Command_process>& process, const std::string& message, Deadline deadline,
                         std::optional<verify::Spent>& spent, verify::Failure& failure)
{
  const auto byte = process->send(message, deadline) ? process->bytes(1, deadline) : std::nullopt;
  const auto answer = byte ? static_cast<wire::Answer>(byte->front()) : wire::Answer::failed;
  bool is_whole = byte.has_value();
  if (answer == wire::Answer::yes || answer == wire::Answer::no) {
    const auto making = take_double(*process, deadline);
    const auto asking = making ? take_double(*process, deadline) : std::nullopt;
    is_whole = asking.has_value();
    if (is_whole) spent = verify::Spent{std::uint64_t(*making), std::uint64_t(*asking)};
  }
  if (is_whole) {
    failure = {"exception", ""};
    return answer;
  }
  const auto status = process->end(std::chrono::steady_clock::now() + std::chrono::milliseconds(200));
  failure = {status ? end_in_words(*status) : "silent", process->last_error()};
  process.reset();
  return wire::Answer::failed;
}

/// A peer at work in a child process.
class Running_peer : public verify::Running_subject {
 public:
  Running_peer(std::string program, std::string name, verify::Knows knows, std::chrono::milliseconds limit)
      : program_(std::move(program)), name_(std::move(name)), knows_(knows), limit_(limit)
  {}

  Outcome operator()(const Object_case& c, kernel::Question question) override
  {
    spent_.reset();
    if (knows_ == verify::Knows::solids && question == kernel::Question::surface) return Outcome::not_asked;
    if (c.pose_a.is_rational() || c.pose_b.is_rational()) return Outcome::not_asked;
    if (!is_rigid(c.pose_a) || !is_rigid(c.pose_b)) return Outcome::not_asked;
    if (c.a->face_count() > most_faces || c.b->face_count() > most_faces) return Outcome::not_asked;
    if (!process_) {
      process_ = started(program_, name_);
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
    switch (take_answer(process_, message_, std::chrono::steady_clock::now() + limit_, spent_, failure_)) {
      case wire::Answer::no: return Outcome::no;
      case wire::Answer::yes: return Outcome::yes;
      case wire::Answer::not_taken: return Outcome::not_asked;
      default: return Outcome::failed;
    }
  }

  void forget() override { a_ = b_ = nullptr; }
  std::optional<verify::Spent> spent() const override { return spent_; }
  verify::Failure failure() const override { return failure_; }

 private:
  std::string program_, name_;
  verify::Knows knows_;
  std::chrono::milliseconds limit_;
  std::unique_ptr<Command_process> process_;
  std::shared_ptr<const covering::Polyhedron> a_, b_;  // what the process has
  std::string message_;
  std::optional<verify::Spent> spent_;
  verify::Failure failure_;
};

constexpr std::chrono::seconds usual_limit(10);

/// A peer of motions at work in a child process.
class Running_motion_peer : public verify::Running_motion {
 public:
  Running_motion_peer(std::string program, std::string name) : program_(std::move(program)), name_(std::move(name)) {}

  verify::Told_contact operator()(const verify::Moving_bodies& bodies, kernel::Question question) override
  {
    const auto rest = shift(bodies.motion_a[0]), from = shift(bodies.motion_b[0]), to = shift(bodies.motion_b[1]);
    if (question == kernel::Question::solid || bodies.motion_a[0] != bodies.motion_a[1] || !rest ||
        !rest->is_identity() || !from || !to)
      return {Outcome::not_asked};
    if (!process_) process_ = started(program_, name_);
    std::string message;
    wire::append(message, wire::Message::models);
    wire::append(message, bodies.a);
    wire::append(message, bodies.b);
    wire::append(message, wire::Message::motion);
    wire::append(message, wire::Asked_motion{from->entries(), to->entries()});
    const auto deadline = std::chrono::steady_clock::now() + usual_limit;
    std::optional<verify::Spent> spent;
    verify::Failure failure;
    const wire::Answer answer = take_answer(process_, message, deadline, spent, failure);
    if (answer == wire::Answer::no) return {Outcome::no, {0, 0}, spent};
    if (answer == wire::Answer::not_taken) return {Outcome::not_asked};
    const auto time = answer == wire::Answer::yes ? take_double(*process_, deadline) : std::nullopt;
    if (!time) process_.reset();  // it is no longer known what the next byte means
    if (!time || !(*time >= 0 && *time <= 1)) return {Outcome::failed};
    return {Outcome::yes, {*time, *time}, spent};
  }

 private:
  /// The pose, where it is a shift by doubles; nothing for another one, and for one by fractions.
  static std::optional<kernel::Pose> shift(const std::vector<kernel::Rational>& numbers)
  {
    std::array<kernel::Rational, 12> entries = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    if (numbers.size() == entries.size()) {
      std::copy(numbers.begin(), numbers.end(), entries.begin());
    } else {
      for (std::size_t k = 1; k < 4; ++k)
        if (numbers[k] != 0) return std::nullopt;
      for (std::size_t k = 0; k < 3; ++k) entries[4 * k + 3] = numbers[4 + k];
    }
    const kernel::Pose pose(entries);
    return pose.is_translation() && !pose.is_rational() ? std::optional(pose) : std::nullopt;
  }

  std::string program_, name_;
  std::unique_ptr<Command_process> process_;
};

verify::Object_subject subject(const std::string& program, const std::string& name, const std::string& note,
                               verify::Knows knows, std::chrono::milliseconds limit,
                               verify::In_floats in_floats = verify::In_floats::nothing)
{
  return {name, false, note, std::nullopt, [=] { return std::make_unique<Running_peer>(program, name, knows, limit); },
          "",   "",    "",   knows,        in_floats};
}

}  // namespace

verify::Object_subject peer_subject(const std::string& program, const std::string& name,
                                    std::chrono::milliseconds limit)
{
  for (const Peer& peer : peers())
    if (peer.name == name) return subject(program, name, peer.note, peer.knows, limit, peer.in_floats);
  return subject(program, name, "", verify::Knows::both, limit);  // for the worker to know
}

std::vector<verify::Object_subject> peer_subjects(const std::string& program)
{
  std::vector<verify::Object_subject> subjects;
  for (const Peer& peer : peers()) subjects.push_back(peer_subject(program, peer.name));
  return subjects;
}

std::vector<verify::Moving_bodies_subject> motion_peer_subjects(const std::string& program)
{
  std::vector<verify::Moving_bodies_subject> subjects;
  for (const Named_motion_peer& peer : motion_peers())
    subjects.push_back({peer.name, false, peer.note, [program, name = std::string(peer.name)] {
                          return std::make_unique<Running_motion_peer>(program, name);
                        }});
  return subjects;
}

}  // namespace tetracone::experiments
