#ifndef TETRACONE_TETRATREE_PAPER_REGULAR_HULL_H
#define TETRACONE_TETRATREE_PAPER_REGULAR_HULL_H

#include "tetracone/kernel/bound/bounds.h"
#include "tetracone/kernel/bound/cone_lattice.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/paper/tetra_cone.h"

#include <array>
#include <cmath>

namespace tetracone::tetratree {

/// Returns the tetra-cone of level `level` (octants are level 1) that holds a direction, by its coordinates along the
/// rays. Coordinates are rounded: near a border it may return the neighbour, which every use here allows.
template <class B>
Tetra_cone cone_towards(const kernel::Bound_point<B>& direction, int level)
{
  const int octant = (direction[0] < 0) + 2 * (direction[1] < 0) + 4 * (direction[2] < 0);
  Tetra_cone cone = Tetra_cone::octant(octant);
  std::array<B, 3> c;
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (cone.ray[i][axis] != 0) c[i] = std::abs(direction[axis]);
  for (; level > 1; --level) {
    const B half = (c[0] + c[1] + c[2]) / 2;
    const int corner = c[0] >= half ? 0 : c[1] >= half ? 1 : c[2] >= half ? 2 : 3;
    cone = cone.child(corner);
    switch (corner) {
      case 0: c = {c[0] - c[1] - c[2], 2 * c[1], 2 * c[2]}; break;
      case 1: c = {2 * c[0], c[1] - c[0] - c[2], 2 * c[2]}; break;
      case 2: c = {2 * c[0], 2 * c[1], c[2] - c[0] - c[1]}; break;
      default: c = {c[0] + c[1] - c[2], c[1] + c[2] - c[0], c[2] + c[0] - c[1]};
    }
  }
  return cone;
}

/// The regular hull of a polyhedron (JS08 Definition 7). It has the triangle V''1 V''2 V''3 of each cone of a level,
/// with every vertex at distance dmax from V0 on its ray. It holds all bounding tetrahedra. So the polyhedron lies in
/// the half-space of each triangle, which Theorem 2 uses.
///
/// Sound form. The hull is convex for every full level that is used here (levels 1 to `deepest_convex_level`, proved by
/// intervals in its test). Leaves lie at different depths, so dmax is the longest edge over *all* leaves, and the level
/// is that of the deepest leaf. The rays of shallower cones are rays of that level too. Hence every V'i is on a segment
/// from V0 to a vertex of the hull. The paper's own words, "the bounding tetrahedra associated to a level", hold only
/// where all leaves are at that level. The leaves may be unknown (nodes on demand), or the level deeper than
/// `deepest_convex_level`. Then the plane touches the sphere about V0 that holds all vertices.
template <class B, bool sound>
class Regular_hull {
 public:
  static constexpr int deepest_convex_level = 8;

  /// Upper bound of the plane's displacement by the rounded normal, relative to its distance. At these levels the edges
  /// of the unit vectors have lengths of about 2^-level, and are rounded by 2^-52. Proved in
  /// verify/proofs/margin_proofs.h.
  static constexpr double normal_rounding = 0x1p-42;

  Regular_hull() = default;

  /// `longest_edge` is dmax, or negative if unknown; `radius` is an upper bound of the distance of all vertices from
  /// V0.
  Regular_hull(const kernel::Bound_point<B>& origin, int level, B longest_edge, B radius)
      : origin_(origin), level_(kernel::maximum(level, 1)), longest_edge_(longest_edge), radius_(radius)
  {}

  /// Returns the half-space of the reference bounding tetrahedron (Definition 8). It is bounded by the plane of the
  /// hull's triangle whose cone holds `direction`.
  kernel::Half_space<B> towards(const kernel::Bound_point<B>& direction) const
  {
    const Tetra_cone cone = cone_towards(direction, level_);
    std::array<kernel::Bound_point<B>, 3> unit;
    for (int i = 0; i < 3; ++i) {
      const kernel::Bound_point<B> ray = {B(cone.ray[i][0]), B(cone.ray[i][1]), B(cone.ray[i][2])};
      const B length = std::sqrt(kernel::squared_length(ray));
      unit[i] = {ray[0] / length, ray[1] / length, ray[2] / length};
    }
    const kernel::Bound_point<B> normal =
        kernel::cross(kernel::difference(unit[1], unit[0]), kernel::difference(unit[2], unit[0]));
    const bool by_hull = longest_edge_ >= 0 && level_ <= deepest_convex_level;
    B offset =
        by_hull ? kernel::dot(normal, unit[0]) * longest_edge_ : std::sqrt(kernel::squared_length(normal)) * radius_;
    if constexpr (sound) offset *= B(1 + normal_rounding);
    return {normal, origin_, offset};
  }

 private:
  kernel::Bound_point<B> origin_{};
  int level_ = 1;
  B longest_edge_ = -1, radius_ = 0;
};

}  // namespace tetracone::tetratree

#endif
