#include "experiments/speed/experiments.h"

#include "experiments/speed/trajectory.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/cases/shape_generators.h"

#include <atomic>
#include <thread>

namespace tetracone::experiments {
namespace {

/// Nanoseconds per query when `count` threads ask the poses in turn, `rounds` times over, each with its own query; and
/// the number of hits.
struct Lap {
  double nanoseconds;
  long hits;
};

Lap lap(const Body& a, const Body& b, const std::vector<kernel::Pose>& poses, int count, int rounds)
{
  std::atomic<std::size_t> next = 0;
  std::atomic<long> hits = 0;
  const std::size_t all = poses.size() * std::size_t(rounds);
  const auto work = [&] {
    Query query(a, b, Question::surface);
    const kernel::Pose unmoved;
    constexpr std::size_t at_once = 64;
    long mine = 0;
    for (std::size_t begin; (begin = next.fetch_add(at_once)) < all;)
      for (std::size_t k = begin; k < std::min(begin + at_once, all); ++k)
        mine += bool(query.collide(unmoved, poses[k % poses.size()]));
    hits += mine;
  };
  const Stopwatch watch;
  std::vector<std::thread> threads;
  for (int k = 1; k < count; ++k) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return {watch.nanoseconds() / double(all), hits};
}

/// Returns nanoseconds per triangle of building a body from its arrays, with all nodes, by `count` threads: the best of
/// some passes.
double making(const covering::Polyhedron& object, int count)
{
  double best = 0;
  for (int pass = 0; pass < 5; ++pass) {
    covering::Polyhedron arrays = object;
    const Stopwatch watch;
    const Body body(std::move(arrays));
    body.make_all(std::size_t(count));
    const double now = watch.nanoseconds() / double(object.face_count());
    if (pass == 0 || now < best) best = now;
  }
  return best;
}

}  // namespace

void run_threads(const Experiment_options& options)
{
  const std::uint64_t seed = options.seed;
  const int processors = int(std::max(1u, std::thread::hardware_concurrency()));
  const covering::Polyhedron object = verify::blob(7172, seed);
  const Body reference(object);
  Query of_reference(reference, reference, Question::surface);
  const auto poses = contour_trajectory(object, object, 1, options.race_frames, seed, [&](const kernel::Pose& pose) {
    return bool(of_reference.collide(kernel::Pose(), pose));
  });
  Csv_table table;
  const auto add_row = [&](int count, const std::string& bodies, const covering::Polyhedron& body, const Lap& best,
                           double alone, std::size_t asked) {
    const double speedup = alone / best.nanoseconds;
    table.add(Csv_row()
                  .add("threads", count)
                  .add("bodies", bodies)
                  .add("triangles", body.face_count())
                  .add_exact("ns", best.nanoseconds)
                  .add_exact("speedup", speedup)
                  .add("hits", best.hits)
                  .add("poses", asked)
                  .add_origin(seed));
    std::printf("%8d  %-6s  %10.0f  %8.2f\n", count, bodies.c_str(), best.nanoseconds, speedup);
  };
  std::printf("%8s  %-6s  %10s  %8s\n", "threads", "bodies", "ns a query", "speed-up");
  for (const std::string bodies : {"fresh", "warm"}) {
    double alone = 0;
    for (int count = 1; count <= 2 * processors; count *= 2) {
      Lap best{0, 0};
      for (int pass = 0; pass < 5; ++pass) {
        const Body a(object), b(object);
        if (bodies == "warm") {
          a.make_all();
          b.make_all();
        }
        const Lap now = lap(a, b, poses, count, bodies == "warm" ? 20 : 1);
        if (pass == 0 || now.nanoseconds < best.nanoseconds) best = now;
      }
      if (count == 1) alone = best.nanoseconds;
      add_row(count, bodies, object, best, alone, poses.size());
    }
  }
  for (const std::size_t triangles : {70000, 700000}) {
    const covering::Polyhedron large = verify::blob(triangles, seed);
    double alone = 0;
    for (int count = 1; count <= processors; count *= 2) {
      const Lap best{making(large, count), 0};
      if (count == 1) alone = best.nanoseconds;
      add_row(count, "making", large, best, alone, 0);
    }
  }
  write_whole(options.out / "threads.csv", table.text());
}

}  // namespace tetracone::experiments
