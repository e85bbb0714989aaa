#ifndef TETRACONE_KERNEL_NUMBER_DOUBLE_DOUBLE_H
#define TETRACONE_KERNEL_NUMBER_DOUBLE_DOUBLE_H

#include <cmath>

namespace tetracone::kernel {

/// An unevaluated sum of two doubles, |low| <= ulp(high) / 2: about 106 bits. Rounding to nearest is required.
///
/// Relative errors, with u = 2^-53, are those that Joldes, Muller and Popescu prove (Tight and rigorous error bounds
/// for basic building blocks of double-word arithmetic, TOMS 2017). They hold for results that do not overflow and have
/// no parts that underflow.
struct Double_double {
  double high = 0, low = 0;

  Double_double() = default;
  Double_double(double x) : high(x) {}
  Double_double(double h, double l) : high(h), low(l) {}

  /// Return x + y and x y, exactly.
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

  /// Returns the sum, with a relative error of at most 3 u^2 / (1 - 4 u) (their AccurateDWPlusDW). It is exact where
  /// the exact sum is a double.
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

  /// Returns the product, with a relative error of at most 7 u^2 (their DWTimesDW1). The tests of
  /// kernel/predicate/adaptive.h derive 7 u^2 / (1 - u)^2, a little more.
  friend Double_double operator*(const Double_double& a, const Double_double& b)
  {
    const Double_double c = product(a.high, b.high);
    return ordered_sum(c.high, c.low + (a.high * b.low + a.low * b.high));
  }

 private:
  /// Returns x + y, exactly where |x| >= |y| or x = 0.
  static Double_double ordered_sum(double x, double y)
  {
    const double s = x + y;
    return {s, y - (s - x)};
  }
};

}  // namespace tetracone::kernel

#endif
