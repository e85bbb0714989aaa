#include "tetracone/covering/io/read_numbers.h"

#include "tetracone/covering/io/read_points.h"
#include "tetracone/covering/io/read_rays.h"
#include "verify/test/support/suite.h"
#include "verify/test/support/temporary_file.h"

// The readers of points and of rays, which read their numbers alike.

BOOST_AUTO_TEST_SUITE(test_read_numbers)

using namespace tetracone::covering;
using tetracone::kernel::Rational;
using tetracone::verify::Temporary_file;

std::string error_of(const std::string& text) { return tetracone::verify::error_of(text, read_points); }

BOOST_AUTO_TEST_CASE(numbers_are_separated_by_blanks_or_by_a_comma)
{
  const Temporary_file file("points.txt",
                            "# x, y, z, and a comma at the end of a comment,\n1,2,3\n4 , 5,\t1/3 # a, b,\r\n\n7 8, 9");
  const auto points = read_points(file.path());
  BOOST_REQUIRE(points.size() == 3u);
  BOOST_TEST(points[0][1].nearest == 2);
  BOOST_TEST((points[1][2].exact() == Rational(1) / 3));
  BOOST_TEST(points[2][2].nearest == 9);
  const Temporary_file rays("rays.txt", "0,0,0,1,0,0\n");
  BOOST_TEST(read_rays(rays.path()).size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_comma_stands_between_two_numbers)
{
  const std::string wrong = " a comma without a number on either side; expected one between two";
  for (const std::string line : {"1,,2,3", ",1,2,3", "1,2,3,", "1,2,3, # more", "1,2, ,3", ","})
    BOOST_TEST(error_of("0 0 0\n" + line + "\n0 0 0\n") == ":2:" + wrong, line);
  BOOST_TEST(error_of("1,2,3\n1,2,3,") == ":2:" + wrong);
  // A comma is no decimal point.
  BOOST_TEST(error_of("0,5 0,5 0,5\n") == ":1: 6 numbers; expected 3, the coordinates of a point");
}

BOOST_AUTO_TEST_CASE(points_are_doubles_or_fractions)
{
  const Temporary_file file("points.txt", "# two\n0.1 -2 3e-1 # one\n\n1/3 2/4 1\n");
  const auto points = read_points(file.path());
  BOOST_REQUIRE(points.size() == 2u);
  BOOST_TEST(points[0][0].nearest == 0.1);
  BOOST_TEST(!points[0][0].fraction.has_value());
  BOOST_TEST((points[0][0].exact() == Rational(0.1)));
  BOOST_TEST((points[1][0].exact() == Rational(1) / 3));
  BOOST_TEST(points[1][0].nearest == 1.0 / 3);
  BOOST_TEST((points[1][1].exact() == Rational(1) / 2));
}

BOOST_AUTO_TEST_CASE(rays_are_six_doubles)
{
  const Temporary_file file("rays.txt", "# one\n0.1 -2 3e-1 0 0 5 # one\n");
  const auto rays = read_rays(file.path());
  BOOST_REQUIRE(rays.size() == 1u);
  BOOST_TEST((rays[0] == std::array<double, 6>{0.1, -2, 0.3, 0, 0, 5}));
}

BOOST_AUTO_TEST_CASE(the_first_thing_wrong_is_named_with_its_line)
{
  BOOST_TEST(error_of("") == ": holds no point; expected three numbers a line");
  BOOST_TEST(error_of("0 0 0\n0 0\n") == ":2: 2 numbers; expected 3, the coordinates of a point");
  BOOST_TEST(error_of("0 0 0 0\n") == ":1: 4 numbers; expected 3, the coordinates of a point");
  BOOST_TEST(error_of("0 0 nan\n") == ":1: 'nan' as number 3; expected a finite decimal number or a fraction n/d");
  const auto of_rays = [](const std::string& text) { return tetracone::verify::error_of(text, read_rays); };
  BOOST_TEST(of_rays("") == ": holds no ray; expected six numbers a line");
  BOOST_TEST(of_rays("0 0 0 1 0 0\n0 0\n") == ":2: 2 numbers; expected 6, the origin and the direction of a ray");
  BOOST_TEST(of_rays("0 0 1/3 1 0 0\n") == ":1: '1/3' as number 3; expected a finite decimal number");
  BOOST_TEST(of_rays("0 0 1 0 -0 0\n") == ":1: the direction is 0; expected a direction of any other length");
}

BOOST_AUTO_TEST_SUITE_END()
