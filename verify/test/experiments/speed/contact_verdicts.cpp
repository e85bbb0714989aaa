#include "experiments/speed/contact_verdicts.h"

#include "verify/cases/shape_generators.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <optional>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_contact_verdicts)

using namespace tetracone;
using experiments::verdict;
using kernel::Rational;

BOOST_AUTO_TEST_CASE(a_list_is_right_where_it_is_the_truth)
{
  using List = std::vector<int>;
  const List truth = {2, 3, 5};
  BOOST_TEST(verdict(truth, truth) == 0);
  BOOST_TEST(verdict(List{2, 5}, truth) == -1);
  BOOST_TEST(verdict(List{2, 4, 5}, truth) == -1);
  BOOST_TEST(verdict(List{2, 3, 4, 5}, truth) == 1);
  BOOST_TEST(verdict(List{}, List{}) == 0);
  BOOST_TEST(verdict(List{1}, List{}) == 1);
}

BOOST_AUTO_TEST_CASE(a_distance_is_right_where_it_is_the_nearest_double)
{
  const double root = std::sqrt(2.0);
  BOOST_TEST(verdict(root, Rational(2), false) == 0);
  BOOST_TEST(verdict(std::nextafter(root, 0.0), Rational(2), false) == 1);
  BOOST_TEST(verdict(std::nextafter(root, 2.0), Rational(2), false) == -1);
  BOOST_TEST(verdict(0.0, Rational(0), false) == 0);
  BOOST_TEST(verdict(0x1p-1074, Rational(0), false) == -1);
}

BOOST_AUTO_TEST_CASE(a_rounded_distance_is_right_where_it_tells_touching_bodies_from_others)
{
  BOOST_TEST(verdict(1.5, Rational(2), true) == 0);
  BOOST_TEST(verdict(0.0, Rational(2), true) == 1);
  BOOST_TEST(verdict(0x1p-60, Rational(0), true) == -1);
  BOOST_TEST(verdict(0.0, Rational(0), true) == 0);
}

BOOST_AUTO_TEST_CASE(a_first_contact_is_right_at_its_exact_time)
{
  const auto at = [](const Rational& x) { return std::vector<Rational>{1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0}; };
  // Face on face after two thirds of the way.
  const verify::Moving_bodies cubes{
      verify::unit_cube(), verify::unit_cube(), {at(0), at(0)}, {at(2), at(Rational(1) / 2)}, {}};
  const double lo = std::nextafter(2 / 3.0, 2 / 3.0 > Rational(2, 3) ? 0.0 : 1.0);
  const kernel::Time_bounds right{std::min(lo, 2 / 3.0), std::max(lo, 2 / 3.0)};
  BOOST_TEST(verdict(right, cubes) == 0);
  BOOST_TEST(verdict(kernel::Time_bounds{0.5, 0.5}, cubes) == 1);
  BOOST_TEST(verdict(kernel::Time_bounds{right.hi, right.hi}, cubes) == 1);
  BOOST_TEST(verdict(std::nullopt, cubes) == -1);
}

BOOST_AUTO_TEST_SUITE_END()
