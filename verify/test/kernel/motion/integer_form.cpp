#include "tetracone/kernel/motion/integer_form.h"

#include "verify/test/support/integer_forms.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_integer_form)

using namespace tetracone::kernel;
using tetracone::verify::form;

bool same(const Integer_form& f, const Integer_form& g)
{
  bool equal = f.size() == g.size();
  for (std::size_t k = 0; equal && k < f.size(); ++k) equal = f[k] == g[k];
  return equal;
}

BOOST_AUTO_TEST_CASE(parts_and_halves_are_the_form_over_parts_of_the_time)
{
  const Integer_form f = form<4>({3, -7, 5, 2}), first = f.first_half(), second = f.second_half();
  for (int k = 0; k <= 4; ++k) {
    // At quarter k of a half: t = k/8 or (4+k)/8; the halves are 8 times the cubic, at s + t = 4 in place of 8.
    BOOST_TEST(first.at(4 - k, k) == f.at(8 - k, k));
    BOOST_TEST(second.at(4 - k, k) == f.at(4 - k, 4 + k));
  }
  BOOST_TEST(same(f.over(2, 2), f.second_half().first_half()));
  BOOST_TEST(same(f.over(1, 2), f.first_half().second_half()));
  BOOST_TEST(same(f.over(0, 0), f));
  const Integer_form part = f.between(1, 7, 3);
  // At quarter k of the part: t = (4 + 6 k) / 32, the form times 8^3 at s + t = 4.
  for (int k = 0; k <= 4; ++k) BOOST_TEST(part.at(4 - k, k) == f.at(28 - 6 * k, 4 + 6 * k));
}

BOOST_AUTO_TEST_CASE(variations_are_changes_of_sign)
{
  BOOST_TEST(form<4>({1, 0, 0, 2}).variations() == 0);
  BOOST_TEST(form<4>({1, 0, 0, -2}).variations() == 1);
  BOOST_TEST(form<4>({1, -1, 0, 2}).variations() == 2);
  BOOST_TEST(form<4>({-1, 1, -1, 2}).variations() == 3);
  BOOST_TEST(form<3>({0, 0, 0}).variations() == 0);
  BOOST_TEST(form<3>({0, 0, 0}).is_zero());
  BOOST_TEST(form<3>({0, -1, 0}).only_sign() == CGAL::NEGATIVE);
}

BOOST_AUTO_TEST_CASE(common_divisors_have_the_common_roots)
{
  // In v: (v-1)^2 (v-2) and (v-1) (v+3).
  const Integer_form f = form<4>({-2, 5, -4, 1}), g = form<3>({-3, 2, 1});
  const Integer_form shared = common_divisor(f, g);
  BOOST_REQUIRE(shared.size() == 2u);
  BOOST_TEST(shared.at(1, 1) == 0);
  BOOST_TEST(common_divisor(f, form<3>({3, 4, 1})).size() == 1u);
  const Integer_form simple = without_squares(f);
  BOOST_REQUIRE(simple.size() == 3u);
  BOOST_TEST(simple.at(1, 1) == 0);
  BOOST_TEST(simple.at(1, 2) == 0);
  // (v-1)^3, and factors s and t.
  BOOST_TEST(without_squares(form<4>({-1, 3, -3, 1})).size() == 2u);
  BOOST_TEST(same(form<4>({0, 6, -4, 0}).primitive(), form<2>({3, -2})));
  // (2 v - 1) (v + 1)^2, and powers of v + 1 alone.
  BOOST_TEST(same(form<4>({-1, 0, 3, 2}).reduced(), form<2>({-1, 2})));
  BOOST_TEST(same(form<3>({5, 10, 5}).reduced(), form<1>({1})));
}

BOOST_AUTO_TEST_CASE(a_quotient_is_found_where_the_form_is_a_divisor)
{
  // In v: (2v - 1) (v + 3), and what differs from it a little.
  const Integer_form divisor = form<2>({-1, 2}), product = form<3>({-3, 5, 2});
  const auto found = exact_quotient(product, divisor);
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST(same(*found, form<2>({3, 1})));
  BOOST_TEST(!exact_quotient(form<3>({-3, 5, 3}), divisor));
  BOOST_TEST(!exact_quotient(form<3>({-3, 6, 2}), divisor));
  BOOST_TEST(!exact_quotient(form<3>({-2, 5, 2}), divisor));
  BOOST_TEST(!exact_quotient(form<1>({2}), divisor));
}

BOOST_AUTO_TEST_SUITE_END()
