#include "experiments/speed/experiments.h"

#include "experiments/speed/race_rows.h"

namespace tetracone::experiments {
namespace {

using tetratree::Bvh8_options;
using tetratree::Config;
using tetratree::Cuts;

/// Returns the depth of the paper's default plus `more` levels.
int depth(std::size_t triangles, int more)
{
  return std::max(1, static_cast<int>(std::ceil(std::log2(double(triangles)) / 2)) + more);
}

template <class Change>
Config changed(Config config, Change change)
{
  change(config);
  return config;
}

/// The table `draw_ablation.py` recognises the names by their first word.
std::vector<Contestant> contestants(std::size_t triangles, std::size_t one_in)
{
  const Config as_published, tuned = changed(as_published, [](Config&c) { c.regular_hull = false; });
  std::vector<Contestant> list = {fast(), fast_with_last_frame(), peer("FCL OBBRSS")};
  const auto add = [&](const std::string& name, const Config& config) {
    list.push_back(paper(name, config).every(one_in));
  };

  // Steps from the listing to the fast tree; each step keeps the steps before.
  Config config = as_published;
  config.descent = tetratree::Descent::both;
  add("step 1 listing of the appendix", config);
  config.descent = tetratree::Descent::larger_first;
  add("step 2 larger node first", config);
  config.regular_hull = false;
  add("step 3 without Theorem 2", config);
  config.sphere_centre = tetratree::Sphere_centre::improved;
  add("step 4 smaller spheres", config);
  config.far_plane = tetratree::Far_plane::tightest;
  add("step 5 tightest far plane", config);
  config.leaf_boxes = true;
  add("step 6 boxes in leaves", config);
  list.push_back(paper_adaptive("step 7 exact signs", config).every(one_in));
  config.boxes = true;
  config.spheres = config.tetrahedra = false;
  list.push_back(paper_adaptive("step 8 boxes for spheres and tetrahedra", config).every(one_in));
  // A node of octants has eight parts and a tetra-cone four; so do the nodes that are cut first.
  list.push_back(fast_as_chosen("step 9 each element in one cone", {.cuts = Cuts::tetra_cones, .leaf_size = 8}));
  list.push_back(
      fast_as_chosen("step 10 cuts through the origin", {.cuts = Cuts::through_origin, .parts = 4, .leaf_size = 8}));
  list.push_back(fast_as_chosen("step 11 principal axes too", {.parts = 4, .leaf_size = 8}));
  list.push_back(fast_as_chosen("step 12 one element a leaf", {.parts = 4}));
  list.push_back(fast_as_chosen("step 13 eight a node", {}));

  // The fast tree with one choice changed at a time.
  const auto add_fast = [&](const std::string& name, const Bvh8_options& options) {
    list.push_back(fast_as_chosen("fast " + name, options));
  };
  add_fast("with octants and four cones each", {.cuts = Cuts::tetra_cones});
  add_fast("with cuts through the origin", {.cuts = Cuts::through_origin});
  add_fast("with principal axes alone", {.cuts = Cuts::principal});
  add_fast("with two a node", {.parts = 2});
  add_fast("with four a node", {.parts = 4});
  add_fast("with two elements a leaf", {.leaf_size = 2});
  add_fast("with eight elements a leaf", {.leaf_size = 8});

  // The paper's tree with one choice changed at a time. Two of them are thousands of times slower.
  const std::size_t rare = 5;
  add("without spheres", changed(as_published, [](Config& c) { c.spheres = false; }));
  list.push_back(
      paper("without tetrahedra", changed(as_published, [](Config& c) { c.tetrahedra = false; })).every(one_in * rare));
  add("without Theorem 2", changed(as_published, [](Config& c) { c.regular_hull = false; }));
  add("with 8 axes instead of 44", changed(as_published, [](Config& c) { c.all_axes = false; }));
  add("with both nodes descended", changed(as_published, [](Config& c) { c.descent = tetratree::Descent::both; }));
  list.push_back(
      paper("with one cone level", changed(as_published, [](Config& c) { c.depth = 1; })).every(one_in * rare));
  add("with smaller spheres",
      changed(as_published, [](Config& c) { c.sphere_centre = tetratree::Sphere_centre::improved; }));
  add("with boxes for spheres and tetrahedra", changed(as_published, [](Config& c) {
        c.boxes = true;
        c.spheres = c.tetrahedra = false;
      }));
  add("with the tightest far plane",
      changed(as_published, [](Config& c) { c.far_plane = tetratree::Far_plane::tightest; }));
  add("with boxes in leaves", changed(as_published, [](Config& c) { c.leaf_boxes = true; }));

  // These vary the paper's own parameters.
  for (const std::size_t leaf_size : {2, 4, 8, 16})
    for (const int more : {-1, 0, 1})
      add("tuned leaf " + std::to_string(leaf_size) + " depth " + (more > 0 ? "+" : "") + std::to_string(more),
          changed(tuned, [&](Config& c) {
            c.leaf_size = leaf_size;
            c.depth = depth(triangles, more);
          }));
  return list;
}

}  // namespace

void run_ablation(const Experiment_options& options)
{
  constexpr int passes = 5;
  const auto objects = std::make_shared<Race_objects>(options.models);
  std::vector<Table_part> parts;
  // Without tetrahedra, one pose of 7172 triangles takes 6 to 20 s, which is too long for short runs.
  const std::size_t many = options.seconds_or(0.1) < 0.1 ? 3000 : 7172;
  for (const auto& [triangles, names] :
       {std::pair<std::size_t, std::vector<std::string>>{760, {"blob", "bunny"}}, {many, {"camel", "knot2"}}})
    for (const std::string& name : names)
      for (const std::string trajectory : {"circular", "contour"}) {
        const bool large = triangles > 2000;
        const std::uint64_t seed = options.seed + 1000 * parts.size();
        const std::size_t one_in = large && !options.full ? 20 : 1;
        const double seconds = large ? 0.1 : 0.2;
        parts.push_back(
            {trajectory + "-" + name + "-" + std::to_string(triangles), [=, triangles = triangles] {
               const Race_course course =
                   on_trajectory((*objects)(name, triangles), name, trajectory, 1, options.race_frames, seed);
               return race_rows(course, contestants(course.a.face_count(), one_in), false, passes, seconds, options);
             }});
      }
  write_table(options.out, "ablation", parts);
  draw("draw_ablation.py", options.out);
}

}  // namespace tetracone::experiments
