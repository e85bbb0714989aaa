#include "tetracone/kernel/predicate/int128_signs.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_int128_signs)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;
using Points = std::array<Vertex, 4>;

std::array<rationals::Vector, 4> exactly(const Points& p)
{
  return {rationals::exactly(p[0]), rationals::exactly(p[1]), rationals::exactly(p[2]), rationals::exactly(p[3])};
}

CGAL::Sign volume(const Points& p)
{
  const auto e = exactly(p);
  return CGAL::sign(rationals::six_volume(e[0], e[1], e[2], e[3]));
}

CGAL::Sign normal(const Points& p, int axis)
{
  const auto e = exactly(p);
  return CGAL::sign(rationals::outer(rationals::minus(e[1], e[0]), rationals::minus(e[2], e[0]))[std::size_t(axis)]);
}

/// Whole numbers of `bits` bits times 2^scale, at the ends of their range every other time; coplanar if asked.
Points on_a_grid(Random& random, int bits, int scale, bool coplanar)
{
  const auto number = [&] {
    const double most = std::ldexp(1.0, bits) - 1;
    const double x = random() % 2 ? most - double(random() % 3) : std::floor(real(random, 0, 1) * most);
    return random() % 2 ? x : -x;
  };
  Points p;
  for (Vertex& v : p)
    for (double& x : v) x = number();
  if (coplanar)
    for (int k = 0; k < 3; ++k) {
      for (int n = 0; n < 3; ++n) p[n][k] = std::trunc(p[n][k] / 8);
      p[3][k] = p[1][k] + p[2][k] - p[0][k];
    }
  for (Vertex& v : p)
    for (double& x : v) x = std::ldexp(x, scale);
  return p;
}

BOOST_AUTO_TEST_CASE(points_of_a_grid_have_their_exact_signs)
{
  Random random(1);
  int zero = 0, decided = 0;
  for (int k = 0; k < 20000; ++k) {
    const Points p = on_a_grid(random, 2 + k % 37, integer(random, -250, 200), k % 2 == 0);
    const auto sign = int128_volume_sign(p[0], p[1], p[2], p[3]);
    const bool all_zero = std::all_of(p.begin(), p.end(), [](const Vertex& v) { return v == Vertex{0, 0, 0}; });
    BOOST_TEST_REQUIRE(sign.has_value() == !all_zero);
    if (!sign) continue;
    ++decided;
    BOOST_TEST(*sign == volume(p));
    zero += *sign == CGAL::ZERO;
    const auto component = int128_normal_sign(p[0], p[1], p[2], k % 3);
    if (component) BOOST_TEST(*component == normal(p, k % 3));
  }
  BOOST_TEST(zero > 9000);
  BOOST_TEST(decided > 19000);
}

BOOST_AUTO_TEST_CASE(the_extreme_corners_of_the_grid_do_not_overflow)
{
  // All tetrahedra with corners of the largest cube: determinants as large as they get.
  const double most = 0x1p38 - 1;
  for (int corners = 0; corners < 4096; ++corners) {
    Points p;
    for (int n = 0; n < 4; ++n)
      for (int k = 0; k < 3; ++k) p[n][k] = corners >> (3 * n + k) & 1 ? most : -most;
    const auto sign = int128_volume_sign(p[0], p[1], p[2], p[3]);
    BOOST_TEST_REQUIRE(sign.has_value());
    BOOST_TEST(*sign == volume(p));
  }
}

BOOST_AUTO_TEST_CASE(what_is_on_no_such_grid_is_left_undecided)
{
  const Vertex a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  const auto sign = [&](double z) { return int128_volume_sign(a, b, c, {0.25, 0.25, z}); };
  BOOST_TEST((sign(0) == CGAL::ZERO));
  BOOST_TEST((sign(0x1p-37) == volume({a, b, c, {0.25, 0.25, 0x1p-37}})));
  BOOST_TEST(!sign(0x1p-38));
  BOOST_TEST(!sign(1e-300));
  BOOST_TEST(!sign(0x1p-1074));
  BOOST_TEST(!sign(0.1));
  BOOST_TEST(!sign(0x1p301));
  BOOST_TEST(!sign(std::numeric_limits<double>::infinity()));
  BOOST_TEST(!sign(std::numeric_limits<double>::quiet_NaN()));
  BOOST_TEST(!int128_volume_sign(a, a, a, a));
  // Where a product with the steps underflows.
  const Vertex large{0x1p300, 0, 0};
  BOOST_TEST(!int128_volume_sign(large, a, {0, 0x1p300, 0}, {0, 0, 0x1p-1074}));
  BOOST_TEST(!int128_normal_sign(large, {0, 0x1p-1074, 0}, a, 2));
  BOOST_TEST(!int128_normal_sign({0x1p-301, 0, 0}, {0, 0x1p-301, 0}, {0, 0, 0}, 2));
}

BOOST_AUTO_TEST_SUITE_END()
