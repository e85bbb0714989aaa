#include "tetracone/covering/io/read_points.h"

#include "verify/test/support/suite.h"
#include "verify/test/support/temporary_file.h"

BOOST_AUTO_TEST_SUITE(test_read_points)

using namespace tetracone::covering;
using tetracone::kernel::Rational;
using tetracone::verify::Temporary_file;

namespace {

std::string error_of(const std::string& text) { return tetracone::verify::error_of(text, read_points); }

}  // namespace

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

BOOST_AUTO_TEST_CASE(the_first_thing_wrong_is_named_with_its_line)
{
  BOOST_TEST(error_of("") == ": holds no point; expected three numbers a line");
  BOOST_TEST(error_of("0 0 0\n0 0\n") == ":2: 2 numbers; expected 3, the coordinates of a point");
  BOOST_TEST(error_of("0 0 0 0\n") == ":1: 4 numbers; expected 3, the coordinates of a point");
  BOOST_TEST(error_of("0 0 nan\n") == ":1: 'nan' as number 3; expected a finite decimal number or a fraction n/d");
}

BOOST_AUTO_TEST_SUITE_END()
