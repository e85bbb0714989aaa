#include "experiments/report/method_figures.h"

#include "experiments/support/experiment.h"
#include "experiments/viewer/view_data.h"
#include "tetracone/tetratree/paper/tetra_tree.h"
#include "verify/cases/shape_generators.h"

#include <nlohmann/json.hpp>

namespace tetracone::experiments {
namespace {

using covering::Index;
using kernel::Pose;
using Tree = tetratree::Tetra_tree<kernel::Adaptive>;
using Json = nlohmann::ordered_json;

/// The image of the model by a point, 0.8 radii from V0 towards the vertex that is farthest from it. Both reach beyond
/// the point, and neither hull holds the other's V0.
Pose facing(const Tree& tree)
{
  const auto& origin = tree.origin();
  const auto difference = [&](const kernel::Vertex& v) {
    return std::array{v[0] - origin[0], v[1] - origin[1], v[2] - origin[2]};
  };
  const auto length = [&](const kernel::Vertex& v) {
    const auto d = difference(v);
    return std::hypot(d[0], d[1], d[2]);
  };
  const auto& vertices = tree.model().vertices();
  const auto reach = difference(*std::ranges::max_element(vertices, {}, length));
  std::array<double, 12> entries{-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0};
  for (int k = 0; k < 3; ++k) entries[4 * k + 3] = 2 * (origin[k] + 0.8 * reach[k]);
  return Pose(entries);
}

/// From the octant with most tetrahedra down, always into the child with most: cone and tetrahedra.
Json path_data(const Tree& tree)
{
  Json path = Json::array();
  const auto size = [&](Index n) { return tree.node(n).end - tree.node(n).begin; };
  for (Index n = Tree::root(); !tree.node(n).is_leaf;) {
    const auto& parent = tree.node(n);
    Index largest = parent.first_child;
    for (Index child = parent.first_child; child < parent.first_child + parent.child_count; ++child)
      if (size(child) > size(largest)) largest = child;
    n = largest;
    const auto elements = tree.elements(tree.node(n));
    path.push_back({{"rays", tree.node(n).cone.ray},
                    {"node", n - 1},
                    {"tetrahedra", std::vector<Index>(elements.begin(), elements.end())}});
  }
  return path;
}

}  // namespace

void run_method_figures(const Experiment_options& options)
{
  Model_file body = options.model.empty() ? whole_model("generated", verify::blob(760, 1))
                                          : load_model(options.model.native(), {}, true);
  make_folder(options.out);
  const Tree tree(body.polyhedron(), tetratree::Config());

  View_scene pair, faces;
  pair.bodies = {body, body};
  pair.poses = {{Pose()}, {facing(tree)}};
  faces.bodies = {whole_model("generated", verify::complex_two())};
  faces.poses = {{Pose()}, {Pose()}};
  const Json data = {{"pair", Json::parse(view_data(pair, "adaptive", verify::Method::tree))},
                     {"path", path_data(tree)},
                     {"faces", Json::parse(view_data(faces, "adaptive", verify::Method::tree))}};
  write_whole(options.out / "method.json", data.dump() + "\n");
  draw("draw_method.py", options.out);
}

}  // namespace tetracone::experiments
