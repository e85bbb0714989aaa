#ifndef TETRACONE_TETRATREE_QUERY_PLACED_BVH8_H
#define TETRACONE_TETRATREE_QUERY_PLACED_BVH8_H

#include "tetracone/covering/model.h"
#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/predicate/triangle_triangle.h"
#include "tetracone/tetratree/fast/bvh8.h"

#include <type_traits>

namespace tetracone::tetratree {

/// A `Bvh8` under a pose, for a query over kernel K. The owner places `placed` and sets `into_other`. Tree and model
/// must outlive this object.
template <class K = kernel::Adaptive>
struct Placed_bvh8 {
  const Bvh8* tree;
  covering::Placed_model<K> placed;
  kernel::Box_map into_other;  ///< from this body's local units to the other's

  explicit Placed_bvh8(const Bvh8& t) requires std::is_same_v<K, kernel::Adaptive> : Placed_bvh8(t, t.model()) {}
  /// `model` belongs to the tree's polyhedron.
  Placed_bvh8(const Bvh8& t, const covering::Model<K>& model) : tree(&t), placed(model) {}

  /// Returns element k of a leaf.
  const Element& element(Box_id box, Index k = 0) const { return tree->element(box, k); }
  Index leaf_count(Box_id box) const { return tree->leaf_count(box); }

  /// Returns `Bvh8_node::signed_size` of the root's box: negative for a leaf.
  float size() const { return tree->node(0).signed_size(0); }

  /// Returns the corners of a triangle, as `placed.place` placed them last. They are valid until it is called again.
  /// Requires an element that is no whole face.
  kernel::Corners<K> corners(const Element& element)
  {
    return {&placed.point(element.corner[0]), &placed.point(element.corner[1]), &placed.point(element.corner[2])};
  }
};

}  // namespace tetracone::tetratree

#endif
