#ifndef TETRACONE_TETRATREE_PAPER_PLACED_TREE_H
#define TETRACONE_TETRATREE_PAPER_PLACED_TREE_H

#include "tetracone/covering/inclusion.h"
#include "tetracone/covering/model.h"
#include "tetracone/kernel/bound/bounds.h"
#include "tetracone/tetratree/paper/tetra_tree.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tetracone::tetratree {

/// A tetra-tree under a pose, one body of a query. Vertices and boxes are placed on first use, once per pose.
template <class K>
class Placed_tree {
 public:
  using B = typename Tetra_tree<K>::B;
  static constexpr bool sound = Tetra_tree<K>::sound;

  explicit Placed_tree(Tetra_tree<K>& tree)
      : tree_(tree),
        body_(tree.model()),
        hull_(tree.regular_hull()),
        coordinates_(tree.model().vertices().size()),
        placed_at_(coordinates_.size(), 0),
        face_box_(tree.model().face_count()),
        boxed_at_(face_box_.size(), 0)
  {}

  /// Moves the body. `pose` must outlive all use of this until the next call.
  void place(const kernel::Pose& pose)
  {
    body_.place(pose);
    frame_ = kernel::Bound_frame<B, sound>(pose, tree_.reach());
    ++now_;
  }

  Tetra_tree<K>& tree() { return tree_; }
  covering::Placed_model<K>& body() { return body_; }
  const kernel::Bound_frame<B, sound>& frame() const { return frame_; }

  kernel::Bound_point<B> origin() const { return frame_(tree_.origin()); }

  kernel::Ball<B> sphere(const Node<B>& node) const { return kernel::placed(frame_, node.sphere); }

  kernel::Bound_tetrahedron<B> tetrahedron(const Node<B>& node) const
  {
    const auto& t = node.tetrahedron;
    return {frame_(t[0]), frame_(t[1]), frame_(t[2]), frame_(t[3])};
  }

  kernel::Bound_box<B> box(Index n) const
  {
    kernel::Bound_box<B> placed = tree_.box(n);
    for (auto& corner : placed) corner = frame_(corner);
    return placed;
  }

  /// Returns the placed half-space of the hull's triangle that faces `point` (JS08 Definition 8).
  kernel::Placed_half_space<B, sound> reference(const kernel::Bound_point<B>& point) const
  {
    auto direction = frame_.pulled_back(kernel::difference(point, origin()));
    if (body_.determinant_sign() == kernel::NEGATIVE)
      for (B& coordinate : direction) coordinate = -coordinate;
    return {frame_, hull_.towards(direction), body_.determinant_sign()};
  }

  /// Returns a box about a placed edge.
  kernel::Box<B> edge_box(Index edge)
  {
    kernel::Box<B> box;
    for (const Index v : tree_.model().covering().edges()[edge]) box.add(coordinates(v));
    box.grow(frame_.error());
    return box;
  }

  /// Returns a box about a placed face.
  const kernel::Box<B>& face_box(Index face)
  {
    if (boxed_at_[face] != now_) {
      kernel::Box<B> box;
      for (const Index v : tree_.model().covering().from(face)) box.add(coordinates(v));
      box.grow(frame_.error());
      face_box_[face] = box;
      boxed_at_[face] = now_;
    }
    return face_box_[face];
  }

  /// True when the placed solid holds p. Requires p on no face, and a closed polyhedron.
  bool contains(const kernel::Point<K>& p)
  {
    const auto leaf = leaf_of(p);
    return leaf && winding_number(p, *leaf) != 0;
  }

  /// Returns the location of p with regard to the placed solid. Requires a closed polyhedron.
  covering::Location locate(const kernel::Point<K>& p)
  {
    const auto leaf = leaf_of(p);
    if (!leaf) return covering::Location::outside;
    // The closed cone of the leaf holds p itself too, so every face through p is classified in it.
    for (const Index face : tree_.faces(tree_.node(*leaf)))
      if (covering::segment_face<K>(p, p, body_, face) != kernel::Contact::none) return covering::Location::on_surface;
    return winding_number(p, *leaf) != 0 ? covering::Location::inside : covering::Location::outside;
  }

 private:
  // Returns the one leaf whose tetra-cone holds p moved by (e, e^2, e^3), which lies on no border of a cone. Returns
  // nothing if no tetrahedron meets that cone. Makes nodes as it descends.
  std::optional<Index> leaf_of(const kernel::Point<K>& p)
  {
    Index n = Tetra_tree<K>::root();
    while (!tree_.node(n).is_leaf) {
      const Node<B> parent = tree_.with_children(n);
      Index holder = covering::none;
      for (Index c = parent.first_child; c < parent.first_child + parent.child_count && holder == covering::none; ++c)
        if (cone_holds(tree_.node(c).cone, p)) holder = c;
      if (holder == covering::none) return std::nullopt;
      n = holder;
    }
    return n;
  }

  // Returns the winding number about p moved by (e, e^2, e^3). It is the signed sum over the tetrahedra of the leaf: no
  // others can hold p (JS08 section 2.2).
  int winding_number(const kernel::Point<K>& p, Index leaf)
  {
    const auto& triangles = tree_.model().covering().triangles();
    const kernel::Point<K> origin = body_.frame()(tree_.model().origin());
    int winding = 0;
    for (const Index element : tree_.elements(tree_.node(leaf))) {
      const auto& corner = triangles[element].corner;
      winding += covering::signed_inclusion<K>(p, origin, body_.point(corner[0]), body_.point(corner[1]),
                                               body_.point(corner[2]));
    }
    return winding;
  }

  bool cone_holds(const Tetra_cone& cone, const kernel::Point<K>& p) const
  {
    const Cone_points<K> c = Cone_points<K>(tree_.model().lattice(), cone).placed(body_.frame());
    const kernel::Sign inside = body_.determinant_sign();
    return kernel::perturbed_side<K>(c.v0, c.v1, c.v2, p) == inside &&
           kernel::perturbed_side<K>(c.v0, c.v2, c.v3, p) == inside &&
           kernel::perturbed_side<K>(c.v0, c.v3, c.v1, p) == inside;
  }

  const kernel::Bound_point<B>& coordinates(Index v)
  {
    if (placed_at_[v] != now_) {
      coordinates_[v] = frame_(kernel::bound_point<B>(tree_.model().vertices()[v]));
      placed_at_[v] = now_;
    }
    return coordinates_[v];
  }

  Tetra_tree<K>& tree_;
  covering::Placed_model<K> body_;
  Regular_hull<B, sound> hull_;
  kernel::Bound_frame<B, sound> frame_;
  std::uint64_t now_ = 0;
  std::vector<kernel::Bound_point<B>> coordinates_;
  std::vector<std::uint64_t> placed_at_;
  std::vector<kernel::Box<B>> face_box_;
  std::vector<std::uint64_t> boxed_at_;
};

}  // namespace tetracone::tetratree

#endif
