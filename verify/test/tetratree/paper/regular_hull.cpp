#include "tetracone/tetratree/paper/regular_hull.h"

#include "verify/test/support/cones.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <CGAL/Interval_nt.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_regular_hull)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using scenes::Random;

namespace {

using Hull = Regular_hull<double, true>;
using Interval = CGAL::Interval_nt_advanced;

/// An edge of the hull and a cone at it. The hull's facets on both sides of an edge stand next to one another when
/// sorted.
struct Side {
  std::array<Direction, 2> edge;
  const Tetra_cone* cone;
  Direction opposite;

  bool operator<(const Side& other) const { return edge < other.edge; }
};

// Requires rounding upward.
std::array<Interval, 3> unit(const Direction& d)
{
  const std::array<Interval, 3> v = {Interval(d[0]), Interval(d[1]), Interval(d[2])};
  const Interval length = CGAL::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

/// det[b-a, c-a, d-a] of the unit vectors, enclosed.
Interval volume(const Direction& a, const Direction& b, const Direction& c, const Direction& d)
{
  const auto p = unit(a), q = unit(b), r = unit(c), s = unit(d);
  std::array<Interval, 3> x, y, z;
  for (int k = 0; k < 3; ++k) {
    x[k] = q[k] - p[k];
    y[k] = r[k] - p[k];
    z[k] = s[k] - p[k];
  }
  return (x[1] * y[2] - x[2] * y[1]) * z[0] + (x[2] * y[0] - x[0] * y[2]) * z[1] + (x[0] * y[1] - x[1] * y[0]) * z[2];
}

}  // namespace

// The proof that Theorem 2 needs. The hull of a level is closed and star-shaped about V0. Its facets are those of the
// cones, and V0 sees each from inside (the determinant of its rays is positive). Such a surface is convex when it is so
// at every edge. It is so at an edge when the far corner of the one facet is strictly below the plane of the other. The
// corners are irrational; intervals decide every sign.
BOOST_AUTO_TEST_CASE(the_hull_of_every_level_in_use_is_convex)
{
  BOOST_TEST(Hull::deepest_convex_level >= 1);
  for (int level = 1; level <= Hull::deepest_convex_level; ++level) {
    const std::vector<Tetra_cone> cones = scenes::cones_of_level(level);
    std::vector<Side> sides;
    int inside_out = 0;
    for (const Tetra_cone& cone : cones) {
      inside_out += scenes::determinant(cone) <= 0;
      for (int i = 0; i < 3; ++i) {
        const Direction &p = cone.ray[i], &q = cone.ray[(i + 1) % 3];
        sides.push_back({{std::min(p, q), std::max(p, q)}, &cone, cone.ray[(i + 2) % 3]});
      }
    }
    std::sort(sides.begin(), sides.end());
    BOOST_TEST(inside_out == 0);
    BOOST_REQUIRE(sides.size() == 3 * cones.size());
    int unpaired = 0, not_proved = 0;
    const CGAL::Protect_FPU_rounding<true> upward;
    for (std::size_t k = 0; k < sides.size(); k += 2) {
      unpaired += sides[k].edge != sides[k + 1].edge || (k > 0 && sides[k - 1].edge == sides[k].edge);
      const auto& [a, b, c] = sides[k].cone->ray;
      not_proved += !(volume(a, b, c, sides[k + 1].opposite).sup() < 0);
    }
    BOOST_TEST(unpaired == 0);
    BOOST_TEST(not_proved == 0);
  }
}

BOOST_AUTO_TEST_CASE(the_cone_towards_a_direction_holds_it)
{
  Random random(1);
  int wrong = 0;
  for (int n = 0; n < 5'000; ++n) {
    const int level = 1 + n % max_cone_depth;
    const Vertex d = scenes::grid_vertex(random, n % 2 == 0 ? 2 : 1000);
    if (d == Vertex{0, 0, 0}) continue;
    const Tetra_cone cone = cone_towards<double>(d, level);
    for (int k = 0; k < 3; ++k) {
      const rationals::Vector side = rationals::outer(scenes::ray(cone, k), scenes::ray(cone, k + 1));
      wrong += rationals::inner(side, rationals::exactly(d)) < 0;
    }
    // Its level: the determinant of the rays is a quarter of the parent's.
    wrong += scenes::determinant(cone) != Rational(std::ldexp(1.0, 3 * max_cone_depth - 2 * (level - 1)));
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(the_plane_of_the_hull_is_at_dmax_and_that_of_the_sphere_at_the_radius)
{
  // Octants: the plane through the points at distance d of the three axes is d / sqrt(3) away.
  const Half_space<double> by_hull = Hull({1, 2, 3}, 1, 6, 5).towards({1, 1, 1});
  const double length = std::sqrt(squared_length(by_hull.normal));
  BOOST_TEST(by_hull.offset / length == 6 / std::sqrt(3.0), boost::test_tools::tolerance(1e-9));
  BOOST_TEST((by_hull.origin == Vertex{1, 2, 3}));
  // Not known, or a level that is not proved convex: the sphere of all vertices.
  for (const Hull& hull : {Hull({0, 0, 0}, 1, -1, 5), Hull({0, 0, 0}, Hull::deepest_convex_level + 1, 6, 5)}) {
    const Half_space<double> plane = hull.towards({1, 1, 1});
    BOOST_TEST(plane.offset / std::sqrt(squared_length(plane.normal)) == 5, boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_SUITE_END()
