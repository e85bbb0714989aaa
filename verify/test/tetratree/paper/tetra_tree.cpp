#include "tetracone/tetratree/paper/tetra_tree.h"

#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tetra_tree)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
namespace scenes = tetracone::verify::scenes;
using scenes::Random;

namespace {

using Exact_signs = std::tuple<Adaptive, Epick>;
using Kernels = std::tuple<Adaptive, Epick, Double, Float, Tolerant>;

Config random_config(Random& random)
{
  Config config;
  config.depth = scenes::integer(random, 0, 5);
  config.leaf_size = scenes::integer(random, 0, 9);
  if (scenes::integer(random, 0, 1) == 0) config.far_plane = Far_plane::tightest;
  if (scenes::integer(random, 0, 1) == 0) config.sphere_centre = Sphere_centre::improved;
  return config;
}

std::vector<scenes::Named> bodies()
{
  auto bodies = scenes::closed_bodies();
  Random random(21);
  bodies.push_back({"blob", scenes::blob(random, 2, 0.5, 1)});
  bodies.push_back({"far blob", scenes::moved(scenes::blob(random, 2, 0.5, 1), 1, {1e6, -1e5, 3})});
  bodies.push_back({"small blob", scenes::moved(scenes::blob(random, 2, 0.1, 1), 1e-100)});
  return bodies;
}

template <class K>
std::set<Index> leaves(const Tetra_tree<K>& tree)
{
  std::set<Index> result;
  for (Index n = 0; n < tree.node_count(); ++n)
    if (tree.node(n).is_leaf) result.insert(n);
  return result;
}

}  // namespace

KERNEL_TEST_CASE(leaves_hold_every_tetrahedron_edge_and_face, K, Kernels)
{
  Random random(1);
  std::vector<scenes::Named> all = bodies();
  for (const double scale : {0x1p-1074, 0x1p-1060, 0x1p-600, 0x1p600, 0x1p1021})
    all.push_back({"scaled blob", scenes::moved(scenes::cube_with_tunnel(), scale)});
  for (const auto& [name, body] : all) {
    if (name.ends_with(" blob") && !Kernel_traits<K>::exact_signs) continue;  // beyond single precision
    BOOST_TEST_INFO_SCOPE(name);
    for (int n = 0; n < 4; ++n) {
      const Tetra_tree<K> tree(body, random_config(random));
      std::set<Index> elements, edges, faces;
      for (const Index leaf : leaves(tree)) {
        const auto& node = tree.node(leaf);
        elements.insert(tree.elements(node).begin(), tree.elements(node).end());
        edges.insert(tree.edges(node).begin(), tree.edges(node).end());
        faces.insert(tree.faces(node).begin(), tree.faces(node).end());
        // Each once, and exactly those of the leaf's own tetrahedra.
        std::set<Index> own_edges, own_faces;
        for (const Index element : tree.elements(node)) {
          const auto& triangle = tree.model().covering().triangles()[element];
          own_faces.insert(triangle.face);
          for (const Index edge : triangle.edge)
            if (edge != tetracone::covering::none) own_edges.insert(edge);
        }
        BOOST_TEST(own_edges.size() == tree.edges(node).size());
        BOOST_TEST(own_faces.size() == tree.faces(node).size());
        BOOST_TEST((own_edges == std::set<Index>(tree.edges(node).begin(), tree.edges(node).end())));
        BOOST_TEST((own_faces == std::set<Index>(tree.faces(node).begin(), tree.faces(node).end())));
      }
      BOOST_TEST(elements.size() == tree.model().covering().triangles().size());
      BOOST_TEST(edges.size() == tree.model().covering().edges().size());
      BOOST_TEST(faces.size() == body.face_count());
    }
  }
}

KERNEL_TEST_CASE(nodes_are_cones_in_their_parents_cone_and_depth_and_leaf_size_are_kept, K, Exact_signs)
{
  Random random(2);
  for (const auto& [name, body] : bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    const Config config = random_config(random);
    const Tetra_tree<K> tree(body, config);
    BOOST_TEST(tree.config().depth == config.depth);
    BOOST_TEST(tree.bytes() > 0u);
    std::size_t reached = 1;
    int wrong = 0;
    for (Index n = 0; n < tree.node_count(); ++n) {
      const auto& node = tree.node(n);
      const std::size_t size = tree.elements(node).size();
      wrong += node.level > config.depth || size == 0;
      if (n != tree.root()) wrong += node.is_leaf != (node.level == config.depth || size <= config.leaf_size);
      wrong += node.is_leaf && node.child_count != 0;
      if (node.is_leaf) continue;
      wrong += !node.has_children;
      reached += node.child_count;
      std::set<Index> in_children;
      for (Index c = node.first_child; c < node.first_child + node.child_count; ++c) {
        const auto& child = tree.node(c);
        wrong += child.level != node.level + 1;
        bool own = false;
        for (int k = 0; k < (node.level == 0 ? 8 : 4); ++k)
          own = own || child.cone.ray == (node.level == 0 ? Tetra_cone::octant(k) : node.cone.child(k)).ray;
        wrong += !own;
        for (const Index element : tree.elements(child)) {
          in_children.insert(element);
          wrong += std::count(tree.elements(node).begin(), tree.elements(node).end(), element) != 1;
        }
      }
      if (node.level == 0) wrong += in_children.size() != size;
    }
    BOOST_TEST(wrong == 0);
    BOOST_TEST(reached == tree.node_count());
  }
}

BOOST_AUTO_TEST_CASE(the_depth_follows_the_size_and_is_kept_within_the_lattice)
{
  Random random(4);
  BOOST_TEST((Tetra_tree<Adaptive>(scenes::unit_cube()).config().depth == 2));              // 12 tetrahedra
  BOOST_TEST((Tetra_tree<Adaptive>(scenes::blob(random, 3, 0.9, 1)).config().depth == 5));  // 512: 4^4.5
  Config deep;
  deep.depth = 99;
  deep.leaf_size = 4;
  BOOST_TEST((Tetra_tree<Adaptive>(scenes::unit_cube(), deep).config().depth == max_cone_depth));
}

BOOST_AUTO_TEST_CASE(on_demand_makes_only_nodes_asked_for_and_the_same_as_all_at_once)
{
  Random random(5);
  for (const auto& [name, body] : bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    Config config = random_config(random);
    config.depth = 4;
    Tetra_tree<Adaptive> whole(body, config);
    config.on_demand = true;
    Tetra_tree<Adaptive> lazy(body, config);
    BOOST_TEST(lazy.node_count() == 1u);
    lazy.with_children(lazy.root());
    BOOST_TEST(lazy.node_count() == 1 + whole.node(0).child_count);
    lazy.with_children(lazy.root());
    BOOST_TEST(lazy.node_count() == 1 + whole.node(0).child_count);

    // Depth first, another order than the whole tree's.
    std::vector<std::pair<Index, Index>> open = {{0, 0}};
    int wrong = 0;
    while (!open.empty()) {
      const auto [n, m] = open.back();
      open.pop_back();
      const auto a = whole.node(n);
      const auto b = lazy.node(m).is_leaf ? lazy.node(m) : lazy.with_children(m);
      wrong += a.cone.ray != b.cone.ray || a.is_leaf != b.is_leaf || a.child_count != b.child_count ||
               a.tetrahedron != b.tetrahedron || a.sphere.radius != b.sphere.radius;
      const auto same = [](auto x, auto y) { return std::equal(x.begin(), x.end(), y.begin(), y.end()); };
      wrong += !same(whole.elements(a), lazy.elements(b));
      wrong += !same(whole.edges(a), lazy.edges(b)) || !same(whole.faces(a), lazy.faces(b));
      for (Index c = 0; c < a.child_count && c < b.child_count; ++c)
        open.push_back({a.first_child + c, b.first_child + c});
    }
    BOOST_TEST(wrong == 0);
    BOOST_TEST(lazy.node_count() == whole.node_count());
  }
}

BOOST_AUTO_TEST_CASE(the_reach_bounds_every_coordinate)
{
  Random random(6);
  for (const auto& [name, body] : bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    Config config = random_config(random);
    const Tetra_tree<Adaptive> tree(body, config);
    int wrong = 0;
    for (const Vertex& v : body.vertices)
      for (const double x : v) wrong += std::abs(x) > tree.reach();
    for (Index n = 1; n < tree.node_count(); ++n)
      for (const auto& v : tree.node(n).tetrahedron)
        for (const double x : v) wrong += std::abs(x) > tree.reach();
    BOOST_TEST(wrong == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
