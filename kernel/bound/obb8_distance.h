#ifndef TETRACONE_KERNEL_BOUND_OBB8_DISTANCE_H
#define TETRACONE_KERNEL_BOUND_OBB8_DISTANCE_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/simd/simd.h"

#include <array>
#include <cstddef>
#include <limits>

namespace tetracone::kernel {

/// Lower bounds of the distances of eight boxes from one, in the local units of the eight, squared.
///
/// In the frame of a box's axes a_i the other box lies in an axis-parallel box: points of both differ along a_i by at
/// least g_i = |a_i . t| - e_i - sum_j f_j |a_i . edge_j|, where that is positive, t from centre to centre. With axes
/// of a defect d (`axis_defect`) |y|^2 >= (1 - 3 d) sum_i (a_i . y)^2. Of a similarity, the same in the frame of the
/// single box, whose edges are orthonormal but for 2^-20: d, the map's tolerance 2^-24, and roundings.
/// Both bounds hold, and the larger one is taken. Each is improved along the way n = sum_i +-g_i a_i that it found: the
/// boxes differ along n by at least sum_i g_i (|t_i| - e_i) - sum_j f_j |sum_i +-g_i a_i . edge_j|, over |n| a bound too.
/// `distance_shrink` is for the root: 1.5 * 2^-20, and a few roundings.
inline constexpr float distance_shrink = 1 - 0x1p-18f;

/// What g_i may be off by, a share of M = |t|_1 + reach + sum of extents, beside the position's error: of t, 1 rounding
/// of the double, 2 of the node's origin and centre; of each product with an axis 3, and 4 of an edge that was carried;
/// of the three reaches 5 more, and 6 of sums along n, where each is times |g_i|. None is of more than sqrt(3) M: 64
/// covers 32 of them, and the axes' defect, which is 8.
inline constexpr double distance_rounding = 64 * 0x1p-24;

/// What lower bounds are made of and held against.
struct Gap_question {
  float stretch;  ///< at most the length of what is of length 1 in the units of the eight, times `distance_shrink`
  float limit;    ///< boxes that are farther apart are not asked for
  float known;    ///< none is nearer
  float size;     ///< of a box: this times the sum of its extents
};

/// What is known of the eight, a lane each.
struct Eight_gaps {
  alignas(32) std::array<float, lanes> low;  ///< lower bounds of distances
  std::array<float, lanes> size;             ///< at least the least normal number
  std::array<float, lanes> between;          ///< of the centres, about, squared, where `stretch` is known
};

/// The lanes of `boxes` against box `lane` of `from`, which `map` carries into their frame.
struct Gap_test {
  const Obb8* boxes;
  const Box_map* map;
  const Obb8* from;
  int lane;
  Gap_question question;

  // What is found.
  unsigned nearer;  ///< lanes, as bits, that are not found farther than the limit
  Eight_gaps gaps;  ///< of lanes that hold nothing they may have any value
};

/// So many tests are made at once at most.
inline constexpr std::size_t most_gap_tests = 4;

/// The size of a box by the sum of its extents, which a sign may be given.
inline float box_size(float sum, float factor)
{
  const float size = sum * factor;
  return size > std::numeric_limits<float>::min() ? size : std::numeric_limits<float>::min();
}

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/obb8_distance_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// Makes up to `most_gap_tests` tests, so that none need wait for what another brings.
inline void find_gaps(Gap_test* tests, std::size_t count)
{
  using Function = void(Gap_test*, std::size_t);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(find_gaps_simd));
  fastest(tests, count);
}

}  // namespace tetracone::kernel

#endif
