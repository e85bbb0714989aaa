#include "experiments/queries/experiments.h"

#include "experiments/queries/judged_depths.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/cases/object_placing.h"
#include "verify/cases/random.h"
#include "verify/cases/shape_generators.h"

#include <tuple>

namespace tetracone::experiments {
namespace {

/// A pose of A, and the direction in which it leaves B.
struct Stand {
  Pose pose;
  std::array<double, 3> direction;
};

Pose moved(const Pose& pose, const std::array<double, 3>& direction, double length)
{
  std::array<double, 12> rows = pose.rows();
  for (std::size_t i = 0; i < 3; ++i) rows[4 * i + 3] += length * direction[i];
  return Pose(rows);
}

/// Returns poses of A, turned at random, in which `overlap` is left to go along a random direction until its last exit.
std::vector<Stand> stands(Query& query, int count, double overlap, std::uint64_t seed)
{
  verify::Random random(seed);
  std::vector<Stand> stands;
  for (int k = 0; k < count; ++k) {
    const Pose centred(verify::object_family::double_rotation(random).entries());
    const std::array<double, 3> direction = random.direction();
    const double way = query.exits(centred, Pose(), direction).last;
    stands.push_back({moved(centred, direction, way - overlap), direction});
  }
  return stands;
}

struct Timed {
  double total = 0, most = 0, width = 0;
  std::size_t exact = 0;

  void add(double ns)
  {
    total += ns;
    most = std::max(most, ns);
  }
  void add(double ns, const Depth& depth)
  {
    add(ns);
    exact += depth.is_exact;
    width += (depth.high - depth.low) / depth.high;
  }
};

void add_row(Csv_table& table, std::size_t triangles, const std::string& place, const std::string& question,
             std::size_t poses, const Timed& timed, std::uint64_t seed)
{
  const double count = double(poses);
  table.add(Csv_row()
                .add("triangles", triangles)
                .add("place", place)
                .add("question", question)
                .add("poses", poses)
                .add("mean_ns", timed.total / count)
                .add("most_ns", timed.most)
                .add("exact", timed.exact)
                .add("mean_width", timed.width / count)
                .add_origin(seed));
  std::printf("%6zu  %-7s %-14s %12.0f ns, at most %12.0f, exact %zu of %zu, width %.3g\n", triangles, place.c_str(),
              question.c_str(), timed.total / count, timed.most, timed.exact, poses, timed.width / count);
}

/// Adds rows: how narrow the brackets of depths are after a number of boxes of translations, and after what time.
void add_widths(Csv_table& table, Query& query, std::size_t triangles, const std::string& place,
                const std::vector<Stand>& all, std::uint64_t seed)
{
  for (const std::size_t budget : {0, 100, 300, 1000, 3000, 10000}) {
    Timed timed;
    for (const Stand& stand : all) {
      const Stopwatch watch;
      const Depth depth = query.depth(stand.pose, Pose(), {.relative = 0, .budget = budget});
      timed.add(watch.nanoseconds(), depth);
    }
    const double count = double(all.size());
    table.add(Csv_row()
                  .add("triangles", triangles)
                  .add("place", place)
                  .add("budget", budget)
                  .add("poses", all.size())
                  .add("mean_ns", timed.total / count)
                  .add("exact", timed.exact)
                  .add("mean_width", timed.width / count)
                  .add_origin(seed));
  }
}

}  // namespace

void run_penetration(const Experiment_options& options)
{
  constexpr double narrowest = 1e-9;  // the width of a bracket that `depth` asks for by itself
  Csv_table table, widths;
  std::vector<std::size_t> sizes = {200, 1000};
  if (options.full) sizes.push_back(7172);
  for (const std::size_t triangles : sizes) {
    const Body body(verify::blob(triangles, options.seed));
    body.make_all();
    Query query(body, body);
    const double size = 2 * verify::radius(body.polyhedron());
    for (const auto& [place, share, relative] :
         {std::tuple("shallow", 0.01, narrowest), std::tuple("deep", 1 / 3.0, 1e-3)}) {
      const auto all = stands(query, std::max(1, options.race_frames / 50), share * size, options.seed);
      Timed exits, contacts, depths, narrow;
      for (const auto& [pose, direction] : all) {
        query.exits(pose, Pose(), direction);  // what is made on demand is there
        Stopwatch watch;
        query.exits(pose, Pose(), direction);
        exits.add(watch.nanoseconds());
        const Motion in = Motion::linear(moved(pose, direction, size), pose), rest = Motion::linear(Pose(), Pose());
        query.first_contact(in, rest);
        watch = Stopwatch();
        query.first_contact(in, rest);
        contacts.add(watch.nanoseconds());
        watch = Stopwatch();
        const Depth depth = query.depth(pose, Pose(), {relative});
        depths.add(watch.nanoseconds(), depth);
        if (relative == narrowest) continue;
        watch = Stopwatch();
        const Depth narrower = query.depth(pose, Pose(), {.relative = narrowest, .budget = 1'000'000});
        narrow.add(watch.nanoseconds(), narrower);
      }
      exits.exact = contacts.exact = all.size();
      add_row(table, body.polyhedron().face_count(), place, "exit", all.size(), exits, options.seed);
      add_row(table, body.polyhedron().face_count(), place, "first contact", all.size(), contacts, options.seed);
      add_row(table, body.polyhedron().face_count(), place, "depth", all.size(), depths, options.seed);
      if (relative > narrowest)
        add_row(table, body.polyhedron().face_count(), place, "depth to 1e-9", all.size(), narrow, options.seed);
      add_widths(widths, query, body.polyhedron().face_count(), place, all, options.seed);
    }
  }
  write_whole(options.out / "penetration.csv", table.text());
  write_whole(options.out / "penetration_widths.csv", widths.text());
  write_whole(options.out / "penetration_peers.csv", judged_depths(options.full ? 1000 : 100, options.seed));
}

}  // namespace tetracone::experiments
