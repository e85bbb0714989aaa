#ifndef TETRACONE_KERNEL_BOUND_OBB8_POINT_H
#define TETRACONE_KERNEL_BOUND_OBB8_POINT_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/simd/simd.h"

#include <array>

namespace tetracone::kernel {

/// Upper bound of the error of a point's coordinate along an axis beyond a box, relative to M = |p|_1 + reach. Here p
/// is relative to the node's origin. The roundings of p and p - c are 2 of 2^-24, products and sums with an axis 4. The
/// difference from the extent and the slack's own rounding are 3. The axes' defect times the extents is 8 of 2^-24. So
/// 17 of 32 are counted by hand (verify/proofs/other_constants.h).
inline constexpr float point_box_rounding = 32 * 0x1p-24f;

/// Factor of a lower bound of a square: 3 `axis_defect` for axes that are not orthonormal, and 6 roundings in float.
/// They are counted by hand (verify/proofs/other_constants.h).
inline constexpr float point_square_shrink = 1 - 0x1p-18f;

/// For each lane, a lower bound of the squared distance of a point and the lane's box, in local units.
using Lane_squares = std::array<float, lanes>;

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/obb8_point_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// Writes into `squares` a lower bound of the squared distance of the point and each box, in local units. Requires
/// coordinates of at most 2^60, with a relative error of at most 2^-50.
///
/// A point x of a box has |a_i . (x - c)| <= e_i + d (e_0 + e_1 + e_2), d the axes' defect. So |a_i . (p - x)| is at
/// least |a_i . (p - c)| less that. The sum of these squares is at most 1 + 3 d times the squared distance.
inline void point_squares(const Obb8& boxes, const std::array<double, 3>& point, Lane_squares& squares)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(point_squares_simd);
  fastest(boxes, point, squares.data());
}

}  // namespace tetracone::kernel

#endif
