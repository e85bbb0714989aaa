#include "experiments/certificates/certified_subjects.h"

#include "experiments/peers/command_process.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/certificate.h"
#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::experiments {
namespace {

using verify::Object_case;
using verify::Outcome;
using verify::Probe_case;
using verify::Told;

/// The checker as a process that proves certificates, one after the other.
class Checker {
 public:
  /// Throws std::runtime_error, with the checker's line, unless it proves the certificate.
  void operator()(const Certificate& certificate)
  {
    std::string text = certificate.text();
    std::ranges::replace(text, '\n', ' ');
    if (!process_) process_ = std::make_unique<Command_process>(words_);
    const auto deadline = std::chrono::steady_clock::now() + longest_proof;
    const auto line = process_->send(text + "\n", deadline) ? process_->line(deadline) : std::nullopt;
    if (line && *line == "proved") return;
    const std::string said = line ? *line : "the checker does not answer: " + process_->last_error();
    if (!line) process_.reset();
    throw std::runtime_error(said);
  }

 private:
  static constexpr std::chrono::seconds longest_proof{60};

  const std::vector<std::string> words_ = {"/usr/bin/python3", "-B",
                                           TETRACONE_SOURCE_DIR "/experiments/certificates/check.py", "-"};
  std::unique_ptr<Command_process> process_;
};

class Certified_objects : public verify::Running_subject {
 public:
  Outcome operator()(const Object_case& c, kernel::Question question) override
  {
    if (is_too_large(c)) return Outcome::not_asked;
    return outcome([&] {
      const Relation relation = query(c, question).collide(c.pose_a, c.pose_b).relation();
      proves(c, [&](Certificate& certificate) { certificate.collide(c.pose_a, c.pose_b, question, relation); });
      return relation != Relation::apart;
    });
  }

  Told<verify::Distance_answer> distance(const Object_case& c, kernel::Question question) override
  {
    if (is_too_large(c)) return {};
    verify::Distance_answer answer;
    const Outcome told = outcome([&] {
      Query asked = query(c, question);
      answer = {asked.nearest(c.pose_a, c.pose_b), asked.distance(c.pose_a, c.pose_b)};
      proves(c, [&](Certificate& certificate) { certificate.distance(c.pose_a, c.pose_b, question, answer.nearest); });
      return true;
    });
    return {told, std::move(answer)};
  }

  Outcome within(const Object_case& c, kernel::Question question, const std::string& limit) override
  {
    if (is_too_large(c)) return Outcome::not_asked;
    return outcome([&] {
      Query asked = query(c, question);
      const bool answer = asked.within(c.pose_a, c.pose_b, limit);
      const Nearest nearest = asked.nearest(c.pose_a, c.pose_b);
      proves(c, [&](Certificate& certificate) {
        certificate.within(c.pose_a, c.pose_b, question, limit, answer, nearest);
      });
      return answer;
    });
  }

  void forget() override { bodies_.reset(); }
  verify::Failure failure() const override { return {"exception", said_}; }

 private:
  static bool is_too_large(const Object_case& c)
  {
    return c.a->face_count() > verify::most_faces || c.b->face_count() > verify::most_faces;
  }

  template <class Answer>
  Outcome outcome(const Answer& answer)
  try {
    return answer() ? Outcome::yes : Outcome::no;
  } catch (const std::exception& error) {
    said_ = error.what();
    return Outcome::failed;
  }

  const std::array<Body, 2>& bodies(const Object_case& c)
  {
    if (!bodies_ || a_ != c.a || b_ != c.b) {
      bodies_.emplace(std::array{triangulated_body(*c.a), triangulated_body(*c.b)});
      a_ = c.a;
      b_ = c.b;
    }
    return *bodies_;
  }

  Query query(const Object_case& c, kernel::Question question) { return Query(bodies(c)[0], bodies(c)[1], question); }

  template <class Add>
  void proves(const Object_case& c, const Add& add)
  {
    Certificate certificate(bodies(c)[0], bodies(c)[1]);
    add(certificate);
    checker_(certificate);
  }

  std::shared_ptr<const covering::Polyhedron> a_, b_;  // those of `bodies_`
  std::optional<std::array<Body, 2>> bodies_;
  Checker checker_;
  std::string said_;
};

/// A running subject of a level of probes. `ask(body, case, certificate)` returns the answer and adds its proof.
template <class Answer>
class Certified_probes : public verify::Running<Probe_case, Answer> {
 public:
  using Ask = Answer (*)(const Body&, const Probe_case&, Certificate&);
  explicit Certified_probes(Ask ask) : ask_(ask) {}

  Told<Answer> operator()(const Probe_case& c) override
  {
    return verify::told_by([&] {
      if (!body_ || polyhedron_ != c.body) {
        body_.emplace(triangulated_body(*c.body));
        polyhedron_ = c.body;
      }
      Certificate certificate(*body_);
      Answer answer = ask_(*body_, c, certificate);
      checker_(certificate);
      return answer;
    });
  }

 private:
  Ask ask_;
  std::shared_ptr<const covering::Polyhedron> polyhedron_;  // that of `body_`
  std::optional<Body> body_;
  Checker checker_;
};

int inside(const Body& body, const Probe_case& c, Certificate& certificate)
{
  const Location answer = body.inside(c.from);
  certificate.inside({kernel::shortest(c.from[0]), kernel::shortest(c.from[1]), kernel::shortest(c.from[2])}, answer);
  return int(answer);
}

verify::Ray_answer hits(const Body& body, const Probe_case& c, Certificate& certificate)
{
  const Ray ray{c.from, c.direction};
  verify::Ray_answer answer{body.first_hit(ray), body.hits(ray)};
  certificate.first_hit(ray, answer.first);
  return answer;
}

constexpr const char* name = "certified tree";

}  // namespace

verify::Object_subject certified_objects()
{
  verify::Object_subject subject;
  subject.name = name;
  subject.is_exact = true;
  subject.make = [] { return std::make_unique<Certified_objects>(); };
  return subject;
}

verify::Point_subject certified_points()
{
  return {name, true, "", [] { return std::make_unique<Certified_probes<int>>(inside); }};
}

verify::Ray_subject certified_rays()
{
  return {name, true, "", [] { return std::make_unique<Certified_probes<verify::Ray_answer>>(hits); }};
}

}  // namespace tetracone::experiments
