#ifndef TETRACONE_TETRATREE_FAST_BVH8_MOTION_H
#define TETRACONE_TETRATREE_FAST_BVH8_MOTION_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/fast/element_gap.h"
#include "tetracone/tetratree/fast/moving_features.h"
#include "tetracone/tetratree/fast/separating_direction.h"
#include "tetracone/tetratree/fast/span_reference.h"
#include "tetracone/tetratree/query_statistics.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetracone::tetratree {

/// The first contact of the surfaces of two moving `Bvh8`, exactly. Build once, ask for many motions.
///
/// Surfaces that share no point at t = 0 first meet where a vertex of one meets a triangle of the other, or an edge an
/// edge. A span of time in which one plane parts the bodies is done with. In another, parts of a node are followed
/// against a box of the other body: those that stay apart are gone, by a certified gap in a pose near all of it
/// (`Span_reference`) or, where there is none, by the span's own coefficients (`Motion_span`); of others a box is opened,
/// or they wait for the halves of the span, whichever is more than the other. Pairs of triangles that stay near are
/// decided in integers, over the span alone. The first half is done before the second, which is left where the first
/// contact found is not after its start.
///
/// Both trees must outlive the query object. Making it and every query throw kernel::Unsound_floating_point when floating
/// point is not as exact answers need it.
class Bvh8_motion {
 public:
  /// Requires trees whose elements are triangles, or faces of corners on one line.
  Bvh8_motion(const Bvh8& a, const Bvh8& b) : tree_{&a, &b}, separating_direction_(a, b), features_(a, b)
  {
    kernel::require_exact_arithmetic();
  }

  /// Nothing where the surfaces never meet. Requires that they share no point at t = 0.
  std::optional<First_meeting> operator()(const kernel::Body_motion& a, const kernel::Body_motion& b)
  {
    kernel::require_sound_floating_point();
    if (tree_[0]->empty() || tree_[1]->empty()) return std::nullopt;
    features_.begin(a, b);
    search(whole_span(a, b), std::array{Near{0, 0, 0, 1}});
    return features_.take_first();
  }

  Query_statistics counts() const
  {
    Query_statistics all = counts_;
    all += features_.counts();
    return all;
  }
  void clear_counts()
  {
    counts_ = {};
    features_.clear_counts();
  }

 private:
  using Box = Index;  // lane k of node n: 8 n + k
  using Vertex = kernel::Vertex;

  /// A box, with its axes.
  struct Part {
    kernel::Moving_box hull;
    std::array<Vertex, 3> axis;
  };
  /// Parts of a node of body `body`, as bits, near a box of the other.
  struct Near {
    Index node;
    Box other;
    std::uint8_t body, lanes;
  };
  /// A span of time, and what is to be followed in its halves.
  struct Span {
    explicit Span(const kernel::Motion_span& all) : reference(all), maps(all) {}

    Span_reference reference;
    kernel::Motion_span maps;
    std::vector<Near> later{};
  };
  static constexpr int most_directions = 8;
  static constexpr unsigned most_halvings = 50;
  static constexpr double share_of_boxes = 0.4, share_of_leaves = 0.002;  // so far they may move in a span

  kernel::Motion_units units(int body) const { return {tree_[body]->scale().origin, tree_[body]->scale().unit}; }

  kernel::Motion_span whole_span(const kernel::Body_motion& a, const kernel::Body_motion& b)
  {
    const auto &of_a = a.ends(), &of_b = b.ends();
    if (of_a && of_b)
      if (const auto span = kernel::Motion_span::of_lines(*of_a, units(0), *of_b, units(1))) return *span;
    return kernel::Motion_span(features_.motion(), units(0), units(1));
  }

  const Bvh8_node& node_of(int body, Box box) const { return tree_[body]->node(box / 8); }
  bool is_leaf(int body, Box box) const { return node_of(body, box).is_leaf(int(box % 8)); }

  /// The sum of the extents, in common units.
  double size_of(const kernel::Motion_span& span, int body, Box box) const
  {
    const auto& extent = node_of(body, box).boxes.extent;
    const auto lane = int(box % 8);
    return span.scale(body) * (double(extent[0][lane]) + double(extent[1][lane]) + double(extent[2][lane]));
  }

  Part part(int body, Box box) const
  {
    const kernel::Obb8& boxes = node_of(body, box).boxes;
    const int lane = int(box % 8);
    Part part{{kernel::centre_of(boxes, lane), {}}, {}};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        part.axis[i][k] = boxes.axis[i][k][lane];
        part.hull.half_edge[i][k] = part.axis[i][k] * double(boxes.extent[i][lane]);
      }
    return part;
  }

  /// Follows the parts in a span of time, and then those that are left for its halves in these.
  void search(const kernel::Motion_span& all, std::span<const Near> near)
  {
    if (separating_direction_(all, most_directions)) return;
    Span span(all);
    for (const Near& parts : near) follow(span, parts);
    for (const bool is_second : {false, true}) {
      if (span.later.empty()) return;
      const kernel::Motion_span half = span.maps.half(is_second);
      if (half.start() < features_.before()) search(half, span.later);
    }
  }

  /// Takes the parts that are not found to stay apart to smaller ones, or leaves them for later.
  void follow(Span& span, Near near)
  {
    counts_.box_tests += std::uint64_t(std::popcount(near.lanes));
    const double way =
        span.reference.is_certifiable() ? leave_parts(span.reference, near) : leave_parts(span.maps, near);
    if (near.lanes == 0) return;
    ++counts_.pairs_visited;
    const unsigned leaves = leaves_of(near);
    for (const unsigned lanes : {leaves, near.lanes & ~leaves}) {
      Near some = near;
      some.lanes = std::uint8_t(lanes);
      if (lanes == 0) continue;
      if (is_long(span.maps, some, way, lanes == leaves))
        span.later.push_back(some);
      else if (lanes == leaves)
        meet_leaves(span.maps, some);
      else
        open(span, some);
    }
  }

  /// Takes those away that stay apart. Returns about how far the others move against each other, in the span's units.
  double leave_parts(const Span_reference& reference, Near& near)
  {
    const Bvh8_node &node = tree_[near.body]->node(near.node), &from = node_of(1 - near.body, near.other);
    const int lane = int(near.other % 8);
    const float apex =
        from.is_leaf(lane) ? kernel::apex_of(Bvh8_node::apex(from.child[std::size_t(lane)])) : kernel::no_apex;
    const auto found = reference.parts(near.body, node.boxes, near.lanes, from.boxes, lane, apex);
    near.lanes = std::uint8_t(near.lanes & ~found.apart);
    near.lanes = std::uint8_t(near.lanes & ~leaves_apart(reference, near));
    return found.way;
  }

  /// Where both are leaves: the parts whose triangles are apart.
  unsigned leaves_apart(const Span_reference& reference, const Near& near)
  {
    unsigned apart = 0;
    for (unsigned left = leaves_of(near); left != 0; left &= left - 1) {
      const int lane = std::countr_zero(left);
      const auto are_apart = [&](const Element& a, const Element& b) { return elements_apart(reference, a, b); };
      if (all_elements(near, lane, are_apart)) apart |= 1u << lane;
    }
    return apart;
  }

  bool elements_apart(const Span_reference& reference, const Element& a, const Element& b)
  {
    ++counts_.leaf_pairs;
    const Element_gap gap = element_gap(*tree_[0], a, *tree_[1], b, reference.frame());
    return gap.low > 0 && reference.are_apart(gap.low, gap.axis, local_corners(*tree_[0], a.corner),
                                              local_corners(*tree_[1], b.corner));
  }

  /// The parts that are leaves, where the box of the other body is one.
  unsigned leaves_of(const Near& near) const
  {
    return is_leaf(1 - near.body, near.other) ? near.lanes & tree_[near.body]->node(near.node).boxes.marked : 0;
  }

  /// Whether holds(element of A, element of B) for all pairs of elements of two leaves, in turn, until one does not.
  template <class Holds>
  bool all_elements(const Near& near, int lane, const Holds& holds) const
  {
    const Box own = 8 * near.node + Box(lane), box_a = near.body == 0 ? own : near.other,
              box_b = near.body == 0 ? near.other : own;
    const int lane_a = int(box_a % 8), lane_b = int(box_b % 8);
    for (Index i = 0; i < tree_[0]->leaf_count(box_a / 8, lane_a); ++i)
      for (Index j = 0; j < tree_[1]->leaf_count(box_b / 8, lane_b); ++j)
        if (!holds(tree_[0]->element(box_a / 8, lane_a, i), tree_[1]->element(box_b / 8, lane_b, j))) return false;
    return true;
  }

  double leave_parts(const kernel::Motion_span& span, Near& near)
  {
    const Part other = part(1 - near.body, near.other);
    double way = 0;
    unsigned apart = 0;
    for (unsigned left = near.lanes; left != 0; left &= left - 1) {
      const int lane = std::countr_zero(left);
      const Part own = part(near.body, 8 * near.node + Box(lane));
      const Part &a = near.body == 0 ? own : other, &b = near.body == 0 ? other : own;
      way = kernel::maximum(way, span.way(a.hull.centre, b.hull.centre));
      if (stay_apart(span, a, b)) apart |= 1u << lane;
    }
    near.lanes = std::uint8_t(near.lanes & ~apart);
    return way;
  }

  /// Whether the parts move too far in the span for their size.
  bool is_long(const kernel::Motion_span& span, const Near& near, double way, bool are_leaves) const
  {
    if (span.k() >= most_halvings) return false;
    const double of_other = size_of(span, 1 - near.body, near.other);
    double size = 0;
    for (unsigned left = near.lanes; left != 0; left &= left - 1) {
      const Box box = 8 * near.node + Box(std::countr_zero(left));
      const double of_box = size_of(span, near.body, box);
      size = kernel::maximum(size, opens_own(near, box, of_box, of_other) ? of_box : of_other);
    }
    way += size * (span.turn(0) / span.scale(0) + span.turn(1) / span.scale(1));
    // What is less than doubles tell apart is not worth another halving.
    return !(way <= kernel::maximum((are_leaves ? share_of_leaves : share_of_boxes) * size, 8 * span.resolution()));
  }

  /// Whether the part is to be opened, and not the box of the other body.
  bool opens_own(const Near& near, Box box, double size, double of_other) const
  {
    return !is_leaf(near.body, box) && (is_leaf(1 - near.body, near.other) || size > of_other);
  }

  void open(Span& span, const Near& near)
  {
    const double of_other = size_of(span.maps, 1 - near.body, near.other);
    for (unsigned left = near.lanes; left != 0; left &= left - 1) {
      const Box box = 8 * near.node + Box(std::countr_zero(left));
      const bool own = opens_own(near, box, size_of(span.maps, near.body, box), of_other);
      const int body = own ? near.body : 1 - near.body;
      const Box opened = own ? box : near.other;
      Near next;
      next.body = std::uint8_t(body);
      next.node = tree_[body]->child(opened / 8, int(opened % 8));
      next.other = own ? near.other : box;
      next.lanes = std::uint8_t((1u << tree_[body]->node(next.node).boxes.lane_count) - 1);
      follow(span, next);
    }
  }

  /// Whether boxes are certainly apart all the time of the span: along the line of their centres, and the axes that part
  /// them in the middle of it.
  static bool stay_apart(const kernel::Motion_span& span, const Part& a, const Part& b)
  {
    const auto& maps = span.at_middle();
    const auto apart = [&](const Vertex& axis) {
      return span.apart_along(kernel::scaled_to_one(axis), a.hull, b.hull);
    };
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

  void meet_leaves(const kernel::Motion_span& span, const Near& near)
  {
    for (unsigned left = near.lanes; left != 0; left &= left - 1)
      all_elements(near, std::countr_zero(left), [&](const Element& a, const Element& b) {
        features_.meet(span, a, b);
        return true;
      });
  }

  std::array<const Bvh8*, 2> tree_;
  Separating_direction separating_direction_;
  Moving_feature_search features_;
  Query_statistics counts_;
};

}  // namespace tetracone::tetratree

#endif
