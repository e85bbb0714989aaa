#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/test/support/object_cases.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_rays)

using namespace tetracone;
namespace scenes = verify::scenes;

BOOST_AUTO_TEST_CASE(normals_are_the_nearest_doubles)
{
  const Body cube(scenes::unit_cube());
  const std::vector<std::array<double, 3>> expected = {{-1, 0, 0}, {1, 0, 0},  {0, -1, 0},
                                                       {0, 1, 0},  {0, 0, -1}, {0, 0, 1}};
  for (Index f = 0; f < 6; ++f) BOOST_TEST((cube.normal(f) == expected[f]));
  // The exact component is between the midpoints to the neighbours: compared by squares of integers.
  scenes::Random random(4640);
  for (int round = 0; round < 200; ++round) {
    std::array<scenes::Vertex, 3> t;
    for (scenes::Vertex& v : t) v = scenes::grid_vertex(random, 9);
    std::array<long, 3> e, f, n;
    for (int k = 0; k < 3; ++k) {
      e[k] = long(t[1][k] - t[0][k]);
      f[k] = long(t[2][k] - t[0][k]);
    }
    long square = 0;
    for (int k = 0; k < 3; ++k) {
      n[k] = e[(k + 1) % 3] * f[(k + 2) % 3] - e[(k + 2) % 3] * f[(k + 1) % 3];
      square += n[k] * n[k];
    }
    const auto normal = Body(scenes::polygon({t[0], t[1], t[2]})).normal(0);
    for (int k = 0; k < 3; ++k) {
      BOOST_TEST((normal[k] > 0) == (n[k] > 0));
      BOOST_TEST((normal[k] < 0) == (n[k] < 0));
      if (n[k] == 0) continue;
      const double x = std::abs(normal[k]);
      const auto middle = [&](double neighbour) {
        return kernel::Rational((kernel::Rational(x) + kernel::Rational(neighbour)) / 2);
      };
      const kernel::Rational exact(n[k] * n[k]), below = middle(std::nextafter(x, 0)),
                                                 above = middle(std::nextafter(x, 2));
      BOOST_TEST((below * below * square <= exact && exact <= above * above * square));
    }
  }
  BOOST_CHECK_THROW(cube.normal(6), Error);
}

BOOST_AUTO_TEST_CASE(a_ray_enters_and_leaves_in_turn)
{
  scenes::Random random(4641);
  for (const Polyhedron& polyhedron : {scenes::blob(random, 3, 0.7, 1), scenes::cube_with_cavity()}) {
    const Body body(polyhedron), turned(scenes::turned(polyhedron));
    int crossings = 0;
    for (int round = 0; round < 100; ++round) {
      const Ray ray{{9, 8, 7}, {-9 + scenes::real(random, -1, 1), -8 + scenes::real(random, -1, 1), -7}};
      bool is_outside = true;
      for (const Ray_hit& hit : body.hits(ray)) {
        BOOST_TEST((body.crossing(ray, hit.face) == (is_outside ? Crossing::entering : Crossing::leaving)));
        BOOST_TEST((turned.crossing(ray, hit.face) == (is_outside ? Crossing::leaving : Crossing::entering)));
        is_outside = !is_outside;
        ++crossings;
      }
      BOOST_TEST(is_outside);
    }
    BOOST_TEST(crossings > 100);
  }
  const Body cube(scenes::unit_cube());
  const Ray beside{{-1, 0, 0.5}, {1, 0, 0}};
  BOOST_TEST((cube.crossing(beside, 2) == Crossing::along));
}

BOOST_AUTO_TEST_CASE(an_end_is_compared_exactly)
{
  const Body cube(scenes::unit_cube());
  const Ray ray{{-1, 0.5, 0.5}, {3, 0, 0}};  // meets at 1/3 and 2/3
  const double third = 1.0 / 3;              // below it
  BOOST_TEST(!cube.first_hit(ray, third).has_value());
  BOOST_TEST(!cube.is_hit(ray, third));
  BOOST_TEST(cube.first_hit(ray, std::nextafter(third, 1)).has_value());
  BOOST_TEST(cube.is_hit(ray, std::nextafter(third, 1)));
  BOOST_TEST(cube.hits(ray, 0.5).size() == 1u);
  BOOST_TEST(cube.hits(ray, std::numeric_limits<double>::infinity()).size() == 2u);
  BOOST_CHECK_THROW(cube.is_hit(ray, std::nan("")), Error);
  BOOST_CHECK_THROW(cube.is_hit({{0, 0, 0}, {0, 0, 0}}, 1), Error);
}

BOOST_AUTO_TEST_SUITE_END()
