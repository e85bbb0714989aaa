#include "tetracone/tetratree/paper/tetra_tree.h"

#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tetra_tree)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
using tetracone::covering::Polyhedron;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using rationals::Vector;
using scenes::Random;

namespace {

using Exact_signs = std::tuple<Adaptive, Epick>;

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

bool is_in_cone(const Tetra_cone& cone, const Vector& from_origin)
{
  const auto ray = [&](int k) { return Vector{cone.ray[k % 3][0], cone.ray[k % 3][1], cone.ray[k % 3][2]}; };
  for (int k = 0; k < 3; ++k)
    if (rationals::inner(rationals::outer(ray(k), ray(k + 1)), from_origin) < 0) return false;
  return true;
}

}  // namespace

KERNEL_TEST_CASE(leaves_hold_every_tetrahedron_edge_and_face, K, Exact_signs)
{
  Random random(1);
  for (const auto& [name, body] : bodies()) {
    BOOST_TEST_CONTEXT(name)
    {
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
}

KERNEL_TEST_CASE(nodes_are_cones_in_their_parents_cone_and_depth_and_leaf_size_are_kept, K, Exact_signs)
{
  Random random(2);
  for (const auto& [name, body] : bodies()) {
    BOOST_TEST_CONTEXT(name)
    {
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
}

KERNEL_TEST_CASE(every_point_of_the_surface_is_in_a_leaf_that_holds_its_triangle_and_in_all_bounds_on_the_way, K,
                 Exact_signs)
{
  Random random(3);
  for (const auto& [name, body] : bodies()) {
    BOOST_TEST_CONTEXT(name)
    {
      const Tetra_tree<K> tree(body, random_config(random));
      const auto& triangles = tree.model().covering().triangles();
      const Vector origin = rationals::exactly(tree.model().lattice().origin);
      int lost = 0, out_of_sphere = 0, out_of_tetrahedron = 0;
      for (int n = 0; n < 60; ++n) {
        const Index element = scenes::integer(random, 0, int(triangles.size()) - 1);
        // A rational point of the triangle: now and then on its border.
        const int p = scenes::integer(random, 0, 7), q = scenes::integer(random, 0, 7 - p);
        const std::array<Rational, 3> weight = {Rational(p) / Rational(7), Rational(q) / Rational(7),
                                                Rational(7 - p - q) / Rational(7)};
        Vector y = {0, 0, 0};
        for (int i = 0; i < 3; ++i)
          y = rationals::plus(
              y, rationals::times(weight[i], rationals::exactly(body.vertices[triangles[element].corner[i]])));
        const Vector from_origin = rationals::minus(y, origin);
        // All the way down, in every cone that holds it.
        std::vector<Index> open = {tree.root()};
        bool held = false;
        while (!open.empty()) {
          const auto& node = tree.node(open.back());
          open.pop_back();
          const auto elements = tree.elements(node);
          const bool here = std::find(elements.begin(), elements.end(), element) != elements.end();
          lost += !here;
          const Vector d = rationals::minus(y, rationals::exactly(node.sphere.centre));
          out_of_sphere += rationals::inner(d, d) > Rational(node.sphere.radius) * Rational(node.sphere.radius);
          if (node.level > 0) {
            // On V0's side of V'1 V'2 V'3, which were rounded: by less than the frame's error, that is 8 units of
            // rounding of the reach.
            std::array<Vector, 4> t;
            for (int i = 0; i < 4; ++i) t[i] = rationals::exactly(node.tetrahedron[i]);
            const Vector normal = rationals::outer(rationals::minus(t[2], t[1]), rationals::minus(t[3], t[1]));
            const Rational at = rationals::inner(normal, rationals::minus(y, t[1])),
                           at_v0 = rationals::inner(normal, rationals::minus(t[0], t[1]));
            const Rational scale = abs(normal[0]) + abs(normal[1]) + abs(normal[2]);
            const Rational allowed = scale * Rational(tree.reach()) * Rational(0x1p-48);
            out_of_tetrahedron += at_v0 > 0 ? at < -allowed : at > allowed;
          }
          held = held || node.is_leaf;
          for (Index c = node.first_child; c < node.first_child + node.child_count; ++c)
            if (is_in_cone(tree.node(c).cone, from_origin)) open.push_back(c);
        }
        lost += !held;
      }
      BOOST_TEST(lost == 0);
      BOOST_TEST(out_of_sphere == 0);
      BOOST_TEST(out_of_tetrahedron == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(without_depth_the_tree_is_one_list)
{
  const Polyhedron body = scenes::cube_with_tunnel();
  const Tetra_tree<Adaptive> tree(body, Config::brute());
  BOOST_REQUIRE(tree.node_count() == 1u);
  BOOST_TEST(tree.node(0).is_leaf);
  BOOST_TEST(tree.faces(tree.node(0)).size() == body.face_count());
  BOOST_TEST(tree.edges(tree.node(0)).size() == tree.model().covering().edges().size());
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
    BOOST_TEST_CONTEXT(name)
    {
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
}

BOOST_AUTO_TEST_CASE(the_reach_bounds_every_coordinate)
{
  Random random(6);
  for (const auto& [name, body] : bodies()) {
    BOOST_TEST_CONTEXT(name)
    {
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
}

BOOST_AUTO_TEST_CASE(trees_of_huge_tiny_and_denormal_models_hold_everything)
{
  Random random(7);
  const Polyhedron body = scenes::cube_with_tunnel();
  for (const double scale : {0x1p-1074, 0x1p-1060, 0x1p-600, 0x1p600, 0x1p1021})
    for (int n = 0; n < 4; ++n) {
      Config config = random_config(random);
      config.depth = 3;
      const Tetra_tree<Adaptive> tree(scenes::moved(body, scale), config);
      std::set<Index> faces;
      for (const Index leaf : leaves(tree))
        faces.insert(tree.faces(tree.node(leaf)).begin(), tree.faces(tree.node(leaf)).end());
      BOOST_TEST(faces.size() == body.face_count());
    }
}

using Rounding = std::tuple<Double, Float, Tolerant>;
KERNEL_TEST_CASE(trees_of_rounding_kernels_hold_every_face, K, Rounding)
{
  Random random(8);
  for (const auto& [name, body] : bodies()) {
    if (name == "far blob" || name == "small blob") continue;  // beyond single precision
    BOOST_TEST_CONTEXT(name)
    {
      const Tetra_tree<K> tree(body, random_config(random));
      std::set<Index> faces;
      for (const Index leaf : leaves(tree))
        faces.insert(tree.faces(tree.node(leaf)).begin(), tree.faces(tree.node(leaf)).end());
      BOOST_TEST(faces.size() == body.face_count());
    }
  }
}

// Planted and seen to fail: child 3 never made, leaves_hold_every_tetrahedron_edge_and_face; the third test of the
// classification left out and bounds without slack,
// every_point_of_the_surface_is_in_a_leaf_that_holds_its_triangle_and_in_all_bounds_on_the_way.

BOOST_AUTO_TEST_SUITE_END()
