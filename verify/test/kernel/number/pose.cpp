#include "tetracone/kernel/number/pose.h"

#include "verify/test/support/rationals.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_pose)

using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;

BOOST_AUTO_TEST_CASE(identity_moves_nothing)
{
  BOOST_TEST(Pose().is_identity());
  BOOST_TEST(Pose().determinant_sign() == CGAL::POSITIVE);
  for (int k = 0; k < 12; ++k) {
    std::array<double, 12> entries = Pose().entries();
    entries[k] = -entries[k];
    BOOST_TEST(Pose(entries).is_identity() == (k % 5 != 0));  // -0 is 0
    entries[k] = 0x1p-1074;
    BOOST_TEST(!Pose(entries).is_identity());
  }
}

BOOST_AUTO_TEST_CASE(an_eigen_round_trip_keeps_every_entry_and_rationals_that_are_doubles_make_the_double_pose)
{
  std::array<double, 12> entries;
  std::array<Rational, 12> eighths;
  for (int k = 0; k < 12; ++k) {
    entries[k] = 1.0 / (k + 3);
    eighths[k] = Rational(k) / 8;
  }
  BOOST_TEST((Pose::from_eigen(Pose(entries).to_eigen()) == Pose(entries)));
  BOOST_TEST(!Pose(eighths).is_rational());
}

BOOST_AUTO_TEST_CASE(quaternion_rotation_is_exactly_orthonormal)
{
  const Pose pose = Pose::from_quaternion(1, 2, -3, 4, {Rational(1) / 3, 0, 7});
  BOOST_TEST(pose.is_rational());
  BOOST_TEST(rationals::is_orthonormal(pose));
  BOOST_TEST(pose.determinant_sign() == CGAL::POSITIVE);
  BOOST_TEST(pose[3] == 1.0 / 3);
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

BOOST_AUTO_TEST_CASE(determinant_sign_is_exact_where_products_underflow)
{
  // Diagonal 2^1000 * 2^-600 * 2^-500 = 2^-100, and the rest -2^-150 * 2^-500: a product underflows before a huge entry
  // meets it.
  const Pose pose(std::array<double, 12>{0x1p1000, 0x1p-150, 0, 0, 1, 0x1p-600, 0, 0, 0, 0, 0x1p-500, 0});
  BOOST_TEST(pose.determinant_sign() == CGAL::POSITIVE);
  // Every matrix of small powers of two against the exact sum, over the whole range of exponents.
  std::uint64_t state = 1;
  const auto bits = [&state] { return (state = state * 6364136223846793005u + 1442695040888963407u) >> 33; };
  for (int sample = 0; sample < 2000; ++sample) {
    std::array<double, 12> m{};
    for (int k = 0; k < 12; ++k) {
      const int exponent = sample % 2 == 0 ? int(bits() % 2000) - 1000 : int(bits() % 8) - 4;
      m[k] = bits() % 4 == 0 ? 0.0 : std::ldexp(bits() % 2 == 0 ? 1.0 : -1.5, exponent);
    }
    const auto row = [&](int i) { return rationals::exactly({m[4 * i], m[4 * i + 1], m[4 * i + 2]}); };
    const Rational exact = rationals::determinant(row(0), row(1), row(2));
    BOOST_REQUIRE(Pose(m).determinant_sign() == CGAL::sign(exact));
  }
}

BOOST_AUTO_TEST_SUITE_END()
