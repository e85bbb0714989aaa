#include "tetracone/tetratree/query/placed_bvh8.h"

#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(test_placed_bvh8)

using namespace tetracone::tetratree;
namespace kernel = tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
using namespace tetracone::verify::scenes;

BOOST_AUTO_TEST_CASE(size_is_that_of_the_root_and_negative_where_it_is_a_leaf)
{
  Polyhedron one;
  one.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.add_polygon({0, 1, 2});
  Bvh8 triangle(one), cube(unit_cube());
  BOOST_TEST(Placed_bvh8(triangle).size() < 0);
  const auto& extent = cube.node(0).boxes.extent;
  BOOST_TEST(Placed_bvh8(cube).size() == extent[0][0] + extent[1][0] + extent[2][0]);
  BOOST_TEST(Placed_bvh8(cube).size() > 0);
}

BOOST_AUTO_TEST_CASE(a_box_is_a_lane_of_a_node_and_its_element_the_leaf_there)
{
  Random random(1);
  Bvh8 tree(blob(random, 3, 1, 2));
  tree.make_all();
  Placed_bvh8 body(tree);
  for (Index n = 0; n < tree.node_count(); ++n)
    for (int lane = 0; lane < tree.node(n).boxes.lane_count; ++lane)
      if (const Box_id box(n, lane); tree.is_leaf(box)) BOOST_TEST(&body.element(box) == &tree.element(box));
}

BOOST_AUTO_TEST_CASE(corners_are_the_placed_vertices)
{
  Random random(2);
  const Polyhedron shape = triangulated(unit_cube());
  Bvh8 tree(shape);
  Placed_bvh8 body(tree);
  const Pose pose = random_rotation(random, 5, {1, 2, 3}), identity;
  for (const bool again : {false, true}) {
    if (again)
      body.placed.place(identity);
    else
      body.placed.place(pose);
    for (Index f = 0; f < shape.face_count(); ++f) {
      const auto loop = shape.loop(f, 0);
      const auto corners = body.corners({f, {loop[0], loop[1], loop[2]}});
      for (int k = 0; k < 3; ++k) {
        const auto exact = rationals::image(again ? identity : pose, rationals::exactly(shape.vertices[loop[k]]));
        for (int i = 0; i < 3; ++i)
          BOOST_TEST(std::abs(corners[k]->image[i] - kernel::nearest_double(exact[i])) < 1e-14);
        BOOST_TEST((corners[k]->vertex == shape.vertices[loop[k]]));
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
