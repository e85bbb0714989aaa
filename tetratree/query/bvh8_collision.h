#ifndef TETRACONE_TETRATREE_QUERY_BVH8_COLLISION_H
#define TETRACONE_TETRATREE_QUERY_BVH8_COLLISION_H

#include "tetracone/kernel/predicate/kept_sides.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/kernel/predicate/segment_face.h"
#include "tetracone/kernel/predicate/triangle_triangle.h"
#include "tetracone/kernel/predicate/vertex_separation.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/fast/bvh8_descent.h"
#include "tetracone/tetratree/fast/separating_direction.h"
#include "tetracone/tetratree/memory/element_gap.h"
#include "tetracone/tetratree/memory/pair_memory.h"
#include "tetracone/tetratree/query/bvh8_containment.h"
#include "tetracone/tetratree/query/placed_bvh8.h"
#include "tetracone/tetratree/query/separating_face.h"
#include "tetracone/tetratree/query_statistics.h"

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace tetracone::tetratree {

using kernel::Pose;
using kernel::Question;
using kernel::Relation;

/// What a query object remembers from one pose to the next.
enum class Coherence {
  none,
  last_frame  ///< a `Pair_memory`: the next pose tries first the direction that separated the bodies and the pair of
              ///< leaves that met. Exact kernels also keep the front of the descent
};

/// Collision detection between two `Bvh8` over kernel K. Build once, ask for many poses.
///
/// A query has three stages, each of which may end it:
/// - a plane between the bodies (`Separating_direction`);
/// - the descent of pairs of boxes: the larger box is opened, and its eight parts are tested against the other box.
///   That box is carried into their frame with a slack that covers all rounding, the pose's included;
/// - pairs of elements, which the signs of K decide. If stages after the adaptive kernel's filter tell a pair apart,
///   `Separating_face` may find that the plane of one parts the bodies. `kernel::are_parted_by_vertices` may find
///   another plane. For bodies of few vertices that nearly touch, the search for the latter comes before the descent.
///
/// An exact kernel's answer equals testing all elements against all elements. A rounding kernel's may differ: planes
/// and boxes discard pairs that its signs would take to meet. For solids whose surfaces share no point,
/// `Bvh8_containment` decides whether one holds the other.
///
/// Both trees, and their models, must outlive the query object. The constructor and every query throw
/// kernel::Unsound_floating_point when floating point is not as exact answers need it.
template <class K = kernel::Adaptive>
class Bvh8_collision {
 public:
  /// A query over the trees' own kernel and models.
  Bvh8_collision(const Bvh8& a, const Bvh8& b,
                 Coherence coherence = Coherence::none) requires std::is_same_v<K, kernel::Adaptive>
      : Bvh8_collision(a, a.model(), b, b.model(), coherence)
  {}

  /// `model_a` and `model_b` are the models of the trees' polyhedra.
  Bvh8_collision(const Bvh8& a, const covering::Model<K>& model_a, const Bvh8& b, const covering::Model<K>& model_b,
                 Coherence coherence = Coherence::none)
      : a_(a, model_a), b_(b, model_b), separating_direction_(a, b)
  {
    kernel::require_exact_arithmetic();
    if (coherence == Coherence::last_frame) own_memory_ = Pair_memory::with_front();
  }

  /// True when the two placed polyhedra collide. Requires det M != 0 of both poses, and closed polyhedra for
  /// `Question::solid`.
  bool operator()(const Pose& pose_a, const Pose& pose_b, Question question = Question::solid)
  {
    return relation(pose_a, pose_b, question) != Relation::apart;
  }

  /// Returns the relation of the two placed polyhedra. Requires as above. `memory` keeps what was learnt about this
  /// pair of placed bodies; null: the object's own memory, if it has one.
  Relation relation(const Pose& pose_a, const Pose& pose_b, Question question = Question::solid,
                    Pair_memory* memory = nullptr)
  {
    if (!memory && own_memory_) memory = &*own_memory_;
    kernel::require_sound_floating_point();
    ++counts_.queries;
    is_plane_tried_ = false;
    if (a_.tree->empty() || b_.tree->empty()) return Relation::apart;
    if ((!memory || memory->is_plane_first()) && is_apart_by_plane(pose_a, pose_b, memory)) return Relation::apart;
    return relation_by_trees(pose_a, pose_b, question, memory);
  }

  /// Calls what(element of A, element of B) for each pair that the descent does not discard. Requires det M != 0 of
  /// both poses.
  template <class What>
  void for_element_pairs(const Pose& pose_a, const Pose& pose_b, const What& what)
  {
    kernel::require_sound_floating_point();
    ++counts_.queries;
    pose_a_ = &pose_a;
    pose_b_ = &pose_b;
    is_placed_ = false;
    // One direction only: a caller who wants all pairs mostly has bodies that meet.
    if (a_.tree->empty() || b_.tree->empty() || separating_direction_(pose_a, pose_b, 1, false)) return;
    relate_frames();
    collect_leaves();
    for (const auto& [box_a, box_b] : leaves_) {
      __builtin_prefetch(&a_.element(box_a));
      __builtin_prefetch(&b_.element(box_b));
    }
    for (const Box_ids& boxes : leaves_)
      any_pair(boxes, [&](const Element& a, const Element& b) {
        what(a, b);
        return false;
      });
  }

  /// Return the bodies at the last pose that was asked. Require that its question was `for_element_pairs` or its answer
  /// was not `apart`, and that the caller's poses still exist.
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

  /// True when vertex v of A (body 0) or B (body 1) is in the other solid at the last pose that was asked. Requires a
  /// pose whose answer was not `apart`, a vertex that is not on the other surface, and that the caller's poses still
  /// exist.
  bool is_vertex_inside(int body, Index v)
  {
    relate_frames();
    place();
    return body == 0 ? containment_.holds(b_, a_, v, counts_) : containment_.holds(a_, b_, v, counts_);
  }

  /// Returns, after `apart`, a lower bound of the distance by the plane between the bodies; 0 if none was found.
  double certified_gap() const { return is_plane_tried_ ? separating_direction_.gap() : 0; }

  /// Returns the counts of work since the last `clear_counts`.
  const Query_statistics& counts() const { return counts_; }
  void clear_counts() { counts_ = {}; }

  /// Returns the bytes of the support tables and the memory; the trees count their own.
  std::size_t bytes() const
  {
    return separating_direction_.bytes() + separating_face_.bytes() + kept_sides_.bytes() +
           (own_memory_ ? own_memory_->bytes() : 0);
  }

  /// True when fronts are kept. Where leaves are decided by rounding, a certificate could change an answer.
  static constexpr bool keeps_fronts = kernel::Kernel_traits<K>::exact_signs && kernel::Kernel_traits<K>::exact_motion;

 private:
  using Point = kernel::Point<K>;
  using Face = covering::Placed_face<K>;
  using Placed = Placed_bvh8<K>;

  /// Directions tried before the search for a plane ends.
  static constexpr int most_directions = 6;

  /// For up to this many vertices of both bodies, a plane between these is looked for first: boxes cost more.
  static constexpr std::size_t few_vertices = 64;

  /// Projecting this many vertices costs about as much as deciding a pair of triangles by exact signs.
  static constexpr std::size_t vertices_of_pair = 256;

  /// True when a plane is found between the bodies. It is looked for once in a pose.
  bool is_apart_by_plane(const Pose& pose_a, const Pose& pose_b, Pair_memory* memory)
  {
    if (is_plane_tried_) return false;
    is_plane_tried_ = true;
    // The last direction belongs to the pair that was asked last. That is this pair if the object keeps its memory.
    const bool is_own = memory && own_memory_ && memory == &*own_memory_;
    const bool is_apart = separating_direction_(pose_a, pose_b, most_directions, is_own);
    if (memory) memory->was_plane_found = is_apart;
    return is_apart;
  }

  /// Returns this thread's count of exact fallbacks, for a kernel that counts them.
  static std::uint64_t exact_fallbacks()
  {
    if constexpr (std::is_same_v<K, kernel::Adaptive>) return K::exact_fallbacks();
    return 0;
  }

  /// Answers a query that no plane has decided at its start.
  [[gnu::noinline]] Relation relation_by_trees(const Pose& pose_a, const Pose& pose_b, Question question,
                                               Pair_memory* memory)
  {
    const std::uint64_t fallbacks = exact_fallbacks();
    pose_a_ = &pose_a;
    pose_b_ = &pose_b;
    is_placed_ = false;
    const std::optional<bool> meet = meet_by_trees(memory);
    const Relation answer = !meet ? Relation::apart : *meet ? Relation::surfaces : relation_of_apart(question, memory);
    counts_.exact_fallbacks += exact_fallbacks() - fallbacks;
    return answer;
  }

  /// True when surfaces meet; nothing where a plane separates the bodies. It tries the witness, the front, a plane, and
  /// last a descent from the roots.
  std::optional<bool> meet_by_trees(Pair_memory* memory)
  {
    if (memory && memory->witness) {
      if (leaves_meet(*memory->witness)) return true;
      memory->witness.reset();
    }
    const bool follows = memory && memory->holds_front();
    if (!follows && is_apart_by_plane(*pose_a_, *pose_b_, memory)) return std::nullopt;
    if (!follows && vertex_count() <= few_vertices && separating_direction_.was_near() && are_parted_by_vertices(1))
      return std::nullopt;
    relate_frames();
    if constexpr (keeps_fronts) {
      if (follows) {
        if (const std::optional<bool> meet = by_front(*memory)) return meet;
        if (is_apart_by_plane(*pose_a_, *pose_b_, memory)) return std::nullopt;
      }
      if (memory && memory->is_front_due()) memory->front = std::make_unique<Bvh8_front>();
      if (memory && memory->front && Bvh8_front::is_certifiable(both_trees()) && memory->front->is_to_be_made())
        return by_front(*memory);
    }
    const std::uint64_t opened = counts_.pairs_visited;
    const std::optional<bool> meet = descend_trees(memory);
    if (memory && !memory->front) memory->opened = std::uint32_t(counts_.pairs_visited - opened);
    return meet;
  }

  /// Follows the front, or makes it where it holds nothing. True when surfaces meet; nothing when the front has been
  /// given up.
  std::optional<bool> by_front(Pair_memory& memory)
  {
    const auto leaf_gap = [&](const Box_ids& boxes) {
      const Bvh8_front::Leaf_gap found = gap_of_leaves(boxes);
      if (found.meet) memory.witness = boxes;
      return found;
    };
    Both_trees trees = both_trees();
    std::optional<bool> meet;
    if (memory.front->holds())
      meet = memory.front->follow(stack_, trees, *a_.tree, *b_.tree, leaf_gap);
    else
      meet = memory.front->make(stack_, trees, *a_.tree, *b_.tree, leaf_gap);
    count(trees);
    return meet;
  }

  /// Returns the relation of bodies whose surfaces do not meet.
  Relation relation_of_apart(Question question, Pair_memory* memory)
  {
    if (question == Question::surface) return Relation::apart;
    Bvh8_front* const front = memory ? memory->front.get() : nullptr;
    if (front && front->relation) return *front->relation;
    place();
    const Relation relation = containment_(a_, b_, counts_)   ? Relation::b_in_a
                              : containment_(b_, a_, counts_) ? Relation::a_in_b
                                                              : Relation::apart;
    if (front && front->holds()) front->relation = relation;
    return relation;
  }

  std::size_t vertex_count() const { return a_.placed.model().vertices().size() + b_.placed.model().vertices().size(); }

  /// True when a plane is found between the bodies' vertices, in at most `steps` directions. The first is the direction
  /// along which they overlap least. Only the adaptive kernel looks for it.
  bool are_parted_by_vertices(int steps)
  {
    if constexpr (std::is_same_v<K, kernel::Adaptive>) {
      place();
      const auto vertices_of = [this](int body, Placed& placed) {
        const auto& vertices = placed.placed.model().vertices();
        if (!largest_[body]) largest_[body] = kernel::largest_coordinate(vertices);
        return kernel::Placed_vertices{vertices, *largest_[body], body == 0 ? *pose_a_ : *pose_b_};
      };
      const auto point_of = [](Placed& body) {
        return [&body](std::size_t v) -> const Point& { return body.placed.point(Index(v)); };
      };
      return kernel::are_parted_by_vertices(separating_direction_.least_overlapping(), vertices_of(0, a_), point_of(a_),
                                            vertices_of(1, b_), point_of(b_), steps);
    }
    return false;
  }

  /// True when a plane is found between the bodies, after exact signs told `told` pairs of elements apart, these two
  /// last. Each search is made when it costs no more than the pairs did.
  bool are_parted_beside(const Element& a, const Element& b, std::size_t told)
  {
    if (separating_face_(a_, a, b_, b, parted_by_, kept_sides_)) return true;
    const std::size_t count = vertex_count(), due = (count + vertices_of_pair - 1) / vertices_of_pair;
    return count > few_vertices && told == due && are_parted_by_vertices(most_directions);
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
    kept_sides_.clear();
    is_placed_ = true;
  }

  /// True when meet(element of A, element of B) holds for some pair of elements of the two leaves.
  template <class Meet>
  bool any_pair(const Box_ids& boxes, const Meet& meet)
  {
    for (Index i = 0; i < a_.leaf_count(boxes[0]); ++i)
      for (Index j = 0; j < b_.leaf_count(boxes[1]); ++j)
        if (meet(a_.element(boxes[0], i), b_.element(boxes[1], j))) return true;
    return false;
  }
  bool leaves_meet(const Box_ids& boxes)
  {
    return any_pair(boxes, [this](const Element& a, const Element& b) { return elements_meet(a, b); });
  }

  /// Returns whether elements of two leaves meet and, if not, a lower bound of the distance of any two. A positive
  /// certified gap proves that triangles do not meet; the signs of K decide the others.
  Bvh8_front::Leaf_gap gap_of_leaves(const Box_ids& boxes)
  {
    Bvh8_front::Leaf_gap all{false, std::numeric_limits<double>::infinity(), {}};
    all.meet = any_pair(boxes, [&](const Element& a, const Element& b) {
      const Element_gap found = element_gap(*a_.tree, a, *b_.tree, b, b_.into_other.frame());
      if (found.low > 0)
        count_triangles();
      else if (elements_meet(a, b))
        return true;
      all.gap = kernel::minimum(all.gap, found.low);
      all.axis = found.axis;
      return false;
    });
    if (a_.leaf_count(boxes[0]) * b_.leaf_count(boxes[1]) != 1) all.axis = {};
    return all;
  }

  /// Writes all pairs of leaves that the descent does not discard to `leaves_`.
  void collect_leaves()
  {
    Both_trees trees = both_trees();
    start(trees);
    next_level_.clear();
    leaves_.clear();
    for (Stop stop; (stop = descend_to_leaves(stack_, next_level_, trees, leaves_)) != Stop::nothing_left;)
      if (stop == Stop::leaves) {  // the roots
        leaves_.push_back(stack_.boxes());
        stack_.pop();
      } else {
        make_child();
      }
    count(trees);
  }

  /// True when some pair of leaves that the descent does not discard meets; that pair becomes the witness. Nothing
  /// where the plane of a triangle separates the bodies.
  std::optional<bool> descend_trees(Pair_memory* memory)
  {
    Both_trees trees = both_trees();
    start(trees);
    separating_face_.restart();
    bool meet = false, are_apart = false;
    std::size_t told = 0;  // pairs that exact signs have told apart
    for (Stop stop; !meet && !are_apart && (stop = descend(stack_, trees)) != Stop::nothing_left;) {
      if (stop == Stop::leaves) {
        const Box_ids boxes = stack_.boxes();
        stack_.pop();
        any_pair(boxes, [&](const Element& a, const Element& b) {
          const std::uint64_t undecided = kept_sides_.undecided();
          meet = elements_meet(a, b);
          if constexpr (std::is_same_v<K, kernel::Adaptive>)
            are_apart = !meet && kept_sides_.undecided() != undecided && are_parted_beside(a, b, ++told);
          return meet || are_apart;
        });
        if (meet && memory) memory->witness = boxes;
      } else {
        make_child();
      }
    }
    count(trees);
    return are_apart ? std::nullopt : std::optional(meet);
  }

  /// Puts the pair of roots on the stack.
  void start(const Both_trees& trees)
  {
    stack_.clear();
    stack_.push({}, a_.size() * trees.scale, b_.size());
  }

  /// Makes the node below the larger box of the top pair, which lacks it.
  void make_child()
  {
    const int larger = stack_.larger_body();
    (larger == 0 ? a_ : b_).tree->child(stack_.box(larger));
  }

  Both_trees both_trees() const
  {
    // A similarity's scale is within these limits. For another map sizes only choose which box to open; but none may
    // become 0 or undefined.
    const double factor = a_.into_other.frame().scale();
    const float scale = factor >= 0x1p-60 && factor <= 0x1p60 ? float(factor) : 1;
    return {{a_.tree->nodes(), b_.tree->nodes()}, {&a_.into_other, &b_.into_other}, scale};
  }

  void count(const Both_trees& trees)
  {
    counts_.pairs_visited += trees.opened;
    counts_.box_tests += trees.compared;
  }

  void count_triangles()
  {
    ++counts_.leaf_pairs;
    ++counts_.triangle_tests;
  }

  bool elements_meet(const Element& a, const Element& b)
  {
    place();
    if (a.is_whole_face() || b.is_whole_face()) {
      ++counts_.leaf_pairs;
      return edges_meet(a_, a, b_, b) || edges_meet(b_, b, a_, a);
    }
    count_triangles();
    if constexpr (std::is_same_v<K, kernel::Adaptive>) {
      using Parted_by = Separating_face::Parted_by;
      // Asked for A's plane first, then for B's unless A's parts the triangles.
      Parted_by asked = Parted_by::neither;
      parted_by_ = Parted_by::neither;
      const auto sides_of = [&](const auto& triangle, const auto& points) {
        const auto sides = kept_sides_(triangle, points);
        asked = asked == Parted_by::neither ? Parted_by::a : Parted_by::b;
        if (kernel::all_strictly_beside(sides)) parted_by_ = asked;
        return sides;
      };
      return kernel::triangles_meet<K>(a_.corners(a), b_.corners(b), sides_of);
    } else {
      return kernel::triangles_meet<K>(a_.corners(a), b_.corners(b));
    }
  }

  /// True when edges of one element meet the other; at least one of the two is a whole face.
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
  kernel::Kept_sides kept_sides_;
  Separating_face separating_face_;
  Separating_face::Parted_by parted_by_ = {};  // of the last pair of triangles
  Bvh8_containment<K> containment_;
  Pair_stack stack_, next_level_;
  std::array<std::optional<double>, 2> largest_;  // coordinates, once they have been asked for
  std::vector<Box_ids> leaves_;
  Query_statistics counts_;
  std::optional<Pair_memory> own_memory_;  // for `Coherence::last_frame`

  const Pose* pose_a_ = nullptr;
  const Pose* pose_b_ = nullptr;
  bool is_placed_ = false;       // at these poses
  bool is_plane_tried_ = false;  // for the bodies at these poses
};

}  // namespace tetracone::tetratree

#endif
