#include "tetracone/tetratree/fast/bvh8_descent.h"

#include "tetracone/covering/repair/repair.h"
#include "tetracone/tetratree/query/placed_bvh8.h"
#include "verify/test/support/object_cases.h"
#include "verify/test/support/simd_versions.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

using Stopping = Stop(Pair_stack&, Both_trees&);
using To_leaves = Stop(Pair_stack&, Pair_stack&, Both_trees&, std::vector<Box_ids>&);

/// Goes on; what it finds of leaves it may add.
using Descend = std::function<To_leaves>;

/// A descent that stops at every pair of leaves.
Descend stopping(Stopping* descend)
{
  return
      [=](Pair_stack& stack, Pair_stack&, Both_trees& trees, std::vector<Box_ids>&) { return descend(stack, trees); };
}

/// All versions of both descents.
std::vector<Descend> descend_versions()
{
  std::vector<Descend> all;
  for (Stopping* each : verify::versions_here<Stopping>(TETRACONE_SIMD_VERSIONS(descend_simd)))
    all.push_back(stopping(each));
  for (To_leaves* each : verify::versions_here<To_leaves>(TETRACONE_SIMD_VERSIONS(descend_to_leaves_simd)))
    all.push_back(each);
  return all;
}

}  // namespace tetracone::tetratree

BOOST_AUTO_TEST_SUITE(test_bvh8_descent)

using namespace tetracone::tetratree;
namespace covering = tetracone::covering;
namespace kernel = tetracone::kernel;
using namespace tetracone::verify::scenes;

namespace {

using Pairs = std::set<std::pair<const Element*, const Element*>>;

struct Descended {
  Pairs offered;
  std::size_t repeated = 0, made = 0;
  Both_trees trees;
};

/// All pairs of leaves that a whole descent offers.
Descended descended(const Descend& descend, Placed_bvh8<>& a, Placed_bvh8<>& b)
{
  const double factor = a.into_other.frame().scale();
  const float scale = factor >= 0x1p-60 && factor <= 0x1p60 ? float(factor) : 1;
  Descended result{{}, 0, 0, {{a.tree->nodes(), b.tree->nodes()}, {&a.into_other, &b.into_other}, scale}};
  Pair_stack stack, next;
  stack.push({}, a.size() * scale, b.size());
  std::vector<Box_ids> leaves;
  for (Stop stop; (stop = descend(stack, next, result.trees, leaves)) != Stop::nothing_left;) {
    if (stop == Stop::leaves) {
      leaves.push_back(stack.boxes());
      stack.pop();
      continue;
    }
    const bool first = first_is_larger(stack.size(0), stack.size(1));
    (first ? a : b).tree->child(stack.box(first ? 0 : 1));
    ++result.made;
    result.trees.nodes[0] = a.tree->nodes();
    result.trees.nodes[1] = b.tree->nodes();
  }
  for (const auto& [box_a, box_b] : leaves)
    if (!result.offered.insert({&a.element(box_a), &b.element(box_b)}).second) ++result.repeated;
  return result;
}

/// All pairs of elements that meet, without a tree.
Pairs meeting(const Polyhedron& p, const Pose& pose_a, Placed_bvh8<>& a, const Polyhedron& q, const Pose& pose_b,
              Placed_bvh8<>& b)
{
  a.placed.place(pose_a);
  b.placed.place(pose_b);
  Pairs pairs;
  std::vector<const Element*> of_a, of_b;
  for (const auto& [body, elements, count] : {std::tuple{&a, &of_a, p.face_count()}, {&b, &of_b, q.face_count()}}) {
    body->tree->make_all();
    for (Index n = 0; n < body->tree->node_count(); ++n)
      for (int lane = 0; lane < body->tree->node(n).boxes.lane_count; ++lane)
        if (body->tree->is_leaf({n, lane})) elements->push_back(&body->tree->element({n, lane}));
    BOOST_TEST(elements->size() == count);
  }
  for (const Element* x : of_a)
    for (const Element* y : of_b)
      if (kernel::triangles_meet<kernel::Adaptive>(a.corners(*x), b.corners(*y))) pairs.insert({x, y});
  return pairs;
}

struct Scene {
  Polyhedron a, b;
  Pose pose_a, pose_b;
};

/// Bodies of triangles, many pairs of which meet, and under one pose touch exactly.
std::vector<Scene> scenes()
{
  Random random(1);
  const std::vector<Polyhedron> bodies = {triangulated(cube(1)),
                                          blob(random, 2, 0.5, 1.5),
                                          blob(random, 3, 1, 1),
                                          triangulated(torus(9, 6)),
                                          random_tetrahedra(random, 12, 3),
                                          tetrahedron({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3})};
  std::vector<Scene> all;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = 0; j < bodies.size(); ++j)
      for (int k = 0; k < 5; ++k) {
        const Pose rotation = random_rotation(random, 4, {1, Rational(1) / 3, 0}), affine = random_affine(random, 2);
        const Pose poses[][2] = {{Pose(), translation(1, 0, 0)},
                                 {rotation, rotation},
                                 {rounded(rotation), random_rotation(random, 3)},
                                 {affine, affine},
                                 {rotation, affine}};
        all.push_back({bodies[i], moved(bodies[j], k == 2 ? 1.0 / 64 : 1), poses[k][0], poses[k][1]});
      }
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_pair_of_leaves_that_meet_is_offered_once)
{
  int missed = 0, met = 0, offered = 0, possible = 0, similar = 0;
  for (const Scene& scene : scenes()) {
    Bvh8 tree_a(scene.a), tree_b(scene.b);
    Placed_bvh8 a(tree_a), b(tree_b);
    a.into_other = kernel::Box_map(scene.pose_b, tree_b.scale(), scene.pose_a, tree_a.scale());
    b.into_other = kernel::Box_map(scene.pose_a, tree_a.scale(), scene.pose_b, tree_b.scale());
    similar += a.into_other.is_similarity();
    const Pairs truth = meeting(scene.a, scene.pose_a, a, scene.b, scene.pose_b, b);
    const Descended with_stops = descended(stopping(&descend), a, b), without = descended(&descend_to_leaves, a, b);
    BOOST_TEST((with_stops.offered == without.offered));
    BOOST_TEST(with_stops.trees.opened == without.trees.opened);
    for (const Descend& descend : descend_versions()) {
      const Descended all = descended(descend, a, b);
      for (const auto& pair : truth) missed += !all.offered.contains(pair);
      met += int(truth.size());
      offered += int(all.offered.size());
      possible += int(tree_a.element_count() * tree_b.element_count());
      BOOST_TEST(all.repeated == 0u);
      BOOST_TEST(all.made == 0u);  // all were there
      BOOST_TEST(all.trees.compared <= 8 * all.trees.opened);
    }
  }
  BOOST_TEST(missed == 0);
  BOOST_TEST(met > 20000);
  BOOST_TEST(offered < possible / 2);
  BOOST_TEST(similar > 50);
  BOOST_TEST(similar < 150);
}

BOOST_AUTO_TEST_CASE(children_that_are_made_on_the_way_change_nothing)
{
  int made = 0, tried = 0;
  for (const Scene& scene : scenes()) {
    if (++tried % 4 != 0) continue;
    Bvh8 lazy_a(scene.a), lazy_b(scene.b);
    Placed_bvh8 a(lazy_a), b(lazy_b);
    a.into_other = kernel::Box_map(scene.pose_b, lazy_b.scale(), scene.pose_a, lazy_a.scale());
    b.into_other = kernel::Box_map(scene.pose_a, lazy_a.scale(), scene.pose_b, lazy_b.scale());
    // An element may change its index while its leaf is not yet made: pairs are compared by corners.
    const auto by_corners = [](const Pairs& pairs) {
      std::vector<std::array<Index, 6>> all;
      for (const auto& [x, y] : pairs)
        all.push_back({x->corner[0], x->corner[1], x->corner[2], y->corner[0], y->corner[1], y->corner[2]});
      std::sort(all.begin(), all.end());
      return all;
    };
    const Descended first = descended(stopping(&descend), a, b);
    made += int(first.made);
    const Descended again = descended(stopping(&descend), a, b);
    BOOST_TEST(again.made == 0u);
    BOOST_TEST((by_corners(first.offered) == by_corners(again.offered)));
    lazy_a.make_all();
    lazy_b.make_all();
    BOOST_TEST((by_corners(descended(stopping(&descend), a, b).offered) == by_corners(first.offered)));
  }
  BOOST_TEST(made > 100);
}

BOOST_AUTO_TEST_CASE(a_pair_of_leaves_is_handed_back_at_once_and_an_empty_stack_too)
{
  Bvh8 tree(polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  Placed_bvh8 a(tree), b(tree);
  a.into_other = b.into_other = kernel::Box_map(Pose(), tree.scale(), Pose(), tree.scale());
  Both_trees trees{{tree.nodes(), tree.nodes()}, {&a.into_other, &b.into_other}, 1};
  Pair_stack stack;
  BOOST_TEST((descend(stack, trees) == Stop::nothing_left));
  stack.push({}, a.size(), b.size());
  BOOST_TEST((descend(stack, trees) == Stop::leaves));
  BOOST_TEST(stack.count() == 1u);
  BOOST_TEST(trees.opened == 0u);
}

BOOST_AUTO_TEST_CASE(the_stack_keeps_pairs_in_order_however_many)
{
  const auto box = [](std::uint32_t number) { return Box_id::from_number(number); };
  Pair_stack stack;
  for (std::uint32_t k = 0; k < 5000; ++k) stack.push({box(k), box(2 * k)}, float(k), -float(k));
  for (std::uint32_t k = 5000; k-- > 0; stack.pop()) {
    BOOST_TEST_REQUIRE(stack.count() == k + 1);
    BOOST_TEST((stack.box(0) == box(k) && stack.box(1) == box(2 * k) && stack.size(0) == float(k) &&
                stack.size(1) == -float(k)));
  }
  BOOST_TEST(stack.empty());
  stack.push({box(1), box(2)}, 3, 4);
  stack.clear();
  BOOST_TEST(stack.empty());
}

BOOST_AUTO_TEST_SUITE_END()
