#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_GRID_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_GRID_H

#include "tetracone/kernel/predicate/adaptive_points.h"
#include "tetracone/kernel/predicate/int128_signs.h"

#include <optional>

namespace tetracone::kernel {

/// The grid stage: the expression in integers of 128 bits, where images are exact and whole multiples of a common power
/// of two.
class Adaptive_grid : public Adaptive_points {
 public:
  /// Returns the sign, exactly, where images are exact and on a common grid; else undecided.
  static Decision int128_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    return are_exact(a, b, c, d) ? kernel::int128_volume_sign(a.image, b.image, c.image, d.image) : std::nullopt;
  }
  static Decision int128_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    return are_exact(a, b, c) ? kernel::int128_normal_sign(a.image, b.image, c.image, axis) : std::nullopt;
  }
};

}  // namespace tetracone::kernel

#endif
