#include "tetracone/covering/io/read_numbers.h"

#include "tetracone/covering/io/read_points.h"
#include "tetracone/covering/io/read_rays.h"
#include "verify/test/support/suite.h"
#include "verify/test/support/temporary_file.h"

BOOST_AUTO_TEST_SUITE(test_read_numbers)

using namespace tetracone::covering;
using tetracone::verify::Temporary_file;

namespace {

std::string error_of(const std::string& text) { return tetracone::verify::error_of(text, read_points); }

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_are_separated_by_blanks_or_by_a_comma)
{
  const Temporary_file file("points.txt",
                            "# x, y, z, and a comma at the end of a comment,\n1,2,3\n4 , 5,\t1/3 # a, b,\r\n\n7 8, 9");
  const auto points = read_points(file.path());
  BOOST_REQUIRE(points.size() == 3u);
  BOOST_TEST(points[0][1].nearest == 2);
  BOOST_TEST((points[1][2].exact() == tetracone::kernel::Rational(1) / 3));
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

BOOST_AUTO_TEST_SUITE_END()
