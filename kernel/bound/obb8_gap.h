#ifndef TETRACONE_KERNEL_BOUND_OBB8_GAP_H
#define TETRACONE_KERNEL_BOUND_OBB8_GAP_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/bound/relative_motion.h"
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

/// Where a box was when gaps along axes were certified.
///
/// A point of it is q = c + sum_j s_j h_j, |s_j| <= 1, c its centre and h_j its half edges. It has moved by
///
///     y + sum_j s_j (L_t - L_0) h_j,    y = p_t - p_0, p the centre's image,
///
/// L_0 the map's linear part then and L_t now. So a gap g along n, which stands still in the frame of the eight, has
/// become g + n . y - sum_j |n . (L_t h_j - L_0 h_j)|.
struct alignas(64) Carried_box {
  double image[4];        ///< of the centre, in double; the fourth is not used
  float edge[3][4];       ///< images of the half edges; the fourth is not used
  float centre[3];        ///< in the box's own local units
  float half_edge[3][3];  ///< there

  /// Above what images then were off by, and how much they are for a map of the scale 1.
  float error, rounding;

  /// Of n . y in float, a share of |p_t - p_0|_1: n may have been rounded once, the way is, and products and sums by 3.
  static constexpr double way_rounding = 16 * 0x1p-24;

  /// Of n . (L_t h_j - L_0 h_j) in float, a share of (|L_t| + |L_0|) |h_j|, the sum over j included: columns, half edges
  /// and n are rounded, images by 3, their difference once, products with n and the sums by 6.
  static constexpr double edge_rounding = 32 * 0x1p-24;

  /// More than a sum of two coordinates of magnitude 2 at most loses, in three of them, and what underflows.
  static constexpr double centre_rounding = 0x1p-20;

  template <class Number>
  static Number placed(Number offset, Number x, Number y, Number z)
  {
    return ((offset + x) + y) + z;
  }
};

/// A box that holds what goes on, in its own local units: all c + sum_j s_j h_j, |s_j| <= 1, as far as it has elements.
struct Going_box {
  float centre[3], half_edge[3][3];

  Going_box() = default;
  Going_box(const Obb8& boxes, int lane)
  {
    for (int k = 0; k < 3; ++k) {
      centre[k] = boxes.origin[k] + boxes.centre[k][lane];
      for (int j = 0; j < 3; ++j) half_edge[j][k] = boxes.axis[j][k][lane] * boxes.extent[j][lane];
    }
  }
};

/// A similarity made ready to carry boxes again, in the course of a motion. The map must outlive it.
///
/// A step of the course takes a point q to q + (V q + v): one of the box that is carried; or, where the eight go on
/// instead, one of theirs the other way, see `Course::reversed`. Of points q = c + sum_j s_j h_j of a box that holds
/// these it takes off a gap along n at most
///
///     sum_j |n . V h_j| - n . (V c + v).
struct alignas(32) Carrier {
  float column[3][4];  ///< of the map's linear part
  const Box_map* map;
  Course course;
  double error;  ///< see `Placement`
  double scale;
  float slack;  ///< of the rate of a gap

  /// Of a rate in float, a share of the course's size: coordinates are |c_k| + sum_j |h_jk| at most, which is below 5,
  /// since boxes of points |p_k| <= 1 are no longer than 2 sqrt(3). Columns, half edges, centres and n are rounded or off
  /// by as much, images by 4, products with n and the sums by 6.
  static constexpr double rate_rounding = 128 * 0x1p-24;

  Carrier(const Box_map& of, const Placement& placement, const Course& going)
      : map(&of),
        course(going),
        error(placement.error),
        scale(placement.scale),
        slack(float(rate_rounding) * course.size * rounded_up + box_underflow)
  {
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 4; ++k) column[j][k] = float(placement.column[j][k]);
  }
};

/// At most a gap, and how much of it a step of the course takes at most, as long as some is left.
struct Gap_and_rate {
  double gap, rate;
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

/// Writes box `lane` of `from` as it is carried now. (Not returned: unoptimised, g++ 12 does not align a temporary of
/// so many bytes.)
inline void carry_now(const Carrier& carrier, const Obb8& from, int lane, Carried_box& box)
{
  using Function = void(const Carrier&, const Obb8&, int, Carried_box&);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(carry_now_simd));
  fastest(carrier, from, lane, box);
}

/// The least of these gaps of lanes, as bits, when the box is carried again, and what goes on is in `going`.
inline Gap_and_rate least_gap_after(const Certified_gaps& gaps, unsigned of_lanes, const Carried_box& box,
                                    const Going_box& going, const Carrier& carrier)
{
  using Function = Gap_and_rate(const Certified_gaps&, unsigned, const Carried_box&, const Going_box&, const Carrier&);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(least_gap_after_simd));
  return fastest(gaps, of_lanes, box, going, carrier);
}

}  // namespace tetracone::kernel

#endif
