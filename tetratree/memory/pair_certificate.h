#ifndef TETRACONE_TETRATREE_MEMORY_PAIR_CERTIFICATE_H
#define TETRACONE_TETRATREE_MEMORY_PAIR_CERTIFICATE_H

#include <array>

/// The arithmetic of the certificate that two bodies of a scene are apart.
///
/// A certificate begins with a lower bound of their distance. It holds while their rotations about their centres since
/// then, plus the change of the vector between these, are less. Rotations are sums of upper bounds, rounded up.
namespace tetracone::tetratree {

/// The vector between the centres of two bodies when a certificate begins, rounded to float.
using Between = std::array<float, 3>;

/// Upper bounds of errors of the vector between two centres, then and later (verify/proofs/scene_proofs.h).
///
/// - `between_rounding`: relative error, one rounding to float and two to double.
/// - `between_underflow`: absolute error of three axes, 2^-150 along each, where floats are denormal.
inline constexpr double between_rounding = 0x1p-23, between_underflow = 0x1p-147;

/// Upper bound of the relative error of the comparison of squares in a certificate (verify/proofs/scene_proofs.h).
inline constexpr double certificate_rounding = 0x1p-46;

/// Range of a certificate.
///
/// - `least_left`: lower bound of its remainder; below it squares would underflow.
/// - `most_gap`: upper bound of the gap that it uses; above it squares would overflow.
inline constexpr double least_left = 0x1p-500, most_gap = 0x1p500;
static_assert(least_left * least_left * certificate_rounding >= 0x1p-1072 && most_gap * most_gap <= 0x1p1000);

/// Returns by how much the vector between two centres has changed along an axis.
template <class Number>
Number change_between(const Number& a, const Number& b, const Number& before)
{
  return a - b - before;
}

/// Returns an upper bound of the error of a certificate that begins with this vector.
template <class Number>
Number error_of_between(const std::array<Number, 3>& magnitudes)
{
  return Number(between_rounding) * (magnitudes[0] + magnitudes[1] + magnitudes[2]) + Number(between_underflow);
}

/// Upper bound of the relative error of a sum of two numbers that are not negative, one of which may be a difference
/// (verify/proofs/scene_proofs.h). Sum, product and difference are rounded; sums of denormals are exact.
inline constexpr double sum_rounding = 0x1p-51;
/// Returns an upper bound of the exact sum of x and y.
template <class Number>
Number sum_above(const Number& x, const Number& y)
{
  return (x + y) * Number(1 + sum_rounding);
}
/// Returns a lower bound of the exact sum of x and y.
template <class Number>
Number sum_below(const Number& x, const Number& y)
{
  return (x + y) * Number(1 - sum_rounding);
}

}  // namespace tetracone::tetratree

#endif
