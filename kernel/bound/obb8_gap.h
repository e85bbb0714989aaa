#ifndef TETRACONE_KERNEL_BOUND_OBB8_GAP_H
#define TETRACONE_KERNEL_BOUND_OBB8_GAP_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/simd.h"

#include <cmath>

/// Certified gaps of eight boxes and one that a similarity carries, each along an axis n as it is stored, of length 1 at
/// most but for 2^-17: for all points q of the one and p of a lane n . (q - p) is at least the gap, and so is their
/// distance.
///
/// The comparison of obb8_overlap.h finds the axis of the largest gap. Its slack is enough to tell whether a gap is
/// positive, since boxes whose centres are farther apart than both reach are apart, whatever is computed; how large one
/// is depends on the distance of the centres too.
namespace tetracone::kernel {

/// What a gap may be off by, a share of M = |t|_1 + reach + sum of extents, t the single box's centre relative to the
/// node's origin, beside the position's error. Boxes may be apart, so that each term counts by itself, the centres' way
/// and both boxes' extents: none is off by more than 99 roundings, the axes' defect among them. The axis that is stored
/// is off from the one that is compared along by 3 roundings of a coordinate, sqrt(3) times, and 7 of a component,
/// three times by two rotations' norms: 26 of M, which no two points' distance is above. Along the sides of a triangle,
/// which are given twice as much, these are 128 and 46.
inline constexpr double gap_rounding = 144 * 0x1p-24;

/// What takes the length of an axis above 1 and the roundings of a gap: the axes' defect 3.5 times, and 46 roundings.
inline constexpr float gap_shrink = 1 - 0x1p-17f;

/// What a box's radius grows by: what its axes lack to be orthonormal, the length of a gap's axis above 1, and few
/// roundings.
inline constexpr float radius_rounding = 0x1p-16f;

/// The slack of certified gaps, of a box that `carried` has placed: not finite where nothing is known.
inline float gap_slack(const Single_box& box, float reach, float size)
{
  const float way = std::abs(box.centre[0]) + std::abs(box.centre[1]) + std::abs(box.centre[2]);
  return box.slack + float(gap_rounding) * (way + reach + size) * rounded_up;
}

/// Above this slack no gap is certified: below, nothing overflows.
inline constexpr float most_gap_slack = 0x1p20f;

/// Gaps of lanes, and their axes, which lead away from the lanes. Where a gap is not positive, nothing is known.
struct alignas(32) Certified_gaps {
  float gap[lanes], axis[3][lanes];
};

/// Where a box was when gaps along axes were certified, and how much they are still worth.
///
/// When a point q of the single box has moved by y = p_t - p_0 + (L_t - L_0)(q - c), c a point near the box's centre and
/// p its image, a gap g along n has become g + n . y, of which the second part is at most the radius about c times the
/// norm of L_t - L_0, or of all such steps since. A node's axes stand still in its own frame.
struct alignas(32) Carried_box {
  double image[4];  ///< of the centre, in double; the fourth is not used
  float centre[3];  ///< in the box's own local units
  float radius;     ///< at least |q - c| of all points, times the length of an axis
  float turned;     ///< at most the sum of the linear parts' steps then
  float error;      ///< at least that of images then, in |.|_2

  Carried_box() = default;
  Carried_box(const Box_map& map, const Obb8& from, int lane, double turned_so_far)
      : turned(float(turned_so_far * (1 - 0x1p-22))), error(float(error_of(map) * (1 + 0x1p-22)))
  {
    float square = 0;
    for (int k = 0; k < 3; ++k) {
      centre[k] = from.origin[k] + from.centre[k][lane];
      square += from.extent[k][lane] * from.extent[k][lane];
    }
    radius = std::sqrt(square) * (1 + radius_rounding) + centre_rounding;
    for (int k = 0; k < 4; ++k)
      image[k] = placed(map.column(3)[k], map.column(0)[k] * double(centre[0]), map.column(1)[k] * double(centre[1]),
                        map.column(2)[k] * double(centre[2]));
  }

  /// Of n . y in float, a share of |p_t - p_0|_1: n may have been rounded once, the way is, and products and sums by 3.
  static constexpr double way_rounding = 16 * 0x1p-24;

  /// More than a sum of two coordinates of magnitude 2 at most loses, in three of them, and what underflows.
  static constexpr float centre_rounding = 0x1p-20f;

  /// Above what an error of each coordinate of a point moves it along an axis.
  static constexpr double position_norm = 2;

  /// Of an image in double: the map's, in three coordinates, and few roundings of terms that are at most the offset and
  /// three times twice a column.
  static double error_of(const Box_map& map)
  {
    const double* offset = map.column(3);
    return position_norm * map.frame().error() +
           few_roundings * (6 * map.scale() + (std::abs(offset[0]) + std::abs(offset[1]) + std::abs(offset[2])));
  }

  template <class Number>
  static Number placed(Number offset, Number x, Number y, Number z)
  {
    return ((offset + x) + y) + z;
  }
};

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/obb8_gap_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// Of the lanes of `boxes` and box `lane` of `from`, which `map`, a similarity, carries into their frame, in the local
/// units of the eight; `apex` says where a triangle lies in that box. Lanes that hold nothing may have any value.
inline void certified_gaps(const Obb8& boxes, const Box_map& map, const Obb8& from, int lane, float apex,
                           Certified_gaps& gaps)
{
  using Function = void(const Obb8&, const Box_map&, const Obb8&, int, float, Certified_gaps&);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(certified_gaps_simd));
  fastest(boxes, map, from, lane, apex, gaps);
}

/// At most the least of these gaps of lanes, as bits, when the box is carried by `map`, whose linear part has changed by
/// steps that sum up to `turned`.
inline double least_gap_after(const Certified_gaps& gaps, unsigned of_lanes, const Carried_box& box, const Box_map& map,
                              double turned)
{
  using Function = double(const Certified_gaps&, unsigned, const Carried_box&, const Box_map&, double);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(least_gap_after_simd));
  return fastest(gaps, of_lanes, box, map, turned);
}

}  // namespace tetracone::kernel

#endif
