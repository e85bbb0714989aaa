#ifndef TETRACONE_TETRATREE_FAST_BVH8_H
#define TETRACONE_TETRATREE_FAST_BVH8_H

#include "tetracone/kernel/number/floating_point.h"
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

/// The fast tree: eight boxes a node, one element a leaf, which any kernel decides (`Bvh8_options` has other choices).
///
/// It keeps of JS08 the covering and its origin, the pairwise descent of two trees and, as `Support_table`, the idea of
/// the regular hull on the lattice of tetra-cones. It is no tetra-tree:
///  - an element is in one part, not in every cone that it meets: nothing is tested twice;
///  - parts come of cuts by cost, across the direction in which elements spread most; among the cuts tried are planes
///    through the origin, the sides of cones, which part layers of the surface that lie behind one another;
///  - the bounding volume is an oriented box, which is tight on a patch of surface where a tetrahedron from the origin
///    is not;
///  - nodes have eight parts, so that one box is compared with eight at once, in float, rounded outward.
/// Faces are triangles, or are given as triangles with the polyhedron; others are leaves as a whole.
///
/// A node's children are made when a query first enters it, or all at once by `make_all`. Any number of threads may ask
/// the tree while they are: a node is made under a lock and then published by its parent, so that the way down takes
/// none.
class Bvh8 {
 public:
  /// `triangles`: for each face that has some, triangles that cover exactly the face. Requires planar faces. The
  /// same by any `both`.
  explicit Bvh8(const covering::Polyhedron& polyhedron, std::span<const Face_triangle> triangles = {},
                const Bvh8_options& options = {}, const covering::Both& both = {})
      : elements_(polyhedron, triangles, both),
        builder_(std::in_place, elements_, options, leaf_ends_, both),
        nodes_(elements_.count())
  {
    // Of every node but the root at least two elements come apart: there are no more nodes than elements.
    if (!empty()) nodes_.push_back(builder_->root(both));
  }

  /// A tree that was made before: its elements in the order of its leaves, and its nodes as `nodes_in_order` had them.
  Bvh8(Bvh8_elements elements, Reserved_array<Bvh8_node> nodes)
      : elements_(std::move(elements)), nodes_(std::move(nodes))
  {}

  Bvh8(const Bvh8&) = delete;

  const covering::Model<kernel::Adaptive>& model() const { return elements_.model(); }
  const kernel::Local_scale& scale() const { return elements_.scale(); }
  bool empty() const { return elements_.count() == 0; }

  kernel::Vector local(Index v) const { return elements_.local(v); }

  /// What its support tables have found.
  const Known_reaches& known_reaches() const { return known_reaches_; }

  const Bvh8_node* nodes() const { return nodes_.data(); }
  const Bvh8_node& node(Index n) const { return nodes_.data()[n]; }

  /// The node of lane `lane` of node `n`, made now if it has to be. Requires a lane of more than one element.
  Index child(Index n, int lane) const
  {
    Bvh8_node& parent = nodes_.data()[n];
    if (const auto known = parent.child_of(lane); known >= 0) return Index(known);
    const std::lock_guard lock(making_);
    if (const auto known = parent.child_of(lane); known >= 0) return Index(known);
    const Index made = builder_->make(parent.first[lane], Bvh8_node::last_of(parent.child[lane]), nodes_);
    parent.publish(lane, made);
    return made;
  }

  /// Asks the memory for a node before it is needed: trees are larger than the caches.
  void prefetch(Index n) const
  {
    const char* const bytes = reinterpret_cast<const char*>(&node(n));
    for (std::size_t k = 0; k < sizeof(Bvh8_node); k += 64) __builtin_prefetch(bytes + k);
  }

  bool is_leaf(Index n, int lane) const { return node(n).is_leaf(lane); }
  /// Element k of a leaf, and how many it holds: one, where the options don't say more.
  const Element& element(Index n, int lane, Index k = 0) const { return elements_[node(n).first[lane] + k]; }
  Index leaf_count(Index n, int lane) const
  {
    if (leaf_ends_.empty()) [[likely]]
      return 1;
    const Index first = node(n).first[lane];
    return leaf_ends_[first] - first;
  }

  /// Calls what(v) for every corner v of the element.
  template <class What>
  void for_vertices(const Element& element, const What& what) const
  {
    elements_.for_vertices(element, what);
  }

  /// Makes every node, and gives back what only the making needs.
  void make_all() const
  {
    make_all([](const auto& work) { work(); });
  }

  /// The same, by `run(work)`, which calls work() from one thread or more at once and returns when all calls have. The
  /// tree is the same whatever their number is. Queries that lack a node wait until all are there: none may be asked by
  /// a thread that is within `run`. What one thread would have most of is made by `both`.
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

  /// All nodes, each before those below it and these in the order of lanes: the same bytes in whatever order they were
  /// made. Requires `make_all`.
  std::vector<Bvh8_node> nodes_in_order() const
  {
    std::vector<Bvh8_node> ordered;
    ordered.reserve(node_count());
    if (node_count() > 0) append_in_order(0, ordered);
    return ordered;
  }

  /// All elements, in the order of leaves. Requires `make_all`.
  const Bvh8_elements& elements() const { return elements_; }

  /// The cuts by which the nodes that there are were made here.
  Cut_counts cuts() const
  {
    const std::lock_guard lock(making_);
    return builder_ ? builder_->cuts() : cuts_;
  }

  std::size_t node_count() const { return nodes_.size(); }
  std::size_t element_count() const { return elements_.count(); }

  /// Without the model.
  std::size_t bytes() const
  {
    const std::lock_guard lock(making_);
    return node_bytes() + elements_.bytes() + known_reaches_.bytes() + leaf_ends_.capacity() * sizeof(Index) +
           (builder_ ? builder_->bytes() : 0);
  }

  /// Of the nodes alone, which are no part of the heap.
  std::size_t node_bytes() const { return nodes_.size() * sizeof(Bvh8_node); }

 private:
  Index append_in_order(Index n, std::vector<Bvh8_node>& ordered) const
  {
    const auto number = Index(ordered.size());
    ordered.push_back(node(n).without_padding());
    for (int lane = 0; lane < node(n).boxes.lane_count; ++lane)
      if (!is_leaf(n, lane)) {
        const Index below = append_in_order(child(n, lane), ordered);
        ordered[number].child[std::size_t(lane)] = std::int32_t(below);
      }
    return number;
  }

  mutable std::mutex making_;
  mutable Bvh8_elements elements_;  // a leaf's are in their place before the leaf can be seen
  mutable std::vector<Index> leaf_ends_;
  mutable Cut_counts cuts_;  // of a builder that is gone
  mutable std::optional<Bvh8_builder> builder_;
  mutable Reserved_array<Bvh8_node> nodes_;
  Known_reaches known_reaches_;
};

}  // namespace tetracone::tetratree

#endif
