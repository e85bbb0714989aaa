#include "tetracone/kernel/motion/times_before.h"

#include "verify/test/support/integer_forms.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_times_before)

using namespace tetracone::kernel;
using tetracone::verify::form;

/// The linear form that is n t - m: zero at m/n.
Integer_form zero_at(const Integer& m, const Integer& n) { return Integer_form(std::array<Integer, 2>{-m, n - m}); }

CGAL::Sign sign(Times_before& times, const Integer_form& f) { return times.sign(times.over(f)); }
CGAL::Sign sign_after_start(Times_before& times, const Integer_form& f)
{
  return times.sign_after_start(times.over(f));
}

// In v: v^2 - 2, whose root is t = 0.5857...
const Integer_form irrational = form<3>({-2, 0, 1});

BOOST_AUTO_TEST_CASE(forms_that_vanish_at_a_dyadic_time_have_their_sign_before)
{
  Time_root half(1, 1);
  Times_before times({0, 0}, half);
  BOOST_TEST(sign(times, zero_at(1, 2)) == CGAL::NEGATIVE);
  BOOST_TEST(sign(times, zero_at(3, 4)) == CGAL::NEGATIVE);
  BOOST_TEST(sign(times, zero_at(1, 4)) == CGAL::ZERO);
  BOOST_TEST(sign(times, zero_at(499999999, 1000000000)) == CGAL::ZERO);
  BOOST_TEST(sign(times, zero_at(0, 1)) == CGAL::ZERO);  // at the start itself
  BOOST_TEST(sign_after_start(times, zero_at(0, 1)) == CGAL::POSITIVE);
  BOOST_TEST(sign(times, form<2>({0, 0})) == CGAL::ZERO);
  // From a quarter on, what vanishes before has a sign.
  Times_before late({1, 2}, half);
  BOOST_TEST(sign(late, zero_at(1, 8)) == CGAL::POSITIVE);
  BOOST_TEST(sign(late, zero_at(1, 4)) == CGAL::ZERO);
}

BOOST_AUTO_TEST_CASE(forms_that_share_a_root_have_their_sign_before_it)
{
  std::vector<Time_root> root = roots_within(irrational);
  BOOST_REQUIRE(root.size() == 1u);
  Times_before times({0, 0}, root[0]);
  BOOST_TEST(sign(times, irrational) == CGAL::NEGATIVE);
  BOOST_TEST(sign(times, irrational * Integer(-3)) == CGAL::POSITIVE);
  BOOST_TEST(sign(times, irrational * form<2>({3, 1})) == CGAL::NEGATIVE);
  BOOST_TEST(sign(times, irrational * form<2>({-1, -7}) * form<2>({1, 1})) == CGAL::POSITIVE);
  // Zero before: at half, at the start, and a hair before the root; and a hair after it, where this need not tell.
  BOOST_TEST(sign(times, irrational * form<2>({-1, 1})) == CGAL::ZERO);
  BOOST_TEST(sign(times, irrational * form<2>({0, 1})) == CGAL::ZERO);
  BOOST_TEST(sign_after_start(times, irrational * form<2>({0, 1})) == CGAL::NEGATIVE);
  BOOST_TEST(sign(times, zero_at(Integer("585786437626904951"), Integer("1000000000000000000"))) == CGAL::ZERO);
  BOOST_TEST(sign(times, irrational * irrational) != CGAL::NEGATIVE);
  BOOST_TEST(sign(times, zero_at(6, 10)) == CGAL::NEGATIVE);
  // Twice zero before, or twice the root and a zero before.
  BOOST_TEST(sign(times, zero_at(1, 4) * zero_at(1, 3)) == CGAL::ZERO);
  BOOST_TEST(sign(times, irrational * zero_at(1, 4) * zero_at(1, 4)) == CGAL::ZERO);
}

BOOST_AUTO_TEST_CASE(a_root_of_a_product_is_shared_with_forms_of_another)
{
  // (v^2 - 2) (v - 5), which has a root later on, and (v^2 - 2) (v + 7).
  const Integer_form product = irrational * form<2>({-5, 1});
  for (const bool is_first : {true, false}) {
    std::vector<Time_root> root = roots_within(product);
    BOOST_REQUIRE(root.size() == 2u);
    Times_before times({0, 0}, root[0]);
    if (is_first) BOOST_TEST(sign(times, product) == CGAL::POSITIVE);
    BOOST_TEST(sign(times, irrational * form<2>({7, 1})) == CGAL::NEGATIVE);
    BOOST_TEST(sign(times, product) == CGAL::POSITIVE);
    BOOST_TEST(sign(times, irrational * form<2>({-1, 1})) == CGAL::ZERO);
    // The later root: the form has an earlier one.
    Times_before until_second({0, 0}, root[1]);
    BOOST_TEST(sign(until_second, product) == CGAL::ZERO);
    BOOST_TEST(sign(until_second, irrational) == CGAL::ZERO);
    Times_before between({3, 2}, root[1]);
    BOOST_TEST(sign(between, product) == CGAL::NEGATIVE);
    BOOST_TEST(sign(between, irrational) == CGAL::POSITIVE);
  }
}

BOOST_AUTO_TEST_CASE(a_divisor_without_the_root_does_not_take_its_place)
{
  // (v^2 - 2) (v + 3), and v + 3 times a form with a zero so near to the root that bounds do not part them.
  const Integer_form product = irrational * form<2>({3, 1});
  for (const Integer& near : {Integer("585786437626904951"), Integer("585786437626904952")}) {
    std::vector<Time_root> root = roots_within(product);
    BOOST_REQUIRE(root.size() == 1u);
    Times_before times({0, 0}, root[0]);
    BOOST_TEST(sign(times, form<2>({3, 1}) * zero_at(near, Integer("1000000000000000000"))) != CGAL::POSITIVE);
    BOOST_TEST(sign(times, product) == CGAL::NEGATIVE);
  }
}

BOOST_AUTO_TEST_SUITE_END()
