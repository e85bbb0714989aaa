#ifndef TETRACONE_VERIFY_PROOFS_ROUNDED_ERROR_H
#define TETRACONE_VERIFY_PROOFS_ROUNDED_ERROR_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"

#include <cmath>
#include <limits>
#include <utility>

namespace tetracone::verify::proofs {

using kernel::Rational;

/// How a rounding is bounded. `by_binade` takes half the spacing of the numbers at the largest result. `by_share` takes
/// the unit roundoff times that result, which makes errors proportional to magnitudes.
enum class Rounds { by_binade, by_share };

/// A computed number: upper bounds of its magnitude and of its error, in exact rationals. An expression run with these
/// gives its own error for all inputs of such magnitudes and errors, underflow included.
template <class Float, Rounds rounds = Rounds::by_binade>
struct Rounded_error {
  Rational most, error;

  /// A constant, exactly.
  explicit Rounded_error(double value = 0) : most(abs(Rational(value))), error(0) {}
  Rounded_error(Rational m, Rational e) : most(std::move(m)), error(std::move(e)) {}

  friend Rounded_error operator+(const Rounded_error& a, const Rounded_error& b)
  {
    return rounded(Rational(a.most + b.most), Rational(a.error + b.error));
  }
  friend Rounded_error operator-(const Rounded_error& a, const Rounded_error& b) { return a + b; }
  friend Rounded_error operator*(const Rounded_error& a, const Rounded_error& b)
  {
    const Rational least(std::numeric_limits<Float>::denorm_min());
    return rounded(Rational(a.most * b.most),
                   Rational(a.error * b.most + b.error * a.most + a.error * b.error + least / 2));
  }
  /// Division by an exact number of at least 1: the quotient is no larger than the dividend.
  friend Rounded_error over_at_least_1(const Rounded_error& a) { return rounded(a.most, a.error); }
  friend Rounded_error abs(const Rounded_error& a) { return a; }

  /// Returns a number of at most this magnitude, with error `error` before it is rounded.
  static Rounded_error rounded(const Rational& most, const Rational& error)
  {
    const Rational loss = rounding_of(most);
    return {is_a_number(most) ? most : Rational(most + loss), Rational(error + loss)};
  }

  /// Returns an upper bound of the rounding error of a number of at most this magnitude.
  static Rational rounding_of(const Rational& most)
  {
    const Rational u(kernel::unit_roundoff<Float>);
    return rounds == Rounds::by_share ? Rational(u * most) : Rational(u * power_not_below(most) / 2);
  }

 private:
  /// Returns the least power of two that is at least x.
  static Rational power_not_below(const Rational& x)
  {
    if (x == 0) return 0;
    Rational power(std::ldexp(1.0, std::ilogb(x.get_d())));
    while (power < x) power *= 2;
    while (power / 2 >= x) power /= 2;
    return power;
  }
  static bool is_a_number(const Rational& x)
  {
    if (x == 0) return true;
    const Rational digits = x / power_not_below(x) / Rational(kernel::unit_roundoff<Float>);
    return digits.get_den() == 1;
  }
};

}  // namespace tetracone::verify::proofs

#endif
