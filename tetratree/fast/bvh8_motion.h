#ifndef TETRACONE_TETRATREE_FAST_BVH8_MOTION_H
#define TETRACONE_TETRATREE_FAST_BVH8_MOTION_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/first_contact.h"
#include "tetracone/kernel/motion/motion_exact.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/query_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
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

/// The first contact of the surfaces of two moving `Bvh8`, exactly. Build once, ask for many motions.
///
/// Surfaces that share no point at t = 0 first meet where a vertex of one meets a triangle of the other, or an edge an
/// edge. Pairs of boxes are followed over spans of time, the earliest first: those that stay apart in a span
/// (`Motion_span`) are gone; of others a box is opened or the span is halved, whichever is more than the other. Pairs of
/// triangles that stay near are decided in integers, over the span alone. The search ends where the first contact found
/// is not after the start of any span left.
///
/// Both trees must outlive the query object. Making it and every query throw kernel::Unsound_floating_point when floating
/// point is not as exact answers need it.
class Bvh8_motion {
 public:
  /// Requires trees whose elements are triangles, or faces of corners on one line.
  Bvh8_motion(const Bvh8& a, const Bvh8& b) : tree_{&a, &b} { kernel::require_exact_arithmetic(); }

  /// Nothing where the surfaces never meet. Requires that they share no point at t = 0.
  std::optional<First_meeting> operator()(const kernel::Body_motion& a, const kernel::Body_motion& b)
  {
    kernel::require_sound_floating_point();
    if (tree_[0]->empty() || tree_[1]->empty()) return std::nullopt;
    motion_.emplace(a, b);
    spans_.clear();
    queue_.clear();
    best_.reset();
    best_before_ = std::numeric_limits<double>::infinity();
    spans_.push_back({kernel::Motion_span(*motion_, units(0), units(1)), {}});
    search();
    return std::exchange(best_, std::nullopt);
  }

  const Query_statistics& counts() const { return counts_; }
  void clear_counts() { counts_ = {}; }

 private:
  using Box = Index;
  using Vertex = kernel::Vertex;

  /// A box, with its axes.
  struct Part {
    Box box;
    kernel::Moving_box hull;
    std::array<Vertex, 3> axis;
    double size;
    bool is_leaf;
  };
  struct Pair {
    double start;
    Index span;
    std::array<Box, 2> box;
  };
  struct Span {
    kernel::Motion_span maps;
    std::array<Index, 2> half;  // 0: not made
  };
  struct Triangle {
    std::array<Index, 3> corner;
    std::array<Vertex, 3> local;
    Index face;
  };

  static constexpr unsigned most_halvings = 50;

  kernel::Motion_units units(int body) const { return {tree_[body]->scale().origin, tree_[body]->scale().unit}; }

  Part part(int body, Box box) const
  {
    const Bvh8_node& node = tree_[body]->node(box / 8);
    const int lane = int(box % 8);
    Part part{box, {}, {}, 0, node.is_leaf(lane)};
    for (int i = 0; i < 3; ++i) {
      part.hull.centre[i] = double(node.boxes.origin[i]) + double(node.boxes.centre[i][lane]);
      part.size += node.boxes.extent[i][lane];
      for (int k = 0; k < 3; ++k) {
        part.axis[i][k] = node.boxes.axis[i][k][lane];
        part.hull.half_edge[i][k] = part.axis[i][k] * double(node.boxes.extent[i][lane]);
      }
    }
    return part;
  }

  void search()
  {
    follow({0, 0, {0, 0}});
    while (!queue_.empty() && queue_.front().start < best_before_) {
      std::pop_heap(queue_.begin(), queue_.end(), is_later);
      const Pair pair = queue_.back();
      queue_.pop_back();
      split(pair);
    }
  }

  static bool is_later(const Pair& x, const Pair& y)
  {
    return x.start != y.start ? x.start > y.start : x.span < y.span;
  }

  /// Queues the pair unless it stays apart.
  void follow(const Pair& pair)
  {
    const Part a = part(0, pair.box[0]), b = part(1, pair.box[1]);
    ++counts_.box_tests;
    if (stay_apart(spans_[pair.span].maps, a, b)) return;
    queue_.push_back(pair);
    std::push_heap(queue_.begin(), queue_.end(), is_later);
  }

  /// Takes the pair to smaller ones.
  void split(const Pair& pair)
  {
    const Part a = part(0, pair.box[0]), b = part(1, pair.box[1]);
    const kernel::Motion_span& span = spans_[pair.span].maps;
    const double of_a = a.size * span.scale(0), of_b = b.size * span.scale(1),
                 size = a.is_leaf && !b.is_leaf   ? of_b
                        : b.is_leaf && !a.is_leaf ? of_a
                                                  : kernel::maximum(of_a, of_b),
                 way = span.way(a.hull.centre, b.hull.centre) + a.size * span.turn(0) + b.size * span.turn(1);
    ++counts_.pairs_visited;
    const bool ends = a.is_leaf && b.is_leaf;
    // What is less than doubles tell apart is not worth another halving.
    const double short_way = kernel::maximum(ends ? 0.125 * size : size, 8 * span.resolution());
    if (span.k() < most_halvings && !(way <= short_way)) {
      for (int half = 0; half < 2; ++half) {
        const Index next = half_of(pair.span, half);
        if (spans_[next].maps.start() < best_before_) follow({spans_[next].maps.start(), next, pair.box});
      }
      return;
    }
    if (ends) {
      meet_leaves(spans_[pair.span].maps, pair.box);
      return;
    }
    const int body = b.is_leaf || (!a.is_leaf && of_a > of_b) ? 0 : 1;
    const Index child = tree_[body]->child(pair.box[body] / 8, int(pair.box[body] % 8));
    for (int lane = 0; lane < tree_[body]->node(child).boxes.lane_count; ++lane) {
      Pair next = pair;
      next.box[body] = 8 * child + Box(lane);
      follow(next);
    }
  }

  Index half_of(Index span, int half)
  {
    if (spans_[span].half[half] == 0) {
      spans_.push_back({spans_[span].maps.half(half == 1), {}});
      spans_[span].half[half] = Index(spans_.size() - 1);
    }
    return spans_[span].half[half];
  }

  static Vertex scaled_to_one(const Vertex& v)
  {
    const double largest = kernel::maximum(std::abs(v[0]), std::abs(v[1]), std::abs(v[2]));
    return {v[0] / largest, v[1] / largest, v[2] / largest};
  }

  /// Whether boxes are certainly apart all the time of the span: along the line of their centres, and the axes that part
  /// them in the middle of it.
  static bool stay_apart(const kernel::Motion_span& span, const Part& a, const Part& b)
  {
    const auto& maps = span.at_middle();
    const auto apart = [&](const Vertex& axis) { return span.apart_along(scaled_to_one(axis), a.hull, b.hull); };
    if (apart(span.between(maps, a.hull.centre, b.hull.centre))) return true;
    std::array<std::array<Vertex, 3>, 2> edge;
    for (int k = 0; k < 3; ++k) {
      edge[0][k] = span.direction(maps, 0, a.axis[k]);
      edge[1][k] = span.direction(maps, 1, b.axis[k]);
    }
    for (const auto& e : edge)
      for (int k = 0; k < 3; ++k)
        if (apart(kernel::cross(e[(k + 1) % 3], e[(k + 2) % 3]))) return true;
    for (const Vertex& of_a : edge[0])
      for (const Vertex& of_b : edge[1])
        if (apart(kernel::cross(of_a, of_b))) return true;
    return false;
  }

  void meet_leaves(const kernel::Motion_span& span, const std::array<Box, 2>& box)
  {
    for (Index i = 0; i < tree_[0]->leaf_count(box[0] / 8, int(box[0] % 8)); ++i)
      for (Index j = 0; j < tree_[1]->leaf_count(box[1] / 8, int(box[1] % 8)); ++j)
        for_triangles(0, tree_[0]->element(box[0] / 8, int(box[0] % 8), i), [&](const Triangle& a) {
          for_triangles(1, tree_[1]->element(box[1] / 8, int(box[1] % 8), j),
                        [&](const Triangle& b) { meet(span, a, b); });
        });
  }

  /// An element as triangles: one, or, of corners on one line, its edges.
  template <class What>
  void for_triangles(int body, const Element& element, const What& what) const
  {
    const auto call = [&](Index p, Index q, Index r) {
      Triangle t{{p, q, r}, {}, element.face};
      for (int k = 0; k < 3; ++k) {
        const kernel::Vector at = tree_[body]->local(t.corner[k]);
        t.local[k] = {at[0], at[1], at[2]};
      }
      what(t);
    };
    if (!element.is_whole_face()) return call(element.corner[0], element.corner[1], element.corner[2]);
    const auto from = tree_[body]->model().covering().from(element.face),
               to = tree_[body]->model().covering().to(element.face);
    for (std::size_t k = 0; k < from.size(); ++k) call(from[k], to[k], to[k]);
  }

  /// Tries all vertices and edges of two triangles.
  void meet(const kernel::Motion_span& span, const Triangle& a, const Triangle& b)
  {
    ++counts_.triangle_tests;
    const std::array<const Triangle*, 2> both = {&a, &b};
    const auto& maps = span.at_middle();
    std::array<std::array<Vertex, 3>, 2> edge;
    for (int body = 0; body < 2; ++body)
      for (int k = 0; k < 3; ++k)
        edge[body][k] =
            span.direction(maps, body, kernel::difference(both[body]->local[(k + 1) % 3], both[body]->local[k]));
    const std::array<Vertex, 2> normal = {kernel::cross(edge[0][0], edge[0][1]), kernel::cross(edge[1][0], edge[1][1])};

    const auto apart = [&](const Vertex& axis, std::span<const Vertex> of_a, std::span<const Vertex> of_b) {
      return span.apart_along(scaled_to_one(axis), kernel::Moving_hull{of_a}, kernel::Moving_hull{of_b});
    };
    for (int body = 0; body < 2; ++body) {
      if (apart(normal[body], a.local, b.local)) return;
      for (const Vertex& e : edge[body])
        if (apart(kernel::cross(normal[body], e), a.local, b.local)) return;
    }
    for (int body = 0; body < 2; ++body)
      for (int k = 0; k < 3; ++k) {
        const std::span<const Vertex> vertex(&both[body]->local[k], 1), face(both[1 - body]->local);
        const auto parts = [&](const Vertex& axis) {
          return body == 0 ? apart(axis, vertex, face) : apart(axis, face, vertex);
        };
        const auto& sides = edge[1 - body];
        const Vertex& n = normal[1 - body];
        if (parts(n) || parts(kernel::cross(n, sides[0])) || parts(kernel::cross(n, sides[1])) ||
            parts(kernel::cross(n, sides[2])))
          continue;
        const auto& corner = both[1 - body]->corner;
        decide(span, {kernel::Moving_kind::vertex_face,
                      body,
                      {a.face, b.face},
                      {both[body]->corner[k], corner[0], corner[1], corner[2]}});
      }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const std::array<Vertex, 2> of_a = {a.local[i], a.local[(i + 1) % 3]},
                                    of_b = {b.local[j], b.local[(j + 1) % 3]};
        const Vertex n = kernel::cross(edge[0][i], edge[1][j]);
        const auto parts = [&](const Vertex& axis) { return apart(axis, of_a, of_b); };
        if (parts(n) || parts(kernel::cross(n, edge[0][i])) || parts(kernel::cross(n, edge[1][j]))) continue;
        decide(span, {kernel::Moving_kind::edge_edge,
                      0,
                      {a.face, b.face},
                      {a.corner[i], a.corner[(i + 1) % 3], b.corner[j], b.corner[(j + 1) % 3]}});
      }
  }

  /// Finds the first contact of two features in the span, exactly.
  void decide(const kernel::Motion_span& span, const Moving_features& features)
  {
    ++counts_.exact_fallbacks;
    const bool is_vertex = features.kind == kernel::Moving_kind::vertex_face;
    const auto body = [&](int k) {
      if (is_vertex) return k == 0 ? features.body : 1 - features.body;
      return k < 2 ? 0 : 1;
    };
    const auto vertex = [&](int k) -> const Vertex& { return tree_[body(k)]->model().vertices()[features.corner[k]]; };
    int least = 0;
    for (int k = 0; k < 4; ++k) least = kernel::Pair_motion::exponent_of(vertex(k), least);
    std::array<kernel::Form_vector, 4> points;
    for (int k = 0; k < 4; ++k) points[k] = motion_->image(body(k), vertex(k), least);
    std::optional<kernel::Time_root> time =
        kernel::Exact_motion(features.kind, std::move(points), motion_->square())
            .first_contact({kernel::Integer(static_cast<unsigned long>(span.m())), span.k()});
    if (!time || (best_ && !time->is_before(best_->time))) return;
    best_before_ = kernel::bounds_about(*time).hi;
    best_ = First_meeting{std::move(*time), features};
  }

  std::array<const Bvh8*, 2> tree_;
  Query_statistics counts_;

  std::optional<kernel::Pair_motion> motion_;
  std::deque<Span> spans_;
  std::vector<Pair> queue_;
  std::optional<First_meeting> best_;
  double best_before_ = 0;  // not before the best
};

}  // namespace tetracone::tetratree

#endif
