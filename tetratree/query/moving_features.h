#ifndef TETRACONE_TETRATREE_QUERY_MOVING_FEATURES_H
#define TETRACONE_TETRATREE_QUERY_MOVING_FEATURES_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/contact_plane.h"
#include "tetracone/kernel/motion/first_contact.h"
#include "tetracone/kernel/motion/motion_exact.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/kernel/motion/times_before.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/query_statistics.h"

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// The features by which moving bodies first meet: a vertex and a triangle of a face, or two edges.
struct Moving_features {
  kernel::Moving_kind kind;
  int body;                     ///< for vertex_face: the vertex's body
  std::array<Index, 2> face;    ///< a face of A and one of B that the features belong to
  std::array<Index, 4> corner;  ///< for vertex_face: the vertex, the triangle; for edge_edge: A's edge, B's edge
};

/// The first contact of two bodies in motion.
struct First_meeting {
  kernel::Time_root time;
  Moving_features features;
};

/// A part of a span of time.
enum class Span_part { first_half, second_half, whole };

/// Returns these vertices, the corners of an element, in local units.
inline std::array<kernel::Vertex, 3> local_corners(const Bvh8& tree, const std::array<Index, 3>& corner)
{
  std::array<kernel::Vertex, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = tree.local(corner[k]).at;
  return corners;
}

/// Returns a box of a tree, as its centre and its axes times its extents.
inline kernel::Moving_box hull_of(const Bvh8_node& node, int lane)
{
  return {kernel::centre_of(node.boxes, lane), kernel::half_edges_of(node.boxes, lane)};
}

/// A cache of answers by number, which `forget` empties at once.
class Kept_answers {
 public:
  /// Empties the cache.
  void forget()
  {
    now_ += 2;
    if (now_ != 0) return;
    kept_.assign(kept_.size(), 0);
    now_ = 2;
  }

  /// Returns answer n; nothing if it is not in the cache.
  std::optional<bool> at(std::size_t n) const
  {
    if (n >= kept_.size() || (kept_[n] | 1u) != (now_ | 1u)) return std::nullopt;
    return kept_[n] != now_;
  }

  /// Stores answer n and returns it.
  bool keep(std::size_t n, bool answer)
  {
    if (n >= kept_.size()) kept_.resize(kernel::maximum(n + 1, 2 * kept_.size()));
    kept_[n] = now_ + std::uint32_t(answer);
    return answer;
  }

 private:
  std::vector<std::uint32_t> kept_;
  std::uint32_t now_ = 2;
};

/// The boxes of two bodies that a plane separates until the first contact so far. Answers are kept, except about leaves
/// below an asked box. A box that touches the plane is decided by its vertices, exactly.
class Parted_boxes {
 public:
  /// Both trees must outlive it.
  Parted_boxes(const Bvh8& a, const Bvh8& b) : tree_{&a, &b} {}

  /// Takes another plane, and forgets all answers.
  void begin(kernel::Contact_plane plane)
  {
    plane_.emplace(std::move(plane));
    plane_->use_units({units(0), units(1)});
    for (int body = 0; body < 2; ++body) {
      of_box_[body].forget();
      of_vertex_[body].forget();
    }
  }

  /// True when the box is known to be on its body's side of the plane until the first contact so far.
  bool holds(int body, Box_id box)
  {
    if (const auto known = of_box_[body].at(box.number())) return *known;
    return of_box_[body].keep(box.number(), find_whether_holds(body, box));
  }

  /// True when the vertex is known to be on its body's side of the plane until the first contact so far.
  bool holds_vertex(int body, Index v)
  {
    if (const auto known = of_vertex_[body].at(v)) return *known;
    return of_vertex_[body].keep(v, plane_->holds(body, tree_[body]->model().vertices()[v]));
  }

 private:
  bool find_whether_holds(int body, Box_id box)
  {
    const Bvh8& tree = *tree_[body];
    const auto are_all_vertices = [&](const auto& hold) {
      bool all = true;
      for (Index k = 0; k < tree.leaf_count(box); ++k)
        tree.for_vertices(tree.element(box, k), [&](Index v) { all = all && hold(v); });
      return all;
    };
    const auto as_last = [&](Index v) { return plane_->is_held_as_last(body, tree.model().vertices()[v]); };
    const bool is_leaf = tree.is_leaf(box);
    if (is_leaf && are_all_vertices(as_last)) return true;
    if (plane_->holds(body, hull_of(tree.node_of(box), box.lane()))) return true;
    if (is_leaf) return are_all_vertices([&](Index v) { return holds_vertex(body, v); });
    const Index child = tree.child(box);
    const int lanes = tree.node(child).boxes.lane_count;
    for (int k = 0; k < lanes; ++k) {
      const Box_id part(child, k);
      // Most leaves are asked about once.
      if (!(tree.is_leaf(part) ? find_whether_holds(body, part) : holds(body, part))) return false;
    }
    return true;
  }

  kernel::Motion_units units(int body) const { return {tree_[body]->scale().origin, tree_[body]->scale().unit}; }

  std::array<const Bvh8*, 2> tree_;
  std::optional<kernel::Contact_plane> plane_;
  std::array<Kept_answers, 2> of_box_, of_vertex_;
};

/// Counts how many pairs each stage of a search for the first contact decided.
struct Motion_stages {
  std::uint64_t by_planes = 0;  ///< boxes, triangles and features that a plane separates until the first contact so far
  std::uint64_t by_signs = 0;   ///< features that signs of their forms prove apart until then
  std::uint64_t by_roots = 0;   ///< features decided by their first contact, an algebraic number
};

/// The first contact of vertices and faces, and of edges, among the triangles that it is given.
///
/// A pair that the bounds of a span do not separate waits. It is decided in integers, over the span alone, in the order
/// of the times from which on pairs may meet. Where bodies land face on face, many features meet at the first contact
/// so far, and doubles cannot distinguish that time from an earlier one. Planes through features that meet then decide
/// them, or else signs of forms: see `kernel::Times_before`.
class Moving_feature_search {
 public:
  /// Both trees must outlive it.
  Moving_feature_search(const Bvh8& a, const Bvh8& b)
      : tree_{&a, &b}, planes_{Parted_boxes(a, b), Parted_boxes(a, b), Parted_boxes(a, b), Parted_boxes(a, b)}
  {}

  /// Begins a new search. Both motions must stay until the first contact is taken.
  void begin(const kernel::Body_motion& a, const kernel::Body_motion& b)
  {
    moving_ = {&a, &b};
    motion_.reset();
    decided_.clear();
    candidates_.clear();
    best_.reset();
    best_before_ = std::numeric_limits<double>::infinity();
    is_start_in_doubt_ = false;
    begun_at_ = counts_.triangle_tests;
    enough_ = begun_at_ + enough_to_look_ahead;
    forget_planes();
  }

  /// Returns both motions, exactly; made on first use.
  const kernel::Pair_motion& motion()
  {
    if (!motion_) motion_.emplace(*moving_[0], *moving_[1]);
    return *motion_;
  }

  /// Returns an upper bound of the time of the first contact so far; infinite if there is none, -infinity after `end`.
  double before() const { return best_before_; }
  /// Returns the first contact so far, or nothing if there is none, and forgets it.
  std::optional<First_meeting> take_first() { return std::exchange(best_, std::nullopt); }

  /// Enters a span of time, which must stay until the next call. Requires that everything of the last span is decided.
  void enter(const kernel::Motion_span& span)
  {
    span_ = &span;
    for (auto& half : half_) half.reset();
    forget_planes();
    latest_ = span.share_before(best_before_);
  }

  /// Returns an upper bound of the time of the first contact so far, as a fraction of the span.
  double latest() const { return latest_; }

  /// Adds two elements. Requires that within this part of the span they do not meet outside `times`, which run from 0
  /// to 1 over the part.
  void meet(Span_part part, const kernel::Time_window& times, const Element& of_a, const Element& of_b)
  {
    for_triangles(0, of_a, [&](const Triangle& a) {
      for_triangles(1, of_b, [&](const Triangle& b) { meet(part, times, a, b); });
    });
  }

  /// True once after elements were added that may meet at t = 0. All others are apart then.
  bool is_start_in_doubt() { return std::exchange(is_start_in_doubt_, false); }

  /// Ends the search after a contact at t = 0: all that waits is discarded when its turn comes.
  void end() { best_before_ = latest_ = -std::numeric_limits<double>::infinity(); }

  /// True when anything waits to be decided.
  bool is_any_undecided() const { return !candidates_.empty(); }

  /// Decides all pairs that may meet before this fraction of the span.
  void decide_until(double share)
  {
    while (!candidates_.empty() && candidates_.front().from() <= share) decide_front();
  }

  /// Decides the earliest waiting pairs ahead of time, if no contact is known yet: a contact may rule out the others.
  /// It does so rarely, since it may be in vain.
  void look_ahead()
  {
    if (best_ || counts_.triangle_tests < enough_) return;
    enough_ += counts_.triangle_tests - begun_at_;
    const std::uint64_t until = counts_.exact_fallbacks + decided_ahead;
    while (!best_ && !candidates_.empty() && counts_.exact_fallbacks < until) decide_front();
  }

  /// True when a plane is known to separate boxes in the span until the first contact so far. A plane is made after
  /// enough calls.
  bool are_parted(const Box_ids& box)
  {
    if (!best_) return false;
    if (plane_count_ == 0 && ++asked_ == enough_for_a_plane) add_plane(best_->features);
    return is_any_plane([&](Parted_boxes& plane) { return plane.holds(0, box[0]) && plane.holds(1, box[1]); });
  }

  /// Returns which stage decided how many pairs, for tests.
  const Motion_stages& stages() const { return stages_; }

  /// Returns the counts of work since the last `clear_counts`.
  const Query_statistics& counts() const { return counts_; }
  void clear_counts()
  {
    counts_ = {};
    stages_ = {};
  }

 private:
  using Vertex = kernel::Vertex;

  /// Making a plane costs about as much as comparing this many pairs of boxes.
  static constexpr std::size_t enough_for_a_plane = 64;
  /// Planes kept at a time.
  static constexpr std::size_t most_planes = 4;
  /// Deciding two features costs more than this many tests of triangles; it is repeated after twice as many.
  static constexpr std::uint64_t enough_to_look_ahead = 64;
  /// Pairs decided exactly each time.
  static constexpr std::uint64_t decided_ahead = 2;

  /// A pair of features that has been decided over a span. Triangles share corners and edges, so it may come again.
  struct Decided {
    kernel::Moving_kind kind;
    int body;
    std::array<Index, 4> corner;
    std::uint64_t m;
    unsigned k;

    auto operator<=>(const Decided&) const = default;
  };
  /// Returns a time of a part of the span as a time of the whole.
  static double in_span(Span_part part, double time)
  {
    return part == Span_part::whole ? time : 0.5 * (time + double(part == Span_part::second_half));
  }

  /// Two triangles, or features of them, that may meet at these times of a part of the span.
  struct Candidate {
    Span_part part;
    kernel::Time_window times;
    std::array<Index, 2> face;
    std::array<std::array<Index, 3>, 2> corner;
    int feature = all;      ///< a vertex of A's or of B's triangle, or two edges
    bool is_sharp = false;  ///< the times of features come from axes at about these times

    /// Value of `feature` for whole triangles; a smaller one is one of their 6 vertex-face and 9 edge-edge pairs.
    static constexpr int all = 15;

    double from() const { return in_span(part, times.from); }

    Moving_features features() const
    {
      if (feature < 6) {
        const int body = feature / 3;
        const auto& other = corner[1 - body];
        return {
            kernel::Moving_kind::vertex_face, body, face, {corner[body][feature % 3], other[0], other[1], other[2]}};
      }
      const int i = (feature - 6) / 3, j = feature % 3;
      const auto& [a, b] = corner;
      return {kernel::Moving_kind::edge_edge, 0, face, {a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]}};
    }
  };
  struct Triangle {
    std::array<Index, 3> corner;
    std::array<Vertex, 3> local;
    Index face;
  };

  /// Calls what(Triangle) for the triangles of an element. A face of corners on one line is given as its edges.
  template <class What>
  void for_triangles(int body, const Element& element, const What& what) const
  {
    const auto call = [&](Index p, Index q, Index r) {
      what(Triangle{{p, q, r}, local_corners(*tree_[body], {p, q, r}), element.face});
    };
    if (!element.is_whole_face()) return call(element.corner[0], element.corner[1], element.corner[2]);
    const auto from = tree_[body]->model().covering().from(element.face),
               to = tree_[body]->model().covering().to(element.face);
    for (std::size_t k = 0; k < from.size(); ++k) call(from[k], to[k], to[k]);
  }

  const kernel::Motion_span& span_of(Span_part part)
  {
    if (part == Span_part::whole) return *span_;
    auto& half = half_[std::size_t(part)];
    if (!half) half.emplace(span_->half(part == Span_part::second_half));
    return *half;
  }

  /// Keeps two triangles if they may meet.
  void meet(Span_part part, kernel::Time_window times, const Triangle& a, const Triangle& b)
  {
    ++counts_.triangle_tests;
    const kernel::Motion_span& span = span_of(part);
    const std::array<const Triangle*, 2> both = {&a, &b};
    const auto& maps = span.at_middle();
    std::array<std::array<Vertex, 3>, 2> edge;
    for (int body = 0; body < 2; ++body)
      for (int k = 0; k < 3; ++k)
        edge[body][k] =
            span.direction(maps, body, kernel::difference(both[body]->local[(k + 1) % 3], both[body]->local[k]));
    const std::array<Vertex, 2> normal = {kernel::cross(edge[0][0], edge[0][1]), kernel::cross(edge[1][0], edge[1][1])};

    const auto of_a = span.placed(0, a.local), of_b = span.placed(1, b.local);
    const auto is_done = [&](const Vertex& axis) {
      times = common(times, span.near_along(kernel::scaled_to_one(axis), of_a, of_b));
      return times.is_empty() || in_span(part, times.from) > latest_;
    };
    for (const Vertex& n : normal)
      if (is_done(n)) return;
    for (const Vertex& e : edge[0])
      for (const Vertex& f : edge[1])
        if (is_done(kernel::cross(e, f))) return;
    for (int body = 0; body < 2; ++body)
      for (const Vertex& e : edge[body])
        if (is_done(kernel::cross(normal[body], e))) return;
    const Candidate both_may_meet{part, times, {a.face, b.face}, {a.corner, b.corner}};
    if (span.m() == 0 && both_may_meet.times.from <= 0) is_start_in_doubt_ = true;
    keep(both_may_meet);
  }

  /// Returns the body of corner k.
  static int body_of(const Moving_features& features, int k)
  {
    if (features.kind == kernel::Moving_kind::vertex_face) return k == 0 ? features.body : 1 - features.body;
    return k < 2 ? 0 : 1;
  }

  /// True when doubles determine no direction across both.
  static bool are_nearly_parallel(const Vertex& e, const Vertex& f)
  {
    const Vertex n = kernel::cross(e, f);
    return !(kernel::dot(n, n) > 0x1p-60 * kernel::dot(e, e) * kernel::dot(f, f));
  }

  /// Returns when features may meet within the times `near`, by axes at the middle of these.
  kernel::Time_window near(const Moving_features& features, const kernel::Motion_span& span,
                           kernel::Time_window near) const
  {
    const kernel::Motion_span::Maps maps = span.about(0.5 * (near.from + near.until));
    std::array<Vertex, 4> p, image;
    for (int k = 0; k < 4; ++k) {
      const int body = body_of(features, k);
      p[k] = tree_[body]->local(features.corner[k]).at;
      image[k] = span.direction(maps, body, p[k]);
    }
    const auto side = [&](int from, int to) { return kernel::difference(image[to], image[from]); };
    const auto take = [&](const std::array<Vertex, 2>& sides, const Vertex* third, const auto& of_a, const auto& of_b) {
      const auto is_done = [&](const Vertex& axis) {
        near = common(near, span.near_along(kernel::scaled_to_one(axis), of_a, of_b));
        return near.is_empty();
      };
      const Vertex n = kernel::cross(sides[0], sides[1]);
      if (is_done(n) || is_done(kernel::cross(n, sides[0])) || is_done(kernel::cross(n, sides[1])) || !third) return;
      is_done(kernel::cross(n, *third));
    };
    if (features.kind == kernel::Moving_kind::edge_edge) {
      std::array<Vertex, 2> sides = {side(0, 1), side(2, 3)};
      const auto of_a = span.placed(0, std::array{p[0], p[1]}), of_b = span.placed(1, std::array{p[2], p[3]});
      if (are_nearly_parallel(sides[0], sides[1])) {
        // Parallel edges are separated by an axis along them, or one that leads from one to the other.
        near = common(near, span.near_along(kernel::scaled_to_one(sides[0]), of_a, of_b));
        sides[1] = side(0, 2);
      }
      take(sides, nullptr, of_a, of_b);
      return near;
    }
    const auto vertex = span.placed(features.body, std::array<Vertex, 1>{p[0]});
    const auto face = span.placed(1 - features.body, std::array{p[1], p[2], p[3]});
    const Vertex third = side(2, 3);
    if (features.body == 0)
      take({side(1, 2), side(1, 3)}, &third, vertex, face);
    else
      take({side(1, 2), side(1, 3)}, &third, face, vertex);
    return near;
  }

  /// Keeps features of two triangles if they may meet.
  void add(Candidate candidate, int feature, bool is_sharp)
  {
    candidate.feature = feature;
    candidate.is_sharp = is_sharp;
    candidate.times = near(candidate.features(), span_of(candidate.part), candidate.times);
    if (!candidate.times.is_empty() && candidate.from() <= latest_) keep(candidate);
  }

  void keep(const Candidate& candidate)
  {
    candidates_.push_back(candidate);
    std::ranges::push_heap(candidates_, std::ranges::greater(), &Candidate::from);
  }

  /// Decides the pair that may meet first, or replaces it by its features, or by sharper times of them.
  void decide_front()
  {
    std::ranges::pop_heap(candidates_, std::ranges::greater(), &Candidate::from);
    const Candidate next = candidates_.back();
    candidates_.pop_back();
    if (next.from() > latest_ || are_parted(next)) return;
    if (next.feature == Candidate::all)
      for (int feature = 0; feature < Candidate::all; ++feature) add(next, feature, false);
    else if (!next.is_sharp)
      add(next, next.feature, true);
    else
      decide(next.features(), span_of(next.part));
  }

  /// Finds the first contact of two features in a part of the span, exactly.
  void decide(const Moving_features& features, const kernel::Motion_span& span)
  {
    Decided now{features.kind, features.body, features.corner, span.m(), span.k()};
    if (features.kind == kernel::Moving_kind::edge_edge)
      for (const int k : {0, 2})
        if (now.corner[k] > now.corner[k + 1]) std::swap(now.corner[k], now.corner[k + 1]);
    if (!decided_.insert(now).second) return;
    ++counts_.exact_fallbacks;
    if (best_ && are_apart_until_best(features)) {
      ++stages_.by_signs;
      return;
    }
    ++stages_.by_roots;
    std::optional<kernel::Time_root> time =
        exact_motion(features, motion())
            .first_contact({kernel::Integer(static_cast<unsigned long>(span.m())), span.k()});
    if (!time || (best_ && !time->is_before(best_->time))) return;
    best_before_ = kernel::bounds_about(*time).hi;
    latest_ = span_->share_before(best_before_);
    best_ = First_meeting{std::move(*time), features};
    forget_planes();
  }

  /// Returns the vertices of features.
  std::array<Vertex, 4> vertices(const Moving_features& features) const
  {
    std::array<Vertex, 4> v;
    for (int k = 0; k < 4; ++k) v[k] = tree_[body_of(features, k)]->model().vertices()[features.corner[k]];
    return v;
  }

  kernel::Exact_motion exact_motion(const Moving_features& features, const kernel::Pair_motion& motion) const
  {
    const std::array<Vertex, 4> v = vertices(features);
    int least = 0;
    for (const Vertex& x : v) least = kernel::Pair_motion::exponent_of(x, least);
    std::array<kernel::Form_vector, 4> points;
    for (int k = 0; k < 4; ++k) points[k] = motion.image(body_of(features, k), v[k], least);
    return kernel::Exact_motion(features.kind, std::move(points), motion.square());
  }

  /// True when signs of forms prove that features are apart in the span until the first contact so far. It also tries
  /// the features' plane, whenever the number of calls has doubled.
  bool are_apart_until_best(const Moving_features& features)
  {
    if (!is_any_time_left()) return true;
    if (++asked_features_ == 2 && plane_count_ == 0) add_plane(best_->features);
    if (asked_features_ > 1 && std::has_single_bit(asked_features_)) add_plane(features);
    return exact_motion(features, *motion_before_).is_apart(*times_before_);
  }

  /// True when the span has times before the first contact so far; prepares the motion until then. Requires a contact.
  bool is_any_time_left()
  {
    if (times_before_) return true;
    const kernel::Time_cell start{kernel::Integer(static_cast<unsigned long>(span_->m())), span_->k()};
    if (best_->time.compare(start.m, start.k) != CGAL::POSITIVE) return false;
    times_before_.emplace(start, best_->time);
    motion_before_.emplace(times_before_->over(motion()));
    return true;
  }

  void forget_planes()
  {
    times_before_.reset();
    plane_count_ = asked_ = asked_features_ = 0;
  }

  /// Adds the plane of features, if it separates them until the first contact so far.
  void add_plane(const Moving_features& features)
  {
    if (plane_count_ == most_planes || !is_any_time_left()) return;
    kernel::Contact_plane plane(*motion_before_, *times_before_, features.kind, features.body, vertices(features));
    if (plane.is_defined()) planes_[plane_count_++].begin(std::move(plane));
  }

  /// True when a plane is known to separate a candidate in the span until the first contact so far.
  bool are_parted(const Candidate& candidate)
  {
    if (candidate.feature == Candidate::all)
      return is_any_plane([&](Parted_boxes& plane) {
        for (int body = 0; body < 2; ++body)
          for (const Index v : candidate.corner[body])
            if (!plane.holds_vertex(body, v)) return false;
        return true;
      });
    const Moving_features features = candidate.features();
    return is_any_plane([&](Parted_boxes& plane) {
      for (int k = 0; k < 4; ++k)
        if (!plane.holds_vertex(body_of(features, k), features.corner[k])) return false;
      return true;
    });
  }

  template <class Ask>
  bool is_any_plane(const Ask& ask)
  {
    for (std::size_t k = 0; k < plane_count_; ++k)
      if (ask(planes_[k])) {
        ++stages_.by_planes;
        return true;
      }
    return false;
  }

  std::array<const Bvh8*, 2> tree_;
  Query_statistics counts_;
  std::array<const kernel::Body_motion*, 2> moving_{};
  std::optional<kernel::Pair_motion> motion_;
  std::set<Decided> decided_;
  std::vector<Candidate> candidates_;  // a heap
  std::optional<First_meeting> best_;
  double best_before_ = std::numeric_limits<double>::infinity();
  const kernel::Motion_span* span_ = nullptr;
  std::array<std::optional<kernel::Motion_span>, 2> half_;  // made on first use
  double latest_ = std::numeric_limits<double>::infinity();
  bool is_start_in_doubt_ = false;
  Motion_stages stages_;
  std::uint64_t begun_at_ = 0, enough_ = 0;  // triangle tests at the beginning, and before looking ahead
  // In the span until the first contact so far:
  std::optional<kernel::Times_before> times_before_;  // made, with the motion, on first use
  std::optional<kernel::Pair_motion> motion_before_;
  std::array<Parted_boxes, most_planes> planes_;
  std::size_t plane_count_ = 0, asked_ = 0, asked_features_ = 0;
};

}  // namespace tetracone::tetratree

#endif
