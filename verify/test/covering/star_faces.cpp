#include "tetracone/covering/star_faces.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_star_faces)

using namespace tetracone::covering;
using namespace tetracone::verify::scenes;

/// A face of these corners, each once.
Polyhedron polygon(const std::vector<std::array<double, 2>>& corners)
{
  std::vector<Index> loop(corners.size());
  std::iota(loop.begin(), loop.end(), Index(0));
  return slanted_face(corners, {loop});
}

BOOST_AUTO_TEST_CASE(convex_faces_are_fans)
{
  const auto of_cube = star_faces(unit_cube());
  BOOST_TEST(of_cube.size() == 12u);
  std::set<Index> faces;
  for (const Face_triangle& t : of_cube) faces.insert(t.face);
  BOOST_TEST(faces.size() == 6u);
  const Polyhedron hexagon = polygon({{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}});
  for (const Polyhedron& p : {hexagon, tetracone::verify::scenes::turned(hexagon)})
    BOOST_TEST(star_faces(p).size() == 4u);
  // Not convex, and yet all corners go round the first.
  BOOST_TEST(star_faces(polygon({{0, 0}, {4, -1}, {1, 0}, {4, 1}})).size() == 2u);
}

BOOST_AUTO_TEST_CASE(other_faces_are_left_as_they_are)
{
  BOOST_TEST(star_faces(triangulated(unit_cube())).empty());
  BOOST_TEST(star_faces(polygon({{0, 0}, {2, 0}, {2, 2}, {1, -1}})).empty());  // crosses itself
  BOOST_TEST(star_faces(polygon({{0, 0}, {1, 0}, {2, 0}, {2, 2}})).empty());   // three on a line
  BOOST_TEST(star_faces(polygon({{4, 0}, {0, 1}, {-4, 0}, {0, 4}})).size() <= 2u);
  BOOST_TEST(star_faces(polygon({{0, 3}, {2, -2}, {-3, 1}, {3, 1}, {-2, -2}})).empty());  // a pentagram
  BOOST_TEST(star_faces(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}})).empty());  // twice
                                                                                                              // round
  std::set<Index> faces;
  for (const Face_triangle& t : star_faces(cube_with_tunnel())) faces.insert(t.face);
  for (const Index f : faces) BOOST_TEST(cube_with_tunnel().loop_count(f) == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
