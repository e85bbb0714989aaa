#include "tetracone/kernel/motion/motion_filter.h"

#include "tetracone/kernel/number/number.h"
#include "verify/cases/random.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_motion_filter)

using namespace tetracone::kernel;
using tetracone::verify::Random;

/// The form over a span of time, in rationals, of the coefficients in doubles that `motion_filter` keeps.
template <std::size_t N>
std::array<Rational, N> over(std::array<Rational, N> form, const std::vector<bool>& second_halves)
{
  for (const bool second : second_halves) {
    std::array<Rational, N> last;
    for (std::size_t round = 0; round < N; ++round) {
      last[N - 1 - round] = form[N - 1];
      for (std::size_t k = N - 1; k > round; --k) form[k] = (form[k - 1] + form[k]) / 2;
    }
    if (second) form = last;
  }
  return form;
}

/// The largest error of a form of doubles, over its bound.
template <std::size_t N>
double worst(const motion_filter::Scaled<N>& form, const std::array<Rational, N>& exact, double bound)
{
  double ratio = 0;
  for (std::size_t k = 0; k < N; ++k) {
    const double error = Rational(abs(Rational(Rational(form[k]) - exact[k]))).get_d();
    ratio = maximum(ratio, error / bound);
  }
  return ratio;
}

/// Coordinates with much cancellation: near one point, or near a plane, or anywhere, under one scale.
Moving_pair pair_of(Random& random)
{
  const int how = static_cast<int>(random.bits() % 3);
  const double scale = std::ldexp(1, static_cast<int>(random.bits() % 200) - 100);
  const double spread = how == 0 ? 1e-9 : 1;
  Moving_pair pair{Moving_kind::edge_edge, {}};
  for (Moving_point& p : pair.points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p.start[axis] = scale * (1 + spread * random.symmetric());
      p.end[axis] = scale * (0.3 + spread * random.symmetric());
    }
  if (how == 1)
    for (Moving_point& p : pair.points) {
      p.start[2] = p.start[0] - 0.7 * p.start[1];
      p.end[2] = p.end[0] - 0.7 * p.end[1];
    }
  return pair;
}

Linear_vector<Rational> difference(const Moving_pair& pair, std::size_t k)
{
  Linear_vector<Rational> d;
  for (std::size_t axis = 0; axis < 3; ++axis)
    d[axis] = {Rational(Rational(pair.points[k].start[axis]) - Rational(pair.points[0].start[axis])),
               Rational(Rational(pair.points[k].end[axis]) - Rational(pair.points[0].end[axis]))};
  return d;
}

std::array<Rational, 3> scaled(const Quadratic_form<Rational>& q)
{
  return {Rational(2 * q[0]), q[1], Rational(2 * q[2])};
}

/// A vertex that falls through a face: (x, y, 1) to (x, y, -1), the face's corners at 0.
Moving_pair falling(double x, double y)
{
  return {Moving_kind::vertex_face,
          {{{{x, y, 1}, {x, y, -1}}, {{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {0, 1, 0}}}}};
}

BOOST_AUTO_TEST_CASE(errors_stay_within_their_bounds_after_all_halvings)
{
  Random random(1);
  double cross = 0, sum = 0, volume = 0;
  for (int k = 0; k < 600; ++k) {
    const Moving_pair pair = pair_of(random);
    const motion_filter::Forms forms = motion_filter::forms(pair);
    BOOST_REQUIRE(forms.in_range);
    std::vector<bool> second_halves;
    motion_filter::Span span = forms.span;
    const int steps = static_cast<int>(random.bits() % (motion_filter::halvings + 1));
    for (int step = 0; step < steps; ++step) {
      const bool second = random.bits() % 2 == 0;
      second_halves.push_back(second);
      const auto go = [&](auto& form) {
        const auto last = motion_filter::halve(form);
        if (second) form = last;
      };
      go(span.volume);
      for (auto& turns : span.turns)
        for (auto& turn : turns) go(turn);
    }
    const auto a = difference(pair, 1), b = difference(pair, 2), c = difference(pair, 3);
    std::array<Quadratic_form<Rational>, 3> n1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      n1[axis] = cross_form(a, b, axis);
      const std::array exact = {n1[axis], cross_form(b, c, axis), cross_form(c, a, axis)};
      Quadratic_form<Rational> all;
      for (std::size_t i = 0; i < 3; ++i) all[i] = exact[0][i] + exact[1][i] + exact[2][i];
      for (std::size_t i = 0; i < 3; ++i)
        cross = maximum(cross,
                        worst(span.turns[axis][i], over(scaled(exact[i]), second_halves), forms.errors.turns[axis][i]));
      sum = maximum(sum, worst(span.turns[axis][3], over(scaled(all), second_halves), forms.errors.turns[axis][3]));
    }
    const auto v = dot_form(n1, c);
    volume =
        maximum(volume, worst(span.volume, over<4>({Rational(3 * v[0]), v[1], v[2], Rational(3 * v[3])}, second_halves),
                              forms.errors.volume));
  }
  BOOST_TEST(cross <= 1);
  BOOST_TEST(sum <= 1);
  BOOST_TEST(volume <= 1);
  // The bounds are of what happens: rounding is met.
  BOOST_TEST(cross > 0.001);
  BOOST_TEST(volume > 0.0005);
}

BOOST_AUTO_TEST_CASE(a_bound_is_held_by_values_just_beyond_it_alone)
{
  using motion_filter::certain_sign;
  BOOST_TEST(certain_sign<3>({2, 2, 2}, 1) == 1);
  BOOST_TEST(certain_sign<3>({-2, -2, -2}, 1) == -1);
  BOOST_TEST(certain_sign<3>({2, 2, 1}, 1) == 0);
  BOOST_TEST(certain_sign<3>({2, -2, 2}, 1) == 0);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  BOOST_TEST(certain_sign<3>({2, nan, 2}, 1) == 0);
  BOOST_TEST(certain_sign<3>({2, 2, 2}, nan) == 0);
  BOOST_TEST(certain_sign<3>({2, infinity, 2}, infinity) == 0);
}

BOOST_AUTO_TEST_CASE(doubles_decide_clear_contact_and_clear_misses)
{
  BOOST_TEST((filtered_contact(falling(0.25, 0.25)) == Moving_contact::meet));
  BOOST_TEST((filtered_contact(falling(0.75, 0.75)) == Moving_contact::apart));
  BOOST_TEST((filtered_contact(falling(0.5, 0.5)) == Moving_contact::uncertain));
  BOOST_TEST((filtered_contact(falling(0, 0)) == Moving_contact::uncertain));
  BOOST_TEST(apart_along_an_axis(falling(2, 0)));
  BOOST_TEST(!apart_along_an_axis(falling(1, 0)));
}

BOOST_AUTO_TEST_CASE(what_overflows_or_underflows_is_uncertain)
{
  for (const double scale : {0x1p200, 0x1p1000, 0x1p-500, 0x1p-1060}) {
    Moving_pair pair = falling(0.25, 0.25);
    for (Moving_point& p : pair.points)
      for (Vertex* const v : {&p.start, &p.end})
        for (double& x : *v) x *= scale;
    BOOST_TEST((filtered_contact(pair) == Moving_contact::uncertain));
  }
  Moving_pair pair = falling(0.25, 0.25);
  pair.points[0].start[2] = std::numeric_limits<double>::infinity();
  BOOST_TEST((filtered_contact(pair) != Moving_contact::meet));
  pair.points[0].start[2] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST((filtered_contact(pair) == Moving_contact::uncertain));
}

BOOST_AUTO_TEST_SUITE_END()
