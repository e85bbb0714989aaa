#ifndef TETRACONE_KERNEL_BOUND_OBB8_OVERLAP_H
#define TETRACONE_KERNEL_BOUND_OBB8_OVERLAP_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/simd/simd.h"

#include <type_traits>

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/obb8_overlap_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// Returns the lanes of `boxes` that are not found apart from the single box, as bits. `similarity` is true when the
/// single box's edges are nearly orthonormal. Lanes that hold nothing may be among the answers of both functions.
inline unsigned overlapping(const Obb8& boxes, const Single_box& box, bool similarity)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(overlapping_simd);
  return fastest(boxes, box, similarity);
}

/// Returns the lanes of `boxes` that are not found apart from box `lane` of `from`, which `map` carries into the frame
/// of `boxes`.
inline unsigned overlapping(const Obb8& boxes, const Box_map& map, const Obb8& from, int lane)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(overlapping_mapped_simd);
  return fastest(boxes, map, from, lane);
}

}  // namespace tetracone::kernel

#endif
