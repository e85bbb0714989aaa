#include "tetracone/tetratree/penetration/convex_body.h"

#include "tetracone/covering/star_faces.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_convex_body)

namespace scenes = tetracone::verify::scenes;
using namespace tetracone::tetratree;
using tetracone::covering::Polyhedron;
using tetracone::kernel::Convex_solid;

namespace {

/// Returns the convex solid of a polyhedron, of whose faces it makes triangles; nothing where it is not convex.
std::optional<Convex_solid> seen(const Polyhedron& body)
{
  const Polyhedron triangles = scenes::triangulated(body);
  const Bvh8 tree(triangles, tetracone::covering::star_faces(triangles));
  const Solid_sides sides(tree, triangles);
  if (!is_known_convex(triangles, sides)) return std::nullopt;
  return convex_solid(triangles, sides);
}

Polyhedron round_prism(int sides)
{
  std::vector<std::array<double, 2>> polygon;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * M_PI * k / sides;
    polygon.push_back({std::cos(angle), std::sin(angle)});
  }
  return scenes::prism(polygon, 1);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_triangles_of_a_plane_are_one_face)
{
  for (const int sides : {3, 4, 5, 12, 300}) {
    const std::optional<Convex_solid> solid = seen(round_prism(sides));
    BOOST_REQUIRE(solid.has_value());
    BOOST_TEST(solid->corners.size() == std::size_t(2 * sides));
    BOOST_TEST(solid->faces.size() == std::size_t(sides + 2));
    BOOST_TEST(solid->edges.size() == std::size_t(3 * sides));
    for (const Convex_solid::Edge& e : solid->edges) BOOST_TEST(e.faces[0] != e.faces[1]);
  }
}

BOOST_AUTO_TEST_CASE(faces_turned_inward_do_not_matter)
{
  const std::optional<Convex_solid> solid = seen(scenes::turned(scenes::unit_cube()));
  BOOST_REQUIRE(solid.has_value());
  BOOST_TEST(solid->edges.size() == 12u);
}

BOOST_AUTO_TEST_CASE(solids_with_edges_that_are_all_convex_need_not_be_convex)
{
  const Polyhedron cube = scenes::unit_cube();
  BOOST_TEST(seen(cube).has_value());
  BOOST_TEST(!seen(scenes::both(cube, scenes::moved(cube, 1, {3, 0, 0}))));  // two pieces
  BOOST_TEST(!seen(scenes::both(cube, scenes::moved(cube, 1, {1, 1, 1}))));  // which share a vertex
  BOOST_TEST(!seen(scenes::both(cube, scenes::moved(cube, 1, {3, 1, 0}))));  // or planes
}

BOOST_AUTO_TEST_CASE(cavities_notches_and_tunnels_are_not_convex)
{
  for (const Polyhedron& body : {scenes::cube_with_cavity(), scenes::star_prism(), scenes::cube_with_tunnel()})
    BOOST_TEST(!seen(body));
}

BOOST_AUTO_TEST_SUITE_END()
