#include "experiments/queries/experiments.h"

#include "experiments/peers/fcl.h"
#include "experiments/speed/benchmark_workload.h"
#include "experiments/support/extent.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_generators.h"

#include <bit>

namespace tetracone::experiments {
namespace {

/// Bodies that a subject is asked about, and the exact answers, rounded once.
struct Distance_course {
  std::string trajectory;
  covering::Polyhedron body;
  std::vector<kernel::Pose> poses;  // of B; A rests
  std::vector<double> exact;
};

/// Returns the number of doubles between two that are not negative.
double ulps_between(double x, double y)
{
  const auto place = [](double z) { return std::bit_cast<std::int64_t>(z > 0 ? z : 0.0); };
  return double(std::abs(place(x) - place(y)));
}

/// The mean of the fastest times of the poses, in nanoseconds, and the answers.
struct Timed_distances {
  double mean_ns;
  std::vector<double> answers;
};

Timed_distances time_distances(const Distance_course& course, int passes,
                               const std::function<double(const kernel::Pose&)>& question)
{
  std::vector<double> answers(course.poses.size());
  const auto fastest = fastest_times(1, answers.size(), passes,
                                     [&](std::size_t, std::size_t k) { answers[k] = question(course.poses[k]); });
  return {mean_of(fastest[0]), std::move(answers)};
}

void add_distances(Csv_table& table, const Distance_course& course, const std::string& subject,
                   const std::string& question, const Timed_distances& asked, const std::vector<double>& truth,
                   std::uint64_t seed)
{
  double total = 0, most = 0;
  std::size_t apart = 0, zero_apart = 0, touching = 0, positive_touching = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const double off = ulps_between(asked.answers[k], truth[k]);
    total += off;
    most = std::max(most, off);
    (truth[k] > 0 ? apart : touching) += 1;
    zero_apart += truth[k] > 0 && !(asked.answers[k] > 0);
    positive_touching += truth[k] == 0 && asked.answers[k] > 0;
  }
  table.add(Csv_row()
                .add("trajectory", course.trajectory)
                .add("triangles", course.body.face_count())
                .add("subject", subject)
                .add("question", question)
                .add("poses", truth.size())
                .add("mean_ns", asked.mean_ns)
                .add("mean_ulps", total / double(truth.size()))
                .add("most_ulps", most)
                .add("apart", apart)
                .add("zero_apart", zero_apart)
                .add("touching", touching)
                .add("positive_touching", positive_touching)
                .add_origin(seed));
  std::printf("%-9s %6zu  %-20s %-9s %10.0f ns  most %9.3g ulps, 0 of %zu apart: %zu, above 0 of %zu touching: %zu\n",
              course.trajectory.c_str(), course.body.face_count(), subject.c_str(), question.c_str(), asked.mean_ns,
              most, apart, zero_apart, touching, positive_touching);
}

void run_course(Csv_table& table, Distance_course course, int passes, std::uint64_t seed)
{
  const Body body(course.body);
  body.make_all();
  Query exact(body, body, Question::surface), in_double(body, body, Question::surface, {.kernel = Kernel::double_});
  const kernel::Pose unmoved;
  const Timed_distances ours =
      time_distances(course, passes, [&](const kernel::Pose& pose) { return exact.distance(unmoved, pose); });
  if (course.exact.empty()) course.exact = ours.answers;
  add_distances(table, course, "tetracone adaptive", "distance", ours, course.exact, seed);
  add_distances(
      table, course, "tetracone double", "distance",
      time_distances(course, passes, [&](const kernel::Pose& pose) { return in_double.distance(unmoved, pose); }),
      course.exact, seed);

  const double near = extent_of(course.body).longest_side() / 10;
  const std::string limit = kernel::shortest(near);
  std::vector<double> is_within;
  for (const double d : course.exact) is_within.push_back(d <= near);
  add_distances(table, course, "tetracone adaptive", "within",
                time_distances(course, passes,
                               [&](const kernel::Pose& pose) { return double(exact.within(unmoved, pose, limit)); }),
                is_within, seed);

  const auto mesh = peer_mesh(course.body);
  for (const auto& [name, make] : distance_peers()) {
    const auto peer = make(*mesh, *mesh);
    add_distances(table, course, name, "distance",
                  time_distances(course, passes, [&](const kernel::Pose& pose) { return peer(unmoved, pose); }),
                  course.exact, seed);
  }
}

/// A cube with triangulated faces, and poses of another cube. The second touches the first in a face or is 2^-k away
/// from it, shifted sideways, so that the distance is known.
Distance_course gaps(int frames, std::uint64_t seed)
{
  Distance_course course{"gaps", triangulated(verify::unit_cube()), {}, {}};
  verify::Random random(seed);
  for (int k = 0; k < frames; ++k) {
    const double x = k % 2 == 0 ? 1 : 1 + std::ldexp(1.0, -(k / 2 % 52) - 1);
    course.poses.push_back(kernel::Pose::translation(x, random.unit() - 0.5, random.unit() - 0.5));
    course.exact.push_back(x - 1);
  }
  return course;
}

}  // namespace

void run_distance(const Experiment_options& options)
{
  const int frames = options.race_frames;
  const std::uint64_t seed = options.seed;
  Csv_table table;
  std::vector<std::size_t> sizes = {7172};
  if (options.full) sizes.push_back(71000);
  for (const std::size_t triangles : sizes) {
    const covering::Polyhedron object = verify::blob(triangles, seed);
    const Body body(object);
    Query query(body, body, Question::surface);
    const Collides collides = [&](const kernel::Pose& pose) { return bool(query.collide(kernel::Pose(), pose)); };
    const int passes = 3;
    run_course(table, {"contour", object, contour_trajectory(object, object, 1, frames, seed, collides), {}}, passes,
               seed);
    run_course(table, {"circular", object, circular_trajectory(object, object, 1, frames, seed, collides), {}}, passes,
               seed);
  }
  run_course(table, gaps(frames, seed), 3, seed);
  write_whole(options.out / "distance.csv", table.text());
}

}  // namespace tetracone::experiments
