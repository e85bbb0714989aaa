#ifndef TETRACONE_KERNEL_MOTION_ROTATION_QUATERNION_H
#define TETRACONE_KERNEL_MOTION_ROTATION_QUATERNION_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace tetracone::kernel {

/// The quaternion (w, x, y, z) of a matrix that is a rotation, exactly or nearly. Its length is 1, up to rounding.
struct Rotation_quaternion {
  std::array<Rational, 4> quaternion;
  double error;  ///< the largest difference of an entry from the quaternion's rotation, rounded to nearest; 0: none
};

/// The largest difference of an accepted matrix's entry from a rotation's. Matrices written with six digits are nearer.
constexpr double rotation_tolerance = 1e-5;

namespace detail {

/// Returns the row-major rotation of a quaternion that is not 0.
inline std::array<Rational, 9> rotation_of(const std::array<Rational, 4>& q)
{
  const auto& [w, x, y, z] = q;
  std::array<Rational, 9> r = {
      w * w + x * x - y * y - z * z, 2 * (x * y - w * z),           2 * (x * z + w * y),
      2 * (x * y + w * z),           w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
      2 * (x * z - w * y),           2 * (y * z + w * x),           w * w - x * x - y * y + z * z};
  const Rational norm = w * w + x * x + y * y + z * z;
  for (Rational& entry : r) entry /= norm;
  return r;
}

inline Rational largest_difference(const std::array<Rational, 9>& r, const std::array<Rational, 9>& m)
{
  Rational largest = 0;
  for (std::size_t k = 0; k < 9; ++k) largest = maximum(largest, Rational(abs(Rational(r[k] - m[k]))));
  return largest;
}

}  // namespace detail

/// Returns the quaternion of the pose's 3x3 part. A matrix that is exactly a rotation gets an exact quaternion, though
/// its length is rounded. Another one gets a quaternion of four doubles and its error. Returns nothing where an entry
/// would have an error above `rotation_tolerance`.
inline std::optional<Rotation_quaternion> rotation_quaternion(const Pose& pose)
{
  std::array<Rational, 9> m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) m[3 * i + j] = pose.exact(int(4 * i + j));
  // Row k is 4 q_k q (Shepperd 1978). The diagonal sums to 4, so its largest entry is 1 or more and that row is not 0.
  const Rational wx = m[7] - m[5], wy = m[2] - m[6], wz = m[3] - m[1], xy = m[1] + m[3], xz = m[2] + m[6],
                 yz = m[5] + m[7];
  const std::array<std::array<Rational, 4>, 4> rows = {{{1 + m[0] + m[4] + m[8], wx, wy, wz},
                                                        {wx, 1 + m[0] - m[4] - m[8], xy, xz},
                                                        {wy, xy, 1 - m[0] + m[4] - m[8], yz},
                                                        {wz, xz, yz, 1 - m[0] - m[4] + m[8]}}};
  std::size_t best = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (rows[k][k] > rows[best][best]) best = k;
  std::array<Rational, 4> q = rows[best];
  const Rational limit(rotation_tolerance), error = detail::largest_difference(detail::rotation_of(q), m);
  if (error > limit) return std::nullopt;

  Rational square = 0;
  for (const Rational& x : q) square += x * x;
  const Rational scale(1 / std::sqrt(nearest_double(square)));
  for (Rational& x : q) x = error == 0 ? Rational(x * scale) : Rational(nearest_double(Rational(x * scale)));
  const Rational rounded = error == 0 ? error : detail::largest_difference(detail::rotation_of(q), m);
  if (rounded > limit) return std::nullopt;
  return Rotation_quaternion{q, nearest_double(rounded)};
}

/// Turns the sign of `to.quaternion`, which changes no rotation, where the motion between the two would take the long
/// way round.
inline void take_short_way(const Rigid_pose& from, Rigid_pose& to)
{
  Rational along = 0;
  for (std::size_t k = 0; k < 4; ++k) along += from.quaternion[k] * to.quaternion[k];
  if (along < 0)
    for (Rational& x : to.quaternion) x = -x;
}

}  // namespace tetracone::kernel

#endif
