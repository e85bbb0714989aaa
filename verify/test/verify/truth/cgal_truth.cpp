#include "verify/truth/cgal_truth.h"

#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_cgal_truth)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;

BOOST_AUTO_TEST_CASE(an_open_surface_has_no_solid)
{
  Polyhedron open;
  open.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  open.add_polygon({0, 1, 2});
  const Brute_body triangle(open), solid(cube(2));
  BOOST_CHECK_THROW(collide(triangle, Pose(), solid, Pose()), std::invalid_argument);
  BOOST_CHECK_THROW(collide(solid, Pose(), triangle, Pose()), std::invalid_argument);
  BOOST_CHECK_THROW(inside(triangle, {0, 0, 1}), std::invalid_argument);
  BOOST_TEST(!collide(triangle, Pose(), solid, Pose(), Question::surface));
  BOOST_TEST(collide(triangle, translation(1.5, 0, 0), solid, Pose(), Question::surface));
}

BOOST_AUTO_TEST_CASE(points_are_inside_on_or_outside_voxels_as_their_cells_say)
{
  Random random(12);
  for (int round = 0; round < 6; ++round) {
    const int n = 2 + round % 2;
    const Voxels voxels(random, n);
    const Brute_body body(round % 3 == 2 ? turned(voxels.solid()) : voxels.solid());
    for (int x = 0; x <= 2 * n; ++x)
      for (int y = 0; y <= 2 * n; ++y)
        for (int z = 0; z <= 2 * n; ++z)
          BOOST_TEST(inside(body, {Rational(x) / 2, Rational(y) / 2, Rational(z) / 2}) == voxels.where(x, y, z));
    BOOST_TEST(inside(body, {-1, 0, 0}) == -1);
    BOOST_TEST(inside(body, {n + 1, n, n}) == -1);
  }
}

// The first ray from the origin is along (1, 7/16, 49/256): it is made to run through an edge, through a vertex and in
// a face's plane.
BOOST_AUTO_TEST_CASE(a_ray_through_an_edge_a_vertex_or_in_a_face_is_not_counted)
{
  const double x = 1, y = 0.4375, z = 0.4375 * 0.4375;
  const tetracone::kernel::Vertex on = {x, y, z}, above = {x, y, z + 1}, below = {x, y, z - 1};
  for (const double far : {1.0, -1.0}) {  // the body's bulk behind the edge, or about the origin
    const tetracone::kernel::Vertex left = {x + 4 * far, y + 3, z}, right = {x + 4 * far, y - 3, z};
    const Brute_body edge(tetrahedron(above, below, left, right));
    BOOST_TEST(inside(edge, {0, 0, 0}) == -int(far));
    const Brute_body turned(tetrahedron(below, above, left, right));
    BOOST_TEST(inside(turned, {0, 0, 0}) == -int(far));
    const tetracone::kernel::Vertex back = {x + 4 * far, y, z + 3}, low = {x + 4 * far, y + 3, z - 3},
                                    high = {x + 4 * far, y - 3, z - 3};
    const Brute_body vertex(tetrahedron(on, back, low, high));
    BOOST_TEST(inside(vertex, {0, 0, 0}) == -int(far));
  }
  // The ray in the plane of a face: a, b, c on the plane of the ray.
  const Brute_body plane(tetrahedron({2, 0.875, 1}, {2, 0.875, -1}, {4, 1.75, 0}, {3, 0, 5}));
  BOOST_TEST(inside(plane, {0, 0, 0}) == -1);
}

BOOST_AUTO_TEST_SUITE_END()
