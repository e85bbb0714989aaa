#include "tetracone/kernel/motion/time_root.h"

#include "verify/test/support/integer_forms.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_time_root)

using namespace tetracone::kernel;
using tetracone::verify::form;

/// The linear form that is n t - m up to a positive factor: zero at m/n.
Integer_form fraction(int m, int n) { return form<2>({-m, n - m}); }

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

BOOST_AUTO_TEST_CASE(signs_of_forms_that_nearly_vanish_are_exact)
{
  std::mt19937_64 random(1);
  const auto below = [&](long n) { return long(random() % std::uint64_t(n)); };
  std::array<int, 3> count = {};
  for (int round = 0; round < 4000; ++round) {
    const long n = 3 + 2 * below(1L << 20), m = 1 + below(n - 1);  // no dyadic time
    std::vector<Time_root> roots = roots_within(Integer_form(std::array<Integer, 2>{Integer(-m), Integer(n - m)}));
    BOOST_REQUIRE(roots.size() == 1u);
    // Factors that vanish 2^-k from there, and one of coefficients of many sizes.
    Integer_form g(std::array<Integer, 1>{Integer(1)});
    for (long factor = below(5); factor-- > 0;) {
      const Integer q = Integer(n) << unsigned(below(70)), p = (q / n) * m + below(3) - 1;
      g = g * Integer_form(std::array<Integer, 2>{Integer(-p), Integer(q - p)});
    }
    Integer_form other;
    for (long k = 1 + below(14); k-- > 0;) other.push_back((Integer(below(2001)) - 1000) << unsigned(below(60)));
    g = g * other;
    const CGAL::Sign exact = sign_of(g.at(Integer(n - m), Integer(m)));
    BOOST_REQUIRE(roots[0].sign(g) == exact);
    ++count[std::size_t(int(exact) + 1)];
  }
  for (const int of_sign : count) BOOST_TEST(of_sign > 100);
}

BOOST_AUTO_TEST_SUITE_END()
