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

/// The times at which eight boxes and one that moves past them may meet.
///
/// Along an axis, boxes that move on lines may be apart before one time and after another. They are apart where their
/// centres' distance, which is linear in time, exceeds the sum of their supports. The test uses the axes of
/// obb8_overlap.h in the middle of a span of time. The boxes may meet only at times that no axis excludes. If they do
/// not turn, they do meet then, up to rounding: boxes that are apart are so along one of these axes.
namespace tetracone::kernel {

/// Upper bound of the error of the motion along an axis in float, relative to the sum of the magnitudes of the sweep's
/// terms (verify/proofs/gap_proofs.h). Entries have 1 rounding, the motion 3 more and along the eight's axes 3. Its
/// products with the axis and their sums have 3. The sum of these terms is at most sqrt(3) times that size.
inline constexpr double sweep_rounding = 32 * 0x1p-24;

/// A vector that is linear in two points: `offset` + `single` q - `eight` p, in the eight's frame and units. p is a
/// point of the eight's body, q one of the single box's, each in its body's local units.
struct Point_way {
  using Rows = std::array<std::array<double, 3>, 3>;

  alignas(32) double offset[4] = {}, single[3][4] = {}, eight[3][4] = {};  ///< columns; of each, the fourth is 0
  float rounded_eight[3][4] = {};                                          ///< `eight`, rounded to float
  double norm_of_single = 0, norm_of_eight = 0;  ///< upper bounds of the largest singular values
  double size = 0;  ///< upper bound of the sum of the magnitudes of all terms, up to few roundings, for points with
                    ///< coordinates of at most 2

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
  /// Returns the eighth root of the sum of the singular values' eighth powers, an upper bound of the largest. 2^-120
  /// covers underflow: eighth powers of singular values underflow below 2^-134, where their root is below 2^-130.
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

/// The motion of the single box's body relative to the eight's. Times x run from -1 to 1, the ends of the span. At x,
/// the vector from p to q differs by `middle` + x `half` from the one that the test's `map` gives. `rest` is an upper
/// bound of the error in any direction.
struct Box_sweep {
  Point_way middle, half;
  double rest = 0;
};

/// Before `from` and after `until`, the single box is known to be apart from all eight. Times run from 0 to 1 over the
/// span.
struct Known_times {
  float from = 0, until = 1;

  /// Returns the largest distance of these times from the middle of the span, as a fraction of its half.
  float farthest() const { return maximum(1 - 2 * from, 2 * until - 1); }
};

/// For each lane, the times, from 0 to 1 over the span, before and after which it is apart from the single box.
struct alignas(32) Near_times {
  float from[lanes], until[lanes];
};

/// A test of the lanes of `boxes` against box `lane` of `from`. The similarity `map` carries that box into their frame
/// in the middle of the span.
struct Sweep_test {
  const Obb8* boxes;
  const Box_map* map;
  const Obb8* from;
  int lane;
  float apex;  ///< the place of a triangle in the single box; `no_apex` where it holds none
  const Box_sweep* sweep;
  Known_times known;

  // The results.
  unsigned near;  ///< lanes, as bits, that may meet the single box
  Near_times times;
};

/// The largest number of tests that are made at once.
inline constexpr std::size_t most_sweep_tests = 4;

/// Returns the distance of a lane's farthest point from its centre, up to `radius_rounding` of it.
inline float radius_of(const Obb8& boxes, int lane)
{
  float square = 0;
  for (int k = 0; k < 3; ++k) square += boxes.extent[k][lane] * boxes.extent[k][lane];
  return std::sqrt(square);
}

/// Number of gap slacks in the slack of a sweep. In each time the distance counts twice and the gap once, each with an
/// error of at most one (verify/proofs/reference_proofs.h).
inline constexpr float slacks_of_sweep = 3;

/// The least speed along an axis: a smaller one is replaced by it (verify/proofs/reference_proofs.h).
inline constexpr float least_speed = 0x1p-100f;

/// Upper bound of the error of a time, as a fraction of the span. A time is a quotient of sums, with 4 roundings
/// (verify/proofs/gap_proofs.h).
inline constexpr float time_rounding = 0x1p-21f;

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/obb8_sweep_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// Writes the results of up to `most_sweep_tests` tests. They are made together, so that no test waits for the data of
/// another. For a map that is no similarity, and for slacks above `most_gap_slack`, all lanes are near.
inline void find_near(Sweep_test* tests, std::size_t count)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(find_near_simd);
  fastest(tests, count);
}

}  // namespace tetracone::kernel

#endif
