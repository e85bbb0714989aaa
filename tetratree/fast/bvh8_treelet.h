#ifndef TETRACONE_TETRATREE_FAST_BVH8_TREELET_H
#define TETRACONE_TETRATREE_FAST_BVH8_TREELET_H

#include "tetracone/kernel/bound/oriented_box.h"
#include "tetracone/tetratree/fast/bvh8_elements.h"
#include "tetracone/tetratree/fast/bvh8_lane.h"
#include "tetracone/tetratree/fast/bvh8_node.h"
#include "tetracone/tetratree/fast/bvh8_options.h"
#include "tetracone/tetratree/fast/corner_set.h"
#include "tetracone/tetratree/fast/surface_area_heuristic.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tetracone::tetratree {

/// Makes all nodes of a few elements at once, so that they are well filled. It builds a binary tree by cuts of least
/// cost (`sah_weight`). Its parts become lanes by dynamic programming (Ylitie, Karras and Laine, HPG 2017, 3.1).
class Bvh8_treelet {
 public:
  /// The largest number of elements of a treelet.
  static constexpr Index most = 64;

  /// `leaf_ends` is as in `Bvh8_builder`.
  Bvh8_treelet(Bvh8_elements& elements, const Bvh8_options& options, std::vector<Index>& leaf_ends)
      : elements_(elements), options_(options), leaf_ends_(leaf_ends)
  {
    for (Index k = 0; k <= most; ++k) weights_[k] = float(sah_weight(int(k)));
  }

  /// Appends the nodes of elements first .. last to `nodes`, the top one first, and returns its number. Requires more
  /// elements than a leaf holds, and at most `most`.
  template <class Nodes>
  Index make(Index first, Index last, Nodes& nodes)
  {
    assert(last - first > options_.leaf_size && last - first <= most);
    first_ = first;
    count_ = last - first;
    corners_.gather(elements_, first, last);
    see_elements();
    sort_along_axes();
    part_count_ = 1;
    parts_[0] = {0, std::uint8_t(count_)};
    for (int v = 0; v < part_count_; ++v)
      if (!is_leaf(v)) cut(v);
    for (int v = part_count_; v-- > 0;) find_costs(v);
    order_elements();
    seen_in_.assign(corners_.points().size(), -1);
    return make_node(0, nodes);
  }

  std::size_t cuts() const { return cuts_; }

 private:
  using Four = Axis_bounds::Four;
  using Vector = kernel::Vector;

  /// Elements begin .. end of the order and, unless it is a leaf, the two parts that it is cut into.
  struct Part {
    std::uint8_t begin, end;
    std::uint8_t parts[2] = {0, 0};
    std::uint8_t lanes = 0;               // the cheapest number of lanes as a node
    float surface = 0;                    // half the surface of the box along the axes
    std::array<float, 9> cost{};          // the least cost of all nodes below, by the number of lanes that the part
                                          // takes
    std::array<std::uint8_t, 9> first{};  // how many of these lanes belong to the first part
  };

  bool is_leaf(int v) const { return std::size_t(parts_[v].end - parts_[v].begin) <= options_.leaf_size; }

  /// Finds the elements' bounds in the corners' principal frame: relative to their mean, divided by the root of their
  /// spread.
  void see_elements()
  {
    const kernel::Spread spread(corners_.points());
    // Squares underflow: the corners count as one point.
    const double scale = spread.size() > 0x1p-900 ? 1 / std::sqrt(spread.size()) : 0;
    const kernel::Matrix to_axes = scale * spread.principal_axes().transpose();
    at_.clear();
    for (const Vector& p : corners_.points()) {
      const Vector s = to_axes * (p - spread.mean);
      at_.push_back(Four{float(s[0]), float(s[1]), float(s[2]), 0});
    }
    for (Index k = 0; k < count_; ++k) {
      bounds_[k] = Axis_bounds();
      for (const std::uint32_t c : corners_.of(k)) bounds_[k].add(at_[c], at_[c]);
    }
  }

  /// Sorts elements along each axis, by the middles of their bounds.
  void sort_along_axes()
  {
    std::array<std::uint64_t, most> keys;
    for (int axis = 0; axis < 3; ++axis) {
      for (Index k = 0; k < count_; ++k) {
        const auto bits = std::bit_cast<std::uint32_t>(bounds_[k].low[axis] + bounds_[k].high[axis]);
        keys[k] = std::uint64_t(bits >> 31 ? ~bits : bits | 1u << 31) << 32 | k;  // in the order of the numbers
      }
      std::sort(keys.begin(), keys.begin() + count_);
      for (Index k = 0; k < count_; ++k) order_[axis][k] = std::uint8_t(keys[k]);
    }
  }

  /// Cuts a part in two between elements sorted along an axis, at the least cost (SAH).
  void cut(int v)
  {
    const int begin = parts_[v].begin, end = parts_[v].end, count = end - begin;
    int best_axis = 0, middle = begin + count / 2;
    if (count == 2) {
      Axis_bounds both = bounds_[order_[0][begin]];
      both.add(bounds_[order_[0][begin + 1]]);
      parts_[v].surface = both.half_surface();
    } else {
      ++cuts_;
      float least = std::numeric_limits<float>::infinity();
      const int fewest =
          kernel::maximum(1, count / 8);  // otherwise elements that span the whole part would be cut off one by one
      for (int axis = 0; axis < 3; ++axis) {
        const auto& order = order_[axis];
        std::array<float, most> after;
        Axis_bounds high;
        for (int k = end; k-- > begin;) {
          high.add(bounds_[order[k]]);
          after[k] = sah_cost(weights_[end - k], high);
        }
        parts_[v].surface = high.half_surface();
        Axis_bounds low;
        for (int k = begin + 1; k < end; ++k) {
          low.add(bounds_[order[k - 1]]);
          const float cost = sah_cost(weights_[k - begin], low) + after[k];
          if (cost < least && k - begin >= fewest && end - k >= fewest) {
            least = cost;
            best_axis = axis;
            middle = k;
          }
        }
      }
    }
    part_orders(begin, middle, end, best_axis);
    for (int side = 0; side < 2; ++side) {
      parts_[v].parts[side] = std::uint8_t(part_count_);
      parts_[part_count_++] =
          side == 0 ? Part{std::uint8_t(begin), std::uint8_t(middle)} : Part{std::uint8_t(middle), std::uint8_t(end)};
    }
  }

  /// Parts the orders of all axes: elements before the middle along `axis` come first along the others, too.
  void part_orders(int begin, int middle, int end, int axis)
  {
    for (int k = begin; k < end; ++k) is_before_[order_[axis][k]] = k < middle;
    for (int other = 0; other < 3; ++other) {
      if (other == axis) continue;
      auto& order = order_[other];
      std::array<std::uint8_t, most> later;
      int before = begin, after = 0;
      for (int k = begin; k < end; ++k) {
        const std::uint8_t e = order[k];
        order[before] = e;
        later[after] = e;
        before += is_before_[e];
        after += !is_before_[e];
      }
      std::copy_n(later.begin(), after, order.begin() + before);
    }
  }

  /// Finds the costs of a part as 1 to 8 lanes. Requires the costs of its own parts. A node costs the surface of its
  /// box times (opening_cost + its number of lanes).
  void find_costs(int v)
  {
    constexpr float impossible = std::numeric_limits<float>::infinity();
    Part& part = parts_[v];
    part.cost.fill(impossible);
    if (is_leaf(v)) {
      part.cost[1] = 0;
      return;
    }
    const Part &a = parts_[part.parts[0]], &b = parts_[part.parts[1]];
    for (std::size_t lanes = 2; lanes <= options_.parts; ++lanes) {
      for (std::size_t first = 1; first < lanes; ++first) {
        const float cost = a.cost[first] + b.cost[lanes - first];
        if (!(cost < part.cost[lanes])) continue;
        part.cost[lanes] = cost;
        part.first[lanes] = std::uint8_t(first);
      }
      const float as_node = part.cost[lanes] + (part.surface + no_surface) * (opening_cost + float(lanes));
      if (!(as_node < part.cost[1])) continue;
      part.cost[1] = as_node;
      part.lanes = std::uint8_t(lanes);
    }
  }

  /// Writes the elements in their new order.
  void order_elements()
  {
    std::array<Element, most> old;
    const std::span<Element> all = elements_.order().subspan(first_, count_);
    std::copy(all.begin(), all.end(), old.begin());
    for (Index k = 0; k < count_; ++k) all[k] = old[order_[0][k]];
  }

  template <class Nodes>
  Index make_node(int v, Nodes& nodes)
  {
    std::array<int, kernel::lanes> parts{};
    std::size_t count = 0;
    list_lanes(v, parts_[v].lanes, parts, count);
    lanes_.clear();
    for (std::size_t k = 0; k < count; ++k) lanes_.push_back(lane_of(parts[k]));
    const Index made = nodes.push_back(node_of(lanes_));
    for (std::size_t k = 0; k < count; ++k) {
      if (is_leaf(parts[k])) continue;
      const Index child = make_node(parts[k], nodes);
      nodes.data()[made].child[k] = std::int32_t(child);
    }
    return made;
  }

  /// Appends the parts that are the lanes when part `v` takes `lanes` lanes.
  void list_lanes(int v, std::size_t lanes, std::array<int, kernel::lanes>& parts, std::size_t& count) const
  {
    if (lanes == 1) {
      parts[count++] = v;
      return;
    }
    const Part& part = parts_[v];
    list_lanes(part.parts[0], part.first[lanes], parts, count);
    list_lanes(part.parts[1], lanes - part.first[lanes], parts, count);
  }

  Bvh8_lane lane_of(int v)
  {
    const Part& part = parts_[v];
    points_.clear();
    for (int k = part.begin; k < part.end; ++k)
      for (const std::uint32_t c : corners_.of(order_[0][k])) {
        if (part.end - part.begin > 1 && seen_in_[c] == v) continue;
        seen_in_[c] = v;
        points_.push_back(corners_.points()[c]);
      }
    const Index first = first_ + part.begin, last = first_ + part.end;
    if (is_leaf(v) && !leaf_ends_.empty()) leaf_ends_[first] = last;
    return Bvh8_lane(first, last, is_leaf(v), points_);
  }

  /// The cost of opening a node, in costs of one of its lanes.
  static constexpr float opening_cost = 10;

  /// A surface added to each, so that a flat box in a line costs something.
  static constexpr float no_surface = 1e-6f;

  Bvh8_elements& elements_;
  const Bvh8_options options_;
  std::vector<Index>& leaf_ends_;
  std::size_t cuts_ = 0;

  Index first_ = 0, count_ = 0;
  Corner_set corners_;
  std::vector<Four> at_;  // the corners in their principal frame
  std::array<Axis_bounds, most> bounds_;
  std::array<std::array<std::uint8_t, most>, 3> order_{};  // along each axis, by parts; k stands for element first_ + k
  std::array<bool, most> is_before_{};
  std::array<Part, 2 * most> parts_;
  int part_count_ = 0;
  std::array<float, most + 1> weights_{};  // see `sah_weight`
  std::vector<int> seen_in_;               // the last part that took each corner
  std::vector<Vector> points_;
  std::vector<Bvh8_lane> lanes_;
};

}  // namespace tetracone::tetratree

#endif
