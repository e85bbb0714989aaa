#ifndef TETRACONE_TETRATREE_CERTIFICATE_FRACTIONS_H
#define TETRACONE_TETRATREE_CERTIFICATE_FRACTIONS_H

#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/face_distance.h"

#include <gmpxx.h>

#include <string>

/// Numbers of placed points, which have a common weight, as the fractions of certificates, and back.
namespace tetracone::tetratree {

/// Returns the numbers as fractions.
inline kernel::Rational_point rational(const kernel::Exact_vector& v)
{
  return {kernel::Rational(v[0]), kernel::Rational(v[1]), kernel::Rational(v[2])};
}

/// Returns a point in the bodies' coordinates. The coordinates of `point` are `weight` times as large.
inline kernel::Rational_point rational(const kernel::Exact_point& point, const kernel::Exact_number& weight)
{
  const kernel::Rational by = kernel::Rational(point.weight) * kernel::Rational(weight);
  kernel::Rational_point x = rational(point.at);
  for (kernel::Rational& c : x) c /= by;
  return x;
}

/// Returns the least common denominator of the coordinates.
inline mpz_class common_denominator(const kernel::Rational_point& x)
{
  return lcm(lcm(x[0].get_den(), x[1].get_den()), x[2].get_den());
}

/// Returns the positive multiple of a direction that has integers without a common factor. Requires one other than 0.
inline kernel::Rational_point in_lowest_terms(kernel::Rational_point m)
{
  const mpz_class common = common_denominator(m);
  mpz_class factor = 0;
  for (kernel::Rational& x : m) {
    x *= common;
    factor = gcd(factor, x.get_num());
  }
  for (kernel::Rational& x : m) x /= factor;
  return m;
}

/// Returns x, rounded towards 0 to a multiple of `unit`. Requires a unit above 0.
inline kernel::Rational rounded_to(const kernel::Rational& unit, const kernel::Rational& x)
{
  const kernel::Rational units = x / unit;
  return kernel::Rational(mpz_class(units.get_num() / units.get_den())) * unit;
}

/// Returns an exponent e for which |x| is above 2^(e - 1) and below 2^(e + 1). Requires a number other than 0.
inline int binary_exponent(const kernel::Rational& x)
{
  return int(mpz_sizeinbase(x.get_num_mpz_t(), 2)) - int(mpz_sizeinbase(x.get_den_mpz_t(), 2));
}

/// Returns the number as a binary fraction. Requires that it is one.
inline kernel::Exact_number exact(const kernel::Rational& x)
{
  kernel::Exact_number value = 0;
  const std::string digits = mpz_class(abs(x.get_num())).get_str(16);
  for (const char digit : digits)
    value = value * kernel::Exact_number(16) + kernel::Exact_number(digit <= '9' ? digit - '0' : digit - 'a' + 10);
  kernel::Rational unit(1, x.get_den());
  // A smaller unit may be no double, so 2^-1000 is taken out of it, as often as is needed.
  for (; unit < kernel::Rational(0x1p-1000); unit *= kernel::Rational(0x1p1000))
    value = value * kernel::Exact_number(0x1p-1000);
  value = value * kernel::Exact_number(unit.get_d());
  return sgn(x) < 0 ? kernel::Exact_number(-value) : value;
}

/// Returns the point times a weight. Requires that the products are binary fractions.
inline kernel::Exact_vector exact(const kernel::Rational_point& x, const kernel::Rational& weight)
{
  return {exact(x[0] * weight), exact(x[1] * weight), exact(x[2] * weight)};
}

}  // namespace tetracone::tetratree

#endif
