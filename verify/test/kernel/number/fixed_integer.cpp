#include "tetracone/kernel/number/fixed_integer.h"

#include "tetracone/kernel/number/number.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_fixed_integer)

using namespace tetracone::kernel;
using Random = std::mt19937_64;

template <int limbs>
mpz_class exactly(const Fixed_integer<limbs>& x)
{
  mpz_class value = 0;
  for (int k = limbs; k-- > 0;)
    value = value * (mpz_class(1) << 64) + mpz_class((unsigned long)(x.limb[std::size_t(k)]));
  return x.is_negative() ? mpz_class(value - (mpz_class(1) << (64 * limbs))) : value;
}

/// True when the number, as wide as it is, is `value` modulo a power of 2.
template <int limbs>
bool is_modulo(const Fixed_integer<limbs>& x, const mpz_class& value)
{
  const mpz_class difference = exactly(x) - value, modulus = mpz_class(1) << (64 * limbs);
  return difference % modulus == 0;
}

/// Digits at the ends of their range every other time: there carries and borrows run on.
template <int limbs>
Fixed_integer<limbs> any(Random& random)
{
  Fixed_integer<limbs> x;
  for (std::uint64_t& digit : x.limb) switch (random() % 6) {
      case 0: digit = 0; break;
      case 1: digit = ~std::uint64_t(0); break;
      case 2: digit = std::uint64_t(1) << 63; break;
      case 3: digit = (std::uint64_t(1) << 63) - 1; break;
      default: digit = random();
    }
  return x;
}

template <int n, int m>
int wrong_products(Random& random)
{
  int wrong = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto a = any<n>(random);
    const auto b = any<m>(random);
    wrong += exactly(a * b) != exactly(a) * exactly(b);
  }
  return wrong;
}

template <int limbs>
int wrong_sums(Random& random)
{
  int wrong = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto a = any<limbs>(random), b = any<limbs>(random);
    const int shift = int(random() % (64 * limbs));
    wrong += !is_modulo(a + b, exactly(a) + exactly(b)) + !is_modulo(a - b, exactly(a) - exactly(b)) +
             !is_modulo(a << shift, exactly(a) * (mpz_class(1) << shift));
    wrong += a.sign() != sgn(exactly(a));
    wrong += exactly(Fixed_integer<limbs + 2>(a)) != exactly(a);
    if constexpr (limbs >= 2) wrong += !is_modulo(Fixed_integer<2>::of(a.modulo()), exactly(a));
  }
  return wrong;
}

BOOST_AUTO_TEST_CASE(products_of_any_digits_are_those_of_whole_numbers)
{
  Random random(1);
  BOOST_TEST((wrong_products<1, 1>(random) + wrong_products<1, 2>(random) + wrong_products<2, 1>(random)) == 0);
  BOOST_TEST((wrong_products<2, 2>(random) + wrong_products<3, 3>(random) + wrong_products<4, 4>(random)) == 0);
  BOOST_TEST((wrong_products<4, 2>(random) + wrong_products<6, 3>(random) + wrong_products<8, 4>(random)) == 0);
  BOOST_TEST((wrong_products<4, 1>(random) + wrong_products<1, 4>(random)) == 0);
}

BOOST_AUTO_TEST_CASE(sums_differences_and_shifts_are_those_of_whole_numbers_modulo_a_power_of_2)
{
  Random random(2);
  BOOST_TEST((wrong_sums<1>(random) + wrong_sums<2>(random) + wrong_sums<3>(random) + wrong_sums<4>(random) +
              wrong_sums<6>(random)) == 0);
}

BOOST_AUTO_TEST_CASE(doubles_are_integers_times_one_power_of_2_or_too_wide)
{
  Random random(3);
  int wrong = 0, wide = 0, zeros = 0;
  for (int n = 0; n < 40000; ++n) {
    // Mostly about the widest that fits: 128 bits from the lowest to the highest.
    const int lowest = n % 3 == 0 ? -1074 : int(random() % 1900) - 1074;
    std::array<double, 3> x;
    for (double& number : x) {
      const double sign = random() % 2 == 0 ? 1 : -1;
      switch (random() % 5) {
        case 0: number = 0 * sign; break;
        case 1: number = sign * std::ldexp(double(random() % 8), lowest); break;
        default: number = sign * std::ldexp(double(random() >> 11), lowest + int(random() % 80)); break;
      }
    }
    const Fixed_numbers<3> fixed = fixed_numbers(x);
    std::array<mpz_class, 3> whole;  // times 2^1074
    int end = 0, start = 1 << 20;
    for (std::size_t k = 0; k < 3; ++k) {
      whole[k] = mpz_class(mpq_class(x[k]) * (mpz_class(1) << 1074));
      if (whole[k] == 0) continue;
      end = std::max(end, int(mpz_sizeinbase(whole[k].get_mpz_t(), 2)));
      start = std::min(start, int(mpz_scan1(whole[k].get_mpz_t(), 0)));
    }
    if (end == 0) {
      wrong += fixed.bits != 0;
      ++zeros;
    } else if (end - start >= 128) {
      wrong += fixed.bits != Binary_number<1>::too_wide;
      ++wide;
    } else {
      wrong += fixed.bits != end - start || fixed.exponent + 1074 != start;
      for (std::size_t k = 0; k < 3; ++k) wrong += (exactly(fixed.integer[k]) << start) != whole[k];
    }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(wide > 500);
  BOOST_TEST(zeros > 100);
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (const double beside : {0.0, 1.0, std::numeric_limits<double>::max()})
      BOOST_TEST((fixed_numbers<3>({beside, bad, 0}).bits == Binary_number<1>::too_wide));
}

BOOST_AUTO_TEST_SUITE_END()
