#include "experiments/scenes/experiments.h"

#include "experiments/speed/trajectory.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/cases/shape_generators.h"

namespace tetracone::experiments {
namespace {

/// A body against itself on a walk.
struct Walk {
  double ratio, clearance;
  std::vector<kernel::Pose> poses;
  double motion;
};

/// One way to ask: the fastest time of each stretch of poses, and what was said in the last pass.
struct Walk_answers {
  Query query;
  std::vector<double> fastest_ns = {};
  std::vector<char> answers = {};
  Query_statistics counts = {};

  double mean_ns() const { return sum_of(fastest_ns) / double(answers.size()); }
};

constexpr std::size_t stretch = 100;

void ask(Walk_answers& asked, const std::vector<kernel::Pose>& poses, std::size_t first, bool is_first_pass)
{
  const kernel::Pose unmoved;
  const std::size_t last = std::min(first + stretch, poses.size());
  const Stopwatch watch;
  for (std::size_t k = first; k < last; ++k) asked.answers[k] = bool(asked.query.collide(unmoved, poses[k]));
  const double ns = watch.nanoseconds();
  double& fastest = asked.fastest_ns[first / stretch];
  fastest = is_first_pass ? ns : std::min(fastest, ns);
}

void add_walk(Csv_table& table, const Body& body, std::size_t triangles, const Walk& walk, Question question,
              std::uint64_t seed)
{
  Walk_answers without{Query(body, body, question)}, with{Query(body, body, question, {.remember = true})};
  constexpr int passes = 5;
  for (int pass = 0; pass < passes; ++pass) {
    for (Walk_answers* asked : {&without, &with}) {
      asked->answers.resize(walk.poses.size());
      asked->fastest_ns.resize(walk.poses.size() / stretch + 1);
      asked->query.clear_statistics();
    }
    // In turn, stretch by stretch, so that what slows the machine for a while slows both.
    for (std::size_t first = 0; first < walk.poses.size(); first += stretch)
      for (Walk_answers* asked : {&without, &with}) ask(*asked, walk.poses, first, pass == 0);
  }
  const double poses = double(walk.poses.size());
  const auto tests = [poses](Walk_answers& asked) { return double(asked.query.statistics().box_tests) / poses; };
  const auto hits = std::count(without.answers.begin(), without.answers.end(), 1);
  std::size_t differ = 0;
  for (std::size_t k = 0; k < walk.poses.size(); ++k) differ += without.answers[k] != with.answers[k];
  const double saved = without.mean_ns() / with.mean_ns();
  table.add(Csv_row()
                .add("object", "blob")
                .add("triangles", triangles)
                .add("ratio", walk.ratio)
                .add("clearance", walk.clearance)
                .add("poses", walk.poses.size())
                .add("motion", walk.motion)
                .add("question", std::string(to_string(question)))
                .add("collisions", hits)
                .add("differ", differ)
                .add("ns_without", without.mean_ns())
                .add("ns_with", with.mean_ns())
                .add("times_faster", saved)
                .add("box_tests_without", tests(without))
                .add("box_tests_with", tests(with))
                .add_origin(seed));
  std::printf(
      "1:%-2.0f  clearance %7.3f %%  motion %7.4f %%  %-7s  %7.0f ns  %7.0f ns  %5.2f times  %4.0f %4.0f boxes  %ld of "
      "%zu collide, %zu differ\n",
      walk.ratio, 100 * walk.clearance, 100 * walk.motion, std::string(to_string(question)).c_str(), without.mean_ns(),
      with.mean_ns(), saved, tests(without), tests(with), long(hits), walk.poses.size(), differ);
}

}  // namespace

void run_coherence(const Experiment_options& options)
{
  const int frames = options.race_frames;
  const std::uint64_t seed = options.seed;
  const covering::Polyhedron object = verify::blob(7172, seed);
  const Body body(object);
  body.make_all();
  Query query(body, body, Question::surface);
  const Collides collides = [&](const kernel::Pose& pose) { return bool(query.collide(kernel::Pose(), pose)); };
  struct Kind {
    double ratio, clearance;
  };
  Csv_table table;
  for (const auto& [ratio, clearance] : {Kind{1, 0.005}, Kind{1, 0.0005}, Kind{1, -0.001}, Kind{8, 0.005}})
    for (const int finer : {1, 5, 25, 125}) {
      Walk walk{ratio, clearance, smooth_walk(object, object, ratio, finer * frames, clearance, seed, collides), 0};
      walk.motion = mean_motion(object, object, walk.poses);
      for (const Question question : {Question::surface, Question::solid})
        add_walk(table, body, object.face_count(), walk, question, seed);
    }
  write_whole(options.out / "coherence.csv", table.text());
}

}  // namespace tetracone::experiments
