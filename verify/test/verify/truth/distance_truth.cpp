#include "verify/truth/distance_truth.h"

#include "tetracone/kernel/bound/common_frame.h"
#include "tetracone/kernel/bound/triangle_distance.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/kernel/predicate/face_distance.h"
#include "verify/cases/random.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_distance_truth)

using namespace tetracone::verify;
namespace kernel = tetracone::kernel;

namespace {

using Triangle = std::array<std::array<double, 3>, 3>;

/// A triangle of small integers, so that edges are parallel, and triangles coplanar, touching or degenerate to a line;
/// or of any numbers.
Triangle any_triangle(Random& random, int step)
{
  Triangle t;
  for (auto& p : t)
    for (double& x : p) x = step % 3 == 0 ? random.unit() : std::floor(random.unit() * (step % 3 == 1 ? 4 : 7));
  if (step % 5 == 0)
    for (auto& p : t) p[2] = step % 10 == 0 ? 1 : 0x1p-60;
  return t;
}

Simplex simplex(const Triangle& t)
{
  Simplex s;
  for (const auto& p : t) s.emplace_back(p[0], p[1], p[2]);
  return s;
}

kernel::Exact_face exact_face(const Triangle& t)
{
  std::array<kernel::Exact_vector, 3> p;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) p[k][i] = kernel::Exact_number(t[k][i]);
  return {{{p[0], p[1]}, {p[1], p[2]}, {p[2], p[0]}}, p};
}

bool is_flat(const Triangle& t)
{
  const Simplex s = simplex(t);
  return CGAL::collinear(s[0], s[1], s[2]);
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_truths_and_the_exact_stage_agree_and_doubles_enclose_them)
{
  Random random(11);
  int zero = 0, certain = 0;
  for (int step = 0; step < 300; ++step) {
    const Triangle a = any_triangle(random, step), b = any_triangle(random, step + 1);
    const Rational by_program = squared_distance_by_program(simplex(a), simplex(b));
    if (!is_flat(a) && !is_flat(b))
      BOOST_TEST((squared_distance_by_features(simplex(a), simplex(b)) == by_program), "step " << step);
    const kernel::Exact_distance exact = kernel::distance_of_faces(exact_face(a), exact_face(b));
    const Rational square = Rational(exact.top()) / Rational(exact.bottom());
    BOOST_TEST((square == by_program), "step " << step);
    zero += sgn(square) == 0;
    const kernel::Triangle_gap gap = kernel::triangle_gap(a, b, 0, 8);
    BOOST_TEST((Rational(gap.low) * Rational(gap.low) <= square), "step " << step);
    BOOST_TEST((Rational(gap.high) * Rational(gap.high) >= square), "step " << step);
    certain += gap.high - gap.low < 1e-12;
  }
  BOOST_TEST(zero >= 15);
  BOOST_TEST(zero < 250);
  BOOST_TEST(certain > 100);
}

BOOST_AUTO_TEST_CASE(what_is_infinite_or_undefined_bounds_nothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Triangle a = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, b = {{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}};
  for (const double bad : {nan, infinity}) {
    BOOST_TEST(kernel::triangle_gap(a, b, bad, 2).low == 0);
    BOOST_TEST(!(kernel::triangle_gap(a, b, bad, 2).high < infinity));
    Triangle c = b;
    c[1][2] = bad;
    BOOST_TEST(kernel::triangle_gap(a, c, 0, bad).low == 0);
    BOOST_TEST(!(kernel::triangle_gap(a, c, 0, bad).high < infinity));
    BOOST_TEST(kernel::least_stretch({{{1, 0, 0}, {0, bad, 0}, {0, 0, 1}}}) == 0);
  }
}

BOOST_AUTO_TEST_CASE(triangles_beyond_a_limit_are_told_so_and_others_are_enclosed_as_without_one)
{
  Random random(13);
  int beyond = 0;
  for (int step = 0; step < 2000; ++step) {
    const Triangle a = any_triangle(random, step), b = any_triangle(random, step + 1);
    const kernel::Triangle_gap free = kernel::triangle_gap(a, b, 0, 8);
    const double limit = free.nearest * (0.5 + random.unit());
    const kernel::Triangle_gap gap = kernel::triangle_gap(a, b, 0, 8, limit);
    if (gap.low > limit) {
      BOOST_TEST(free.high >= gap.low);
      ++beyond;
    } else {
      BOOST_TEST(gap.nearest == free.nearest);
      BOOST_TEST(gap.low == free.low);
    }
  }
  BOOST_TEST(beyond > 100);
}

BOOST_AUTO_TEST_CASE(what_is_surely_before_a_point_is_so_exactly_though_all_is_rounded)
{
  Random random(17);
  const auto vector = [&] {
    return kernel::Double_vector{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
  };
  constexpr double error = 0x1p-50;
  int sure = 0, wrong = 0;
  for (int step = 0; step < 4000; ++step) {
    const kernel::Double_vector direction = vector(), p = vector(), off = vector();
    // From p across the direction, and a little way along it.
    const kernel::Double_vector across = kernel::cross(direction, off);
    const double along = std::ldexp(random.unit() - 0.5, -int(random.unit() * 60));
    kernel::Double_vector n, x;
    Rational height = 0;
    for (int k = 0; k < 3; ++k) {
      x[k] = p[k] + across[k] + along * direction[k];
      n[k] = direction[k] * (1 + (random.unit() < 0.5 ? -1 : 1) * 0x1p-51);
      // Each as far off as it may be.
      const double shift = error * (direction[k] < 0 ? -1 : 1);
      height += Rational(direction[k]) * (Rational(x[k]) + Rational(shift) - Rational(p[k]) + Rational(shift));
    }
    const bool is_sure = kernel::is_surely_before(x, p, n, error, 2);
    sure += is_sure;
    wrong += is_sure && sgn(height) >= 0;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(sure > 1000);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity}) {
    BOOST_TEST(!kernel::is_surely_before({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, bad, 1));
    BOOST_TEST(!kernel::is_surely_before({0, 0, 0}, {1, 0, 0}, {1, bad, 0}, 0, 1));
    BOOST_TEST(!kernel::is_surely_before({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, 0, bad));
  }
  BOOST_TEST(kernel::is_surely_before({0, 0, 0}, {1, 0, 0}, {1, 0, 0}, 0, 1));
}

BOOST_AUTO_TEST_CASE(a_map_shortens_nothing_below_its_least_stretch)
{
  Random random(5);
  for (int step = 0; step < 500; ++step) {
    std::array<std::array<double, 3>, 3> l = rotation(random.unit() + 0.1, random.unit(), random.unit(), random.unit());
    if (step % 2)
      for (auto& row : l)
        for (double& x : row) x += (random.unit() - 0.5) * std::ldexp(1.0, -(step % 40));
    const double least = kernel::least_stretch(l);
    if (step % 2 == 0) BOOST_TEST(least > 1 - 1e-13);
    for (int k = 0; k < 20; ++k) {
      const double v[3] = {random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
      Rational from = 0, to = 0;
      for (int i = 0; i < 3; ++i) {
        Rational row = 0;
        for (int j = 0; j < 3; ++j) row += Rational(l[i][j]) * Rational(v[j]);
        from += Rational(v[i]) * Rational(v[i]);
        to += row * row;
      }
      BOOST_TEST((Rational(least) * Rational(least) * from <= to));
    }
  }
}

BOOST_AUTO_TEST_CASE(roots_are_rounded_to_the_nearest_double)
{
  Random random(3);
  const auto check = [](const Rational& square) {
    const double x = kernel::nearest_root(square);
    BOOST_TEST(is_nearest_root(x, square));
    // If two doubles are nearest, it is the even one.
    if (is_nearest_root(std::nextafter(x, 0.0), square) || is_nearest_root(std::nextafter(x, HUGE_VAL), square))
      BOOST_TEST(std::remainder(std::ldexp(x, 52 - std::ilogb(x)), 2) == 0);
  };
  for (int step = 0; step < 2000; ++step) {
    const double x = std::ldexp(1 + random.unit(), int(random.unit() * 2000) - 1040);
    const Rational here(x), middle = (here + Rational(std::nextafter(x, HUGE_VAL))) / 2;
    BOOST_TEST(kernel::nearest_root(Rational(here * here)) == x);
    check(middle * middle);
    check(middle * middle * Rational("1000000000000000000000000000001/1000000000000000000000000000000"));
    check(here / 3);
  }
  BOOST_TEST(kernel::nearest_root(Rational(0)) == 0);
  const Rational least(std::numeric_limits<double>::denorm_min());
  BOOST_TEST(kernel::nearest_root(Rational(least * least)) == std::numeric_limits<double>::denorm_min());
  BOOST_TEST(kernel::nearest_root(Rational(least * least / 4)) == 0);
  const Rational most(std::numeric_limits<double>::max());
  BOOST_TEST(kernel::nearest_root(Rational(most * most)) == std::numeric_limits<double>::max());
  BOOST_TEST(std::isinf(kernel::nearest_root(Rational(most * most * 4))));
}

BOOST_AUTO_TEST_SUITE_END()
