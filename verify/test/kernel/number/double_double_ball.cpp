#include "tetracone/kernel/number/double_double_ball.h"

#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/kernel/number/number.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_double_double_ball)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

using Ball = Double_double_ball;

Rational exact(const Double_double& x) { return Rational(x.high) + Rational(x.low); }

/// A ball, and a number in it: at its border, or anywhere.
struct Held {
  Ball ball;
  Rational number;
};

Held any(Random& random, int exponent)
{
  const double high = std::ldexp(real(random, -1, 1), exponent + int(random() % 20)),
               low = high * std::ldexp(real(random, -1, 1), -54);
  Held held{{Double_double::sum(high, low), 0}, 0};
  if (random() % 2 == 0) held.ball.radius = std::abs(high) * std::ldexp(1.0, -int(random() % 110));
  held.number = exact(held.ball.middle) + Rational(held.ball.radius) * Rational(int(random() % 3) - 1);
  return held;
}

BOOST_AUTO_TEST_CASE(sums_and_products_hold_those_of_what_balls_hold)
{
  Random random(1);
  int outside = 0, wide = 0;
  // Where products underflow, too.
  for (const int exponent : {0, -500, -530})
    for (int k = 0; k < 4000; ++k) {
      std::array<Held, 4> x;
      for (Held& each : x) each = any(random, exponent);
      if (k % 3 == 0) x[2] = {-x[0].ball, -x[0].number};
      if (k % 3 == 0) x[3] = x[1];
      const Ball found = x[0].ball * x[1].ball + x[2].ball * x[3].ball - x[0].ball;
      const Rational number = x[0].number * x[1].number + x[2].number * x[3].number - x[0].number;
      outside += abs(Rational(number - exact(found.middle))) > Rational(found.radius);
      bool are_points = exponent == 0;
      for (const Held& each : x) are_points = are_points && each.ball.radius == 0;
      wide += are_points && found.radius > 0x1p-98 * 0x1p40;
    }
  BOOST_TEST(outside == 0);
  BOOST_TEST(wide == 0);
}

BOOST_AUTO_TEST_CASE(what_overflows_or_is_undefined_is_not_positive)
{
  const Ball large(0x1p600);
  const double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(large.is_positive());
  BOOST_TEST(!(-large).is_positive());
  for (const Ball& x : {large * large, large * large + large, Ball({1, 0}, infinite), Ball({1, 0}, none), Ball(none),
                        Ball({1, 0}, 1), Ball(0)})
    BOOST_TEST(!x.is_positive());
}

BOOST_AUTO_TEST_CASE(a_quotient_of_balls_holds_the_quotients_of_their_numbers)
{
  Random random(3);
  const auto number = [&](int k) {
    return Double_double(real(random, 0.5, 1)) * Double_double(std::ldexp(real(random, 0.5, 1), k % 41 - 20));
  };
  int wrong = 0, wide = 0;
  for (int k = 0; k < 3000; ++k) {
    const Double_double y = number(k / 41), positive = number(k),
                        x = k % 2 == 0 ? positive : Double_double(-positive.high, -positive.low);
    const double x_radius = k % 3 == 0 ? std::abs(x.high) * 0x1p-60 : 0, y_radius = k % 4 == 0 ? y.high * 0x1p-49 : 0;
    const Ball found = Ball(x, x_radius) / Ball(y, y_radius);
    for (const int side_x : {-1, 1})
      for (const int side_y : {-1, 1}) {
        const Rational quotient =
            Rational(exact(x) + side_x * Rational(x_radius)) / Rational(exact(y) + side_y * Rational(y_radius));
        wrong += abs(Rational(exact(found.middle) - quotient)) > Rational(found.radius);
      }
    wide += x_radius == 0 && y_radius == 0 && !(found.radius < std::abs(found.middle.high) * 0x1p-98);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(wide == 0);
  const double infinite = std::numeric_limits<double>::infinity();
  for (const Ball& y : {Ball(0), Ball(-1), Ball({1, 0}, 0x1p-48), Ball({1, 0}, infinite), Ball(infinite)})
    BOOST_TEST(!((Ball(1) / y).radius < infinite));
  // Rationals beyond the last bit decide between a double and its neighbours.
  BOOST_TEST(((Ball(1) / Ball(3)).nearest() == std::optional(1.0 / 3)));
  BOOST_TEST(!(Ball({1, 0x1p-53}, 0) / Ball(1)).nearest().has_value());
}

BOOST_AUTO_TEST_CASE(the_nearest_double_to_a_quotient_is_told_unless_two_are_as_near)
{
  Random random(2);
  int wrong = 0, untold = 0;
  for (int k = 0; k < 3000; ++k) {
    const Double_double top = Double_double(real(random, 0.5, 1)) * Double_double(std::ldexp(1.0, int(k % 40) - 20)),
                        square = Double_double(real(random, 0.5, 1)) * Double_double(real(random, 0.5, 1));
    const auto found = nearest_over_root({top, 0}, {square, 0});
    const Rational t = exact(top);
    untold += !found;
    wrong += found && *found != nearest_root(Rational(t * t), exact(square));
    // The middle of two doubles, and what is a double.
    const double x = real(random, 1, 2), above = std::nextafter(x, 3);
    wrong += nearest_over_root({Double_double::sum(x, (above - x) / 2), 0}, 1).has_value();
    wrong += nearest_over_root(x, 1) != std::optional(x) || nearest_over_root(x, 0.25) != std::optional(2 * x);
    // A ball that is too wide has no nearest double.
    wrong += nearest_over_root({x, 0x1p-50}, 1).has_value();
  }
  // Powers of two have a nearer neighbour below.
  for (const double below : {0x1p-55, 0x1.8p-54})
    wrong += nearest_over_root({Double_double(1, -below), 0}, 1) != std::optional(below < 0x1p-54 ? 1 : 1 - 0x1p-53);
  BOOST_TEST(wrong == 0);
  BOOST_TEST(untold == 0);
}

BOOST_AUTO_TEST_SUITE_END()
