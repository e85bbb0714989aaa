#include "experiments/accuracy/contracted.h"

#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>

BOOST_AUTO_TEST_SUITE(test_contracted)

using namespace tetracone;
using experiments::Contracted;
using kernel::Sign;
using verify::scenes::integer;
using verify::scenes::Random;
using verify::scenes::real;
using Point = kernel::Point<Contracted>;

namespace {

constexpr auto minor = Contracted::difference_of_products;

Sign exact_volume_sign(const std::array<Point, 4>& p)
{
  std::array<std::array<kernel::Rational, 3>, 3> d;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) d[k][i] = kernel::Rational(p[k + 1][i]) - kernel::Rational(p[0][i]);
  const kernel::Rational volume = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                                  d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                                  d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
  return CGAL::sign(volume);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_first_product_is_not_rounded)
{
  Random random(1);
  for (int k = 0; k < 1000; ++k) {
    const double a = real(random, -1, 1), b = real(random, -1, 1), c = real(random, -1, 1), d = real(random, -1, 1),
                 second = c * d;
    const kernel::Rational difference = kernel::Rational(a) * kernel::Rational(b) - kernel::Rational(second);
    BOOST_TEST(minor(a, b, c, d) == kernel::nearest_double(difference));
  }
  const double x = 1 + 0x1p-30;
  BOOST_TEST(minor(x, x, x, x) == 0x1p-60);  // where both products are rounded, and exactly, 0
}

BOOST_AUTO_TEST_CASE(signs_of_small_integers_are_exact)
{
  Random random(2);
  int zeros = 0;
  for (int k = 0; k < 5000; ++k) {
    const int most = k % 2 == 0 ? 2 : 1000;
    std::array<Point, 4> p;
    for (Point& x : p)
      x = Point(integer(random, -most, most), integer(random, -most, most), integer(random, -most, most));
    const Sign exact = exact_volume_sign(p);
    zeros += exact == CGAL::ZERO;
    BOOST_TEST(kernel::volume_sign<Contracted>(p[0], p[1], p[2], p[3]) == exact);
    BOOST_TEST(kernel::volume_sign<Contracted>(p[1], p[0], p[2], p[3]) == -exact);
    for (int axis = 0; axis < 3; ++axis) {
      // That of a volume whose fourth point is off the first along the axis.
      std::array<double, 3> off = {p[0][0], p[0][1], p[0][2]};
      off[axis] += 1;
      BOOST_TEST(kernel::normal_sign<Contracted>(p[0], p[1], p[2], axis) ==
                 exact_volume_sign({p[0], p[1], p[2], Point(off[0], off[1], off[2])}));
    }
  }
  BOOST_TEST(zeros > 100);
}

BOOST_AUTO_TEST_CASE(contraction_gives_signs_to_what_has_none_and_the_same_both_ways_round)
{
  // A triangle with two corners in one place: doubles that are not contracted say 0.
  Random random(3);
  int signs = 0, both_ways = 0;
  for (int k = 0; k < 1000; ++k) {
    const Point a(0, 0, 0), b(real(random, 0, 1), real(random, 0, 1), 0), c = b;
    const Sign sign = kernel::normal_sign<Contracted>(a, b, c, 2);
    signs += sign != CGAL::ZERO;
    both_ways += sign != CGAL::ZERO && kernel::normal_sign<Contracted>(a, c, b, 2) == sign;
  }
  BOOST_TEST(signs > 900);
  BOOST_TEST(both_ways == signs);
}

BOOST_AUTO_TEST_SUITE_END()
