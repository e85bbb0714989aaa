#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_BOUNDS_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_BOUNDS_H

#include "tetracone/kernel/number/floating_point.h"

#include <array>

/// The error bounds of the adaptive kernel. Every constant stands here once, and every bound as it is computed, over
/// any number type. u = 2^-53. Each is proved from these texts by verify/proofs/adaptive_proofs.h.
namespace tetracone::kernel::adaptive_bound {

inline constexpr double u = unit_roundoff<double>;

/// Upper bound of the error of a placed coordinate, relative to S = |m0 x| + |m1 y| + |m2 z| + |t|. The coordinate has
/// at most 4 roundings a term, and one of an entry that is a rounded fraction. S as computed may be below S by at most
/// 4 roundings.
inline constexpr double image = 6 * u;

/// Upper bound of the relative error of a translated coordinate: one sum.
inline constexpr double translation = 1.001 * u;

/// Upper bound of the error of a volume, relative to Mx My Mz. m_k is the largest magnitude of a computed difference
/// along axis k, and M_k = m_k + `error`, the errors of two points. There are 46 roundings, 8 of four products and 7 of
/// the two that are added last. The rest covers the bound's own.
inline constexpr double volume = 49 * u;

/// Factor of the effect of the points' errors on a volume: six products, in which three factors are replaced one after
/// the other.
inline constexpr double volume_motion = 6.001;

/// Upper bound of the error of a component of a normal, relative to Mi Mj: two products of 2 differences, 1 product and
/// 1 sum, which are 8 roundings.
inline constexpr double normal = 9 * u;

/// Factor of the effect of the points' errors on a component of a normal: two products, in which two factors are
/// replaced.
inline constexpr double normal_motion = 2.001;

/// Factor of the effect of both points' errors on a difference.
inline constexpr double difference_motion = 1.001;

/// Upper bound of the error of an image in double-double, relative to S. An image has three products, three sums, and
/// entries of fractions with an error of u^2.
inline constexpr double double_double_image = 20 * u * u;

/// Upper bound of the error of a difference in double-double, relative to its high part.
inline constexpr double double_double_difference = 3.02 * u * u;

/// `volume` and `normal` in double-double: 23 u^2 on four products and 20 u^2 on two; 10 u^2 on each of two.
inline constexpr double double_double_volume = 146 * u * u, double_double_normal = 22 * u * u;

/// Return the error bounds of a placed coordinate, in double and in double-double, by the sum of its terms' magnitudes.
template <class Number>
Number image_bound(const Number& magnitudes)
{
  return Number(image) * magnitudes + Number(underflow_slack);
}
template <class Number>
Number double_double_image_bound(const Number& magnitudes)
{
  return Number(double_double_image) * magnitudes + Number(underflow_slack);
}

/// Returns the error bound of a difference of two images whose errors sum to `error`.
template <class Number>
Number difference_bound(const Number& error)
{
  return Number(difference_motion) * error;
}

/// Returns the error bound of a difference m of two images in double-double whose errors sum to `images`.
template <class Number>
Number double_double_difference_error(const Number& images, const Number& m)
{
  return images + Number(double_double_difference) * m;
}

/// Returns the filter's error bound of det[b-a, c-a, d-a], for differences of magnitudes m and points whose errors sum
/// to `error`.
template <class Number>
Number volume_bound(const Number& mx, const Number& my, const Number& mz, const Number& error)
{
  const Number Mx = mx + error, My = my + error, Mz = mz + error;
  return Number(volume) * (Mx * My * Mz) + Number(volume_motion) * error * (My * Mz + mx * Mz + mx * my) +
         Number(underflow_slack);
}

/// Returns the filter's error bound of a component of (b-a) x (c-a).
template <class Number>
Number normal_bound(const Number& mi, const Number& mj, const Number& error)
{
  return Number(normal) * ((mi + error) * (mj + error)) + Number(normal_motion) * error * ((mj + error) + mi) +
         Number(underflow_slack);
}

/// Return the error bounds of double-double. Its differences are rounded too, so each axis has its own error.
template <class Number>
Number double_double_volume_bound(const std::array<Number, 3>& m, const std::array<Number, 3>& error)
{
  const std::array<Number, 3> M = {m[0] + error[0], m[1] + error[1], m[2] + error[2]};
  return Number(double_double_volume) * (M[0] * M[1] * M[2]) +
         Number(volume_motion) * (error[0] * (M[1] * M[2]) + m[0] * error[1] * M[2] + m[0] * m[1] * error[2]) +
         Number(underflow_slack);
}
template <class Number>
Number double_double_normal_bound(const Number& mi, const Number& mj, const Number& ei, const Number& ej)
{
  return Number(double_double_normal) * ((mi + ei) * (mj + ej)) + Number(normal_motion) * (ei * (mj + ej) + mi * ej) +
         Number(underflow_slack);
}

}  // namespace tetracone::kernel::adaptive_bound

#endif
