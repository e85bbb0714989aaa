#ifndef TETRACONE_TETRATREE_FAST_BVH8_COLLISION_H
#define TETRACONE_TETRATREE_FAST_BVH8_COLLISION_H

#include "tetracone/kernel/predicate/question.h"
#include "tetracone/kernel/predicate/segment_face.h"
#include "tetracone/kernel/predicate/triangle_triangle.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/fast/bvh8_containment.h"
#include "tetracone/tetratree/fast/bvh8_descent.h"
#include "tetracone/tetratree/fast/placed_bvh8.h"
#include "tetracone/tetratree/fast/separating_direction.h"
#include "tetracone/tetratree/query_statistics.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace tetracone::tetratree {

using kernel::Pose;
using kernel::Question;
using kernel::Relation;

/// What a query object keeps from one pose to the next.
enum class Coherence {
  none,
  last_frame  ///< the direction that separated the bodies, and the pair of elements that met: tried first in the next
              ///< pose
};

/// Collision detection between two `Bvh8` over kernel K. Build once, ask for many poses.
///
/// Stages, each of which may end a query: a plane between the bodies (`Separating_direction`); the descent of pairs of
/// boxes, the larger one first, its eight parts against the other box, carried into their frame with a slack that
/// covers all rounding and the pose's; pairs of elements, which the signs of K decide. So the answer is that of all
/// elements against all elements, exact where these signs are. Of solids whose surfaces share no point,
/// `Bvh8_containment` tells whether one holds the other.
///
/// Both trees, and their models, must outlive the query object. Making it and every query throw
/// kernel::Unsound_floating_point when floating point is not as exact answers need it.
template <class K = kernel::Adaptive>
class Bvh8_collision {
 public:
  Bvh8_collision(const Bvh8& a, const Bvh8& b,
                 Coherence coherence = Coherence::none) requires std::is_same_v<K, kernel::Adaptive>
      : Bvh8_collision(a, a.model(), b, b.model(), coherence)
  {}

  /// `model_a`, `model_b`: of the trees' polyhedra.
  Bvh8_collision(const Bvh8& a, const covering::Model<K>& model_a, const Bvh8& b, const covering::Model<K>& model_b,
                 Coherence coherence = Coherence::none)
      : a_(a, model_a), b_(b, model_b), separating_direction_(a, b), coherence_(coherence)
  {
    kernel::require_exact_arithmetic();
  }

  /// Whether the two placed polyhedra collide. Requires det M != 0 of both poses, and closed polyhedra for
  /// `Question::solid`.
  bool operator()(const Pose& pose_a, const Pose& pose_b, Question question = Question::solid)
  {
    return relation(pose_a, pose_b, question) != Relation::apart;
  }

  /// How they stand to one another. Requires the same.
  Relation relation(const Pose& pose_a, const Pose& pose_b, Question question = Question::solid)
  {
    kernel::require_sound_floating_point();
    ++counts_.queries;
    if (a_.tree->empty() || b_.tree->empty() ||
        separating_direction_(pose_a, pose_b, 6, coherence_ == Coherence::last_frame))
      return Relation::apart;
    return ask_trees(pose_a, pose_b, question);
  }

  /// Calls leaf_test(element of A, element of B) for the pairs that the query does not discard, until one returns true:
  /// the descent alone, with a leaf test of the caller's. Returns whether one did.
  template <class Leaf_test>
  bool any_element_pair(const Pose& pose_a, const Pose& pose_b, const Leaf_test& leaf_test)
  {
    kernel::require_sound_floating_point();
    ++counts_.queries;
    if (a_.tree->empty() || b_.tree->empty() || separating_direction_(pose_a, pose_b, 6, false)) return false;
    pose_a_ = &pose_a;
    pose_b_ = &pose_b;
    is_placed_ = false;
    relate_frames();
    return descend_trees([&](Box box_a, Box box_b) { return any_pair(box_a, box_b, leaf_test); });
  }

  /// The bodies at the poses that were asked last. Requires that the poses are still there.
  covering::Placed_model<K>& placed_a()
  {
    place();
    return a_.placed;
  }
  covering::Placed_model<K>& placed_b()
  {
    place();
    return b_.placed;
  }

  /// After `apart`: how far from one another the placed bodies were at least, by the plane between them; 0 where none
  /// was found.
  double certified_gap() const { return separating_direction_.gap(); }

  const Query_statistics& counts() const { return counts_; }
  void clear_counts() { counts_ = {}; }

  /// Of the tables of reach; the trees have their own.
  std::size_t bytes() const { return separating_direction_.bytes(); }

 private:
  using Point = kernel::Point<K>;
  using Face = covering::Placed_face<K>;
  using Placed = Placed_bvh8<K>;
  using Box = typename Placed::Box;

  /// What no plane has decided.
  [[gnu::noinline]] Relation ask_trees(const Pose& pose_a, const Pose& pose_b, Question question)
  {
    const std::uint64_t fallbacks = exact_fallbacks();
    pose_a_ = &pose_a;
    pose_b_ = &pose_b;
    is_placed_ = false;
    const Relation answer = relation_of_trees(question);
    counts_.exact_fallbacks += exact_fallbacks() - fallbacks;
    return answer;
  }

  /// Of this thread, as far as K counts them.
  static std::uint64_t exact_fallbacks()
  {
    if constexpr (std::is_same_v<K, kernel::Adaptive>) return K::exact_fallbacks();
    return 0;
  }

  Relation relation_of_trees(Question question)
  {
    if (witness_ && leaves_meet(witness_->first, witness_->second)) return Relation::surfaces;
    relate_frames();
    witness_.reset();
    const bool surfaces_meet = descend_trees([this](Box box_a, Box box_b) {
      const bool meet = leaves_meet(box_a, box_b);
      if (meet && coherence_ == Coherence::last_frame) witness_ = {box_a, box_b};
      return meet;
    });
    if (surfaces_meet) return Relation::surfaces;
    if (question == Question::surface) return Relation::apart;
    place();
    return containment_(a_, b_, counts_)   ? Relation::b_in_a
           : containment_(b_, a_, counts_) ? Relation::a_in_b
                                           : Relation::apart;
  }

  void relate_frames()
  {
    const Pose &pose_a = *pose_a_, &pose_b = *pose_b_;
    const kernel::Local_scale &in_a = a_.tree->scale(), &in_b = b_.tree->scale();
    const kernel::Origin_offset between(pose_a, in_a, pose_b, in_b);
    // In place: a copy would stall on store forwarding.
    std::construct_at(&a_.into_other, pose_b, in_b, pose_a, in_a, -between);
    std::construct_at(&b_.into_other, pose_a, in_a, pose_b, in_b, between);
  }

  void place()
  {
    if (is_placed_) return;
    a_.placed.place(*pose_a_);
    b_.placed.place(*pose_b_);
    is_placed_ = true;
  }

  /// Whether meet(element of A, element of B) holds for some pair of elements of the two leaves.
  template <class Meet>
  bool any_pair(Box box_a, Box box_b, const Meet& meet)
  {
    for (Index i = 0; i < a_.leaf_count(box_a); ++i)
      for (Index j = 0; j < b_.leaf_count(box_b); ++j)
        if (meet(a_.element(box_a, i), b_.element(box_b, j))) return true;
    return false;
  }
  bool leaves_meet(Box box_a, Box box_b)
  {
    return any_pair(box_a, box_b, [this](const Element& a, const Element& b) { return elements_meet(a, b); });
  }

  /// Whether leaf_pair(box of A, box of B) holds for some pair of leaves that is not discarded.
  template <class Leaf_pair>
  bool descend_trees(const Leaf_pair& leaf_pair)
  {
    // Of a similarity it is between these. Else sizes tell no more than which box to open; but none may become 0 or
    // undefined.
    const double factor = a_.into_other.frame().scale();
    const float scale = factor >= 0x1p-60 && factor <= 0x1p60 ? float(factor) : 1;
    stack_.clear();
    stack_.push(0, 0, a_.size() * scale, b_.size());
    Both_trees trees{{a_.tree->nodes(), b_.tree->nodes()}, {&a_.into_other, &b_.into_other}, scale};
    bool meet = false;
    for (Stop stop; !meet && (stop = descend(stack_, trees)) != Stop::nothing_left;) {
      const Box box_a = stack_.box(0), box_b = stack_.box(1);
      if (stop == Stop::leaves) {
        stack_.pop();
        meet = leaf_pair(box_a, box_b);
      } else {
        const int larger = first_is_larger(stack_.size(0), stack_.size(1)) ? 0 : 1;
        const Bvh8& tree = *(larger == 0 ? a_ : b_).tree;
        const Box box = larger == 0 ? box_a : box_b;
        tree.child(box / 8, int(box % 8));
      }
    }
    counts_.pairs_visited += trees.opened;
    counts_.box_tests += trees.compared;
    return meet;
  }

  bool elements_meet(const Element& a, const Element& b)
  {
    place();
    ++counts_.leaf_pairs;
    if (a.is_whole_face() || b.is_whole_face()) return edges_meet(a_, a, b_, b) || edges_meet(b_, b, a_, a);
    ++counts_.triangle_tests;
    return kernel::triangles_meet<K>(a_.corners(a), b_.corners(b));
  }

  /// The edges of an element against one, of which either is a whole face.
  bool edges_meet(Placed& body, const Element& with_edges, Placed& other, const Element& face)
  {
    const auto meets = [&](const Point& p, const Point& q) {
      ++counts_.edge_face_tests;
      if (face.is_whole_face())
        return kernel::segment_face<K>(p, q, Face(other.placed, face.face)) != kernel::Contact::none;
      const auto t = other.corners(face);
      return kernel::segment_face<K>(p, q, kernel::Triangle<K>{*t[0], *t[1], *t[2]}) != kernel::Contact::none;
    };
    if (with_edges.is_whole_face()) {
      const Face edges(body.placed, with_edges.face);
      for (std::size_t k = 0; k < edges.edge_count(); ++k)
        if (meets(edges.from(k), edges.to(k))) return true;
      return false;
    }
    const auto p = body.corners(with_edges);
    return meets(*p[0], *p[1]) || meets(*p[1], *p[2]) || meets(*p[2], *p[0]);
  }

  Placed a_, b_;
  Separating_direction separating_direction_;
  Bvh8_containment<K> containment_;
  Pair_stack stack_;
  Query_statistics counts_;
  Coherence coherence_;

  const Pose* pose_a_ = nullptr;
  const Pose* pose_b_ = nullptr;
  bool is_placed_ = false;                      // at these
  std::optional<std::pair<Box, Box>> witness_;  // elements that met in the last pose
};

}  // namespace tetracone::tetratree

#endif
