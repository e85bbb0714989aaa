#ifndef TETRACONE_KERNEL_BOUND_OBB8_SWEEP_H
#define TETRACONE_KERNEL_BOUND_OBB8_SWEEP_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_gap.h"
#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/simd/simd.h"

#include <array>
#include <cmath>
#include <cstddef>

/// When eight boxes and one that moves past them may meet.
///
/// Boxes that move on lines are apart along an axis before one time and after another, if at all: where the distance of
/// their centres, linear in time, is more than both reach. Of the axes of the comparison of obb8_overlap.h in the middle
/// of a span of time, all these times together leave the times at which they may meet: of boxes that do not turn, no
/// others, since boxes that are apart at a time are so along one of these axes.
namespace tetracone::kernel {

/// What the way along an axis is off by in float, a share of the sum of the magnitudes of the sweep's terms: entries are
/// off by 1 rounding, the way by 3 more, along the eight's axes by 3, its products with the axis and their sums by 3, of
/// terms whose sum is at most sqrt(3) times that size.
inline constexpr double sweep_rounding = 32 * 0x1p-24;

/// A way, linear in two points: from p, of the eight's body, to q, of the single box's, each in its body's local units,
/// `offset` + `single` q - `eight` p in the eight's frame and units.
struct Point_way {
  using Rows = std::array<std::array<double, 3>, 3>;

  alignas(32) double offset[4] = {}, single[3][4] = {}, eight[3][4] = {};  ///< columns; of each, the fourth is 0
  float rounded_eight[3][4] = {};
  double norm_of_single = 0, norm_of_eight = 0;  ///< at least the largest singular values
  double size = 0;  ///< at least the sum of the magnitudes of all terms of points whose coordinates are at most 2

  Point_way() = default;
  Point_way(const std::array<double, 3>& shift, const Rows& of_single, const Rows& of_eight)
      : norm_of_single(norm(of_single)), norm_of_eight(norm(of_eight))
  {
    for (std::size_t i = 0; i < 3; ++i) {
      offset[i] = shift[i];
      size += std::abs(shift[i]);
      for (std::size_t j = 0; j < 3; ++j) {
        single[j][i] = of_single[i][j];
        eight[j][i] = of_eight[i][j];
        rounded_eight[j][i] = float(of_eight[i][j]);
        size += 2 * (std::abs(of_single[i][j]) + std::abs(of_eight[i][j]));
      }
    }
  }

 private:
  /// The root of the sum of the singular values' eighth powers, with what underflows there.
  static double norm(const Rows& m)
  {
    Rows square = m;
    for (int round = 0; round < 2; ++round) {
      const Rows x = square;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) square[i][j] = dot(x[i], x[j]);
    }
    double sum = 0;
    for (const auto& row : square) sum += dot(row, row);
    return std::sqrt(std::sqrt(std::sqrt(sum))) * (1 + few_roundings) + 0x1p-120;
  }
};

/// How the single box's body moves against the eight's: at x in [-1, 1], the ends of a span of time, points have gone
/// apart by `middle` + x `half` against where a similarity places them, but for `rest` at most, in any direction.
struct Box_sweep {
  Point_way middle, half;
  double rest = 0;
};

/// Times from 0 to 1 over the span, before and after which the single box is known to be apart from all of the eight.
struct Known_times {
  float from = 0, until = 1;

  /// How far from the middle of the span these are at most, a share of its half.
  float farthest() const { return maximum(1 - 2 * from, 2 * until - 1); }
};

/// Of each lane: before and after these times, from 0 to 1 over the span, it is apart from the single box.
struct alignas(32) Near_times {
  float from[lanes], until[lanes];
};

/// The lanes of `boxes` against box `lane` of `from`, which `map`, a similarity, carries into their frame in the middle
/// of the span.
struct Sweep_test {
  const Obb8* boxes;
  const Box_map* map;
  const Obb8* from;
  int lane;
  float apex;  ///< where a triangle lies in the single box
  const Box_sweep* sweep;
  Known_times known;

  // What is found.
  unsigned near;  ///< lanes, as bits, that may meet the single box
  Near_times times;
};

/// So many tests are made at once at most.
inline constexpr std::size_t most_sweep_tests = 4;

/// About the distance of a lane's farthest point from its centre.
inline float radius_of(const Obb8& boxes, int lane)
{
  float square = 0;
  for (int k = 0; k < 3; ++k) square += boxes.extent[k][lane] * boxes.extent[k][lane];
  return std::sqrt(square);
}

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

/// Makes up to `most_sweep_tests` tests, so that none need wait for what another brings.
inline void find_near(Sweep_test* tests, std::size_t count)
{
  using Function = void(Sweep_test*, std::size_t);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(find_near_simd));
  fastest(tests, count);
}

}  // namespace tetracone::kernel

#endif
