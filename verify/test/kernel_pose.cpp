#include "kernel/pose.h"

#include <boost/test/unit_test.hpp>

using namespace tetracone::kernel;

BOOST_AUTO_TEST_CASE(identity_moves_nothing)
{
  BOOST_TEST(Pose().is_identity());
  BOOST_TEST(Pose().determinant_sign() == CGAL::POSITIVE);
  BOOST_TEST(!Pose(std::array<double, 12>{1, 0, 0, 0x1p-1074, 0, 1, 0, 0, 0, 0, 1, 0}).is_identity());
}

BOOST_AUTO_TEST_CASE(eigen_round_trip_keeps_every_entry)
{
  std::array<double, 12> entries;
  for (int k = 0; k < 12; ++k) entries[k] = 1.0 / (k + 3);
  const Pose pose(entries);
  BOOST_TEST((Pose::from_eigen(pose.to_eigen()) == pose));
}

BOOST_AUTO_TEST_CASE(quaternion_rotation_is_exactly_orthonormal)
{
  const Pose pose = Pose::from_quaternion(1, 2, -3, 4, {Rational(1) / 3, 0, 7});
  BOOST_TEST(pose.is_rational());
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Rational dot = 0;
      for (int k = 0; k < 3; ++k) dot += pose.exact(4 * i + k) * pose.exact(4 * j + k);
      BOOST_TEST((dot == (i == j ? 1 : 0)));
    }
  BOOST_TEST(pose.determinant_sign() == CGAL::POSITIVE);
  BOOST_TEST(pose[3] == 1.0 / 3);
}

BOOST_AUTO_TEST_CASE(rational_entries_that_are_doubles_are_the_double_pose)
{
  std::array<Rational, 12> entries;
  for (int k = 0; k < 12; ++k) entries[k] = Rational(k) / 8;
  BOOST_TEST(!Pose(entries).is_rational());
}

BOOST_AUTO_TEST_CASE(determinant_sign_is_exact_where_double_is_not)
{
  // det = 2^-104 > 0, though the double expression rounds to 0.
  const double a = 1 + 0x1p-52;
  const Pose nearly_flat(std::array<double, 12>{a, a * a - 0x1p-104, 0, 0, 1, a, 0, 0, 0, 0, 1, 0});
  const Rational exact = Rational(a) * Rational(a) - Rational(nearly_flat[1]);
  BOOST_TEST(nearly_flat.determinant_sign() == CGAL::sign(exact));
  BOOST_TEST(Pose(std::array<double, 12>{1, 2, 3, 0, 2, 4, 6, 0, 0, 0, 1, 0}).determinant_sign() == CGAL::ZERO);
  BOOST_TEST(Pose(std::array<double, 12>{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}).determinant_sign() == CGAL::NEGATIVE);
}
