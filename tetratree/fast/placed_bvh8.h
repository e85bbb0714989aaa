#ifndef TETRACONE_TETRATREE_FAST_PLACED_BVH8_H
#define TETRACONE_TETRATREE_FAST_PLACED_BVH8_H

#include "tetracone/covering/model.h"
#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/predicate/triangle_triangle.h"
#include "tetracone/tetratree/fast/bvh8.h"

#include <cmath>

namespace tetracone::tetratree {

/// A `Bvh8` under a pose, as a query uses it. A box is lane k of node n, 8 n + k.
struct Placed_bvh8 {
  using Adaptive = kernel::Adaptive;
  using Point = kernel::Point<Adaptive>;
  using Box = Index;

  const Bvh8* tree;
  covering::Placed_model<Adaptive> placed;
  kernel::Box_map into_other;  ///< from this body's local units to the other's

  explicit Placed_bvh8(const Bvh8& t) : tree(&t), placed(t.model()) {}

  const Element& element(Box box) const { return tree->element(box / 8, int(box % 8)); }

  /// The sum of the extents of the root's box, negative where it is a leaf.
  float size() const
  {
    const auto& extent = tree->node(0).boxes.extent;
    const float size = extent[0][0] + extent[1][0] + extent[2][0];
    return tree->is_leaf(0, 0) ? -size : size;
  }

  kernel::Corners<Adaptive> corners(const Element& element)
  {
    return {&placed.point(element.corner[0]), &placed.point(element.corner[1]), &placed.point(element.corner[2])};
  }
};

}  // namespace tetracone::tetratree

#endif
