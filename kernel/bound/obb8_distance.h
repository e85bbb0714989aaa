#ifndef TETRACONE_KERNEL_BOUND_OBB8_DISTANCE_H
#define TETRACONE_KERNEL_BOUND_OBB8_DISTANCE_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/simd/simd.h"

#include <array>
#include <cstddef>
#include <limits>

/// Lower bounds of the squared distances of eight boxes from one, in the local units of the eight.
///
/// In the frame of a box's axes a_i the other box lies in an axis-parallel box. Points of both differ along a_i by g_i
/// = |a_i . t| - e_i - sum_j f_j |a_i . edge_j| or more, where that is positive, t from centre to centre. With axes of
/// a defect d (`axis_defect`) |y|^2 >= (1 - 3 d) sum_i (a_i . y)^2. For a similarity, another bound holds in the frame
/// of the single box, whose edges are orthonormal up to 2^-20. (That is d, the map's tolerance 2^-24, and roundings.)
/// The larger bound is taken.
///
/// Each is improved along the vector n = sum_i +-g_i a_i that it found. A lower bound of the difference of the boxes
/// along n is sum_i g_i (|t_i| - e_i) - sum_j f_j |sum_i +-g_i a_i . edge_j|. Divided by |n|, it bounds the distance.
namespace tetracone::kernel {

/// Factor of the root of a squared distance. It covers the defect of the frames' axes, 1.5 * 2^-20, and a few roundings
/// (verify/proofs/obb8_distance_proofs.h).
inline constexpr float distance_shrink = 1 - 0x1p-18f;

/// Upper bound of the error of g_i, relative to M = |t|_1 + reach + sum of extents, beside the position's error
/// (verify/proofs/obb8_distance_proofs.h). t has 1 rounding of the double and 2 of the node's origin and centre. Each
/// product with an axis has 3, and 4 of an edge that was carried. The three extents along n have 5 more, and sums along
/// n, where each is times |g_i|, have 6. No term is more than sqrt(3) M: 64 covers 32 of them, and the axes' defect,
/// which is 8.
inline constexpr double distance_rounding = 64 * 0x1p-24;

/// The parameters of lower bounds of gaps.
struct Gap_question {
  float stretch;  ///< `distance_shrink` times a lower bound of the length that a unit vector of the eight has in the
                  ///< asked units; 0 gives no bound
  float limit;    ///< lanes farther apart than this are not wanted
  float known;    ///< a lower bound that is known already
  float size;     ///< the size of a box is this times the sum of its extents
};

/// The gaps of the eight, a lane each.
struct Eight_gaps {
  alignas(32) std::array<float, lanes> low;  ///< lower bounds of distances
  std::array<float, lanes> size;             ///< sizes of boxes, not below the least normal number
  std::array<float, lanes> between;          ///< approximate squared distances of the centres, in the asked units
};

/// A test of the lanes of `boxes` against box `lane` of `from`, which `map` carries into their frame.
struct Gap_test {
  const Obb8* boxes;
  const Box_map* map;
  const Obb8* from;
  int lane;
  Gap_question question;

  // The results.
  unsigned nearer;  ///< lanes, as bits, that are not found farther than the limit
  Eight_gaps gaps;  ///< they may have any value in lanes that hold nothing
};

/// The largest number of tests that are made at once.
inline constexpr std::size_t most_gap_tests = 4;

/// Returns the size of a box, `factor` times the sum of its extents, not below the least normal number.
inline float box_size(float sum, float factor)
{
  const float size = sum * factor;
  return size > std::numeric_limits<float>::min() ? size : std::numeric_limits<float>::min();
}

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/obb8_distance_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// Writes the results of up to `most_gap_tests` tests. They are made together, so that no test waits for the data of
/// another.
inline void find_gaps(Gap_test* tests, std::size_t count)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(find_gaps_simd);
  fastest(tests, count);
}

}  // namespace tetracone::kernel

#endif
