#ifndef TETRACONE_TETRATREE_CERTIFICATE_GROUP_HULL_H
#define TETRACONE_TETRATREE_CERTIFICATE_GROUP_HULL_H

#include "tetracone/kernel/predicate/hull_separation.h"
#include "tetracone/tetratree/certificate/group_tree.h"
#include "tetracone/tetratree/fast/support_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// The convex hull of corners of a body, with the points beyond them along `recession` where there is one. The corners
/// are a list, or all vertices of a group. Those of a group are looked up in the tree, since most are far from last.
class Group_hull {
 public:
  /// The hull of a list of points, at least one. All must outlive this object.
  Group_hull(const kernel::Hull_points& points, std::span<const std::uint32_t> corners,
             const kernel::Rounded_vector* recession = nullptr)
      : points_(&points), corners_(corners), recession_(recession)
  {}
  /// The hull of a group of the body whose vertices the points are. Both must outlive this object.
  Group_hull(const kernel::Hull_points& points, Group_tree& groups, Box_id box) : points_(&points)
  {
    if (groups.is_piece(box) || !points.rounded_map()) {
      corners_ = groups.group(box).corners;
    } else {
      tree_ = &groups.tree();
      box_ = box;
    }
  }

  const kernel::Hull_points& points() const { return *points_; }
  const kernel::Rounded_vector* recession() const { return recession_; }

  /// Calls each(v) for a few corners v.
  template <class Each>
  void for_few(const Each& each) const
  {
    constexpr std::size_t few = 8;  // corners, about
    const std::size_t step = kernel::maximum(corners_.size() / few, std::size_t(1));
    for (std::size_t c = 0; c < corners_.size(); c += step) each(corners_[c]);
    if (!tree_) return;
    const Bvh8_node& node = tree_->node(tree_->child(box_));
    for (int lane = 0; lane < node.boxes.lane_count; ++lane) {
      bool is_first = true;
      tree_->for_vertices(tree_->elements()[node.first[std::size_t(lane)]], [&](Index v) {
        if (std::exchange(is_first, false)) each(v);
      });
    }
  }

  /// Returns the corner that is last along a direction, in doubles. `known` are some corners; one of them that is near
  /// the last makes it faster.
  std::uint32_t last(const kernel::Rounded_vector& way, std::span<const std::uint32_t> known = {}) const
  {
    std::uint32_t last = 0;
    double best = -HUGE_VAL;
    const auto look_at = [&](std::uint32_t v, double at) {
      if (!(at > best)) return;
      best = at;
      last = v;
    };
    for (const std::uint32_t v : known) look_at(v, kernel::dot(way, points_->rounded(v)));
    for_those_beyond(way, best, look_at);
    return last;
  }

  /// Calls each(v) for the corners v that may be the first (sign < 0) or the last (sign > 0) along m. All others are
  /// behind one of them by more than all rounding errors. It may call twice for a corner.
  template <class Each>
  void for_last(const kernel::Exact_vector& m, int sign, const Each& each) const
  {
    constexpr double least = 0x1p-100,  // the least size of m at which underflow is below the slack
        least_point = 0x1p-900;         // the least coordinate at which it is
    // Upper bound of the error of two scalar products, relative to their terms. Numbers have an error of 2 of 2^-53
    // each, and products and sums 3: 14 of 32, counted by hand (verify/proofs/other_constants.h).
    constexpr double rounding = 0x1p-48;
    const kernel::Rounded_vector way = {sign * m[0].to_double(), sign * m[1].to_double(), sign * m[2].to_double()};
    const double size = std::abs(way[0]) + std::abs(way[1]) + std::abs(way[2]);
    double behind = -HUGE_VAL;
    if (size >= least && points_->largest() >= least_point)
      behind =
          kernel::dot(way, points_->rounded(last(way))) - (rounding * points_->largest() + 4 * points_->error()) * size;
    for_those_beyond(way, behind, [&](std::uint32_t v, double at) {
      if (!(at < behind)) each(v);
    });
  }

 private:
  /// Calls each(v, at) for all corners whose product with the direction, rounded to `at`, may be above `limit`, and for
  /// some others. A call may raise the limit.
  template <class Each>
  void for_those_beyond(const kernel::Rounded_vector& way, const double& limit, const Each& each) const
  {
    const auto look_at = [&](std::uint32_t v) { each(v, kernel::dot(way, points_->rounded(v))); };
    for (const std::uint32_t v : corners_) look_at(v);
    if (tree_) Below(*tree_, *points_, way).visit(box_, limit, look_at);
  }

  /// The boxes of a tree, along a direction of the placed body.
  class Below {
   public:
    Below(const Bvh8& tree, const kernel::Hull_points& points, const kernel::Rounded_vector& way) : tree_(&tree)
    {
      const auto& map = *points.rounded_map();
      const kernel::Local_scale& scale = tree.scale();
      kernel::Rounded_vector turned{};
      double terms = 0;  // of all sums, upper bound
      for (std::size_t k = 0; k < 3; ++k) {
        double most = std::abs(map[4 * k + 3]);
        for (std::size_t c = 0; c < 3; ++c) {
          turned[c] += way[k] * map[4 * k + c];
          most += std::abs(map[4 * k + c]) * (std::abs(scale.origin[c]) + farthest * scale.unit);
        }
        terms += std::abs(way[k]) * most;
      }
      length_ = scale.unit * (std::abs(turned[0]) + std::abs(turned[1]) + std::abs(turned[2]));
      start_ = kernel::dot(turned, scale.origin) + (way[0] * map[3] + way[1] * map[7] + way[2] * map[11]) +
               of_boxes * length_ + of_places * terms;
      const bool is_in_range = length_ >= shortest && terms < HUGE_VAL;
      if (!is_in_range) start_ = HUGE_VAL;  // no box ends below a limit
      for (std::size_t c = 0; c < 3; ++c) direction_[c] = is_in_range ? float(scale.unit * turned[c] / length_) : 0;
    }

    /// Calls look_at(v) for the vertices in a box, except in boxes that end below the limit.
    template <class Look_at>
    void visit(Box_id box, const double& limit, const Look_at& look_at) const
    {
      const Index child = tree_->child(box);
      const Bvh8_node& node = tree_->node(child);
      std::array<float, kernel::lanes> reach;
      Support_table::find_reach(node.boxes, direction_, reach);
      const auto visit_lane = [&](int lane) {
        if (start_ + double(reach[std::size_t(lane)]) * length_ < limit) return;
        if (node.is_leaf(lane))
          tree_->for_vertices(tree_->element({child, lane}), look_at);
        else
          visit({child, lane}, limit, look_at);
      };
      // The farthest box is visited first: the others are behind its corners then, mostly.
      const int count = node.boxes.lane_count,
                first = int(std::max_element(reach.begin(), reach.begin() + count) - reach.begin());
      visit_lane(first);
      for (int lane = 0; lane < count; ++lane)
        if (lane != first) visit_lane(lane);
    }

   private:
    // Upper bounds of errors. That of a box's reach is relative to the body's unit and the direction. It is eight times
    // `Support_table::box_reach_rounding`, since the direction is rounded, too. That of places is relative to `terms`:
    // 12 roundings of 2^-53, counted by hand, and it is far above underflow (verify/proofs/other_constants.h).
    static constexpr double of_boxes = 8 * Support_table::box_reach_rounding, of_places = 0x1p-44;
    static constexpr double farthest = 2;         // upper bound of local coordinates
    static constexpr double shortest = 0x1p-500;  // the least length at which underflow is far below the errors

    const Bvh8* tree_;
    double start_, length_;
    std::array<float, 3> direction_;
  };

  const kernel::Hull_points* points_;
  std::span<const std::uint32_t> corners_;
  const kernel::Rounded_vector* recession_ = nullptr;
  const Bvh8* tree_ = nullptr;  // of a group
  Box_id box_;
};

/// Two hulls, B beyond A.
struct Hull_pair {
  Group_hull a, b;
};

/// Returns the least (sign < 0) or largest product of m with the corners, exactly. It leaves out the recession.
inline kernel::Exact_number extent_of(const Group_hull& hull, const kernel::Exact_vector& m, int sign)
{
  std::optional<kernel::Exact_number> best;
  hull.for_last(m, sign, [&](std::uint32_t v) {
    kernel::Exact_number at = kernel::dot(m, hull.points().exact(v));
    if (!best || (sign < 0 ? at < *best : at > *best)) best = std::move(at);
  });
  return *best;
}

/// Returns a direction as kernel::direction_between does, for hulls of many corners. It searches with a few corners,
/// and adds those that the direction found does not separate. Returns nothing also where that takes too many rounds.
inline std::optional<kernel::Rounded_vector> direction_by_few(std::span<const Hull_pair> pairs, double distance)
{
  using kernel::Rounded_vector;
  constexpr int most_rounds = 12;  // searches
  std::vector<std::array<std::vector<std::uint32_t>, 2>> some(pairs.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    pairs[p].a.for_few([&](std::uint32_t v) { some[p][0].push_back(v); });
    pairs[p].b.for_few([&](std::uint32_t v) { some[p][1].push_back(v); });
  }
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<kernel::Hull_pair> of_some;
    of_some.reserve(pairs.size());
    for (std::size_t p = 0; p < pairs.size(); ++p)
      of_some.push_back(
          {{&pairs[p].a.points(), some[p][0], pairs[p].a.recession()}, {&pairs[p].b.points(), some[p][1]}});
    const auto z = kernel::direction_between(of_some, distance);
    if (!z) return std::nullopt;
    const Rounded_vector back = {-(*z)[0], -(*z)[1], -(*z)[2]};
    bool is_between = true;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const std::uint32_t a = pairs[p].a.last(*z, some[p][0]), b = pairs[p].b.last(back, some[p][1]);
      if (kernel::dot(*z, pairs[p].b.points().rounded(b)) - kernel::dot(*z, pairs[p].a.points().rounded(a)) >
          distance * std::sqrt(kernel::dot(*z, *z)))
        continue;
      is_between = false;
      some[p][0].push_back(a);
      some[p][1].push_back(b);
    }
    if (is_between) return z;
  }
  return std::nullopt;
}

}  // namespace tetracone::tetratree

#endif
