#include "tetracone/tetratree/penetration/convex_bounds.h"

#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

#include <array>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_convex_bounds)

namespace scenes = tetracone::verify::scenes;
using namespace tetracone;
using tetratree::Convex_bounds;

namespace {

/// The cube from -1 to 1, whose upper face has a point in its middle, at this height.
covering::Polyhedron dented_cube(double height)
{
  covering::Polyhedron cube = scenes::triangulated(scenes::cube(1)), dented;
  dented.vertices = cube.vertices;
  dented.vertices.push_back({0, 0, height});
  std::vector<std::array<Index, 3>> upper;
  for (Index f = 0; f < cube.face_count(); ++f) {
    const covering::Loop t = cube.loop(f, 0);
    std::array<Index, 3> corners = {t[0], t[1], t[2]};
    bool is_upper = true;
    for (const Index v : corners) is_upper = is_upper && cube.vertices[v][2] == 1;
    if (is_upper)
      upper.push_back(corners);
    else
      dented.add_polygon(corners);
  }
  // Each border edge of the upper face gets a triangle to the point. The diagonal has one in both directions.
  for (const auto& t : upper)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = t[k], to = t[(k + 1) % 3];
      const auto &p = cube.vertices[from], &q = cube.vertices[to];
      if (p[0] == q[0] || p[1] == q[1]) dented.add_polygon(std::array<Index, 3>{from, to, 8});
    }
  return dented;
}

/// A prism over a regular polygon, turned about an odd axis, whose corners are rounded.
covering::Polyhedron turned_prism(int sides)
{
  std::vector<std::array<double, 2>> polygon;
  for (int k = 0; k < sides; ++k) polygon.push_back({std::cos(2 * M_PI * k / sides), std::sin(2 * M_PI * k / sides)});
  covering::Polyhedron prism = scenes::triangulated(scenes::prism(polygon, 2));
  const double c = 0.6, s = 0.8, d = 5.0 / 13, e = 12.0 / 13;
  for (auto& [x, y, z] : prism.vertices) {
    const double turned = c * x - s * z, up = s * x + c * z;
    x = d * turned - e * y;
    y = e * turned + d * y;
    z = up;
  }
  return prism;
}

std::optional<Convex_bounds> bounds(const covering::Polyhedron& solid)
{
  const Body body(solid);
  return tetratree::convex_bounds(solid, [&](const covering::Polyhedron& inner) {
    const auto is = Query(Body(inner), body).solid_relation_alone(Pose(), Pose());
    return is == Solid_relation::inside || is == Solid_relation::covered_by || is == Solid_relation::equal;
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_small_dent_has_bounds_near_the_solid)
{
  for (const int n : {52, 40, 30, 20}) {
    const auto found = bounds(dented_cube(1 - std::ldexp(1.0, -n)));
    BOOST_REQUIRE(found.has_value());
    BOOST_TEST(found->outer.vertices.size() == 8u);
    const double lost = tetratree::rounded_volume(found->outer, {}) - tetratree::rounded_volume(found->inner, {});
    BOOST_TEST(lost > 0);
    BOOST_TEST(lost < 24 * 64 * std::ldexp(1.0, std::max(-n, -44)));
  }
}

BOOST_AUTO_TEST_CASE(solids_that_are_far_from_convex_have_none)
{
  BOOST_TEST(!bounds(dented_cube(-0.5)).has_value());
  scenes::Random random(2);
  BOOST_TEST(!bounds(scenes::blob(random, 2, 0.5, 1.5)).has_value());
  BOOST_TEST(!bounds(scenes::triangulated(scenes::torus(9, 5))).has_value());
  // A cavity lacks little volume, but each inner convex solid of nearly the size holds it.
  BOOST_TEST(!bounds(scenes::triangulated(scenes::with_cavity(scenes::cube(1), scenes::cube(0.01)))).has_value());
}

BOOST_AUTO_TEST_CASE(depths_of_nearly_convex_solids_are_narrow_and_hold_the_truth)
{
  // The dent is inside of the upper face's border, so it changes no depth of a cube that is as large.
  const Body cube(scenes::cube(1));
  for (const int n : {50, 36, 24}) {
    const Body dented(dented_cube(1 - std::ldexp(1.0, -n)));
    Query query(dented, cube);
    for (const auto& [pose, truth] : std::vector<std::pair<Pose, double>>{{Pose::translation(1.75, 0.5, 0.25), 0.25},
                                                                          {Pose::translation(0.25, 0.5, -1.5), 0.5},
                                                                          {Pose::translation(0, 0, 0), 2}}) {
      const Depth depth = query.depth(pose, Pose());
      BOOST_TEST(depth.low <= truth);
      BOOST_TEST(depth.high >= truth);
      BOOST_TEST(depth.high - depth.low <= kernel::maximum(1e-9, 64 * std::ldexp(1.0, -n)) * truth);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_point_may_go_into_a_dent)
{
  // A pyramid stands on its point, in the cube. The least translation takes that point into the dent.
  covering::Polyhedron pyramid;
  pyramid.vertices = {{0, 0, 0.5}, {1, 1, 3}, {-1, 1, 3}, {-1, -1, 3}, {1, -1, 3}};
  for (const auto& face : {std::vector<Index>{1, 2, 3}, {1, 3, 4}, {0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}})
    pyramid.add_polygon(face);
  for (const int n : {30, 20}) {
    const double truth = 0.5 - std::ldexp(1.0, -n);
    const Body dented(dented_cube(1 - std::ldexp(1.0, -n))), standing(pyramid);
    for (const bool swapped : {false, true}) {
      Query query(swapped ? standing : dented, swapped ? dented : standing);
      const Depth depth = query.depth(Pose(), Pose());
      BOOST_TEST(depth.low <= truth);
      BOOST_TEST(depth.high >= truth);
      BOOST_TEST(depth.high <= 0.5);
      BOOST_TEST(depth.low >= truth - 64 * std::ldexp(1.0, -n));
    }
  }
}

BOOST_AUTO_TEST_CASE(rounded_prisms_have_the_depth_of_prisms)
{
  for (const int sides : {5, 12, 24}) {
    const Body prism(turned_prism(sides));
    Query query(prism, prism);
    // Along the axis of the prism, its height is 2. The depth of equal ones is that of half the way out, or less.
    const Depth depth = query.depth(Pose(), Pose());
    BOOST_TEST(depth.high - depth.low <= 1e-9 * depth.high);
    const double across = sides % 2 == 0 ? 2 * std::cos(M_PI / sides) : 1 + std::cos(M_PI / sides);
    BOOST_TEST(depth.low <= across * (1 + 1e-12));
    BOOST_TEST(depth.high >= across * (1 - 1e-12));
    const Depth back = query.depth(Pose::translation(0.5, 0.25, 0.125), Pose());
    const Depth swapped = query.depth(Pose(), Pose::translation(0.5, 0.25, 0.125));
    BOOST_TEST(kernel::maximum(back.low, swapped.low) <= kernel::minimum(back.high, swapped.high));
    BOOST_TEST(back.high - back.low <= 1e-9 * back.high);
  }
}

BOOST_AUTO_TEST_SUITE_END()
