#include "tetracone/kernel/contact/direction_view.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_direction_view)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;

Rational_point seen(const Direction_view& view, const Pose& pose, const Rational_point& x)
{
  return tetracone::verify::rationals::image(Pose(view.of(pose)), x);
}

BOOST_AUTO_TEST_CASE(a_step_along_the_direction_changes_the_height_alone)
{
  Random random(1);
  for (int round = 0; round < 30; ++round) {
    Rational_point d;
    do
      for (Rational& x : d) x = Rational(integer(random, -3, 3), 1 + round % 3);
    while (is_zero(d));
    for (Rational& x : d) x.canonicalize();
    const Direction_view view(d);
    const Pose pose = random_affine(random);
    const Rational_point x = {1, Rational(2, 3), -5}, before = seen(view, pose, x);
    const auto [moved, unmoved] = moved_along(pose, pose, d, Rational(7, 2));
    BOOST_TEST((unmoved == pose));
    const Rational_point after = seen(view, moved, x);
    BOOST_TEST(view.height() > 0);
    BOOST_TEST((difference(after, before) == Rational_point{0, 0, Rational(7, 2) * view.height()}));
  }
}

BOOST_AUTO_TEST_CASE(poses_beyond_the_doubles_are_scaled_together)
{
  const Pose far = Pose::translation(0x1p1023, 0, 1), near = Pose::translation(0, 3, 0);
  const auto [moved, other] = moved_along(far, near, {1, 0, 0}, Rational(0x1p1023));
  for (int k = 0; k < 12; ++k) BOOST_TEST(std::isfinite(moved[k]));
  const Rational scale = other.exact(0);
  BOOST_TEST(scale > 0);
  BOOST_TEST((moved.exact(3) == scale * 2 * Rational(0x1p1023)));
  BOOST_TEST((moved.exact(5) == scale && moved.exact(11) == scale && other.exact(7) == 3 * scale));
}

BOOST_AUTO_TEST_SUITE_END()
