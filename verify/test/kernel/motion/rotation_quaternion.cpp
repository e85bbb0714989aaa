#include "tetracone/kernel/motion/rotation_quaternion.h"

#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_rotation_quaternion)

using namespace tetracone::kernel;

/// The pose of a quaternion, exactly.
Pose pose_of(const std::array<Rational, 4>& q) { return Body_motion::rigid({q, {}}, {q, {}})->at(0); }

double length(const std::array<Rational, 4>& q)
{
  double square = 0;
  for (const Rational& x : q) square += x.get_d() * x.get_d();
  return std::sqrt(square);
}

BOOST_AUTO_TEST_CASE(an_exact_rotation_has_an_exact_quaternion_whatever_its_angle)
{
  std::mt19937 random(1);
  const auto number = [&] { return Rational(int(random() % 13) - 6); };
  int half_turns = 0;
  for (int k = 0; k < 500; ++k) {
    const std::array<Rational, 4> q = {k % 5 == 0 ? Rational(0) : number(), number(), number(), number()};
    if (q == std::array<Rational, 4>{}) continue;
    half_turns += q[0] == 0;
    const auto found = rotation_quaternion(pose_of(q));
    BOOST_REQUIRE(found);
    BOOST_TEST(found->error == 0);
    BOOST_TEST(std::abs(length(found->quaternion) - 1) < 1e-12);
    // The quaternions are equal up to a factor.
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) BOOST_TEST((found->quaternion[i] * q[j] == found->quaternion[j] * q[i]));
  }
  BOOST_TEST(half_turns > 50);
}

BOOST_AUTO_TEST_CASE(a_rounded_rotation_has_a_quaternion_of_doubles_and_the_error_that_it_has)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const double noise : {0.0, 1e-7, 2e-6}) {
    for (int k = 0; k < 200; ++k) {
      const std::array<Rational, 4> q = {number(random), number(random), number(random), number(random)};
      std::array<double, 12> entries = pose_of(q).entries();
      for (double& x : entries) x += noise * number(random);
      const auto found = rotation_quaternion(Pose(entries));
      BOOST_REQUIRE(found);
      for (const Rational& x : found->quaternion) BOOST_TEST((x == Rational(nearest_double(x))));
      const Pose turned = pose_of(found->quaternion);
      double error = 0;
      for (int i = 0; i < 12; ++i)
        if (i % 4 != 3) error = std::max(error, std::abs(Rational(turned.exact(i) - Rational(entries[i])).get_d()));
      BOOST_TEST(found->error == error, boost::test_tools::tolerance(1e-12));
      BOOST_TEST(found->error > 0);
      BOOST_TEST(found->error < 4 * noise + 1e-15);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_far_from_a_rotation_has_none)
{
  for (const std::array<double, 12>& rows : {std::array<double, 12>{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0},
                                             {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0},
                                             {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0},
                                             {1, 1e-4, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
                                             {1 + 2e-5, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
                                             {1e300, 1e300, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
                                             {5e-324, 0, 0, 0, 0, 5e-324, 0, 0, 0, 0, 5e-324, 0}})
    BOOST_TEST(!rotation_quaternion(Pose(rows)));
}

BOOST_AUTO_TEST_CASE(the_short_way_is_taken)
{
  const Rigid_pose from;
  Rigid_pose to{{-3, 1, 0, 0}, {1, 2, 3}};
  take_short_way(from, to);
  BOOST_TEST(to.quaternion[0] == 3);
  BOOST_TEST(to.quaternion[1] == -1);
  BOOST_TEST(to.translation[2] == 3);
  take_short_way(from, to);
  BOOST_TEST(to.quaternion[0] == 3);
}

BOOST_AUTO_TEST_SUITE_END()
