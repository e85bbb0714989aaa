#ifndef TETRACONE_KERNEL_NUMBER_NEAREST_ROOT_H
#define TETRACONE_KERNEL_NUMBER_NEAREST_ROOT_H

#include "tetracone/kernel/number/number.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace tetracone::kernel {

/// Returns the double nearest to sqrt(top / bottom), by the rule of `nearest_double`: infinite from 2^1024 - 2^970 on.
/// Requires top >= 0 and bottom > 0. They may have a common factor.
///
/// top / bottom is scaled by 4^k so that its integer root r has 62 or 63 bits. The remainders of the division and the
/// root tell whether r is the root itself or below it. That is one more bit, which rounds like all others.
inline double nearest_root(const mpz_class& top, const mpz_class& bottom)
{
  if (sgn(top) == 0) return 0;
  const long bits = long(mpz_sizeinbase(top.get_mpz_t(), 2)) - long(mpz_sizeinbase(bottom.get_mpz_t(), 2));
  const long k = (125 - bits) >= 0 ? (125 - bits) / 2 : -((bits - 125 + 1) / 2);
  mpz_class scaled = k > 0 ? mpz_class(top << mp_bitcnt_t(2 * k)) : top;
  const mpz_class divisor = k < 0 ? mpz_class(bottom << mp_bitcnt_t(-2 * k)) : bottom;
  mpz_class left, root, left_of_root;
  mpz_tdiv_qr(scaled.get_mpz_t(), left.get_mpz_t(), scaled.get_mpz_t(), divisor.get_mpz_t());
  mpz_sqrtrem(root.get_mpz_t(), left_of_root.get_mpz_t(), scaled.get_mpz_t());
  static_assert(sizeof(unsigned long) == 8);
  const std::uint64_t rounded = 2 * std::uint64_t(root.get_ui()) + (sgn(left) != 0 || sgn(left_of_root) != 0);
  // A normal double is rounded once, by the conversion.
  if (k < 900) return std::ldexp(double(rounded), int(-k - 1));
  mpz_class unit = 1;
  unit <<= mp_bitcnt_t(k + 1);
  Rational value(mpz_class(static_cast<unsigned long>(rounded)), unit);
  value.canonicalize();
  return nearest_double(value);
}

/// Returns the double nearest to sqrt(top / bottom). Requires top >= 0 and bottom > 0.
inline double nearest_root(const Rational& top, const Rational& bottom)
{
  return nearest_root(mpz_class(top.get_num() * bottom.get_den()), mpz_class(bottom.get_num() * top.get_den()));
}
/// Returns the double nearest to the root of a rational that is not negative.
inline double nearest_root(const Rational& square) { return nearest_root(square.get_num(), square.get_den()); }

/// Returns two doubles that enclose the sum of the roots of rationals that are not negative: equal where the sum is a
/// double, else neighbours. The upper one is infinite where the sum exceeds all doubles.
///
/// Rational roots are added exactly: they may sum up to a double, as 1/3 and 2/3 do. The others are scaled by 2^k and
/// rounded down. Each adds less than one unit of 2^-k, which gives the upper bound. k is doubled until no double lies
/// between the bounds. This ends: a sum of irrational roots, all positive, is irrational.
inline std::array<double, 2> enclosed_root_sum(std::span<const Rational> squares)
{
  Rational exact = 0;
  std::vector<Rational> others;
  for (const Rational& square : squares) {
    if (mpz_perfect_square_p(square.get_num_mpz_t()) != 0 && mpz_perfect_square_p(square.get_den_mpz_t()) != 0)
      exact += Rational(sqrt(square.get_num()), sqrt(square.get_den()));
    else
      others.push_back(square);
  }
  for (mp_bitcnt_t k = 64;; k *= 2) {
    mpz_class sum = 0, unit = 1;
    unit <<= k;
    for (const Rational& square : others) sum += sqrt(mpz_class((square.get_num() << 2 * k) / square.get_den()));
    Rational low(sum, unit), high(mpz_class(sum + mpz_class(others.size())), unit);
    low.canonicalize();
    high.canonicalize();
    low += exact;
    high += exact;
    double below = nearest_double(low), above = nearest_double(high);
    if (!std::isfinite(below) || Rational(below) > low) below = std::nextafter(below, -HUGE_VAL);
    if (std::isfinite(above) && Rational(above) < high) above = std::nextafter(above, HUGE_VAL);
    if (above <= std::nextafter(below, HUGE_VAL)) return {below, above};
  }
}

}  // namespace tetracone::kernel

#endif
