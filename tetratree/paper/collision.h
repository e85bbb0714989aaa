#ifndef TETRACONE_TETRATREE_PAPER_COLLISION_H
#define TETRACONE_TETRATREE_PAPER_COLLISION_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/predicate/contact.h"
#include "tetracone/kernel/predicate/question.h"
#include "tetracone/tetratree/paper/placed_tree.h"
#include "tetracone/tetratree/query_statistics.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace tetracone::tetratree {

using kernel::Contact;
using kernel::Feature_pair;
using kernel::Pose;
using kernel::Question;
using kernel::Relation;

/// Collision detection between two tetra-trees (JS08 Algorithm 1). Build once, ask for many poses.
///
/// A query first takes the reference bounding tetrahedron of each body (Theorem 2), then descends both trees. It
/// discards a pair of nodes by Theorem 2, by spheres and by bounding tetrahedra, in this order. It tests the edges in
/// one leaf against the faces in the other, both ways: real edges only, never inner ones of the covering.
///
/// Exact kernels: the answer equals testing all edges against all faces. Proof: a point y where an edge e of A meets a
/// face f of B lies in a leaf cone of each tree. The edge e is on a covering triangle through y, which is classified in
/// A's leaf. Likewise f has a covering triangle through y in B's. Bounding tetrahedra and spheres are rounded outward
/// and hold what lies in their cone, so this pair of leaves is never discarded. Two faces that share a point also share
/// one on an edge of one of them.
///
/// Departures from the listing:
/// - the choice of the node to descend (see `Descent`);
/// - flags of Theorem 2 are decided when a node is descended, not set by a walk over the whole tree;
/// - Theorem 2 also asks for V0 beyond the plane; otherwise a body whose origin lies inside the hull could be
///   discarded;
/// - pairs of nodes are compared along all 44 axes of two tetrahedra (`Config::all_axes`);
/// - the side of a vertex against a face is decided once for all edges at that vertex;
/// - nodes may have oriented boxes (`Config::boxes`);
/// - a query may give up the descent and test each pair once (`Config::all_pairs_after`).
///
/// `solid` and `features` are extensions that the paper names.
///
/// The config of the first tree decides how a query runs. Both trees must outlive the query object. Where K decides
/// exactly, the constructor and every query throw kernel::Unsound_floating_point when floating point is not as that
/// needs it.
template <class K>
class Collision {
 public:
  /// Number of pairs of an edge and a face that take the time of comparing two nodes, for `Config::all_pairs_after`.
  /// Measured on models of 14 to 760 faces: 14 to 37 ns per pair against 110 to 140 ns. It is 0 where K rounds: there
  /// the answers of the descent itself are wanted, right or wrong.
  static constexpr std::size_t pairs_per_visit = Tetra_tree<K>::sound ? 8 : 0;

  Collision(Tetra_tree<K>& a, Tetra_tree<K>& b)
      : config_(a.config()),
        a_(a),
        b_(b),
        sides_(kernel::maximum(a.model().vertices().size(), b.model().vertices().size())),
        all_pairs_(pairs(a, b) + pairs(b, a))
  {
    if constexpr (sound) kernel::require_exact_arithmetic();
  }

  /// True when the two placed polyhedra collide. Requires det M != 0 of both poses, and closed polyhedra for
  /// `Question::solid`.
  bool operator()(const Pose& pose_a, const Pose& pose_b, Question question = Question::solid)
  {
    return relation(pose_a, pose_b, question) != Relation::apart;
  }

  /// Returns the relation of the two placed polyhedra. Requires as above.
  Relation relation(const Pose& pose_a, const Pose& pose_b, Question question = Question::solid)
  {
    const Fallbacks fallbacks(counts_);
    begin(pose_a, pose_b);
    if (roots_apart()) return Relation::apart;
    if (surfaces_meet()) return Relation::surfaces;
    if (question == Question::surface) return Relation::apart;
    return holds_a_shell(a_, b_) ? Relation::b_in_a : holds_a_shell(b_, a_) ? Relation::a_in_b : Relation::apart;
  }

  /// Calls leaf_test(node of A, node of B) for the pairs of leaves that the query does not discard, until one call
  /// returns true. True when one did. This is the descent alone, with the caller's leaf test.
  template <class Leaf_test>
  bool any_leaf_pair(const Pose& pose_a, const Pose& pose_b, const Leaf_test& leaf_test)
  {
    begin(pose_a, pose_b);
    return !roots_apart() && descend_from_roots(leaf_test);
  }

  /// Returns all pairs of an edge of one body and a face of the other that share a point, sorted, with their kinds of
  /// contact. Requires det M != 0 of both poses.
  std::vector<Feature_pair> features(const Pose& pose_a, const Pose& pose_b)
  {
    const Fallbacks fallbacks(counts_);
    std::vector<Feature_pair> found;
    features_ = &found;
    begin(pose_a, pose_b);
    if (!roots_apart()) surfaces_meet();
    features_ = nullptr;
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Returns the choices by which queries run; choices of the build have no more effect.
  Config& config() { return config_; }

  Placed_tree<K>& a() { return a_; }
  Placed_tree<K>& b() { return b_; }

  const Query_statistics& counts() const { return counts_; }
  void clear_counts() { counts_ = {}; }

 private:
  using B = typename Tetra_tree<K>::B;
  static constexpr bool sound = Tetra_tree<K>::sound;
  static constexpr Index root = Tetra_tree<K>::root();
  using Body = Placed_tree<K>;
  using Plane = std::optional<kernel::Placed_half_space<B, sound>>;

  /// Counts the exact stage of the adaptive kernel over its lifetime.
  struct Fallbacks {
    Query_statistics& counts;
    std::uint64_t before = now();

    explicit Fallbacks(Query_statistics& c) : counts(c) {}
    ~Fallbacks() { counts.exact_fallbacks += now() - before; }
    static std::uint64_t now()
    {
      if constexpr (std::is_same_v<K, kernel::Adaptive>) return kernel::Adaptive::exact_fallbacks();
      return 0;
    }
  };

  void begin(const Pose& pose_a, const Pose& pose_b)
  {
    ++counts_.queries;
    a_.place(pose_a);
    b_.place(pose_b);
    slack_ = kernel::projection_slack(a_.frame(), b_.frame());
    determinant_a_ = std::abs(volume_factor(a_));
    determinant_b_ = std::abs(volume_factor(b_));
    plane_a_.reset();
    plane_b_.reset();
    pairs_seen_ = 0;
    limit_ = std::numeric_limits<double>::infinity();
    gave_up_ = false;
  }

  static double pairs(const Tetra_tree<K>& edges_of, const Tetra_tree<K>& faces_of)
  {
    return double(edges_of.model().covering().edges().size()) * double(faces_of.model().face_count());
  }

  static B volume_factor(const Body& body)
  {
    const auto& m = body.frame().entries();
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
           m[2] * (m[4] * m[9] - m[5] * m[8]);
  }

  // Tests the spheres of the whole bodies. If neither has a tree, nothing is discarded.
  bool roots_apart()
  {
    const Node<B>&a = a_.tree().node(root), &b = b_.tree().node(root);
    return !(a.is_leaf && b.is_leaf) && spheres_apart(a, b);
  }

  // True when an edge of one body and a face of the other share a point. With `features_` it finds all of them first.
  bool surfaces_meet()
  {
    limit_ = config_.all_pairs_after * all_pairs_;
    const bool met = descend_from_roots([this](const Node<B>& a, const Node<B>& b) { return leaves_meet(a, b); });
    if (!gave_up_) return met;
    const Every_element every_a(a_), every_b(b_);
    return elements_meet(every_a.elements(), every_b.elements());
  }

  // Counts work that takes the time of `pairs` pairs of an edge and a face. True, which ends the descent, when testing
  // all pairs at once is better.
  bool gives_up(std::size_t pairs)
  {
    pairs_seen_ += pairs;
    gave_up_ = double(pairs_seen_) > limit_;
    return gave_up_;
  }

  template <class Leaf_test>
  bool descend_from_roots(const Leaf_test& leaf_test)
  {
    if (config_.regular_hull) {
      plane_a_ = reference(a_, b_);
      plane_b_ = reference(b_, a_);
    }
    return descend(root, root, leaf_test);
  }

  // Returns the plane of `body` that faces `other`, if it can discard anything. It can if the other's V0, a vertex of
  // all its bounding tetrahedra, is beyond it.
  Plane reference(const Body& body, const Body& other) const
  {
    const auto plane = body.reference(other.origin());
    return plane.is_beyond(other.origin(), slack_) ? Plane(plane) : std::nullopt;
  }

  bool beyond(const Plane& plane, const Body& body, const Node<B>& node)
  {
    if (!plane || node.level == 0) return false;
    ++counts_.hull_tests;
    for (int i = 1; i < 4; ++i)
      if (!plane->is_beyond(body.frame()(node.tetrahedron[i]), slack_)) return false;
    ++counts_.discarded_by_hull;
    return true;
  }

  bool spheres_apart(const Node<B>& a, const Node<B>& b)
  {
    if (!config_.spheres) return false;
    ++counts_.sphere_tests;
    const bool apart = kernel::separated<B, sound>(a_.sphere(a), b_.sphere(b));
    counts_.discarded_by_sphere += apart;
    return apart;
  }

  bool tetrahedra_apart(const Node<B>& a, const Node<B>& b)
  {
    if (!config_.tetrahedra || a.level == 0 || b.level == 0) return false;
    ++counts_.tetrahedron_tests;
    const bool apart = kernel::separated<B>(a_.tetrahedron(a), b_.tetrahedron(b), config_.all_axes, slack_);
    counts_.discarded_by_tetrahedron += apart;
    return apart;
  }

  bool boxes_apart(Index na, Index nb)
  {
    if (!(config_.boxes && a_.tree().config().boxes && b_.tree().config().boxes)) return false;
    ++counts_.box_tests;
    return kernel::separated<B>(a_.box(na), b_.box(nb), slack_);
  }

  // Compares a pair of nodes. True when a contact was found and one is enough, or when the descent is given up.
  template <class Leaf_test>
  bool visit(Index na, Index nb, const Leaf_test& leaf_test)
  {
    if (gives_up(pairs_per_visit)) return true;
    ++counts_.pairs_visited;
    const Node<B>&a = a_.tree().node(na), &b = b_.tree().node(nb);
    if (spheres_apart(a, b) || tetrahedra_apart(a, b) || boxes_apart(na, nb)) return false;
    return descend(na, nb, leaf_test);
  }

  template <class Leaf_test>
  bool descend(Index na, Index nb, const Leaf_test& leaf_test)
  {
    const Node<B>&a = a_.tree().node(na), &b = b_.tree().node(nb);
    if (a.is_leaf && b.is_leaf) return leaf_test(a, b);
    if (config_.descent == Descent::both && !a.is_leaf && !b.is_leaf)
      return for_children_of_a(na, [&](Index child_a) {
        return for_children_of_b(nb, [&](Index child_b) { return visit(child_a, child_b, leaf_test); });
      });
    const bool a_first = b.is_leaf || (!a.is_leaf && a.volume * determinant_a_ > b.volume * determinant_b_);
    if (a_first) return for_children_of_a(na, [&](Index child) { return visit(child, nb, leaf_test); });
    return for_children_of_b(nb, [&](Index child) { return visit(na, child, leaf_test); });
  }

  template <class Visit>
  bool for_children_of_a(Index n, const Visit& visit_child)
  {
    return for_children(a_, n, plane_b_, visit_child);
  }
  template <class Visit>
  bool for_children_of_b(Index n, const Visit& visit_child)
  {
    return for_children(b_, n, plane_a_, visit_child);
  }
  template <class Visit>
  bool for_children(Body& body, Index n, const Plane& plane_of_other, const Visit& visit_child)
  {
    const Node<B>& parent = body.tree().with_children(n);
    const Index first = parent.first_child, end = first + parent.child_count;
    for (Index child = first; child < end; ++child)
      if (!beyond(plane_of_other, body, body.tree().node(child)) && visit_child(child)) return true;
    return false;
  }

  // Compares a pair of leaves; returns as `visit`.
  bool leaves_meet(const Node<B>& a, const Node<B>& b)
  {
    ++counts_.leaf_pairs;
    const Elements of_a = {a_.tree().edges(a), a_.tree().faces(a)}, of_b = {b_.tree().edges(b), b_.tree().faces(b)};
    const std::size_t pairs = of_a.edges.size() * of_b.faces.size() + of_b.edges.size() * of_a.faces.size();
    const bool are_all = is_whole(a_, of_a) && is_whole(b_, of_b);
    return (!are_all && gives_up(pairs)) || elements_meet(of_a, of_b);
  }

  // Indices of edges and faces.
  struct Elements {
    std::span<const Index> edges, faces;
  };

  static bool is_whole(Body& body, const Elements& elements)
  {
    return elements.faces.size() == body.tree().model().face_count();
  }

  // All edges and faces of a body.
  struct Every_element {
    std::vector<Index> edges, faces;

    explicit Every_element(Body& body)
        : edges(body.tree().model().covering().edges().size()), faces(body.tree().model().face_count())
    {
      std::iota(edges.begin(), edges.end(), Index(0));
      std::iota(faces.begin(), faces.end(), Index(0));
    }
    Elements elements() const { return {edges, faces}; }
  };

  bool elements_meet(const Elements& of_a, const Elements& of_b)
  {
    return edges_meet_faces(a_, of_a.edges, b_, of_b.faces, 0) || edges_meet_faces(b_, of_b.edges, a_, of_a.faces, 1);
  }

  // Tests edges of one body against faces of the other. The side of a vertex against a face's plane alone decides most
  // pairs. It is computed once for all edges at that vertex.
  bool edges_meet_faces(Body& body, std::span<const Index> edges, Body& other, std::span<const Index> faces,
                        int body_number)
  {
    const auto& ends = body.tree().model().covering().edges();
    edge_boxes_.clear();
    if (config_.leaf_boxes)
      for (const Index edge : edges) edge_boxes_.push_back(body.edge_box(edge));
    for (const Index face : faces) {
      const covering::Placed_face<K> placed(other.body(), face);
      const bool is_triangle = placed.edge_count() == 3, is_degenerate = placed.is_degenerate();
      ++face_now_;
      const auto side = [&](Index v) {
        if (is_degenerate) return kernel::ZERO;
        Side& known = sides_[v];
        if (known.decided_at != face_now_)
          known = {face_now_, kernel::volume_sign<K>(placed.plane_basis(0), placed.plane_basis(1),
                                                     placed.plane_basis(2), body.body().point(v))};
        return known.sign;
      };
      for (std::size_t k = 0; k < edges.size(); ++k) {
        if (config_.leaf_boxes && !edge_boxes_[k].meets(other.face_box(face))) {
          ++counts_.discarded_by_box;
          continue;
        }
        ++counts_.edge_face_tests;
        const auto& [from, to] = ends[edges[k]];
        const kernel::Sign side_from = side(from), side_to = side(to);
        if (side_from == side_to && side_from != kernel::ZERO) continue;
        if constexpr (sound) pairs_seen_ += placed.edge_count();  // these are looked at now, one by one
        const kernel::Point<K>&p = body.body().point(from), &q = body.body().point(to);
        const Contact contact = is_triangle && !is_degenerate
                                    ? kernel::segment_triangle<K>(p, q, placed.plane_basis(0), placed.plane_basis(1),
                                                                  placed.plane_basis(2), side_from, side_to)
                                    : kernel::segment_face<K>(p, q, placed, side_from, side_to);
        if (contact == Contact::none) continue;
        if (features_ == nullptr) return true;
        features_->push_back({body_number, from, to, face, contact});
      }
    }
    return false;
  }

  // True when the holder holds a shell of the other body. Requires surfaces that share no point: then each shell is
  // inside or outside as a whole, and one vertex decides.
  bool holds_a_shell(Body& holder, Body& held)
  {
    for (const Index v : held.tree().model().covering().shell_vertices()) {
      ++counts_.inclusion_tests;
      if (holder.contains(held.body().point(v))) return true;
    }
    return false;
  }

  Config config_;
  Body a_, b_;
  B slack_ = 0, determinant_a_ = 1, determinant_b_ = 1;
  Plane plane_a_, plane_b_;
  std::vector<Feature_pair>* features_ = nullptr;

  struct Side {
    std::uint64_t decided_at = 0;  // the face, as a value of `face_now_`
    kernel::Sign sign = kernel::ZERO;
  };
  std::vector<Side> sides_;  // sides of vertices of either body against the present face
  std::uint64_t face_now_ = 0;
  std::vector<kernel::Box<B>> edge_boxes_;  // of the present leaf
  const double all_pairs_;                  // number of pairs of an edge and a face
  std::size_t pairs_seen_ = 0;              // pairs whose time this query has taken
  double limit_ = 0;                        // the number of pairs above which the descent is given up
  bool gave_up_ = false;
  Query_statistics counts_;
};

}  // namespace tetracone::tetratree

#endif
