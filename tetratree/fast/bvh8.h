#ifndef TETRACONE_TETRATREE_FAST_BVH8_H
#define TETRACONE_TETRATREE_FAST_BVH8_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/fast/box_id.h"
#include "tetracone/tetratree/fast/bvh8_builder.h"
#include "tetracone/tetratree/fast/bvh8_elements.h"
#include "tetracone/tetratree/fast/bvh8_node.h"
#include "tetracone/tetratree/fast/bvh8_options.h"
#include "tetracone/tetratree/fast/bvh8_subtrees.h"
#include "tetracone/tetratree/fast/known_reaches.h"
#include "tetracone/tetratree/fast/reserved_array.h"

#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// The fast tree: a hierarchy of oriented boxes with eight boxes per node and one element per leaf. Any kernel may
/// decide the elements; `Bvh8_options` has other choices of construction.
///
/// The tree takes three ideas from JS08: the covering and its origin, the pairwise descent of two trees, and the
/// regular hull. The hull, on the lattice of tetra-cones, is `Support_table`. The tree is no tetra-tree:
/// - An element is in one box, not in every cone that it meets, so no element is tested twice.
/// - Boxes come from cuts by cost (SAH), across the direction in which elements spread most, or along three axes where
///   they are few. Planes through the origin, the sides of cones, are among the cuts tried: they separate layers of the
///   surface that lie behind one another.
/// - The bounding volume is an oriented box, which is tight on a patch of surface. A tetrahedron from the origin is
///   not.
/// - A node has eight boxes, so that one box is compared with eight at once, in float, rounded outward.
///
/// Faces are triangles, or are given as triangles with the polyhedron; any other face is one leaf.
///
/// A query makes a node when it first enters it; `make_all` makes all at once. Any number of threads may query the tree
/// meanwhile. A node is made under a lock and then published by its parent, so that a descent takes no lock.
class Bvh8 {
 public:
  /// Makes the root. `triangles` cover exactly each face that has some. Requires planar faces. `both` may do two things
  /// at a time; the tree does not depend on it.
  explicit Bvh8(const covering::Polyhedron& polyhedron, std::span<const Face_triangle> triangles = {},
                const Bvh8_options& options = {}, const covering::Both& both = {})
      : elements_(polyhedron, triangles, both),
        builder_(std::in_place, elements_, options, leaf_ends_, both),
        nodes_(elements_.count())
  {
    // A node other than the root parts at least two elements, so there are no more nodes than elements.
    if (!empty()) nodes_.push_back(builder_->root(both));
  }

  /// Restores a tree of one element a leaf: its elements in the order of leaves, its nodes as by `nodes_in_order`.
  Bvh8(Bvh8_elements elements, Reserved_array<Bvh8_node> nodes)
      : elements_(std::move(elements)), nodes_(std::move(nodes))
  {}

  Bvh8(const Bvh8&) = delete;

  const covering::Model<kernel::Adaptive>& model() const { return elements_.model(); }
  const kernel::Local_scale& scale() const { return elements_.scale(); }
  bool empty() const { return elements_.count() == 0; }

  kernel::Vector local(Index v) const { return elements_.local(v); }

  /// Returns the support values that its support tables have found.
  const Known_reaches& known_reaches() const { return known_reaches_; }

  const Bvh8_node* nodes() const { return nodes_.data(); }
  const Bvh8_node& node(Index n) const { return nodes_.data()[n]; }
  const Bvh8_node& node_of(Box_id box) const { return node(box.node()); }

  /// Returns the node below a box, and makes it if necessary. Requires a box that is no leaf.
  Index child(Box_id box) const
  {
    Bvh8_node& parent = nodes_.data()[box.node()];
    const int lane = box.lane();
    if (const auto known = parent.child_of(lane); known >= 0) return Index(known);
    const std::lock_guard lock(making_);
    if (const auto known = parent.child_of(lane); known >= 0) return Index(known);
    const Index made = builder_->make(parent.first[lane], Bvh8_node::last_of(parent.child[lane]), nodes_);
    parent.publish(lane, made);
    return made;
  }

  /// Prefetches a node before it is needed: trees are larger than the caches.
  void prefetch(Index n) const
  {
    const char* const bytes = reinterpret_cast<const char*>(&node(n));
    for (std::size_t k = 0; k < sizeof(Bvh8_node); k += 64) __builtin_prefetch(bytes + k);
  }

  bool is_leaf(Box_id box) const { return node_of(box).is_leaf(box.lane()); }
  /// Returns element k of a leaf. A leaf holds one element, unless the options say more.
  const Element& element(Box_id box, Index k = 0) const { return elements_[node_of(box).first[box.lane()] + k]; }
  /// Returns the place of an element of a leaf in the order of leaves, which does not change.
  std::size_t number_of(const Element& element) const { return std::size_t(&element - &elements_[0]); }
  /// Returns the number of elements of a leaf.
  Index leaf_count(Box_id box) const
  {
    if (leaf_ends_.empty()) [[likely]]
      return 1;
    const Index first = node_of(box).first[box.lane()];
    return leaf_ends_[first] - first;
  }

  /// Calls what(v) for every corner v of the element.
  template <class What>
  void for_vertices(const Element& element, const What& what) const
  {
    elements_.for_vertices(element, what);
  }

  /// Makes every node, and frees what only the construction needs.
  void make_all() const
  {
    make_all([](const auto& work) { work(); });
  }

  /// Does the same by threads. `run(work)` calls work() from one thread or more at once, and returns when all calls
  /// have returned; the tree does not depend on their number. A query that lacks a node waits until all are there, so
  /// no query may run on a thread that is within `run`. `both` shares what would keep one longest.
  template <class Run>
  void make_all(const Run& run, const covering::Both& both = {}) const
  {
    kernel::require_sound_floating_point();
    const std::lock_guard lock(making_);
    if (!builder_) return;
    nodes_.expect(elements_.count() / (kernel::lanes - 1));
    Bvh8_subtrees(*builder_, nodes_).make(run, both);
    cuts_ = builder_->cuts();
    builder_.reset();
  }

  /// Returns all nodes, each before the nodes below it, and those in the order of lanes. The bytes do not depend on the
  /// order in which nodes were made. Requires `make_all`.
  std::vector<Bvh8_node> nodes_in_order() const
  {
    std::vector<Bvh8_node> ordered;
    ordered.reserve(node_count());
    if (node_count() > 0) append_in_order(0, ordered);
    return ordered;
  }

  /// Returns all elements, in the order of leaves. Requires `make_all`.
  const Bvh8_elements& elements() const { return elements_; }

  /// Returns the number of cuts that this object tried and made for its present nodes.
  Cut_counts cuts() const
  {
    const std::lock_guard lock(making_);
    return builder_ ? builder_->cuts() : cuts_;
  }

  std::size_t node_count() const { return nodes_.size(); }
  std::size_t element_count() const { return elements_.count(); }

  /// Returns the bytes held, except the model's.
  std::size_t bytes() const
  {
    const std::lock_guard lock(making_);
    return node_bytes() + elements_.bytes() + known_reaches_.bytes() + leaf_ends_.capacity() * sizeof(Index) +
           (builder_ ? builder_->bytes() : 0);
  }

  /// Returns the bytes of the nodes alone, which are not on the heap.
  std::size_t node_bytes() const { return nodes_.size() * sizeof(Bvh8_node); }

 private:
  Index append_in_order(Index n, std::vector<Bvh8_node>& ordered) const
  {
    const auto number = Index(ordered.size());
    ordered.push_back(node(n).without_padding());
    for (int lane = 0; lane < node(n).boxes.lane_count; ++lane)
      if (!is_leaf({n, lane})) {
        const Index below = append_in_order(child({n, lane}), ordered);
        ordered[number].child[std::size_t(lane)] = std::int32_t(below);
      }
    return number;
  }

  mutable std::mutex making_;
  mutable Bvh8_elements elements_;  // a leaf's elements are in place before the leaf can be seen
  mutable std::vector<Index> leaf_ends_;
  mutable Cut_counts cuts_;  // kept when the builder is gone
  mutable std::optional<Bvh8_builder> builder_;
  mutable Reserved_array<Bvh8_node> nodes_;
  Known_reaches known_reaches_;
};

}  // namespace tetracone::tetratree

#endif
