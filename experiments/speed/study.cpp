#include "experiments/speed/experiments.h"

#include "experiments/peers/fcl.h"
#include "experiments/speed/contact_questions.h"
#include "experiments/speed/timed_poses.h"
#include "verify/subjects/subject.h"

#include <iostream>

namespace tetracone::experiments {
namespace {

using kernel::Pose;
using kernel::Question;
using verify::Method;
using verify::Subject;

/// A subject of the harness, prepared as a contestant.
class Subject_pair : public Prepared_pair {
 public:
  explicit Subject_pair(std::unique_ptr<verify::Prepared_pair> pair) : pair_(std::move(pair)) {}

  bool collide(const Pose& pose_a, const Pose& pose_b, Question question) override
  {
    return pair_->collide(pose_a, pose_b, question);
  }
  tetratree::Query_statistics take_counts() override { return pair_->take_counts(); }
  std::size_t node_count() const override { return pair_->node_count(); }
  std::size_t tree_bytes() const override { return pair_->bytes(); }

 private:
  std::unique_ptr<verify::Prepared_pair> pair_;
};

Contestant ours(const std::string& kernel, Method method, std::size_t one_in = 1)
{
  const Subject subject = *Subject::parse(kernel, method);
  return {.name = subject.name(),
          .exact = subject.is_exact(),
          .knows_solids = true,
          .counts_work = true,
          .one_in = one_in,
          .prepare =
              [subject](const covering::Polyhedron& a, const covering::Polyhedron& b) {
                return std::make_unique<Subject_pair>(verify::prepare(subject, a, b));
              },
          .kernel = subject.kernel_name(),
          .method = std::string(to_string(method))};
}

/// FCL with B scaled as in the poses of the workload. It knows surfaces only.
Contestant scaled_fcl(const Workload& workload)
{
  return {.name = "FCL OBBRSS",
          .prepare = [scale_b = workload.scale_b](const covering::Polyhedron& a,
                                                  const covering::Polyhedron& b) { return prepare_fcl(a, b, scale_b); },
          .kernel = "FCL",
          .method = "peer"};
}

std::vector<Contestant> contestants(const Workload& workload, const std::vector<verify::Object_subject>& programs)
{
  std::vector<Contestant> list;
  for (const char* kernel : {"float", "double", "double-eps=1e-12", "epick", "epeck", "adaptive"})
    list.push_back(ours(kernel, Method::tree));
  list.push_back(ours("rational", Method::tree, 4));
  // One kernel is run with every method. For large bodies, where a pose takes a tenth of a second or a second, fewer
  // poses are asked.
  const bool is_large = workload.a.face_count() * workload.b.face_count() > 1'000'000;
  for (const char* kernel : {"double", "adaptive"}) {
    list.push_back(ours(kernel, Method::tuned));
    list.push_back(ours(kernel, Method::paper, is_large ? 4 : 1));
  }
  for (const char* kernel : {"double", "adaptive"}) list.push_back(ours(kernel, Method::brute, is_large ? 30 : 1));
  if (workload.regime == "degenerate")
    for (const char* kernel : {"float", "double-eps=1e-12", "epick"}) list.push_back(ours(kernel, Method::brute));
  list.push_back(scaled_fcl(workload));
  for (const verify::Object_subject& subject : programs) list.push_back(program(subject));
  return list;
}

/// What contact costs: exactness, by the same tree in double and in EPECK, and FCL.
std::vector<Contestant> contestants_of_contact(const Workload& workload)
{
  std::vector<Contestant> list;
  for (const char* kernel : {"adaptive", "double", "epeck"}) list.push_back(ours(kernel, Method::tree));
  list.push_back(scaled_fcl(workload));
  return list;
}

struct Judged {
  Timed_poses poses;
  double build_seconds = 0;
  std::size_t bytes = 0, nodes = 0;
  tetratree::Query_statistics counts;  ///< work of one pass
};

/// Times `answer(k)` to each case, and judges it by the truth. `asked` tells its work, and its own time where it clocks
/// itself.
template <class Asked, class Answer>
Judged judge(Asked& asked, const Answer& answer, const std::vector<char>& truth, std::size_t one_in,
             double build_seconds)
{
  Judged result{Timed_poses(truth, one_in), build_seconds, 0, 0, {}};

  const Stopwatch since_first;
  constexpr int passes = 5;
  constexpr double enough_seconds = 0.3;  // slow subjects are timed once
  for (int pass = 0; pass < passes; ++pass) {
    result.poses.pass(
        answer, 0,
        [&](double weight) {
          const auto counts = asked.take_counts();
          if (pass == 0) result.counts += weighted(counts, weight);
        },
        [&] { return asked.own_ns(); });
    if (since_first.seconds() > enough_seconds) break;
  }
  // By now, the nodes built on demand exist.
  result.bytes = asked.tree_bytes();
  result.nodes = asked.node_count();
  return result;
}

/// Returns nothing if the contestant does not take such bodies. Throws No_answer.
std::optional<Judged> judge(const Workload& workload, const Contestant& contestant, Question question,
                            const std::vector<char>& truth)
{
  const Stopwatch build;
  const auto pair = contestant.prepare(workload.a, workload.b);
  if (!pair) return std::nullopt;
  return judge(
      *pair, [&](std::size_t k) { return pair->collide(workload.pose_a(k), workload.poses_b[k], question); }, truth,
      contestant.one_in, build.seconds());
}

Csv_row row(const Workload& workload, const std::string& question, const Contestant& contestant, const Judged& judged,
            std::uint64_t seed)
{
  const Timed_poses& timed = judged.poses;
  const Judged_answers& answers = timed.judged();
  const auto whole = [](double x) { return static_cast<long long>(x); };
  const auto a_pose = [&](std::uint64_t count) { return static_cast<double>(count) / double(answers.course_poses); };
  const auto& counts = judged.counts;
  const bool is_program = contestant.method == "program";     // it makes its bodies in its own process
  const bool has_time = std::isfinite(timed.mean_ns(timed));  // a program may tell none
  const auto time = [&](double ns) { return has_time ? std::to_string(whole(ns)) : std::string(); };
  return Csv_row()
      .add("regime", workload.regime)
      .add("scenario", workload.scenario)
      .add("a", workload.a_name)
      .add("b", workload.b_name)
      .add("faces_a", workload.a.face_count())
      .add("faces_b", workload.b.face_count())
      .add_exact("ratio", 1 / workload.scale_b)
      .add("question", question)
      .add("subject", contestant.name)
      .add("kernel", contestant.kernel)
      .add("method", contestant.method)
      .add("exact", contestant.exact ? 1 : 0)
      .add("poses", answers.poses)
      .add("collisions", answers.collisions)
      .add("false_positives", answers.false_positives)
      .add("false_negatives", answers.false_negatives)
      .add("course_poses", answers.course_poses)
      .add("course_collisions", answers.course_collisions)
      .add("estimator", answers.estimator())
      .add("mean_ns", time(timed.mean_ns(timed)))
      .add("median_ns", time(timed.quantile_ns(0.5)))
      .add("p99_ns", time(timed.quantile_ns(0.99)))
      .add("build_ms", is_program ? "" : kernel::shortest(std::round(judged.build_seconds * 1e6) / 1e3))
      .add("bytes", is_program ? "" : std::to_string(judged.bytes))
      .add("nodes", judged.nodes)
      .add_exact("pairs_visited", a_pose(counts.pairs_visited))
      .add_exact("discarded_by_hull", a_pose(counts.discarded_by_hull))
      .add_exact("discarded_by_sphere", a_pose(counts.discarded_by_sphere))
      .add_exact("discarded_by_tetrahedron", a_pose(counts.discarded_by_tetrahedron))
      .add_exact("bounding_tests", a_pose(counts.bounding_tests()))
      .add_exact("primitive_tests", a_pose(counts.primitive_tests()))
      .add_exact("exact_fallbacks", a_pose(counts.exact_fallbacks))
      .add_origin(seed);
}

std::string study_workload(const Workload& workload, const std::vector<Contestant>& contestants, std::uint64_t seed)
{
  const auto truth_teller = verify::prepare(*Subject::parse("rational", Method::brute), workload.a, workload.b);
  Csv_table table;
  for (const Question question : workload.questions) {
    std::vector<char> truth;
    for (std::size_t k = 0; k < workload.poses_b.size(); ++k)
      truth.push_back(truth_teller->collide(workload.pose_a(k), workload.poses_b[k], question));
    for (const Contestant& contestant : contestants) {
      if (question == Question::solid && !contestant.knows_solids) continue;
      try {
        if (const auto judged = judge(workload, contestant, question, truth))
          table.add(row(workload, std::string(to_string(question)), contestant, *judged, seed));
      } catch (const No_answer& what) {
        std::cerr << what.what() << "; it has no row of " << workload.scenario << ", " << to_string(question) << '\n';
      }
    }
  }
  return table.text();
}

std::string contact_rows(const Contact_question& asked, std::uint64_t seed)
{
  Csv_table table;
  for (const Way& way : asked.ways) {
    const Stopwatch build;
    const auto answers = way.prepare();
    const double build_seconds = build.seconds();
    const auto answer = [&](std::size_t k) { return asked.truth[k] + answers->verdict(k); };
    table.add(row(*asked.workload, asked.name, way.who,
                  judge(*answers, answer, asked.truth, way.who.one_in, build_seconds), seed));
  }
  return table.text();
}

}  // namespace

void run_study(const Experiment_options& options)
{
  const int more = options.full ? 20 : 1;
  std::vector<Table_part> parts;
  for (Named_workload& workload :
       study_workloads(options.models, more * options.frames, more * options.rotations, options.seed))
    parts.push_back(
        {std::move(workload.name), [make = std::move(workload.make), seed = options.seed, programs = options.programs] {
           const Workload made = make();
           return study_workload(made, contestants(made, programs), seed);
         }});
  write_table(options.out, "study", parts);
  if (!options.rows_alone) draw("report.py", options.out);
}

void run_contact_cost(const Experiment_options& options)
{
  std::vector<Table_part> parts;
  for (Named_workload& workload : study_workloads(options.models, options.frames, options.rotations, options.seed))
    if (workload.name.starts_with("degenerate-"))
      parts.push_back({std::move(workload.name), [make = std::move(workload.make), seed = options.seed] {
                         const Workload made = make();
                         return study_workload(made, contestants_of_contact(made), seed);
                       }});
  for (Named_question& question : contact_questions(options.models, options.rotations, options.seed))
    parts.push_back({std::move(question.name),
                     [make = std::move(question.make), seed = options.seed] { return contact_rows(make(), seed); }});
  write_table(options.out, "contact_cost", parts);
  draw("tables_price.py", options.out);
}

}  // namespace tetracone::experiments
