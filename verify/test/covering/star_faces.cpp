#include "tetracone/covering/star_faces.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_star_faces)

using namespace tetracone::covering;
using namespace tetracone::verify::scenes;

namespace {

Polyhedron polygon(const std::vector<std::array<double, 2>>& corners, bool turned = false)
{
  Polyhedron p;
  std::vector<Index> loop;
  for (const auto& [x, y] : corners) {
    loop.push_back(Index(loop.size()));
    p.vertices.push_back({x, y, x + 2 * y});
  }
  if (turned) std::reverse(loop.begin(), loop.end());
  p.add_polygon(loop);
  return p;
}

}  // namespace

BOOST_AUTO_TEST_CASE(convex_faces_are_fans)
{
  const auto of_cube = star_faces(unit_cube());
  BOOST_TEST(of_cube.size() == 12u);
  std::set<Index> faces;
  for (const Face_triangle& t : of_cube) faces.insert(t.face);
  BOOST_TEST(faces.size() == 6u);
  for (const bool turned : {false, true}) {
    const auto hexagon = star_faces(polygon({{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}}, turned));
    BOOST_TEST(hexagon.size() == 4u);
  }
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
