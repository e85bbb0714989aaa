#include "experiments/scenes/experiments.h"

#include "experiments/scenes/scene_workload.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/scene/scene.h"

namespace tetracone::experiments {
namespace {

using kernel::Adaptive;
using kernel::Stage_counts;

/// Each body of a model of its own, and the time that has been spent on them.
struct Timed_scene {
  explicit Timed_scene(const Scene_workload& work) : scene({.question = Question::surface})
  {
    for (std::size_t k = 0; k < work.model_of.size(); ++k) {
      bodies.emplace_back(work.models[work.model_of[k]]);
      scene.add_body(scene.add_model(bodies.back()));
    }
  }

  void make_all()
  {
    const Stopwatch watch;
    for (const Body& body : bodies) body.make_all();
    ns += watch.nanoseconds();
  }
  const std::vector<Scene_pair>& frame(const std::vector<kernel::Pose>& poses)
  {
    const Stopwatch watch;
    for (std::size_t k = 0; k < poses.size(); ++k) scene.place(k, poses[k]);
    const auto& pairs = scene.pairs();
    ns += watch.nanoseconds();
    return pairs;
  }

  std::vector<Body> bodies;
  Scene scene;
  double ns = 0;
};

/// The sizes of all bodies' trees, as far as they have been built.
struct Trees {
  explicit Trees(const std::vector<Body>& bodies)
  {
    for (const Body& body : bodies)
      if (const tetratree::Bvh8* const tree = detail::data_of(body).made_bvh8()) {
        ++count;
        nodes += tree->node_count();
        bytes += tree->bytes();
      }
  }
  std::size_t count = 0, nodes = 0, bytes = 0;
};

/// The signs of this thread that doubles did not decide.
std::uint64_t beyond_doubles(const Stage_counts& signs)
{
  return signs.total() - signs[Adaptive::Stage::filter] - signs[Adaptive::Stage::zero];
}

/// In per cent.
double share(std::size_t part, std::size_t whole) { return 100 * double(part) / double(whole); }

}  // namespace

void run_demand(const Experiment_options& options)
{
  const auto frames = std::size_t(std::max(2, options.race_frames / 10));
  const Scene_workload work = scene_workload("gravity", "large", 200, frames, options.seed);
  Timed_scene asked(work), first(work);
  first.make_all();
  const Trees all(first.bodies);
  Stage_counts signs;
  std::uint64_t signs_asked = 0, signs_beyond = 0;
  Csv_table table;
  std::printf("%6s %7s %6s %9s %9s %9s %10s %10s %9s %9s\n", "frame", "pairs", "trees", "nodes", "of trees", "bytes",
              "signs", "beyond", "ms", "ms first");
  for (std::size_t frame = 0; frame < frames; ++frame) {
    signs = Adaptive::decided_by();
    const auto& pairs = asked.frame(work.frames[frame]);
    signs = Adaptive::decided_by() - signs;
    signs_asked += signs.total();
    signs_beyond += beyond_doubles(signs);
    const bool differ = pairs != first.frame(work.frames[frame]);
    const Trees made(asked.bodies);
    table.add(Csv_row()
                  .add("frame", frame)
                  .add("bodies", work.model_of.size())
                  .add("triangles", work.models[0].face_count())
                  .add("pairs", pairs.size())
                  .add("differ", int(differ))
                  .add("trees", made.count)
                  .add("nodes", made.nodes)
                  .add("nodes_of_whole_trees", all.nodes)
                  .add("bytes_of_trees", made.bytes)
                  .add("bytes_of_whole_trees", all.bytes)
                  .add("bytes", asked.scene.statistics().bytes)
                  .add("bytes_made_first", first.scene.statistics().bytes)
                  .add("signs", signs_asked)
                  .add("signs_beyond_doubles", signs_beyond)
                  .add("ns", std::uint64_t(asked.ns))
                  .add("ns_made_first", std::uint64_t(first.ns))
                  .add_origin(options.seed));
    if (frame % 10 == 0 || frame + 1 == frames)
      std::printf("%6zu %7zu %6zu %8.2f%% %8.2f%% %8.2f%% %10lu %10lu %9.1f %9.1f\n", frame, pairs.size(), made.count,
                  share(made.nodes, all.nodes), share(made.bytes, all.bytes),
                  share(asked.scene.statistics().bytes, first.scene.statistics().bytes), signs_asked, signs_beyond,
                  asked.ns / 1e6, first.ns / 1e6);
  }
  std::fflush(stdout);
  write_whole(options.out / "demand.csv", table.text());
}

}  // namespace tetracone::experiments
