#ifndef TETRACONE_TETRATREE_FAST_MOVING_FEATURES_H
#define TETRACONE_TETRATREE_FAST_MOVING_FEATURES_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/first_contact.h"
#include "tetracone/kernel/motion/motion_exact.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/query_statistics.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Where moving bodies first meet: a vertex and a triangle of a face, or two edges.
struct Moving_features {
  kernel::Moving_kind kind;
  int body;                     ///< vertex_face: of the vertex
  std::array<Index, 2> face;    ///< of A and of B, one that the feature belongs to
  std::array<Index, 4> corner;  ///< vertex_face: the vertex, the triangle; edge_edge: A's edge, B's edge
};

/// The first contact of two bodies in motion.
struct First_meeting {
  kernel::Time_root time;
  Moving_features features;
};

/// Of a span of time.
enum class Span_part { first_half, second_half, whole };

/// The corners of an element, in local points.
inline std::array<kernel::Vertex, 3> local_corners(const Bvh8& tree, const std::array<Index, 3>& corner)
{
  std::array<kernel::Vertex, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const kernel::Vector at = tree.local(corner[k]);
    corners[k] = {at[0], at[1], at[2]};
  }
  return corners;
}

/// The first contact of vertices and faces, and of edges, of the triangles that it is given: what the bounds of a span do
/// not part waits, and is decided in integers, over the span alone, in the order of the times from which on it may meet.
class Moving_feature_search {
 public:
  /// Both trees must outlive it.
  Moving_feature_search(const Bvh8& a, const Bvh8& b) : tree_{&a, &b} {}

  /// Begins anew. Both motions must stay until the first contact is taken.
  void begin(const kernel::Body_motion& a, const kernel::Body_motion& b)
  {
    moving_ = {&a, &b};
    motion_.reset();
    decided_.clear();
    candidates_.clear();
    best_.reset();
    best_before_ = std::numeric_limits<double>::infinity();
    is_start_in_doubt_ = false;
  }

  /// Both motions, exactly; made when first asked for.
  const kernel::Pair_motion& motion()
  {
    if (!motion_) motion_.emplace(*moving_[0], *moving_[1]);
    return *motion_;
  }

  /// Not before the first contact so far; infinity where there is none.
  double before() const { return best_before_; }
  std::optional<First_meeting> take_first() { return std::exchange(best_, std::nullopt); }

  /// Looks at a span of time. It must stay until the next. Requires that all of the last one is decided.
  void enter(const kernel::Motion_span& span)
  {
    span_ = &span;
    for (auto& half : half_) half.reset();
    latest_ = span.share_before(best_before_);
  }

  /// The first contact so far is not after such a share of the span.
  double latest() const { return latest_; }

  /// Takes in two elements, which do not meet in a part of the span outside of these times, from 0 to 1 over it.
  void meet(Span_part part, const kernel::Time_window& times, const Element& of_a, const Element& of_b)
  {
    for_triangles(0, of_a, [&](const Triangle& a) {
      for_triangles(1, of_b, [&](const Triangle& b) { meet(part, times, a, b); });
    });
  }

  /// Whether elements that were taken in may meet at t = 0; told once. All others are apart then.
  bool is_start_in_doubt() { return std::exchange(is_start_in_doubt_, false); }

  /// Leaves all that may meet later than a contact at t = 0.
  void end() { best_before_ = latest_ = -std::numeric_limits<double>::infinity(); }

  /// Whether anything waits to be decided.
  bool is_any_undecided() const { return !candidates_.empty(); }

  /// Decides what may meet before such a share of the span.
  void decide_until(double share)
  {
    while (!candidates_.empty() && candidates_.front().from() <= share) {
      std::ranges::pop_heap(candidates_, std::ranges::greater(), &Candidate::from);
      const Candidate next = candidates_.back();
      candidates_.pop_back();
      if (next.from() > latest_) continue;
      if (next.feature == Candidate::all)
        for (int feature = 0; feature < Candidate::all; ++feature) add(next, feature, false);
      else if (!next.is_sharp)
        add(next, next.feature, true);
      else
        decide(next.features(), span_of(next.part));
    }
  }

  const Query_statistics& counts() const { return counts_; }
  void clear_counts() { counts_ = {}; }

 private:
  using Vertex = kernel::Vertex;

  /// A pair of features that has been decided over a span: triangles share corners and edges.
  struct Decided {
    kernel::Moving_kind kind;
    int body;
    std::array<Index, 4> corner;
    std::uint64_t m;
    unsigned k;

    auto operator<=>(const Decided&) const = default;
  };
  /// A time of a part of the span as one of the whole.
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
    bool is_sharp = false;  ///< times of features are by axes of about these times

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

  /// An element as triangles: one, or, of corners on one line, its edges.
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

  /// Body of corner k.
  static int body_of(const Moving_features& features, int k)
  {
    if (features.kind == kernel::Moving_kind::vertex_face) return k == 0 ? features.body : 1 - features.body;
    return k < 2 ? 0 : 1;
  }

  /// When the features may meet within these times of a span, by axes of the middle of them.
  kernel::Time_window near(const Moving_features& features, const kernel::Motion_span& span,
                           kernel::Time_window near) const
  {
    const kernel::Motion_span::Maps maps = span.about(0.5 * (near.from + near.until));
    std::array<Vertex, 4> p, image;
    for (int k = 0; k < 4; ++k) {
      const int body = body_of(features, k);
      const kernel::Vector at = tree_[body]->local(features.corner[k]);
      p[k] = {at[0], at[1], at[2]};
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
      take({side(0, 1), side(2, 3)}, nullptr, span.placed(0, std::array{p[0], p[1]}),
           span.placed(1, std::array{p[2], p[3]}));
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

  /// Finds the first contact of two features in a part of the span, exactly.
  void decide(const Moving_features& features, const kernel::Motion_span& span)
  {
    Decided now{features.kind, features.body, features.corner, span.m(), span.k()};
    if (features.kind == kernel::Moving_kind::edge_edge)
      for (const int k : {0, 2})
        if (now.corner[k] > now.corner[k + 1]) std::swap(now.corner[k], now.corner[k + 1]);
    if (!decided_.insert(now).second) return;
    ++counts_.exact_fallbacks;
    const auto vertex = [&](int k) -> const Vertex& {
      return tree_[body_of(features, k)]->model().vertices()[features.corner[k]];
    };
    int least = 0;
    for (int k = 0; k < 4; ++k) least = kernel::Pair_motion::exponent_of(vertex(k), least);
    std::array<kernel::Form_vector, 4> points;
    for (int k = 0; k < 4; ++k) points[k] = motion().image(body_of(features, k), vertex(k), least);
    std::optional<kernel::Time_root> time =
        kernel::Exact_motion(features.kind, std::move(points), motion().square())
            .first_contact({kernel::Integer(static_cast<unsigned long>(span.m())), span.k()});
    if (!time || (best_ && !time->is_before(best_->time))) return;
    best_before_ = kernel::bounds_about(*time).hi;
    latest_ = span_->share_before(best_before_);
    best_ = First_meeting{std::move(*time), features};
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
  std::array<std::optional<kernel::Motion_span>, 2> half_;  // made when first asked for
  double latest_ = std::numeric_limits<double>::infinity();
  bool is_start_in_doubt_ = false;
};

}  // namespace tetracone::tetratree

#endif
