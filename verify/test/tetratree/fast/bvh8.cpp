#include "tetracone/tetratree/fast/bvh8.h"

#include "tetracone/covering/repair/repair.h"
#include "verify/test/support/object_cases.h"
#include "verify/test/support/placed_boxes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <functional>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bvh8)

using namespace tetracone::tetratree;
namespace covering = tetracone::covering;
namespace kernel = tetracone::kernel;
using namespace tetracone::verify::scenes;

namespace {

std::vector<Polyhedron> bodies()
{
  Random random(1);
  return {unit_cube(),
          cube_with_cavity(),
          cube_with_tunnel(),
          star_prism(),
          blob(random, 4, 0.5, 1.5),
          random_tetrahedra(random, 30, 9),
          moved(unit_cube(), 0x1p-200),
          moved(unit_cube(), 1, {0x1p40, 0, 0}),
          polygon({{1, 2, 3}})};
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_element_is_in_one_leaf_and_in_all_boxes_above_it)
{
  const Bvh8_options choices[] = {
      {}, {Cuts::tetra_cones, 8, 1}, {Cuts::tetra_cones, 8, 3}, {Cuts::through_origin, 4, 1}, {Cuts::principal, 2, 5}};
  for (const Polyhedron& body : bodies())
    for (const Bvh8_options& options : choices) {
      const auto triangles = options.leaf_size > 1 || &options == &choices[1] ? covering::triangulate_faces(body)
                                                                              : std::vector<covering::Face_triangle>();
      Bvh8 tree(body, triangles, options);
      std::size_t leaves = 0;
      std::size_t outside = 0;
      // The elements under a lane are checked against its box, and each leaf is counted.
      const std::function<std::vector<Index>(Index, int)> visit = [&](Index n, int lane) {
        std::vector<Index> corners;
        if (tree.is_leaf({n, lane})) {
          leaves += tree.leaf_count({n, lane});
          BOOST_TEST(tree.leaf_count({n, lane}) <= options.leaf_size);
          for (Index k = 0; k < tree.leaf_count({n, lane}); ++k)
            tree.for_vertices(tree.element({n, lane}, k), [&](Index v) { corners.push_back(v); });
        } else {
          const Index child = tree.child({n, lane});
          BOOST_TEST(std::size_t(tree.node(child).boxes.lane_count) <= options.parts);
          for (int k = 0; k < tree.node(child).boxes.lane_count; ++k)
            for (const Index v : visit(child, k)) corners.push_back(v);
        }
        const Bvh8_node& node = tree.node(n);
        kernel::Matrix axes;
        kernel::Vector centre;
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) axes(j, i) = node.boxes.axis[i][j][lane];
          centre[i] = double(node.boxes.centre[i][lane]) + double(node.boxes.origin[i]);
        }
        for (const Index v : corners) {
          const auto& vertex = tree.model().vertices()[v];
          kernel::Vector p;
          for (int i = 0; i < 3; ++i) p[i] = (vertex[i] - tree.scale().origin[i]) / tree.scale().unit;
          const kernel::Vector s = solved(axes, p - centre);
          for (int i = 0; i < 3; ++i) outside += std::abs(s[i]) > double(node.boxes.extent[i][lane]) + 1e-15;
          outside += p.norm_infinity() > 1;
        }
        return corners;
      };
      std::size_t corner_count = visit(0, 0).size();
      BOOST_TEST(outside == 0u);
      BOOST_TEST(leaves == tree.element_count());
      std::size_t expected = 3 * triangles.size();
      std::vector<bool> has(body.face_count(), false);
      for (const auto& t : triangles) has[t.face] = true;
      for (Index f = 0; f < body.face_count(); ++f)
        if (!has[f]) expected += tree.model().covering().from(f).size();
      BOOST_TEST(corner_count == expected);
    }
}

BOOST_AUTO_TEST_CASE(the_reach_of_a_node_is_that_of_its_farthest_box)
{
  for (const Polyhedron& body : bodies()) {
    Bvh8 tree(body);
    tree.make_all();
    int too_short = 0, too_long = 0;
    for (Index n = 0; n < tree.node_count(); ++n) {
      const kernel::Obb8& boxes = tree.node(n).boxes;
      double reach = 0;
      for (int lane = 0; lane < tree.node(n).boxes.lane_count; ++lane)
        reach = kernel::maximum(
            reach,
            std::hypot(double(boxes.centre[0][lane]), double(boxes.centre[1][lane]), double(boxes.centre[2][lane])) +
                double(boxes.extent[0][lane]) + boxes.extent[1][lane] + boxes.extent[2][lane]);
      too_short += boxes.reach < reach;
      too_long += boxes.reach > 1.000001 * reach;
    }
    BOOST_TEST(too_short == 0);
    BOOST_TEST(too_long == 0);
  }
}

BOOST_AUTO_TEST_CASE(nodes_are_made_when_they_are_entered)
{
  Random random(2);
  const Polyhedron body = blob(random, 4, 0.5, 1.5);
  Bvh8 lazy(body), whole(body);
  BOOST_TEST(lazy.node_count() == 1u);
  whole.make_all();
  const std::size_t all = whole.node_count();
  BOOST_TEST(all > body.face_count() / 8);
  whole.make_all();
  BOOST_TEST(whole.node_count() == all);
  lazy.child({});
  BOOST_TEST(lazy.node_count() == 2u);
  BOOST_TEST(lazy.child({}) == 1u);
  BOOST_TEST(lazy.node_count() == 2u);
  BOOST_TEST(whole.bytes() < 400 * body.face_count());
}

BOOST_AUTO_TEST_CASE(cuts_are_counted_by_their_kind)
{
  Random random(3);
  const Polyhedron body = blob(random, 4, 0.5, 1.5);
  const auto cuts = [&](Cuts kind) {
    Bvh8 tree(body, {}, {.cuts = kind});
    tree.make_all();
    return tree.cuts();
  };
  const Cut_counts cheapest = cuts(Cuts::least_cost), principal = cuts(Cuts::principal),
                   cones = cuts(Cuts::tetra_cones), origin = cuts(Cuts::through_origin);
  BOOST_TEST(cheapest.all > body.face_count() / 4);
  BOOST_TEST(cheapest.tried_cones < cheapest.all);  // small parts are not worth it
  BOOST_TEST(cheapest.through_origin <= cheapest.tried_cones);
  BOOST_TEST(cheapest.through_origin > 0u);
  BOOST_TEST(principal.tried_cones == 0u);
  BOOST_TEST(cones.all == 0u);
  BOOST_TEST(origin.through_origin == origin.tried_cones);
  BOOST_TEST(origin.through_origin > cheapest.through_origin);
}

BOOST_AUTO_TEST_CASE(a_body_without_faces_is_empty) { BOOST_TEST(Bvh8(Polyhedron()).empty()); }

namespace {

/// Nodes on the longest way down.
int depth_of(Bvh8& tree, Index n)
{
  int deepest = 0;
  for (int lane = 0; lane < tree.node(n).boxes.lane_count; ++lane)
    if (!tree.is_leaf({n, lane})) deepest = std::max(deepest, depth_of(tree, tree.child({n, lane})));
  return deepest + 1;
}

}  // namespace

BOOST_AUTO_TEST_CASE(trees_are_shallow_whatever_lies_where)
{
  Random random(8);
  constexpr int count = 3000;
  Polyhedron everywhere, halving, stacked;
  for (int k = 0; k < count; ++k) {
    // Each as large as the whole; each half the size of the last; all in one place.
    for (auto* body : {&everywhere, &halving, &stacked}) {
      const Index first = Index(body->vertices.size());
      const double size = body == &halving ? std::ldexp(1.0, -k / 4) : 1;
      for (int corner = 0; corner < 3; ++corner)
        body->vertices.push_back({size * real(random, -1, 1), size * real(random, -1, 1), size * real(random, -1, 1)});
      if (body == &stacked) body->vertices.resize(3);
      const Index base = body == &stacked ? 0 : first;
      body->add_polygon({base, base + 1, base + 2});
    }
  }
  for (const Polyhedron* body : {&everywhere, &halving, &stacked}) {
    Bvh8 tree(*body);
    tree.make_all();
    BOOST_TEST(tree.element_count() == std::size_t(count));
    const int depth = depth_of(tree, 0);
    BOOST_TEST(depth <= 30);  // 7/8 to the 60th of them is one
  }
}

BOOST_AUTO_TEST_SUITE_END()
