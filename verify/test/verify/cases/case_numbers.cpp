// The numbers of a case: taken out, put back, measured.

#include "verify/cases/case_numbers.h"

#include "verify/cases/shape_generators.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <memory>

BOOST_AUTO_TEST_SUITE(test_case_numbers)

using namespace tetracone;

BOOST_AUTO_TEST_CASE(an_odd_mantissa_and_a_power_of_two_make_the_number_again)
{
  for (const double x : {1.0, -3.0, 0.1, 12.0, 0x1p-1074, 0x1.8p-1030, std::numeric_limits<double>::max(), -0x1p1000}) {
    const verify::Odd parts = verify::odd(x);
    BOOST_TEST(parts.mantissa % 2 == 1u);
    BOOST_TEST(std::ldexp(double(parts.mantissa), parts.exponent) == std::abs(x));
  }
  BOOST_TEST(verify::odd(0).mantissa == 0u);
}

BOOST_AUTO_TEST_CASE(the_identity_and_zeros_have_no_bits)
{
  verify::Predicate_case c{};
  c.v = {};
  c.p = c.q = c.r = {0, 0, 0};
  BOOST_TEST(verify::bits(numbers_of(c)) == 0u);
  c.r[2] = 5;
  BOOST_TEST(verify::bits(numbers_of(c)) == 3u);
  c.pose_a = kernel::Pose::translation(0, 1, 0);
  BOOST_TEST(verify::bits(numbers_of(c)) == 5u);
  c.pose_a = kernel::Pose::from_quaternion(1, 1, 1, 0);
  BOOST_TEST(verify::bits(numbers_of(c)) > 20u);
}

BOOST_AUTO_TEST_CASE(numbers_put_back_change_nothing_else)
{
  verify::Object_case c;
  c.a = std::make_shared<covering::Polyhedron>(verify::unit_cube());
  c.b = std::make_shared<covering::Polyhedron>(verify::prism_with_tunnel());
  c.origin.family = "voxels";
  c.solid = true;
  auto numbers = numbers_of(c);
  numbers.points[1][3][0] += 1;
  const auto changed = with_numbers(c, numbers);
  BOOST_TEST((changed.a == c.a));
  BOOST_TEST((changed.b != c.b));
  BOOST_TEST(changed.b->vertices[3][0] == c.b->vertices[3][0] + 1);
  BOOST_TEST(changed.b->face_count() == c.b->face_count());
  BOOST_TEST(changed.origin.family == "voxels");
  BOOST_TEST(!changed.solid.has_value());

  verify::Predicate_case p;
  p.v = {{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}}};
  p.p = {13, 14, 15};
  p.q = {16, 17, 18};
  p.r = {19, 20, 21};
  const auto same = with_numbers(p, numbers_of(p));
  BOOST_TEST((same.v == p.v && same.p == p.p && same.q == p.q && same.r == p.r));
}

BOOST_AUTO_TEST_SUITE_END()
