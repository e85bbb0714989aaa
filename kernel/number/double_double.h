#ifndef TETRACONE_KERNEL_NUMBER_DOUBLE_DOUBLE_H
#define TETRACONE_KERNEL_NUMBER_DOUBLE_DOUBLE_H

#include <cmath>

namespace tetracone::kernel {

/// An unevaluated sum of two doubles, |low| <= ulp(high) / 2: about 106 bits. Rounding to nearest is required; relative
/// errors, with u = 2^-53, are those that Joldes, Muller and Popescu prove (Tight and rigorous error bounds for basic
/// building blocks of double-word arithmetic, TOMS 2017), for results that neither overflow nor have parts that
/// underflow.
struct Double_double {
  double high = 0, low = 0;

  Double_double() = default;
  Double_double(double x) : high(x) {}
  Double_double(double h, double l) : high(h), low(l) {}

  /// x + y and x y, exactly.
  static Double_double sum(double x, double y)
  {
    const double s = x + y, part = s - x;
    return {s, (x - (s - part)) + (y - part)};
  }
  static Double_double product(double x, double y)
  {
    const double p = x * y;
    return {p, std::fma(x, y, -p)};
  }

  /// Relative error at most 3 u^2 / (1 - 4 u), and none when the result is a double's worth (their AccurateDWPlusDW).
  friend Double_double operator+(const Double_double& a, const Double_double& b)
  {
    const Double_double s = sum(a.high, b.high), t = sum(a.low, b.low);
    const Double_double v = ordered_sum(s.high, s.low + t.high);
    return ordered_sum(v.high, t.low + v.low);
  }
  friend Double_double operator-(const Double_double& a, const Double_double& b)
  {
    return a + Double_double(-b.high, -b.low);
  }

  /// Relative error at most 7 u^2 (their DWTimesDW1); the tests of kernel/predicate/adaptive.h derive 7 u^2 / (1 -
  /// u)^2.
  friend Double_double operator*(const Double_double& a, const Double_double& b)
  {
    const Double_double c = product(a.high, b.high);
    return ordered_sum(c.high, c.low + (a.high * b.low + a.low * b.high));
  }

 private:
  /// x + y exactly where |x| >= |y| or x = 0.
  static Double_double ordered_sum(double x, double y)
  {
    const double s = x + y;
    return {s, y - (s - x)};
  }
};

}  // namespace tetracone::kernel

#endif
