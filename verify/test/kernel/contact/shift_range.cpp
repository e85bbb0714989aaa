#include "tetracone/kernel/contact/shift_range.h"

#include "tetracone/kernel/contact/rational_contact.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_shift_range)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;
using Exact_piece = Convex_piece<Rational>;

Exact_piece piece(const std::vector<Rational_point>& corners, const Rational& rise = 0)
{
  Exact_piece result;
  for (Rational_point x : corners) {
    x[2] += rise;
    result.corner[std::size_t(result.count++)] = x;
  }
  return result;
}

/// Encloses a piece. The middles of the enclosures are off by a quarter of the width.
Convex_piece<Interval> about(const Exact_piece& exact, double width)
{
  Convex_piece<Interval> result;
  result.count = exact.count;
  for (int k = 0; k < exact.count; ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = nearest_double(exact.corner[k][i]);
      result.corner[k][i] = Interval(x - width, x + width / 2);
    }
  return result;
}

std::vector<Rational_point> any_triangle(Random& random, int denominator = 1)
{
  for (;;) {
    std::vector<Rational_point> t(3);
    for (Rational_point& x : t)
      for (Rational& coordinate : x) coordinate = Rational(integer(random, -3, 3)) / denominator;
    if (!is_zero(cross(difference(t[1], t[0]), difference(t[2], t[0])))) return t;
  }
}

Rational_face face(const Exact_piece& p)
{
  std::vector<Rational_face::Edge> edges;
  for (int k = 0; k < p.count; ++k) edges.push_back({p.corner[k], p.corner[(k + 1) % p.count]});
  return Rational_face(edges);
}

/// The number of points and pieces that two faces share.
bool share(const Exact_piece& p, const Exact_piece& q) { return !face_contact(face(p), face(q)).empty(); }

BOOST_AUTO_TEST_CASE(triangles_meet_at_both_ends_and_between_them_and_not_beyond)
{
  Random random(2);
  int ranges = 0, flat = 0;
  for (int round = 0; round < 1500; ++round) {
    const auto p = any_triangle(random, 3), q = any_triangle(random, 2);
    const Exact_piece a = piece(p), b = piece(q);
    const Shift_range<Rational> range(a, b), in_integers{Integer_piece(a), Integer_piece(b)};
    BOOST_TEST(in_integers.is_empty() == range.is_empty());
    if (range.is_empty()) {
      // Seen pieces without common area may touch, for a single shift if neither is upright.
      BOOST_TEST(!range.is_certain());
      continue;
    }
    ++ranges;
    BOOST_TEST(range.is_certain());
    const Rational low = range.low()->least, high = range.high()->most;
    BOOST_TEST((low == range.low()->most && high == range.high()->least));
    BOOST_TEST((low == in_integers.low()->least && high == in_integers.high()->most));
    flat += low == high;
    const Rational step(1, 1000);
    for (const Rational& s : {low, high, Rational((low + high) / 2)}) BOOST_TEST(share(piece(p, s), b));
    for (const Rational& s : {Rational(low - step), Rational(high + step)}) BOOST_TEST(!share(piece(p, s), b));
    if (low == high) BOOST_TEST(is_zero(cross(detail::normal(a), detail::normal(b))));
  }
  BOOST_TEST(ranges > 300);
  BOOST_TEST(flat > 0);
}

BOOST_AUTO_TEST_CASE(a_pair_is_empty_where_the_seen_pieces_share_no_area)
{
  const Exact_piece floor = piece({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  const auto is_empty = [&](const Exact_piece& a) { return Shift_range<Rational>(a, floor).is_empty(); };
  BOOST_TEST(is_empty(piece({{2, 0, 1}, {4, 0, 1}, {4, 2, 2}})));   // beside it
  BOOST_TEST(!is_empty(piece({{1, 0, 1}, {4, 0, 1}, {4, 2, 2}})));  // over it
  BOOST_TEST(!is_empty(piece({{1, 0, 1}, {1, 2, 1}, {1, 2, 2}})));  // upright, across it
  BOOST_TEST(is_empty(piece({{2, 0, 1}, {2, 2, 1}, {2, 2, 2}})));   // upright, along its edge
  BOOST_TEST(!is_empty(piece({{0, 0, 5}, {2, 0, 5}, {0, 2, 5}})));  // parallel
  const Exact_piece wall = piece({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}});
  BOOST_TEST(Shift_range<Rational>(wall, wall).is_empty());
}

BOOST_AUTO_TEST_CASE(enclosed_and_rounded_pieces_bound_the_exact_ends)
{
  Random random(3);
  int certain = 0, empty = 0, told_by_rounded = 0;
  for (int round = 0; round < 1500; ++round) {
    const Exact_piece a = piece(any_triangle(random)), b = piece(any_triangle(random, 2));
    const Shift_range<Rational> exact(a, b);
    for (const double width : {0.0, 0x1p-50, 0x1p-4}) {
      const CGAL::Protect_FPU_rounding<true> upward;
      const auto in_a = about(a, width), in_b = about(b, width);
      BOOST_TEST(is_bounded(in_a));
      const Rounded_piece rounded_a(in_a), rounded_b(in_b);
      const Integer_piece whole_a(a), whole_b(b);
      const auto exactly = [&] { return std::array{&whole_a, &whole_b}; };
      for (const auto& range : {Shift_range<Interval>(in_a, in_b), Shift_range<Interval>(rounded_a, rounded_b),
                                Shift_range<Interval>(in_a, in_b, exactly)}) {
        BOOST_TEST(!(range.is_empty() && !exact.is_empty()));
        BOOST_TEST(!(range.is_certain() && exact.is_empty()));
        empty += range.is_empty();
        if (exact.is_empty()) continue;
        if (range.high()) {
          BOOST_TEST(Rational(range.high()->most) >= exact.high()->most);
          BOOST_TEST(Rational(range.low()->least) <= exact.low()->most);
        }
        if (!range.is_certain()) continue;
        ++certain;
        BOOST_TEST(Rational(range.high()->least) <= exact.high()->most);
        BOOST_TEST(Rational(range.low()->most) >= exact.low()->most);
        BOOST_TEST((exact_high(in_a, in_b, range.high()->most, whole_a, whole_b) == exact.high()->most));
      }
      // Axes that are exactly level, or no axes, leave nothing open.
      if (width <= 0x1p-50 && !exact.is_empty() && exact.low()->most < exact.high()->least)
        BOOST_TEST(Shift_range<Interval>(in_a, in_b, exactly).is_certain());
      told_by_rounded += Shift_range<Interval>(rounded_a, rounded_b).is_certain();
    }
  }
  BOOST_TEST(certain > 300);
  BOOST_TEST(empty > 300);
  BOOST_TEST(told_by_rounded > 100);
}

BOOST_AUTO_TEST_CASE(what_could_overflow_is_not_bounded)
{
  const Exact_piece large = piece({{0, 0, 0}, {Rational(0x1p201), 0, 0}, {0, 1, 0}});
  BOOST_TEST(!is_bounded(about(large, 0)));
}

BOOST_AUTO_TEST_SUITE_END()
