#include "experiments/certificates/certified_subjects.h"

#include "experiments/peers/command_process.h"
#include "experiments/support/csv_row.h"
#include "experiments/support/stopwatch.h"
#include "tetracone/tetratree/door/certificate.h"
#include "tetracone/tetratree/door/repair.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace tetracone::experiments {
namespace {

using verify::Object_case;
using verify::Outcome;
using verify::Probe_case;
using verify::Told;

/// What the certificates of one kind of answer have cost.
struct Costs {
  std::uint64_t asked = 0, without_proof = 0, refused = 0;
  double bytes = 0, most_bytes = 0, made_ns = 0, checked_ns = 0;  // sums, but for the most
};

/// The costs by kind, of all threads.
struct Table {
  std::mutex lock;
  std::map<std::string, Costs> kinds;
};

Table& table()
{
  static Table table;
  return table;
}

/// A checker as a process that proves certificates, one after the other.
class Checker {
 public:
  /// Proves the certificate about `of` to which add(certificate) adds. It counts its cost, with the answer's, for a
  /// kind of answer, which add() may find. An answer without a proof is counted. Throws std::runtime_error, with
  /// the checker's line, where the certificate is refused.
  template <class Add, class... Of>
  void prove(const std::string& kind, const Add& add, const Of&... of)
  {
    Costs cost{1, 0, 0, 0, 0, 0, 0};
    const Stopwatch making;
    Certificate certificate(of...);
    add(certificate);
    std::string text = certificate.text();
    cost.made_ns = making.nanoseconds();
    std::string said = "proved";
    if (certificate.without_proof() > 0) {
      cost.without_proof = 1;
    } else {
      std::ranges::replace(text, '\n', ' ');
      const Stopwatch checking;
      said = checked(text);
      cost.checked_ns = checking.nanoseconds();
      cost.bytes = cost.most_bytes = double(text.size());
      cost.refused = said != "proved";
    }
    count(kind, cost);
    if (said != "proved") throw std::runtime_error(said);
  }

 private:
  static constexpr std::chrono::seconds longest_proof{60};

  std::string checked(const std::string& text)
  {
    if (!process_) process_ = std::make_unique<Command_process>(words());
    const auto deadline = std::chrono::steady_clock::now() + longest_proof;
    const auto line = process_->send(text + "\n", deadline) ? process_->line(deadline) : std::nullopt;
    if (line) return *line;
    const std::string said = "the checker does not answer: " + process_->last_error();
    process_.reset();
    return said;
  }

  static void count(const std::string& kind, const Costs& cost)
  {
    const std::lock_guard lock(table().lock);
    Costs& all = table().kinds[kind];
    all.asked += cost.asked;
    all.without_proof += cost.without_proof;
    all.refused += cost.refused;
    all.bytes += cost.bytes;
    all.most_bytes = std::max(all.most_bytes, cost.most_bytes);
    all.made_ns += cost.made_ns;
    all.checked_ns += cost.checked_ns;
  }

  /// The checker that the environment names, else the one in Python.
  static std::vector<std::string> words()
  {
    if (const char* const named = std::getenv("TETRACONE_CHECKER")) return {named, "-"};
    return {"/usr/bin/python3", "-B", TETRACONE_SOURCE_DIR "/experiments/certificates/check.py", "-"};
  }

  std::unique_ptr<Command_process> process_;
};

class Certified_objects : public verify::Running_subject {
 public:
  Outcome operator()(const Object_case& c, kernel::Question question) override
  {
    return outcome(c, [&] {
      Query asked = query(c, question);
      Relation relation{};
      std::string kind;
      const auto add = [&](Certificate& certificate) {
        relation = certificate.collide(asked, c.pose_a, c.pose_b).relation();
        kind = "collide " + std::string(kernel::to_string(relation));
      };
      checker_.prove(kind, add, asked);
      return relation != Relation::apart;
    });
  }

  Told<verify::Distance_answer> distance(const Object_case& c, kernel::Question question) override
  {
    verify::Distance_answer answer;
    const Outcome told = outcome(c, [&] {
      Query asked = query(c, question);
      const auto add = [&](Certificate& certificate) {
        answer.nearest = certificate.distance(asked, c.pose_a, c.pose_b);
      };
      checker_.prove("distance", add, asked);
      answer.alone = asked.distance(c.pose_a, c.pose_b);
      return true;
    });
    return {told, std::move(answer)};
  }

  Outcome within(const Object_case& c, kernel::Question question, const std::string& limit) override
  {
    return outcome(c, [&] {
      Query asked = query(c, question);
      bool answer = false;
      const auto add = [&](Certificate& certificate) { answer = certificate.within(asked, c.pose_a, c.pose_b, limit); };
      checker_.prove("within", add, asked);
      return answer;
    });
  }

  Told<verify::Solid_answer> solids(const Object_case& c) override
  {
    auto told = uncertified_->solids(c);
    const kernel::Solid_relation relation = told.answer.alone;
    certify(c, told, "relation " + std::string(to_string(relation)),
            [&](Certificate& certificate) { certificate.relation(c.pose_a, c.pose_b, relation); });
    return told;
  }

  Told<verify::Exit_answer> exits(const Object_case& c, const std::array<kernel::Rational, 3>& direction) override
  {
    auto told = uncertified_->exits(c, direction);
    certify(c, told, "exit", [&](Certificate& certificate) {
      const auto text = [](const kernel::Rational& x) { return kernel::to_string(x); };
      const auto& [first, last] = told.answer.exits;
      certificate.exits(c.pose_a, c.pose_b, {text(direction[0]), text(direction[1]), text(direction[2])},
                        {told.answer.first, told.answer.last, text(first), text(last)});
    });
    return told;
  }

  Told<Depth> depth(const Object_case& c) override
  {
    auto told = uncertified_->depth(c);
    certify(c, told, "depth", [&](Certificate& certificate) { certificate.depth(c.pose_a, c.pose_b, told.answer); });
    return told;
  }

  void forget() override
  {
    bodies_.reset();
    uncertified_->forget();
  }
  verify::Failure failure() const override { return {"exception", said_}; }

 private:
  template <class Answer>
  Outcome outcome(const Object_case& c, const Answer& answer)
  try {
    if (c.a->face_count() > verify::most_faces || c.b->face_count() > verify::most_faces) return Outcome::not_asked;
    return answer() ? Outcome::yes : Outcome::no;
  } catch (const std::exception& error) {
    said_ = error.what();
    return Outcome::failed;
  }

  /// Proves what another subject has told. It has failed where the proof is refused.
  template <class Answer, class Add>
  void certify(const Object_case& c, Told<Answer>& told, const std::string& kind, const Add& add)
  {
    if (told.outcome != Outcome::yes) return;
    told.outcome = outcome(c, [&] {
      checker_.prove(kind, add, bodies(c)[0], bodies(c)[1]);
      return true;
    });
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

  std::shared_ptr<const covering::Polyhedron> a_, b_;  // those of `bodies_`
  std::optional<std::array<Body, 2>> bodies_;
  std::unique_ptr<verify::Running_subject> uncertified_ = verify::solid_subjects().front().make();
  Checker checker_;
  std::string said_;
};

class Certified_motions : public verify::Running_motion {
 public:
  verify::Told_contact operator()(const verify::Moving_bodies& bodies, kernel::Question question) override
  try {
    const Body a(bodies.a), b(bodies.b);
    const Motion of_a(verify::motion_of(bodies.motion_a)), of_b(verify::motion_of(bodies.motion_b));
    const auto first = Query(a, b, question).first_contact(of_a, of_b);
    const auto add = [&](Certificate& certificate) { certificate.first_contact(of_a, of_b, question, first); };
    checker_.prove(bodies.is_rigid() ? "motion rigid" : "motion linear", add, a, b);
    if (!first) return {Outcome::no};
    return {Outcome::yes, {first->lo, first->hi}};
  } catch (const std::exception&) {
    return {Outcome::failed};
  }

 private:
  Checker checker_;
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
      Answer answer{};
      const auto add = [&](Certificate& certificate) { answer = ask_(*body_, c, certificate); };
      checker_.prove(std::is_same_v<Answer, int> ? "inside" : "ray", add, *body_);
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

verify::Moving_bodies_subject certified_motions()
{
  return {name, true, "", [] { return std::make_unique<Certified_motions>(); }};
}

std::string certificate_costs(std::uint64_t seed)
{
  const std::lock_guard lock(table().lock);
  Csv_table rows;
  for (const auto& [kind, cost] : table().kinds) {
    const std::uint64_t proved = cost.asked - cost.without_proof - cost.refused;
    const double count = double(std::max<std::uint64_t>(cost.asked - cost.without_proof, 1));
    Csv_row row;
    row.add("kind", kind)
        .add("asked", cost.asked)
        .add("proved", proved)
        .add("without_proof", cost.without_proof)
        .add("refused", cost.refused)
        .add("bytes_mean", cost.bytes / count)
        .add("bytes_most", cost.most_bytes)
        .add("made_ns", cost.made_ns / double(cost.asked))
        .add("checked_ns", cost.checked_ns / count)
        .add_origin(seed);
    rows.add(row);
  }
  return rows.text();
}

}  // namespace tetracone::experiments
