#include "tetracone/kernel/predicate/signs.h"

#include "tetracone/kernel/predicate/frame.h"
#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

// Campaigns ask every kernel for signs near and in a plane, under poses, in every order and at every scale.

BOOST_AUTO_TEST_SUITE(test_signs)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

using Kernels = std::tuple<Float, Double, Tolerant, Epick, Epeck, Rational_kernel, Adaptive>;

rationals::Vector between(const Vertex& a, const Vertex& b)
{
  return rationals::minus(rationals::exactly(b), rationals::exactly(a));
}

KERNEL_TEST_CASE(perturbed_side_is_the_side_of_the_point_really_moved, K, Kernels)
{
  // Small enough: the volume is an integer, the normal's components are integers of at most 72.
  const Rational e = Rational(1) / Rational(1 << 20);
  Random random(9);
  int wrong = 0, moved = 0;
  for (int n = 0; n < 5'000; ++n) {
    const Vertex a = grid_vertex(random, 2), b = grid_vertex(random, 2), c = grid_vertex(random, 2),
                 p = grid_vertex(random, 2);
    const rationals::Vector really = rationals::plus(between(a, p), {e, Rational(e * e), Rational(e * e * e)});
    const int truth = rationals::sign(rationals::determinant(between(a, b), between(a, c), really));
    const Sign sign = perturbed_side<K>(point<K>(a), point<K>(b), point<K>(c), point<K>(p)),
               unmoved = volume_sign<K>(point<K>(a), point<K>(b), point<K>(c), point<K>(p));
    wrong += int(sign) != truth;
    wrong += unmoved != ZERO && sign != unmoved;
    wrong += (sign == ZERO) != (projection_axis<K>(point<K>(a), point<K>(b), point<K>(c)) < 0);
    moved += unmoved == ZERO && sign != ZERO;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(moved > 100);
}

// --- Tolerant --------------------------------------------------------------------------------------------------------

struct With_tolerance {
  explicit With_tolerance(double absolute, double relative) { Tolerant::tolerance() = {absolute, relative}; }
  ~With_tolerance() { Tolerant::tolerance() = {}; }
};

// The corner of the unit cube with the third edge of length h: volume h, permanent h.
Sign corner_of_height(double h)
{
  using T = Tolerant::Point_3;
  return volume_sign<Tolerant>(T(0, 0, 0), T(1, 0, 0), T(0, 1, 0), T(0, 0, h));
}

BOOST_AUTO_TEST_CASE(absolute_tolerance_makes_small_values_zero_up_to_and_including_it_and_none_is_plain_double)
{
  BOOST_TEST(corner_of_height(0x1p-1074) == POSITIVE);
  BOOST_TEST(corner_of_height(-0x1p-1074) == NEGATIVE);
  BOOST_TEST(corner_of_height(0) == ZERO);
  const With_tolerance within(0x1p-10, 0);
  const double above = std::nextafter(0x1p-10, 1);
  BOOST_TEST(corner_of_height(0x1p-10) == ZERO);
  BOOST_TEST(corner_of_height(-0x1p-10) == ZERO);
  BOOST_TEST(corner_of_height(above) == POSITIVE);
  BOOST_TEST(corner_of_height(-above) == NEGATIVE);

  using T = Tolerant::Point_3;
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [axis](double x, int which) {
      std::array<double, 3> p{};
      p[(axis + which) % 3] = x;
      return T(p[0], p[1], p[2]);
    };
    BOOST_TEST(normal_sign<Tolerant>(along(0, 0), along(1, 1), along(0x1p-10, 2), axis) == ZERO);
    BOOST_TEST(normal_sign<Tolerant>(along(0, 0), along(1, 1), along(above, 2), axis) == POSITIVE);
    BOOST_TEST(normal_sign<Tolerant>(along(0, 0), along(above, 2), along(1, 1), axis) == NEGATIVE);
    BOOST_TEST(difference_sign<Tolerant>(along(0x1p-10, 0), along(0, 0), axis) == ZERO);
    BOOST_TEST(difference_sign<Tolerant>(along(above, 0), along(0, 0), axis) == POSITIVE);
    BOOST_TEST(difference_sign<Tolerant>(along(0, 0), along(above, 0), axis) == NEGATIVE);
  }
}

BOOST_AUTO_TEST_CASE(relative_tolerance_is_a_share_of_the_permanent)
{
  const With_tolerance within(0, 0x1p-10);
  // A lone product is its own permanent: no relative tolerance below 1 makes it zero, however small it is.
  BOOST_TEST(corner_of_height(0x1p-1000) == POSITIVE);
  // h = 1 * (1 + h) - 1 * 1, permanent 2 + h: zero up to h = 2^-10 (2 + h).
  using T = Tolerant::Point_3;
  const double low = 0x1p-9 * (1 + 0x1p-11), high = 0x1p-9 * (1 + 0x1p-9);
  for (const double scale : {1.0, 0x1p-100, 0x1p100}) {
    const auto sheared = [scale](double h) {
      const double s = scale;
      return volume_sign<Tolerant>(T(0, 0, 0), T(s, s, 0), T(s, s * (1 + h), 0), T(0, 0, s));
    };
    BOOST_TEST(sheared(low) == ZERO);
    BOOST_TEST(sheared(high) == POSITIVE);
    const auto flat = [scale](double h) {
      return normal_sign<Tolerant>(T(0, 0, 0), T(scale, scale, 0), T(scale, scale * (1 + h), 0), 2);
    };
    BOOST_TEST(flat(low) == ZERO);
    BOOST_TEST(flat(high) == POSITIVE);
    BOOST_TEST(difference_sign<Tolerant>(T(scale * (1 + low), 0, 0), T(scale, 0, 0), 0) == ZERO);
    BOOST_TEST(difference_sign<Tolerant>(T(scale * (1 + high), 0, 0), T(scale, 0, 0), 0) == POSITIVE);
  }
}

BOOST_AUTO_TEST_CASE(a_tolerance_belongs_to_its_thread)
{
  const With_tolerance within(1, 1);
  BOOST_TEST(corner_of_height(0.5) == ZERO);
  Sign elsewhere = ZERO;
  std::thread([&] { elsewhere = corner_of_height(0.5); }).join();
  BOOST_TEST(elsewhere == POSITIVE);
}

BOOST_AUTO_TEST_SUITE_END()
