#ifndef TETRACONE_KERNEL_BOUND_OBB8_POINT_H
#define TETRACONE_KERNEL_BOUND_OBB8_POINT_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/simd/simd.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace tetracone::kernel {

/// Upper bound of the error of a point's coordinate along an axis beyond a box, relative to M = |p|_1 + reach. Here p
/// is relative to the node's origin. The roundings of p and p - c are 2 of 2^-24, products and sums with an axis 4. The
/// difference from the extent and the slack's own rounding are 3. The axes' defect times the extents is 8 of 2^-24. So
/// 17 of 32 are counted by hand (verify/proofs/other_constants.h).
inline constexpr float point_box_rounding = 32 * 0x1p-24f;

/// Factor of a lower bound of a square: 3 `axis_defect` for axes that are not orthonormal, and 6 roundings in float.
/// They are counted by hand (verify/proofs/other_constants.h).
inline constexpr float point_square_shrink = 1 - 0x1p-18f;

/// For each lane, a lower bound of the squared distance of a point and the lane's box, in local units. Its last three
/// bits are the lane's number, which may raise a bound of 0 to 7 * 2^-149.
using Lane_squares = std::array<float, lanes>;

/// The least squares: bounds where nothing is known.
inline constexpr Lane_squares zero_squares = [] {
  Lane_squares squares;
  for (std::uint32_t lane = 0; lane < lanes; ++lane) squares[lane] = std::bit_cast<float>(lane);
  return squares;
}();

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

/// Returns the lane of the least square among those whose bits are set in `left`. Returns -1 if none is left or the
/// least exceeds `limit`. Requires squares of `point_squares`.
inline int nearest_lane(const Lane_squares& squares, std::uint32_t left, float limit)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(nearest_lane_simd);
  return fastest(squares, left, limit);
}

}  // namespace tetracone::kernel

#endif
