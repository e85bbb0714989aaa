#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_ZERO_EXITS_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_ZERO_EXITS_H

#include "tetracone/kernel/predicate/adaptive_points.h"

#include <CGAL/enum.h>

#include <optional>

namespace tetracone::kernel {

/// The zero exits: a stage for signs that are zero without arithmetic. Two points are one vertex under one pose, or
/// equal exact coordinates give every product a factor 0.
class Adaptive_zero_exits : public Adaptive_points {
 public:
  /// Returns ZERO where det[b-a, c-a, d-a] is 0 at sight; else undecided. That is so where two points are identical. It
  /// is also so where images are exact and each of the six products has a factor 0, as on a plane perpendicular to an
  /// axis. A difference of doubles is 0 only when they are equal.
  static Decision zero_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    if (identical(c, d) || identical(b, d) || identical(b, c) || identical(a, d) || identical(a, c) || identical(a, b))
      return CGAL::ZERO;
    if (!are_exact(a, b, c, d)) return std::nullopt;
    const auto is_0 = [&a](const Point_3& p, int k) { return p.image[k] == a.image[k]; };
    const auto vanishes = [&](int i, int j, int k) { return is_0(b, i) || is_0(c, j) || is_0(d, k); };
    if (vanishes(0, 1, 2) && vanishes(1, 2, 0) && vanishes(2, 0, 1) && vanishes(0, 2, 1) && vanishes(1, 0, 2) &&
        vanishes(2, 1, 0))
      return CGAL::ZERO;
    return std::nullopt;
  }

  /// Returns ZERO where component `axis` of (b-a) x (c-a) is 0 at sight; else undecided.
  static Decision zero_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    if (identical(b, c) || identical(a, c) || identical(a, b)) return CGAL::ZERO;
    if (!are_exact(a, b, c)) return std::nullopt;
    const auto is_0 = [&a](const Point_3& p, int k) { return p.image[k] == a.image[k]; };
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    if ((is_0(b, i) || is_0(c, j)) && (is_0(b, j) || is_0(c, i))) return CGAL::ZERO;
    return std::nullopt;
  }
};

}  // namespace tetracone::kernel

#endif
