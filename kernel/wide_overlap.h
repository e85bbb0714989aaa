#ifndef TETRACONE_KERNEL_WIDE_OVERLAP_H
#define TETRACONE_KERNEL_WIDE_OVERLAP_H

#include "kernel/simd.h"
#include "kernel/wide_boxes.h"

#define TETRACONE_SIMD_KERNEL "kernel/wide_overlap_kernel.h"
#include "kernel/simd_rounds.h"

namespace tetracone::kernel {

/// The lanes of `boxes` that are not found apart from the single box, as bits; lanes that hold nothing may be among them.
inline unsigned overlapping(const Wide_boxes& boxes, const Single_box& box, bool similarity)
{
  using Function = unsigned(const Wide_boxes&, const Single_box&, bool);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(overlapping_kernel));
  return fastest(boxes, box, similarity);
}

/// The same of box `lane` of `from`, which `map` carries into the frame of `boxes`.
inline unsigned overlapping(const Wide_boxes& boxes, const Box_map& map, const Wide_boxes& from, int lane)
{
  using Function = unsigned(const Wide_boxes&, const Box_map&, const Wide_boxes&, int);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(overlapping_mapped_kernel));
  return fastest(boxes, map, from, lane);
}

}  // namespace tetracone::kernel

#endif
