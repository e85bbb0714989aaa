#ifndef TETRACONE_TETRATREE_QUERY_BVH8_SELF_CONTACTS_H
#define TETRACONE_TETRATREE_QUERY_BVH8_SELF_CONTACTS_H

#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/bound/origin_offset.h"
#include "tetracone/tetratree/contact/face_pairs.h"
#include "tetracone/tetratree/contact/self_pairs.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/fast/bvh8_descent.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Pairs of faces of one body that intersect improperly (`Self_pairs`), exactly, by the fast tree against itself.
///
/// Two different lanes of a node hold each pair of elements once. Such lanes are descended as two bodies would be.
/// Signs of corners decide nearly all pairs of faces, which are neighbours. Exact contacts decide the others.
///
/// The tree must have one element a leaf, and must outlive this object. Sound floating point is required
/// (`kernel::require_sound_floating_point`).
class Bvh8_self_contacts {
 public:
  /// `polyhedron` is the tree's.
  Bvh8_self_contacts(const Bvh8& tree, const covering::Polyhedron& polyhedron)
      : tree_(tree), polyhedron_(polyhedron), pairs_(tree.model())
  {}

  /// True when no pair is improper. Pairs are settled in lots of about `at_once`; it stops after an improper lot.
  bool is_simple()
  {
    Found_contacts found;
    const auto settle_some = [&] {
      settle(found);
      return found.pieces.empty();
    };
    return for_nodes([&] { return uncertain_.size() < at_once || settle_some(); }) && settle_some();
  }

  /// Returns the pieces of the improper pairs that common vertices and edges do not hold. They are sorted by their
  /// faces, face_a < face_b.
  Found_contacts improper()
  {
    std::size_t limit = at_once;
    for_nodes([&] {
      if (uncertain_.size() < limit) return true;
      sort_uncertain();
      limit = 2 * uncertain_.size() + at_once;
      return true;
    });
    Found_contacts found;
    settle(found);
    return found;
  }

 private:
  static constexpr std::size_t at_once = 4096;  ///< pairs that are settled together; their exact faces are kept

  /// The exact contacts, made when a pair needs them.
  struct Exact_contacts {
    Contact_faces faces;
    Face_pairs<kernel::Adaptive> pairs;

    Exact_contacts(const covering::Polyhedron& polyhedron, const covering::Covering& covering)
        : faces(polyhedron, covering), pairs(faces, faces)
    {}
  };

  /// Visits all nodes; the pairs of faces that signs leave undecided are then in `uncertain_`. It returns false at once
  /// when go_on() does.
  template <class Go_on>
  bool for_nodes(const Go_on& go_on)
  {
    uncertain_.clear();
    if (tree_.empty()) return true;
    tree_.make_all();
    const kernel::Pose rest;
    const kernel::Local_scale& scale = tree_.scale();
    const kernel::Box_map map(rest, scale, rest, scale, kernel::Origin_offset(rest, scale, rest, scale));
    Both_trees trees{{tree_.nodes(), tree_.nodes()}, {&map, &map}, 1};
    std::vector<Index> open = {0};
    while (!open.empty()) {
      const Index n = open.back();
      open.pop_back();
      visit(n, trees);
      if (!go_on()) return false;
      const Bvh8_node& node = tree_.node(n);
      for (int lane = node.boxes.lane_count - 1; lane >= 0; --lane)
        if (!node.is_leaf(lane)) open.push_back(tree_.child({n, lane}));
    }
    return true;
  }

  /// Decides pairs of elements of different lanes of a node.
  void visit(Index n, Both_trees& trees)
  {
    const Bvh8_node& node = tree_.node(n);
    for (int lane = 0; lane < node.boxes.lane_count; ++lane) {
      const Box_id box(n, lane);
      assert(!node.is_leaf(lane) || tree_.leaf_count(box) == 1);
      const unsigned near = kernel::overlapping(node.boxes, *trees.into[0], node.boxes, lane);
      for (int other = lane + 1; other < node.boxes.lane_count; ++other) {
        if (!(near >> other & 1)) continue;
        if (node.is_leaf(lane) && node.is_leaf(other))
          leaves_.push_back({box, Box_id(n, other)});
        else
          stack_.push({box, Box_id(n, other)}, node.signed_size(lane), node.signed_size(other));
      }
    }
    const Stop stop = descend_to_leaves(stack_, next_level_, trees, leaves_);
    assert(stop == Stop::nothing_left);
    static_cast<void>(stop);
    for (const Box_ids& pair : leaves_)
      for (const Box_id box : pair) __builtin_prefetch(&tree_.element(box));
    for (const auto& [a, b] : leaves_) decide(tree_.element(a).face, tree_.element(b).face);
    leaves_.clear();
  }

  void decide(Index f, Index g)
  {
    if (f == g || pairs_.is_surely_proper(f, g)) return;
    uncertain_.push_back(std::uint64_t(kernel::minimum(f, g)) << 32 | kernel::maximum(f, g));
  }

  void sort_uncertain()
  {
    std::ranges::sort(uncertain_);
    uncertain_.erase(std::unique(uncertain_.begin(), uncertain_.end()), uncertain_.end());
  }

  /// Moves the improper pieces of the uncertain pairs to `found`.
  void settle(Found_contacts& found)
  {
    if (uncertain_.empty()) return;
    sort_uncertain();
    if (!exact_) exact_.emplace(polyhedron_, tree_.model().covering());
    const kernel::Pose rest;
    std::vector<Face_pair> some;
    for (std::size_t first = 0; first < uncertain_.size(); first += at_once) {
      const std::size_t count = kernel::minimum(at_once, uncertain_.size() - first);
      some.clear();
      for (const std::uint64_t pair : std::span(uncertain_).subspan(first, count))
        some.push_back(exact_->pairs.pair(Index(pair >> 32), Index(pair)));
      Found_contacts shared;
      covering::Placed_model<kernel::Adaptive> placed(tree_.model());  // anew: it keeps each point that was asked for
      placed.place(rest);
      exact_->pairs.begin();
      exact_->pairs.add_contacts(placed, rest, placed, rest, some, shared);
      for (const Found_piece& piece : shared.pieces) {
        if (!pairs_.is_improper(piece, shared)) continue;
        found.pieces.push_back(piece);
        if (piece.by_signs.count > 0) continue;
        found.pieces.back().kept = Index(found.kept.size());
        found.kept.push_back(std::move(shared.kept[piece.kept]));
      }
    }
    uncertain_.clear();
  }

  const Bvh8& tree_;
  const covering::Polyhedron& polyhedron_;
  Self_pairs pairs_;
  std::optional<Exact_contacts> exact_;
  Pair_stack stack_, next_level_;
  std::vector<Box_ids> leaves_;
  std::vector<std::uint64_t> uncertain_;  // pairs of faces: the smaller number in the high half
};

}  // namespace tetracone::tetratree

#endif
