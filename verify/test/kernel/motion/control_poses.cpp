#include "tetracone/kernel/motion/control_poses.h"

#include "verify/cases/random.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_control_poses)

using namespace tetracone::kernel;
using tetracone::verify::Random;
namespace rationals = tetracone::verify::rationals;

Rational part(int n, int d) { return Rational(n) / d; }

/// A turn, from short to nearly whole, by quaternions of different lengths.
Body_motion any_turn(Random& random)
{
  const auto small = [&] { return part(int(random.bits() % 17) - 8, 1 + int(random.bits() % 5)); };
  const Rational length = part(1 + int(random.bits() % 40), 10);
  Rigid_pose from{{part(9, 2), small(), small(), small()}, {small(), small(), small()}}, to = from;
  to.translation = {small(), small(), small()};
  const int kind = int(random.bits() % 3);
  for (Rational& x : to.quaternion)
    x = kind == 0 ? Rational(x + small() / 9) : kind == 1 ? small() : Rational(-x * length);
  to.quaternion[1] += part(1, kind == 2 ? 50 : 7);
  return Body_motion::rigid(from, to).value();
}

BOOST_AUTO_TEST_CASE(a_point_stays_in_the_hull_of_its_images)
{
  Random random(5);
  std::size_t undivided = 0, divided = 0;
  for (int n = 0; n < 60; ++n) {
    const Body_motion motion = any_turn(random);
    const auto poses = control_poses(motion);
    BOOST_REQUIRE(poses.has_value());
    ++(poses->size() <= 4 ? undivided : divided);
    const auto whole = [&] { return Rational(int(random.bits() % 19) - 9); };
    for (int k = 0; k < 4; ++k) {
      const rationals::Vector point = {whole(), whole(), whole()}, direction = {whole(), whole(), whole()};
      Rational most = rationals::inner(direction, rationals::image(poses->front(), point));
      for (const Pose& pose : *poses) {
        const Rational at = rationals::inner(direction, rationals::image(pose, point));
        if (at > most) most = at;
      }
      for (int t = 0; t <= 12; ++t)
        BOOST_REQUIRE(rationals::inner(direction, rationals::image(motion.at(part(t, 12)), point)) <= most);
    }
    for (const Pose& pose : *poses)
      for (int k = 0; k < 11; ++k) BOOST_TEST((k % 4 == 3 || abs(pose.exact(k)) <= 2));
  }
  BOOST_TEST(undivided > 10u);
  BOOST_TEST(divided > 10u);
}

BOOST_AUTO_TEST_CASE(a_motion_on_lines_stays_between_its_ends)
{
  const Pose from = Pose::translation(1, 2, 3), to = Pose::from_quaternion(1, 2, 3, 4);
  const auto poses = control_poses(Body_motion::linear(from, to));
  BOOST_REQUIRE(poses.has_value());
  BOOST_TEST((*poses == std::vector<Pose>{from, to}));
  const auto shifted = control_poses(Body_motion::rigid({{3, 0, 0, 4}, {1, 2, 3}}, {{3, 0, 0, 4}, {5, 6, 7}}).value());
  BOOST_REQUIRE(shifted.has_value());
  BOOST_TEST(shifted->size() == 2u);
}

BOOST_AUTO_TEST_CASE(what_turns_too_fast_or_goes_too_far_has_none)
{
  const Rational tiny = part(1, 1000000000) * part(1, 1000000000);
  BOOST_TEST(!control_poses(Body_motion::rigid({}, {{-1, tiny, 0, 0}, {}}).value()));
  const Integer huge = Integer(1) << 2000;
  BOOST_TEST(!control_poses(Body_motion::rigid({}, {{1, 1, 0, 0}, {Rational(huge), 0, 0}}).value()));
}

BOOST_AUTO_TEST_SUITE_END()
