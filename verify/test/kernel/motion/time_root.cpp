#include "tetracone/kernel/motion/time_root.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_time_root)

using namespace tetracone::kernel;

namespace {

template <std::size_t N>
Integer_form form(const std::array<int, N>& coefficients)
{
  Integer_form f;
  for (const int c : coefficients) f.push_back(c);
  return f;
}

/// The linear form that is n t - m up to a positive factor: zero at m/n.
Integer_form fraction(int m, int n) { return form<2>({-m, n - m}); }

}  // namespace

BOOST_AUTO_TEST_CASE(roots_are_isolated_in_order)
{
  // v = t/s is 1/2, 1 and 3: t is 1/3, 1/2 and 3/4.
  std::vector<Time_root> roots = roots_within(form<4>({-3, 10, -9, 2}));
  BOOST_REQUIRE(roots.size() == 3u);
  BOOST_TEST(roots[0].sign(fraction(1, 3)) == CGAL::ZERO);
  BOOST_TEST(roots[1].sign(fraction(1, 2)) == CGAL::ZERO);
  BOOST_TEST(roots[2].sign(fraction(3, 4)) == CGAL::ZERO);
  BOOST_TEST(roots[0].sign(fraction(333333333, 1000000000)) == CGAL::POSITIVE);
  BOOST_TEST(roots[0].sign(fraction(333333334, 1000000000)) == CGAL::NEGATIVE);
  BOOST_TEST(roots[0].is_before(roots[1]));
  BOOST_TEST(!roots[2].is_before(roots[1]));
  BOOST_TEST(!roots[1].is_before(roots[1]));
}

BOOST_AUTO_TEST_CASE(a_double_root_is_found_once_and_ends_are_not)
{
  BOOST_TEST(roots_within(form<3>({1, -2, 1})).size() == 1u);
  BOOST_TEST(roots_within(form<3>({1, -1, 1})).empty());
  BOOST_TEST(roots_within(form<3>({0, 1, 0})).empty());
  // (v - 1)^2 v: a double root beside one at the start.
  BOOST_TEST(roots_within(form<4>({0, 1, -2, 1})).size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_shared_irrational_root_is_a_zero_and_equal)
{
  // v^2 = 2, and (v^2 - 2) (v + 1).
  std::vector<Time_root> roots = roots_within(form<3>({-2, 0, 1})), others = roots_within(form<4>({-2, -2, 1, 1}));
  BOOST_REQUIRE((roots.size() == 1u && others.size() == 1u));
  BOOST_TEST(!roots[0].is_dyadic());
  BOOST_TEST(roots[0].sign(form<4>({-2, -2, 1, 1})) == CGAL::ZERO);
  BOOST_TEST(roots[0].sign(form<4>({-3, -2, 1, 1})) == CGAL::NEGATIVE);
  BOOST_TEST(!roots[0].is_before(others[0]));
  BOOST_TEST(!others[0].is_before(roots[0]));
  std::vector<Time_root> later = roots_within(form<3>({-200001, 0, 100000}));
  BOOST_TEST(roots[0].is_before(later[0]));
  BOOST_TEST(!later[0].is_before(roots[0]));
}

BOOST_AUTO_TEST_SUITE_END()
