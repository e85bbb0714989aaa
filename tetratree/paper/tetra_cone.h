#ifndef TETRACONE_TETRATREE_PAPER_TETRA_CONE_H
#define TETRACONE_TETRATREE_PAPER_TETRA_CONE_H

#include "tetracone/kernel/bound/cone_lattice.h"
#include "tetracone/kernel/predicate/frame.h"
#include "tetracone/kernel/predicate/signs.h"

#include <array>
#include <cassert>

namespace tetracone::tetratree {

using kernel::Direction;
using kernel::Point;
using kernel::Sign;

/// A tetra-cone: the closed region between three rays from the common origin V0 (JS08 Definition 3). Its rays run
/// through points of the tree's lattice of directions, which are exact in every kernel. It is positively oriented:
/// det[V1, V2, V3] > 0.
///
/// Departure from the paper: the corners of the octants are at distance lattice_size * step, not 1, and V0 is the
/// model's origin. So no vertex is translated, and nothing is rounded.
struct Tetra_cone {
  std::array<Direction, 3> ray;  ///< V1, V2, V3

  /// Returns octant `k` (bit 0: x < 0, bit 1: y < 0, bit 2: z < 0). For k = 0, V1, V2, V3 are on z, x and y (JS08 Fig.
  /// 4).
  static Tetra_cone octant(int k)
  {
    const auto sign = [k](int axis) { return (k >> axis) & 1 ? -kernel::lattice_size : kernel::lattice_size; };
    const Direction x{sign(0), 0, 0}, y{0, sign(1), 0}, z{0, 0, sign(2)};
    const bool reflected = ((k ^ (k >> 1) ^ (k >> 2)) & 1) != 0;
    return reflected ? Tetra_cone{z, y, x} : Tetra_cone{z, x, y};
  }

  /// Returns child `k` of four, by the midpoints of the three edges (JS08 Definition 4): 0, 1, 2 keep V1, V2, V3; 3 is
  /// the middle one.
  Tetra_cone child(int k) const
  {
    const auto middle = [](const Direction& a, const Direction& b) {
      assert((a[0] + b[0]) % 2 == 0 && (a[1] + b[1]) % 2 == 0 && (a[2] + b[2]) % 2 == 0);
      return Direction{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    };
    const Direction m12 = middle(ray[0], ray[1]), m23 = middle(ray[1], ray[2]), m31 = middle(ray[2], ray[0]);
    switch (k) {
      case 0: return {ray[0], m12, m31};
      case 1: return {m12, ray[1], m23};
      case 2: return {m31, m23, ray[2]};
      default: return {m12, m23, m31};
    }
  }
};

/// A tetra-cone as points of K, in the body's coordinates or placed.
template <class K>
struct Cone_points {
  Point<K> v0, v1, v2, v3;

  Cone_points(const kernel::Cone_lattice& lattice, const Tetra_cone& cone)
      : v0(kernel::point<K>(lattice.origin)),
        v1(kernel::point<K>(lattice.point(cone.ray[0]))),
        v2(kernel::point<K>(lattice.point(cone.ray[1]))),
        v3(kernel::point<K>(lattice.point(cone.ray[2])))
  {}

  template <class Frame>
  Cone_points placed(const Frame& frame) const
  {
    Cone_points result = *this;
    result.v0 = frame(v0);
    result.v1 = frame(v1);
    result.v2 = frame(v2);
    result.v3 = frame(v3);
    return result;
  }
};

}  // namespace tetracone::tetratree

#endif
