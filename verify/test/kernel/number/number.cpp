#include "tetracone/kernel/number/number.h"

#include "tetracone/kernel/number/nearest_root.h"
#include "verify/test/support/suite.h"

#include <cstring>

BOOST_AUTO_TEST_SUITE(test_number)

using namespace tetracone::kernel;

/// A random finite double of any exponent, denormals included.
double any_double(std::mt19937_64& random)
{
  while (true) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

Rational distance(const Rational& a, double b) { return abs(Rational(a - Rational(b))); }

BOOST_AUTO_TEST_CASE(decimals_become_the_nearest_double)
{
  BOOST_TEST(parse_double("0.1").value() == 0.1);
  BOOST_TEST(parse_double("+.5").value() == 0.5);
  BOOST_TEST(parse_double("5.").value() == 5);
  BOOST_TEST(parse_double("-1E+2").value() == -100);
  BOOST_TEST(parse_double("5e-324").value() == 0x1p-1074);
  BOOST_TEST(parse_double("1.7976931348623157e308").value() == std::numeric_limits<double>::max());
  // Ties go to even, and the least digit behind a tie decides.
  BOOST_TEST(parse_double("9007199254740993").value() == 9007199254740992.0);
  BOOST_TEST(parse_double("9007199254740993.00000000000000000000001").value() == 9007199254740994.0);
}

BOOST_AUTO_TEST_CASE(what_is_too_small_is_zero_with_its_sign)
{
  BOOST_TEST(parse_double("1e-400").value() == 0);
  BOOST_TEST(!std::signbit(parse_double("1e-400").value()));
  BOOST_TEST(std::signbit(parse_double("-1e-400").value()));
  BOOST_TEST(std::signbit(parse_double("-0").value()));
  const std::string zeros(400, '0');
  for (const std::string& word :
       std::vector<std::string>{"1.5e-400", "100000.0e-500", "12e-99999999999999999999", "1e-9223372036854775808",
                                "0." + zeros + "5", "0." + zeros + "5e+9"})
    BOOST_TEST(parse_double(word).value() == 0, word);
  BOOST_TEST(parse_double("0." + zeros + "5e402").value() == 50);
}

BOOST_AUTO_TEST_CASE(words_that_are_no_finite_decimals_are_refused)
{
  for (const char* word : {"",       "+",    "-",       ".",           "nan",
                           "-nan",   "inf",  "-inf",    "infinity",    "1e400",
                           "-1e400", "0x10", "1.5e400", "-0.001e+400", "12e99999999999999999999",
                           "1,5",    "1/2",  "1 ",      " 1",          "1e",
                           "--1",    "+-1",  "++1",     "1.2.3",       "1d5",
                           "1f",     "one"})
    BOOST_TEST(!parse_double(word).has_value(), word);
}

BOOST_AUTO_TEST_CASE(fractions_are_exact_and_decimal_and_other_words_are_refused)
{
  BOOST_TEST((parse_fraction("1/3").value() == Rational(1) / 3));
  BOOST_TEST((parse_fraction("-4/6").value() == Rational(-2) / 3));
  BOOST_TEST((parse_fraction("+010/08").value() == Rational(5) / 4));
  BOOST_TEST((parse_fraction("0/7").value() == 0));
  BOOST_TEST(
      (parse_fraction("123456789012345678901234567890/3").value() * 3 == Rational("123456789012345678901234567890")));
  for (const char* word : {"", "/", "1/", "/2", "1/0", "1/00", "1/-2", "1/+2", "1.5/2", "1/2.0", "1/2/3", "a/b", "1",
                           "--1/2", "1 /2", "0x1/2"})
    BOOST_TEST(!parse_fraction(word).has_value(), word);
}

BOOST_AUTO_TEST_CASE(rationals_print_in_lowest_terms_and_read_back_exactly)
{
  for (const char* word :
       {"1/3", "-22/7", "123456789012345678901234567890/1", "-1000000000000000000000000000000000000001/1"})
    BOOST_TEST(exact_text(Rational(*parse_fraction(word))) == word);
  for (const double x : {0.0, 1.5, -0x1p-1074, 1e300, 3e22}) BOOST_TEST(exact_text(Rational(x)) == shortest(x));
  for (const auto& [value, text] :
       {std::pair(Rational(Rational(4) / 6), "2/3"), {Rational(-2), "-2"}, {Rational(0), "0"}})
    BOOST_TEST(to_string(Rational(value)) == text);
}

BOOST_AUTO_TEST_CASE(no_neighbour_is_nearer_than_the_nearest_double)
{
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000; ++k) {
    const double a = any_double(random), b = any_double(random);
    if (b == 0) continue;
    const Rational value = Rational(a) / Rational(b);
    const double nearest = nearest_double(value);
    if (!std::isfinite(nearest)) {
      BOOST_TEST((abs(value) >= Rational(std::numeric_limits<double>::max()) + Rational(0x1p970)));
      continue;
    }
    for (const double other : {std::nextafter(nearest, -HUGE_VAL), std::nextafter(nearest, HUGE_VAL)}) {
      if (std::isfinite(other)) BOOST_TEST((distance(value, nearest) <= distance(value, other)));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_double_is_its_own_nearest_double_and_ties_go_to_even)
{
  std::mt19937_64 random(2);
  for (int k = 0; k < 2000; ++k) {
    const double a = any_double(random);
    BOOST_TEST(nearest_double(Rational(a)) == a);
  }
  BOOST_TEST(nearest_double(Rational(1) + Rational(0x1p-53)) == 1);
  BOOST_TEST(nearest_double(Rational(1) + Rational(0x1.8p-52)) == 1 + 0x1p-51);
  BOOST_TEST(nearest_double(-Rational(1) - Rational(0x1p-53)) == -1);
}

BOOST_AUTO_TEST_CASE(beyond_the_largest_double_all_round_as_ieee_754_does)
{
  const double largest = std::numeric_limits<double>::max(), infinite = std::numeric_limits<double>::infinity();
  // Half a step beyond the largest double: a tie, whose even neighbour is 2^1024.
  const Rational tie = Rational(largest) + Rational(0x1p970);
  const Rational little = Rational(1) / Rational(0x1p1000);
  for (const auto& [value, expected] : {std::pair(Rational(largest), largest),
                                        {Rational(Rational(largest) + 1), largest},
                                        {Rational(tie - little), largest},
                                        {tie, infinite},
                                        {Rational(tie + little), infinite},
                                        {Rational(Rational(2) * Rational(0x1p1023)), infinite},
                                        {Rational(Rational(largest) * 1000), infinite}}) {
    BOOST_TEST(nearest_double(value) == expected, value.get_d());
    BOOST_TEST(nearest_double(-value) == -expected, value.get_d());
    BOOST_TEST(nearest_root(Rational(value * value)) == expected, value.get_d());
    // A decimal that is not finite is none.
    if (value.get_den() == 1) BOOST_TEST(parse_double(value.get_str()).value_or(infinite) == expected, value.get_d());
  }
  // A root of no rational is rounded by the same rule.
  BOOST_TEST(nearest_root(Rational(tie * tie - 1)) == largest);
  BOOST_TEST(nearest_root(Rational(tie * tie + 1)) == infinite);
}

BOOST_AUTO_TEST_CASE(the_shortest_decimal_reads_back_as_the_same_bits)
{
  std::mt19937_64 random(3);
  for (int k = 0; k < 20000; ++k) {
    const double a = any_double(random);
    const auto back = parse_double(shortest(a));
    BOOST_REQUIRE(back.has_value());
    BOOST_TEST(std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(a));
  }
  BOOST_TEST(shortest(0.1) == "0.1");
}

BOOST_AUTO_TEST_CASE(a_sum_of_roots_is_enclosed_by_neighbours_or_told_exactly)
{
  using Bounds = std::array<double, 2>;
  const auto sum = [](const std::vector<Rational>& squares) { return enclosed_root_sum(squares); };
  BOOST_TEST((sum({}) == Bounds{0, 0}));
  BOOST_TEST((sum({4, Rational(9, 4)}) == Bounds{3.5, 3.5}));
  BOOST_TEST((sum({2}) == Bounds{std::nextafter(std::sqrt(2.0), 0), std::sqrt(2.0)}));  // sqrt(2) is rounded up
  BOOST_TEST((sum({Rational(1, 9)}) == Bounds{1.0 / 3, std::nextafter(1.0 / 3, 1)}));
  BOOST_TEST((sum({Rational(1, 9), Rational(4, 9)}) == Bounds{1, 1}));  // 1/3 + 2/3
  BOOST_TEST((sum({Rational(1, 9), 2, Rational(4, 9)}) == sum({1, 2})));
  BOOST_TEST((sum({1, Rational(0x1p-1000) * Rational(0x1p-1000)}) == Bounds{1, std::nextafter(1.0, 2)}));
  const Rational huge = Rational(0x1p1000) * Rational(0x1p1000);
  BOOST_TEST((sum({huge, Rational(2)}) == Bounds{0x1p1000, std::nextafter(0x1p1000, HUGE_VAL)}));
  const double largest = std::numeric_limits<double>::max();
  BOOST_TEST((sum({huge * huge}) == Bounds{largest, HUGE_VAL}));
}

BOOST_AUTO_TEST_CASE(a_fraction_of_many_digits_rounds_as_its_value_does)
{
  mpz_class many;
  mpz_ui_pow_ui(many.get_mpz_t(), 3, 4000);
  const Rational hair(1, many);
  std::mt19937_64 random(7);
  for (int k = 0; k < 400; ++k) {
    const double low = std::bit_cast<double>(random()), high = std::nextafter(low, HUGE_VAL);
    if (!std::isfinite(low) || !std::isfinite(high)) continue;
    const Rational middle = (Rational(low) + Rational(high)) / 2;
    const double even = (std::bit_cast<std::uint64_t>(low) & 1) == 0 ? low : high;
    BOOST_TEST(nearest_double(middle - hair) == low);
    BOOST_TEST(nearest_double(middle + hair) == high);
    BOOST_TEST(nearest_double(shortened(middle.get_num() * many, middle.get_den() * many)) == even);
  }
  for (const double end : {HUGE_VAL, -HUGE_VAL})
    BOOST_TEST(nearest_double(end > 0 ? Rational(many) : Rational(-many)) == end);
  BOOST_TEST(nearest_double(hair) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
