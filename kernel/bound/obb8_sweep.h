#ifndef TETRACONE_KERNEL_BOUND_OBB8_SWEEP_H
#define TETRACONE_KERNEL_BOUND_OBB8_SWEEP_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_gap.h"
#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/simd.h"

#include <cmath>

/// When eight boxes and one that moves past them may meet.
///
/// Boxes that move on lines are apart along an axis before one time and after another, if at all: where the distance of
/// their centres, linear in time, is more than both reach. Of the axes of the comparison of obb8_overlap.h in the middle
/// of a span of time, all these times together leave the times at which they may meet: of boxes that do not turn, no
/// others, since boxes that are apart at a time are so along one of these axes.
namespace tetracone::kernel {

/// How the single box moves against the eight, in their frame and local units: at x in [-1, 1], the ends of a span of
/// time, a point of its centre and one at p from the node's origin have gone apart by x (`shift` - `bend` p) since the
/// middle. All other motion takes at most `loss`, and `turn` times the distance of a lane's farthest point from its
/// centre.
struct Box_sweep {
  float shift[3], bend[3][3];
  double loss, turn;

  /// Above the sum of the magnitudes of all products and terms, for points within `reach` of the origin.
  double size(double reach) const
  {
    double sum = 0;
    for (int k = 0; k < 3; ++k)
      sum += std::abs(double(shift[k])) +
             reach * (std::abs(double(bend[k][0])) + std::abs(double(bend[k][1])) + std::abs(double(bend[k][2])));
    return sum;
  }
};

/// Of each lane: before and after these times, from 0 to 1 over the span, it is apart from the single box.
struct alignas(32) Near_times {
  float from[lanes], until[lanes];
};

/// What the way along an axis is off by in float, a share of the sweep's size: entries are off by 1 rounding, the way by
/// 3 more, along the eight's axes by 3, its products with the axis and their sums by 3, of terms whose sum is at most
/// sqrt(3) times the size.
inline constexpr double sweep_rounding = 32 * 0x1p-24;

/// A distance and what both boxes reach are each off by the slack of a gap at most: so many times that.
inline constexpr float slacks_of_sweep = 3;

/// Below that an axis' speed is taken for it.
inline constexpr float least_speed = 0x1p-100f;

/// What times are off by, as shares of the span: a time is a quotient of sums, off by 4 roundings of itself.
inline constexpr float time_rounding = 0x1p-21f;

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/obb8_sweep_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// The lanes of `boxes`, as bits, that may meet box `lane` of `from`, which `map`, a similarity, carries into their frame
/// in the middle of the span; and when. `apex` says where a triangle lies in that box. Lanes that hold nothing may be
/// among them.
inline unsigned near_in_sweep(const Obb8& boxes, const Box_map& map, const Obb8& from, int lane, float apex,
                              const Box_sweep& sweep, Near_times& times)
{
  using Function = unsigned(const Obb8&, const Box_map&, const Obb8&, int, float, const Box_sweep&, Near_times&);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(near_in_sweep_simd));
  return fastest(boxes, map, from, lane, apex, sweep, times);
}

}  // namespace tetracone::kernel

#endif
