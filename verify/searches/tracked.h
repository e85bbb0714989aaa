#ifndef TETRACONE_VERIFY_SEARCHES_TRACKED_H
#define TETRACONE_VERIFY_SEARCHES_TRACKED_H

#include "tetracone/kernel/number/number.h"

#include <cmath>
#include <utility>

namespace tetracone::verify::proofs {

using kernel::Rational;

/// A computed number and its exact value. An expression that is run with these gives its own error.
template <class Float>
struct Tracked {
  Float computed;
  Rational exact;

  explicit Tracked(double x) : computed(Float(x)), exact(computed) {}
  Tracked(Float c, Rational e) : computed(c), exact(std::move(e)) {}

  /// Returns |computed - exact|, rounded.
  double error() const { return Rational(abs(Rational(Rational(computed) - exact))).get_d(); }

  friend Tracked operator+(const Tracked& a, const Tracked& b)
  {
    return {a.computed + b.computed, Rational(a.exact + b.exact)};
  }
  friend Tracked operator-(const Tracked& a, const Tracked& b)
  {
    return {a.computed - b.computed, Rational(a.exact - b.exact)};
  }
  friend Tracked operator*(const Tracked& a, const Tracked& b)
  {
    return {a.computed * b.computed, Rational(a.exact * b.exact)};
  }
  friend Tracked operator/(const Tracked& a, const Tracked& b)
  {
    return {a.computed / b.computed, Rational(a.exact / b.exact)};
  }
  friend Tracked operator-(const Tracked& a) { return {-a.computed, Rational(-a.exact)}; }
  friend Tracked abs(const Tracked& a) { return {std::abs(a.computed), Rational(abs(a.exact))}; }

  /// Returns c + a b or, for the sign '-', c - a b, rounded once.
  friend Tracked fused_sum(const Tracked& a, const Tracked& b, const Tracked& c, char sign)
  {
    const Float factor = sign == '-' ? -a.computed : a.computed;
    Rational exact = a.exact * b.exact;
    if (sign == '-') exact = -exact;
    return {std::fma(factor, b.computed, c.computed), Rational(exact + c.exact)};
  }

  /// Returns a pose's entry. The search has rounded it before (`rounded_once`), so nothing is rounded here.
  friend Tracked entry(const Tracked& a) { return a; }
};

}  // namespace tetracone::verify::proofs

#endif
