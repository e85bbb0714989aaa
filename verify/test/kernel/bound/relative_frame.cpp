#include "tetracone/kernel/bound/relative_frame.h"

#include "verify/test/support/placed_boxes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_relative_frame)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

/// A frame's error of an image's coordinate.
double error(const Bound_point<double>& image, const rationals::Vector& right, int i)
{
  return std::abs(nearest_double(Rational(Rational(image[i]) - right[i])));
}

/// The largest error in units of the bound, at some of the cube's corners; -1 where no bound is known.
double share_of_bound(const Placing& p)
{
  const Relative_frame frame = p.frame();
  if (!(frame.error() < HUGE_VAL)) return -1;
  double worst = 0;
  for (int corner = 0; corner < 8; corner += 3) {
    const Vertex at = {corner & 1 ? -1.0 : 1.0, corner & 2 ? -1.0 : 1.0, corner & 4 ? -1.0 : 1.0};
    const auto image = frame(at);
    const rationals::Vector right = p.image(rationals::exactly(at));
    for (int i = 0; i < 3; ++i)
      worst =
          maximum(worst, std::abs(nearest_double(Rational((Rational(image[i]) - right[i]) / Rational(frame.error())))));
  }
  return worst;
}

/// A pose that the similarity's route refuses: sheared by a thousandth.
Pose sheared(const Pose& pose)
{
  auto entries = pose.entries();
  for (int i = 0; i < 3; ++i) entries[4 * i] += 0x1p-10 * entries[4 * i + 1];
  return Pose(entries);
}

/// The pose with this translation.
Pose placed_at(const Pose& pose, const Vertex& place)
{
  auto entries = pose.entries();
  for (std::size_t i = 0; i < 3; ++i) entries[4 * i + 3] = place[i];
  return Pose(entries);
}

Pose any_pose(Random& random, int kind)
{
  switch (kind % 6) {
    case 0: return Pose();
    case 1: return random_rotation(random);
    case 2: return rounded(random_rotation(random));
    case 3: return random_affine(random);
    case 4: return placed_at(rounded(random_rotation(random)), {0x1p40, 2 * 0x1p40, 3 * 0x1p40});
    default: {  // nearly flat
      auto entries = Pose().entries();
      for (int j = 0; j < 3; ++j) entries[8 + j] = entries[j] + std::ldexp(double(int(random() % 5) - 2), -20);
      entries[10] += 0x1p-12;
      return Pose(entries);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_point_that_is_off_itself_has_an_image_off_by_no_more_than_the_error_of_both)
{
  // Sizes from 2^-40 to 2^40: where B is the larger, the error of its point is most of the whole error.
  Random random(14);
  double worst = 0;
  int known = 0;
  for (int k = 0; k < 3000; ++k) {
    Placing p{any_pose(random, k), any_pose(random, k / 6), {}, {}};
    if (p.a.determinant_sign() == CGAL::ZERO || p.b.determinant_sign() == CGAL::ZERO) continue;
    p.in_a = {real_vertex(random, 2), 1};
    p.in_b = {real_vertex(random, 2), std::ldexp(1.0, int(random() % 81) - 40)};
    const Relative_frame frame = p.frame();
    const double off = std::ldexp(1.0, -10 - int(random() % 43)), bound = frame.error(off);
    if (!(bound < HUGE_VAL)) continue;
    ++known;
    const Vertex right = real_vertex(random, 0.5);
    Vertex at = right;
    for (double& x : at) x += random() % 2 == 0 ? off : -off;
    for (int i = 0; i < 3; ++i) worst = maximum(worst, error(frame(at), p.image(rationals::exactly(right)), i) / bound);
  }
  BOOST_TEST(known > 2000);
  BOOST_TEST(worst <= 1);
  BOOST_TEST(worst > 0.9);
}

BOOST_AUTO_TEST_CASE(fractions_that_round_to_denormals_or_to_0_stay_within_the_error)
{
  Random random(15);
  int known = 0;
  for (int k = 0; k < 1500; ++k) {
    // Any entries of either pose, far below all others, where local units are at the ends of their range.
    const auto with_tiny_entries = [&](const Pose& pose) {
      std::array<Rational, 12> m;
      for (int e = 0; e < 12; ++e)
        m[e] = integer(random, 0, 2) == 0
                   ? Rational(integer(random, 1, 9)) / 7 / rationals::power(integer(random, 1060, 1300))
                   : pose.exact(e);
      return Pose(m);
    };
    const Pose a = k % 2 == 0 ? any_pose(random, k / 2) : with_tiny_entries(any_pose(random, k / 2)),
               b = with_tiny_entries(any_pose(random, k / 6));
    if (a.determinant_sign() == CGAL::ZERO) continue;
    const auto units = [&] {
      const auto end = [&](int most) { return std::ldexp(1.0, integer(random, -1, 1) * most); };
      return Local_scale{real_vertex(random, end(199)), end(200)};
    };
    const Local_scale in_a = units(), in_b = units();
    const double share = share_of_bound({a, b, in_a, in_b});
    known += share >= 0;
    BOOST_TEST(share <= 1);
  }
  BOOST_TEST(known > 300);
}

BOOST_AUTO_TEST_CASE(squares_that_overflow_make_no_similarity_and_no_bound)
{
  // Columns are (1, 0, 0), (0, h, h), (0, -h, h) in any order: entries of M^T M are infinity minus infinity. Such a
  // pose scales its axes differently under any rounding: it is no similarity. The inverse has its own limits. A second
  // pose that shrinks those axes by h makes every entry of M_a^T M_b near 1, so that no other number is too large.
  for (const int exponent : {20, 300, 511, 512, 700, 1000})
    for (int turn = 0; turn < 3; ++turn) {
      const double h = std::ldexp(1.0, exponent);
      std::array<double, 12> entries{};
      const int i = turn, j = (turn + 1) % 3, k = (turn + 2) % 3;
      entries[5 * i] = 1;
      entries[5 * j] = entries[5 * k] = entries[4 * k + j] = h;
      entries[4 * j + k] = -h;
      std::array<double, 12> shrunk{};
      shrunk[5 * i] = 1;
      shrunk[5 * j] = shrunk[5 * k] = 1 / h;
      BOOST_TEST(!Relative_frame(Pose(entries), {}, Pose(), {}).is_similarity());
      for (const Pose& b : {Pose(), Pose(shrunk)})
        if (exponent > 300) BOOST_TEST(std::isinf(Relative_frame(Pose(entries), {}, b, {}).error()));
    }
}

BOOST_AUTO_TEST_CASE(rotations_of_a_scale_that_floats_can_carry_are_similarities_and_shears_are_not)
{
  Random random(5);
  const auto is_similarity = [](const Pose& a, const Pose& b, double unit_a = 1, double unit_b = 1) {
    return Placing{a, b, {{0, 0, 0}, unit_a}, {{0, 0, 0}, unit_b}}.frame().is_similarity();
  };
  for (int k = 0; k < 200; ++k) {
    const Pose a = random_rotation(random), b = rounded(random_rotation(random));
    BOOST_TEST(is_similarity(a, b));
    BOOST_TEST(is_similarity(b, a));
  }
  BOOST_TEST(is_similarity(diagonal(2, 2, 2), Pose()));
  BOOST_TEST(!is_similarity(Pose(std::array<double, 12>{1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}), Pose()));
  BOOST_TEST(!is_similarity(Pose(), diagonal(1, 2, 1)));
  for (const int exponent : {-300, -100, -61, 61, 100, 300}) {
    BOOST_TEST(!is_similarity(Pose(), Pose(), 1, std::ldexp(1.0, exponent)));
    BOOST_TEST(!is_similarity(Pose(), Pose(), std::ldexp(1.0, exponent), 1));
  }
  for (const int exponent : {-60, -20, 0, 20, 60})
    BOOST_TEST(is_similarity(Pose(), Pose(), 1, std::ldexp(1.0, exponent)));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_bounded_is_said_to_be_unknown)
{
  const auto is_unknown = [](const Pose& a, const Pose& b) {
    return std::isinf(Placing{a, b, {}, {}}.frame().error());
  };
  const double tiny = 0x1p-300, huge = 0x1p300;
  for (const Pose& pose : {diagonal(tiny, tiny, tiny), diagonal(huge, huge, huge),
                           Pose(std::array<double, 12>{1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0x1p-60, 0})})
    BOOST_TEST(is_unknown(pose, Pose()));
  BOOST_TEST(std::isinf(Relative_frame().error()));
  // A column of B's that overflows, another that does not.
  const double large = 0x1p40, over = 0x1p1020;
  const Pose turned(
      std::array<double, 12>{large, -large, 0, 0, large, large, 0, 0, 0, 0, 1.4142135623730951 * large, 0});
  for (const Pose& a : {Pose(), turned, sheared(turned)})
    BOOST_TEST(is_unknown(a, Pose(std::array<double, 12>{1, over, 0, 0, 0, over, 0, 0, 0, -over, 1, 0})));
}

BOOST_AUTO_TEST_CASE(both_routes_keep_their_bound_for_scales_units_and_distances_of_every_size)
{
  Random random(6);
  int known = 0;
  double worst = 0;
  for (int k = 0; k < 2400; ++k) {
    const Pose rational = random_rotation(random, 5, {Rational(1) / 3, 0, Rational(-2) / 7});
    Pose a = k % 2 == 0 ? scaled(rounded(rational), std::ldexp(1.0 + real(random, 0, 1), integer(random, -40, 40)))
                        : rational;
    Pose b = k % 3 == 0 ? random_rotation(random, 4)
                        : scaled(rounded(random_rotation(random, 5)), std::ldexp(1.0, integer(random, -60, 60)));
    if (k % 8 >= 4) a = sheared(a);
    if (k % 5 == 0) {  // both far away
      const double distance = std::ldexp(1.0, integer(random, 10, 90));
      a = placed_at(a, {distance, distance + 1, distance + 2});
      b = placed_at(b, {distance, distance, distance});
    }
    const Local_scale in_a{real_vertex(random, k % 7 == 0 ? 1e12 : 1), std::ldexp(1.0, integer(random, -90, 90))};
    const Local_scale in_b{real_vertex(random, k % 11 == 0 ? 1e12 : 1), std::ldexp(1.0, integer(random, -90, 90))};
    const double share = share_of_bound({a, b, in_a, in_b});
    known += share >= 0;
    worst = maximum(worst, share);
  }
  BOOST_TEST(worst <= 1);
  BOOST_TEST(worst > 0.001);
  BOOST_TEST(known > 1500);
}

BOOST_AUTO_TEST_CASE(bodies_modelled_far_off_and_brought_together_keep_their_bound)
{
  // Placed origins are some 1 apart, while what they are summed from is up to 2^60: nearly all cancels.
  Random random(10);
  double worst = 0, worst_of_small = 0;
  for (int k = 0; k < 1200; ++k) {
    const int exponent = integer(random, 0, 60);
    Pose a = k % 3 == 0 ? random_rotation(random, 5) : rounded(random_rotation(random, 5));
    const Pose b = k % 4 == 0 ? random_rotation(random, 5) : rounded(random_rotation(random, 5));
    if (k % 5 == 0) a = sheared(a);
    const Local_scale in_a{real_vertex(random, std::ldexp(1.0, exponent)), 1},
        in_b{real_vertex(random, std::ldexp(1.0, exponent)), 1};
    std::array<Rational, 12> entries;
    for (int n = 0; n < 12; ++n) entries[n] = b.exact(n);
    for (int i = 0; i < 3; ++i) {
      Rational t = a.exact(4 * i + 3) + Rational(real(random, -1, 1));
      for (int j = 0; j < 3; ++j)
        t += a.exact(4 * i + j) * Rational(in_a.origin[j]) - b.exact(4 * i + j) * Rational(in_b.origin[j]);
      entries[4 * i + 3] = k % 2 == 0 ? Rational(nearest_double(t)) : t;
    }
    const Pose near(entries);
    const double share = share_of_bound({a, near, in_a, in_b});
    BOOST_TEST_REQUIRE(share >= 0);
    worst = maximum(worst, share);
    if (exponent >= 10 && exponent < 20 && k % 5 != 0) worst_of_small = maximum(worst_of_small, share);
  }
  BOOST_TEST(worst <= 1);
  BOOST_TEST(worst_of_small > 0.01);
}

BOOST_AUTO_TEST_CASE(a_fraction_that_rounds_to_nothing_has_no_false_bound)
{
  // Times a coordinate near the largest double, it is as large as the body.
  const double small = 0x1p-50;
  int known = 0;
  for (const int exponent : {0, 100, 199, 210, 900, 1000, 1022})
    for (const int digits : {1, 49, 51, 99}) {
      std::array<Rational, 12> entries;
      for (Rational& x : entries) x = 0;
      entries[0] = Rational(0x1p-1074) * Rational(digits) / Rational(100);
      entries[5] = entries[10] = small;
      const Pose flat(entries), straight = diagonal(small, small, small);
      const Local_scale far{{std::ldexp(1.0, exponent), 0, 0}, 4};
      for (const Pose& a : {straight, sheared(straight)}) {
        const double share = share_of_bound({a, flat, {}, far});
        BOOST_TEST(share <= 1);
        known += share >= 0;
      }
    }
  BOOST_TEST(known > 0);
}

BOOST_AUTO_TEST_CASE(scale_is_the_length_of_the_first_column_and_offset_the_image_of_the_origin)
{
  Random random(8);
  for (int k = 0; k < 300; ++k) {
    Placing p{any_pose(random, k % 4), any_pose(random, k / 4 % 4), {}, {real_vertex(random, 1), 0.5}};
    p.in_a = {real_vertex(random, 1), std::ldexp(1.0, integer(random, -3, 3))};
    const Relative_frame frame = p.frame(), same(p.a, p.in_a, p.b, p.in_b, -Origin_offset(p.b, p.in_b, p.a, p.in_a));
    const auto& l = frame.linear();
    BOOST_TEST(frame.scale() == std::sqrt(l[0][0] * l[0][0] + l[1][0] * l[1][0] + l[2][0] * l[2][0]),
               boost::test_tools::tolerance(1e-14));
    BOOST_TEST((frame.offset() == frame(Vertex{0, 0, 0})));
    const auto direction = frame.direction(Vertex{1, 2, 3}), image = frame(Vertex{1, 2, 3});
    for (int i = 0; i < 3; ++i) {
      BOOST_TEST(image[i] == direction[i] + frame.offset()[i]);
      BOOST_TEST(error(frame.offset(), p.image({0, 0, 0}), i) <= frame.error());
      BOOST_TEST((frame.linear()[i] == same.linear()[i]));
      BOOST_TEST(std::abs(frame.offset()[i] - same.offset()[i]) <= 2 * frame.error());
    }
    if (k % 4 < 3 && k / 4 % 4 < 3) BOOST_TEST(frame.scale() == 0.5 / p.in_a.unit, boost::test_tools::tolerance(1e-7));
  }
}

BOOST_AUTO_TEST_CASE(the_origins_are_as_far_apart_as_said)
{
  Random random(9);
  double worst = 0, worst_finer = 0;
  for (int k = 0; k < 3600; ++k) {
    const Pose a = any_pose(random, k), b = any_pose(random, k / 6);
    const Local_scale in_a{real_vertex(random, k % 5 == 0 ? 1e9 : 2), 1}, in_b{real_vertex(random, 3), 8};
    const Origin_offset d(a, in_a, b, in_b), finer = Origin_offset::in_double_double(a, in_a, b, in_b);
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
      Rational right = b.exact(4 * i + 3) - a.exact(4 * i + 3),
               terms = CGAL::abs(b.exact(4 * i + 3)) + CGAL::abs(a.exact(4 * i + 3));
      for (int j = 0; j < 3; ++j) {
        const Rational plus = b.exact(4 * i + j) * Rational(in_b.origin[j]),
                       minus = a.exact(4 * i + j) * Rational(in_a.origin[j]);
        right += plus - minus;
        terms += CGAL::abs(plus) + CGAL::abs(minus);
      }
      const auto off = [&](double x) { return std::abs(nearest_double(Rational(Rational(x) - right))); };
      if (d.error() > 0) worst = maximum(worst, off(d[i]) / d.error());
      if (finer.error() > 0) worst_finer = maximum(worst_finer, off(finer[i]) / finer.error());
      BOOST_TEST(off(d[i]) <= d.error());
      BOOST_TEST(off(finer[i]) <= finer.error());
      BOOST_TEST(nearest_double(terms) <= d.terms() * (1 + 1e-14));
      BOOST_TEST((-d)[i] == -d[i]);
      largest = maximum(largest, std::abs(d[i]));
    }
    BOOST_TEST(d.largest() == largest);
    BOOST_TEST((-d).error() == d.error());
  }
  BOOST_TEST(worst > 0.01);
  BOOST_TEST(worst_finer > 0.01);
}

BOOST_AUTO_TEST_SUITE_END()
