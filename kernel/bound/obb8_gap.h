#ifndef TETRACONE_KERNEL_BOUND_OBB8_GAP_H
#define TETRACONE_KERNEL_BOUND_OBB8_GAP_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/bound/relative_motion.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/simd.h"

#include <cmath>

/// Certified gaps of eight boxes and one that a similarity carries. Each is along an axis n as it is stored, whose
/// length is at most 1 + 2^-17. The gap is a lower bound of n . (q - p), and so of the distance, for all points q of
/// the one and p of a lane.
///
/// The comparison of obb8_overlap.h finds the axis of the largest gap. Its slack suffices to tell whether a gap is
/// positive. Boxes whose centres are farther apart than the sum of their supports are apart, whatever is computed. The
/// error of a gap's size also grows with the distance of the centres.
namespace tetracone::kernel {

/// Upper bound of the error of a gap, relative to M, beside the position's error (verify/proofs/gap_proofs.h). M =
/// |t|_1 + reach + sum of extents, t the single box's centre relative to the node's origin.
///
/// Boxes may be apart, so each term counts by itself: the distance of the centres and both boxes' extents. Each has at
/// most 99 roundings, the axes' defect among them. The stored axis differs from the one that is compared along. It has
/// 3 roundings of a coordinate, sqrt(3) times, and 7 of a component, three times by two rotations' norms. That is 26 of
/// M, which is an upper bound of the distance of two points. Along the sides of a triangle, which have twice the slack,
/// the counts are 128 and 46.
inline constexpr double gap_rounding = 144 * 0x1p-24;

/// Factor that covers the length of an axis above 1 and the roundings of a gap: the axes' defect 3.5 times, and 46
/// roundings (verify/proofs/gap_proofs.h).
inline constexpr float gap_shrink = 1 - 0x1p-17f;

/// Relative margin of a box's radius: the axes' defect, the length of a gap's axis above 1, and few roundings
/// (verify/proofs/gap_proofs.h).
inline constexpr float radius_rounding = 0x1p-16f;

/// Returns the slack of certified gaps for a single box in the frame of the eight; not finite where nothing is known.
/// `reach` is the eight's, and `size` an upper bound of the sum of the single box's extents there.
inline float gap_slack(const Single_box& box, float reach, float size)
{
  const float way = std::abs(box.centre[0]) + std::abs(box.centre[1]) + std::abs(box.centre[2]);
  return box.slack + float(gap_rounding) * (way + reach + size) * rounded_up;
}

/// The largest slack at which gaps are certified. Up to it nothing overflows.
inline constexpr float most_gap_slack = 0x1p20f;

/// Gaps of lanes, and their axes, which point away from the lanes. A gap that is not positive says nothing.
struct alignas(32) Certified_gaps {
  float gap[lanes], axis[3][lanes];
};

/// The state of a box when gaps along axes were certified.
///
/// A point of it is q = c + sum_j s_j h_j, |s_j| <= 1, with c its centre and h_j its half edges. It has moved since by
///
///     y + sum_j s_j (L_t - L_0) h_j,    y = p_t - p_0, p the centre's image,
///
/// L_0 the map's linear part then and L_t now. The axis n stands still in the frame of the eight. So a gap g along n
/// has become g + n . y - sum_j |n . (L_t h_j - L_0 h_j)|.
struct alignas(64) Carried_box {
  double image[4];        ///< of the centre, in double; the fourth is not used
  float edge[3][4];       ///< images of the half edges; the fourth is not used
  float centre[3];        ///< in the local units of the box's own body
  float half_edge[3][3];  ///< in these units
  float error;            ///< upper bound of the error of the images then
  float rounding;         ///< the part of `error` that is due to rounding, for a map of scale 1

  /// Upper bound of the error of n . y in float, relative to |p_t - p_0|_1 (verify/proofs/gap_proofs.h). n and y may
  /// have been rounded once each; products and sums have 3 roundings.
  static constexpr double way_rounding = 16 * 0x1p-24;

  /// Upper bound of the error of n . (L_t h_j - L_0 h_j) in float, relative to (|L_t| + |L_0|) |h_j|, the sum over j
  /// included (verify/proofs/gap_proofs.h). Columns are rounded and images have 3 roundings, all these sqrt(3) times.
  /// Half edges, n and the images' difference are rounded, and products with n and the sums have 6.
  static constexpr double edge_rounding = 32 * 0x1p-24;

  /// Upper bound of the error of three sums of two coordinates of magnitude at most 2, and of underflow:
  /// verify/proofs/gap_proofs.h.
  static constexpr double centre_rounding = 0x1p-20;
};

/// A box about the elements that move on, in its own local units: all c + sum_j s_j h_j, |s_j| <= 1.
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

/// A similarity made ready to carry boxes again, for a motion on a course. The map must outlive it.
///
/// A step of the course takes a point q to q + (V q + v). q is a point of the carried box. Where the eight move
/// instead, q is a point of theirs, and the motion is the inverse one: see `Course::reversed`. Let q = c + sum_j s_j
/// h_j be the points of a box that holds these. Then an upper bound of the loss of a gap along n, in a step, is
///
///     sum_j |n . V h_j| - n . (V c + v).
struct alignas(32) Carrier {
  float column[3][4];  ///< of the map's linear part
  const Box_map* map;
  Course course;
  double error;  ///< see `Placement`
  double scale;  ///< see `Relative_frame`
  float slack;   ///< upper bound of the error of a gap's rate

  /// Upper bound of the error of a rate in float, relative to the course's size (verify/proofs/gap_proofs.h).
  /// Coordinates are at most |c_k| + sum_j |h_jk|, which is below 5, since boxes of points |p_k| <= 1 are no longer
  /// than 2 sqrt(3). Columns, half edges, centres and n have a rounding each or an equal error. Images have 4, products
  /// with n and the sums 6.
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

/// A lower bound of the gaps of some lanes, and its rate. After k steps of the course, gap - k rate is still a lower
/// bound, as long as it is positive.
struct Gap_and_rate {
  double gap, rate;
};

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/obb8_gap_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// Writes the certified gaps of the lanes of `boxes` and box `lane` of `from`, in the local units of the eight. `map`,
/// a similarity, carries that box into their frame; `apex` is the place of a triangle in it. For another map, or a
/// slack above `most_gap_slack`, all gaps are 0. Lanes without a box may have any value.
inline void certified_gaps(const Obb8& boxes, const Box_map& map, const Obb8& from, int lane, float apex,
                           Certified_gaps& gaps)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(certified_gaps_simd);
  fastest(boxes, map, from, lane, apex, gaps);
}

/// Writes box `lane` of `from` as it is carried now. It is not returned: without optimisation, g++ 12 does not align a
/// temporary of this size.
inline void carry_now(const Carrier& carrier, const Obb8& from, int lane, Carried_box& box)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(carry_now_simd);
  fastest(carrier, from, lane, box);
}

/// Returns a lower bound of the gaps of the lanes `of_lanes`, a set of bits, when the box is carried again, and its
/// rate. The gap is 0 if nothing is known. `going` holds the elements that move on.
inline Gap_and_rate least_gap_after(const Certified_gaps& gaps, unsigned of_lanes, const Carried_box& box,
                                    const Going_box& going, const Carrier& carrier)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(least_gap_after_simd);
  return fastest(gaps, of_lanes, box, going, carrier);
}

}  // namespace tetracone::kernel

#endif
