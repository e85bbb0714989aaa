#include "experiments/scenes/experiments.h"

#include "experiments/peers/scene_peer.h"
#include "experiments/scenes/scene_workload.h"
#include "experiments/support/extent.h"
#include "tetracone/tetratree/scene/scene.h"
#include "verify/truth/cgal_truth.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>

#include <map>

namespace tetracone::experiments {
namespace {

using Pair = Scene_peer::Pair;
using Pairs = std::vector<Pair>;
using kernel::Pose;

/// One who tells the colliding pairs of a frame.
struct Scene_contestant {
  std::string name;
  std::function<Pairs(const std::vector<Pose>&)> frame;
  std::function<std::size_t()> candidates;

  std::vector<double> ns = {};
  std::size_t candidate_count = 0, pair_count = 0, lost = 0, invented = 0, judged = 0;
};

Scene_contestant ours(const std::string& name, const Scene_workload& work, const std::vector<Body>& bodies,
                      std::size_t threads)
{
  const auto scene = std::make_shared<Scene>(Scene_options{.question = Question::surface, .threads = threads});
  for (const Body& body : bodies) scene->add_model(body);
  for (const std::size_t model : work.model_of) scene->add_body(model);
  return {name,
          [scene](const std::vector<Pose>& poses) {
            for (std::size_t k = 0; k < poses.size(); ++k) scene->place(k, poses[k]);
            Pairs pairs;
            for (const Scene_pair& pair : scene->pairs())
              pairs.push_back({std::uint32_t(pair.a), std::uint32_t(pair.b)});
            return pairs;
          },
          [scene] { return scene->statistics().candidates; }};
}

/// Boxes of the turned boxes of models, a little too large, by CGAL; what they let through, by our queries.
class Boxes_of_cgal {
 public:
  Boxes_of_cgal(const Scene_workload& work, const std::vector<Body>& bodies) : work_(work), bodies_(bodies)
  {
    for (const Body& body : bodies) boxes_.push_back(extent_of(body.polyhedron()));
  }

  Pairs frame(const std::vector<Pose>& poses)
  {
    std::vector<Box> boxes;
    boxes.reserve(poses.size());
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const Extent& extent = boxes_[work_.model_of[k]];
      std::array<double, 3> low, high;
      for (int i = 0; i < 3; ++i) {
        double at = poses[k][4 * i + 3], reach = 0;
        for (int j = 0; j < 3; ++j) {
          at += poses[k][4 * i + j] * ((extent.low[j] + extent.high[j]) / 2);
          reach += std::abs(poses[k][4 * i + j]) * ((extent.high[j] - extent.low[j]) / 2);
        }
        low[i] = at - reach * (1 + 1e-9);
        high[i] = at + reach * (1 + 1e-9);
      }
      boxes.emplace_back(CGAL::Bbox_3(low[0], low[1], low[2], high[0], high[1], high[2]), std::uint32_t(k));
    }
    candidates_ = 0;
    Pairs found;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& x, const Box& y) {
      ++candidates_;
      const auto [a, b] = std::minmax({x.info(), y.info()});
      const std::size_t of_a = work_.model_of[a], of_b = work_.model_of[b];
      auto& query = queries_[{of_a, of_b}];
      if (!query) query.emplace(bodies_[of_a], bodies_[of_b], Question::surface);
      if (query->collide(poses[a], poses[b])) found.push_back({a, b});
    });
    return found;
  }
  std::size_t candidates() const { return candidates_; }

 private:
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
  const Scene_workload& work_;
  std::vector<Body> bodies_;
  std::vector<Extent> boxes_;
  std::map<std::pair<std::size_t, std::size_t>, std::optional<Query>> queries_;
  std::size_t candidates_ = 0;
};

/// True when pairs with this lesser body are judged: all of them up to 10,000 bodies, else one body in ten.
bool is_judged(std::uint32_t lesser_body, std::size_t bodies) { return bodies <= 10000 || lesser_body % 10 == 0; }

/// Every pair that is judged and whose outward-rounded boxes meet is decided in rationals where intervals are not
/// certain.
Pairs truth(const std::vector<verify::Brute_body>& models, const Scene_workload& work, const std::vector<Pose>& poses)
{
  std::vector<std::optional<verify::Placed_body>> placed(poses.size());
  std::vector<CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>> boxes;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    placed[k].emplace(models[work.model_of[k]], poses[k]);
    boxes.emplace_back(placed[k]->whole_box(), k);
  }
  Pairs near;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const auto& x, const auto& y) {
    const auto [a, b] = std::minmax({x.info(), y.info()});
    if (is_judged(std::uint32_t(a), poses.size())) near.push_back({std::uint32_t(a), std::uint32_t(b)});
  });
  std::vector<char> meet(near.size());
  for (std::size_t k = 0; k < near.size(); ++k)
    meet[k] = verify::detail::surfaces_meet(*placed[near[k][0]], *placed[near[k][1]]);
  Pairs pairs;
  for (std::size_t k = 0; k < near.size(); ++k)
    if (meet[k]) pairs.push_back(near[k]);
  std::ranges::sort(pairs);
  return pairs;
}

std::vector<Scene_contestant> contestants(const Scene_workload& work, const std::vector<Body>& bodies)
{
  std::vector<Scene_contestant> all = {ours("tetracone", work, bodies, 1),
                                       ours("tetracone, 2 threads", work, bodies, 2)};
  const auto boxes = std::make_shared<Boxes_of_cgal>(work, bodies);
  all.push_back({"CGAL boxes, our queries", [boxes](const auto& poses) { return boxes->frame(poses); },
                 [boxes] { return boxes->candidates(); }});
  std::vector<Peer_mesh> meshes;
  for (const Polyhedron& model : work.models) meshes.push_back(*peer_mesh(model));
  for (const Scene_library& library : scene_libraries()) {
    const std::shared_ptr<Scene_peer> peer = library.prepare(meshes, work.model_of);
    if (peer)
      all.push_back({library.name, [peer](const auto& poses) { return peer->frame(poses); },
                     [peer] { return peer->candidates(); }});
  }
  return all;
}

/// The number of frames for scenes of more than 10,000 bodies.
constexpr std::size_t frames_of_many = 5;

/// The mean of all frames but the first, which makes things ready.
double mean(const std::vector<double>& ns) { return mean_of({ns.begin() + 1, ns.end()}); }

void run_scene(const Scene_workload& work, Csv_table& table, std::uint64_t seed)
{
  std::vector<Body> bodies;
  std::vector<verify::Brute_body> brute;
  for (const Polyhedron& model : work.models) {
    bodies.emplace_back(model);
    brute.emplace_back(model);
  }
  const std::size_t n = work.model_of.size(), frames = work.frames.size();
  std::vector<std::optional<Pairs>> right(frames);  // of frames that are judged
  for (std::size_t frame = 0; frame < frames; ++frame)
    if (n <= 1000 || frame + 1 == frames) right[frame] = truth(brute, work, work.frames[frame]);
  // Each plays alone, as in a program: who comes after another would find the caches full of that one's.
  auto all = contestants(work, bodies);
  for (Scene_contestant& each : all)
    for (std::size_t frame = 0; frame < frames; ++frame) {
      const Stopwatch watch;
      Pairs pairs = each.frame(work.frames[frame]);
      each.ns.push_back(watch.nanoseconds());
      if (frame > 0) each.candidate_count += each.candidates();
      if (!right[frame]) continue;
      std::erase_if(pairs, [n](const Pair& pair) { return !is_judged(pair[0], n); });
      std::ranges::sort(pairs);
      each.pair_count += pairs.size();
      each.judged += right[frame]->size();
      each.lost += missing(pairs, *right[frame]);
      each.invented += missing(*right[frame], pairs);
    }
  for (const Scene_contestant& each : all) {
    const double us = mean(each.ns) / 1000, ratio = mean(each.ns) / mean(all[0].ns);
    table.add(Csv_row()
                  .add("scene", work.kind)
                  .add("model", work.kind == "thin" ? "rods" : work.model)
                  .add("triangles", work.models[0].face_count())
                  .add("bodies", n)
                  .add("method", each.name)
                  .add("frames", frames)
                  .add_exact("us_a_frame", us)
                  .add_exact("us_first_frame", each.ns[0] / 1000)
                  .add_exact("ratio", ratio)
                  .add("candidates", double(each.candidate_count) / double(frames - 1))
                  .add("pairs_judged", each.judged)
                  .add("lost", each.lost)
                  .add("invented", each.invented)
                  .add_origin(seed));
    std::printf("%-9s %-7s %7zu %-26s %11.1f %11.1f %9.2f %10.0f %8zu %6zu %8zu\n", work.kind.c_str(),
                work.kind == "thin" ? "rods" : work.model.c_str(), n, each.name.c_str(), us, each.ns[0] / 1000, ratio,
                double(each.candidate_count) / double(frames - 1), each.judged, each.lost, each.invented);
  }
  std::fflush(stdout);
}

}  // namespace

void run_scenes(const Experiment_options& options)
{
  const auto frames = std::size_t(std::max(2, options.race_frames / 20));
  Csv_table table;
  std::printf("%-9s %-7s %7s %-26s %11s %11s %9s %10s %8s %6s %8s\n", "scene", "model", "bodies", "method",
              "us a frame", "first us", "ratio", "candidates", "pairs", "lost", "invented");
  const auto run = [&](const char* kind, const char* model, std::size_t bodies) {
    const std::size_t of_these = bodies <= 10000 ? frames : std::min(frames, frames_of_many);
    run_scene(scene_workload(kind, model, bodies, of_these, options.seed), table, options.seed);
    write_whole(options.out / "scenes.csv", table.text());
  };
  for (const char* kind : {"brownian", "fall", "gravity", "resting"}) {
    run(kind, "convex", 1000);
    run(kind, "blob", 1000);
    run(kind, "convex", 10000);
    if (options.full) {
      run(kind, "large", 1000);
      run(kind, "blob", 10000);
      run(kind, "convex", 100000);
    }
  }
  for (const std::size_t bodies : {1000, 10000, 100000})
    if (bodies <= 10000 || options.full) run("thin", "", bodies);
}

}  // namespace tetracone::experiments
