#ifndef TETRACONE_TETRATREE_SCENE_BOX_TREE_H
#define TETRACONE_TETRATREE_SCENE_BOX_TREE_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/short_vectors.h"
#include "tetracone/tetratree/scene/large_pages.h"
#include "tetracone/tetratree/scene/world_box.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

namespace tetracone::tetratree {

/// A tree of boxes, eight a node, that finds all pairs that meet. Boxes change in place; the tree is rebuilt when
/// searches in it have become too costly.
class Box_tree {
 public:
  using Item = std::uint32_t;

  /// A part of a search. It is two lanes of the tree whose boxes meet, each an item or a child; or all pairs within one
  /// node.
  struct Part {
    std::uint32_t first;   ///< a lane; `no_place`: all pairs within the node `second`
    std::uint32_t second;  ///< a lane, or a node
  };

  /// Builds the tree of `items`; item i has boxes[i].
  void build(std::span<const World_box> boxes, std::span<const Item> items)
  {
    nodes_.clear();
    place_.assign(boxes.size(), no_place);
    count_ = items.size();
    std::vector<Centre> order(count_);
    std::ranges::transform(items, order.begin(), [boxes](Item item) { return centre_of(boxes[item], item); });
    if (count_ > 0) make(boxes, order, no_place);
    new_ = worn_ = {};
  }

  /// True when the tree holds the item. It serves tests.
  bool holds(Item item) const { return item < place_.size() && place_[item] != no_place; }
  /// Returns the number of items of the last `build`, including those removed since.
  std::size_t count() const { return count_; }

  /// Gives an item another box, and updates the boxes above it. Requires that the tree holds the item.
  void set(Item item, const World_box& box)
  {
    std::uint32_t place = place_[item];
    node_of(place).set(lane_of(place), box);
    while ((place = node_of(place).parent) != no_place) {
      const World_box all = union_of(nodes_[std::size_t(child_at(place))]);
      if (box_at(place) == all) break;
      node_of(place).set(lane_of(place), all);
    }
  }

  /// Takes an item out. Requires that the tree holds it, and that it is not marked.
  void remove(Item item)
  {
    set(item, nothing);
    node_of(place_[item]).used &= ~bit_of(place_[item]);
    place_[item] = no_place;
  }

  /// Gives every item of the tree its box in `boxes`.
  void set_all(std::span<const World_box> boxes)
  {
    // A child's number is above its parent's.
    for (std::size_t n = nodes_.size(); n-- > 0;)
      for (unsigned used = nodes_[n].used; used != 0; used &= used - 1) {
        const int lane = std::countr_zero(used);
        const std::int32_t child = nodes_[n].child[lane];
        nodes_[n].set(lane, child >= 0 ? union_of(nodes_[std::size_t(child)]) : boxes[Item(~child)]);
      }
  }

  /// Marks an item. Searches find the pairs with at least one marked item.
  void mark(Item item)
  {
    for (std::uint32_t place = place_[item]; place != no_place && !is_marked(place); place = node_of(place).parent)
      node_of(place).marked |= bit_of(place);
  }
  /// Takes the mark off an item.
  void unmark(Item item)
  {
    for (std::uint32_t place = place_[item]; place != no_place; place = node_of(place).parent)
      if ((node_of(place).marked &= ~bit_of(place)) != 0) break;
  }

  /// Returns the parts of a search for all pairs: at least `enough` of them, unless the pairs are fewer. Their order
  /// depends on the tree and its marks only.
  std::vector<Part> parts(std::size_t enough) const
  {
    std::vector<Part> parts, opened;
    if (!nodes_.empty()) parts.push_back({no_place, 0});
    for (bool can_open = true; can_open && parts.size() < enough; parts.swap(opened)) {
      can_open = false;
      opened.clear();
      for (const Part& part : parts)
        if (is_pair(part)) {
          opened.push_back(part);
        } else {
          open(part, [&opened](const Part& smaller) { opened.push_back(smaller); });
          can_open = true;
        }
    }
    return parts;
  }

  /// Calls what(item, item) for the pairs of this part whose boxes meet, each once. Returns the number of nodes that
  /// were opened. Any number of threads may search at once.
  template <class What>
  std::size_t for_meeting(const Part& all, const What& what) const
  {
    std::size_t opened = 0;
    std::vector<Part> left;
    const auto take = [&](const Part& part) {
      if (is_pair(part))
        what(item_at(part.first), item_at(part.second));
      else
        left.push_back(part);
    };
    take(all);
    while (!left.empty()) {
      const Part part = left.back();
      left.pop_back();
      ++opened;
      open(part, take);
    }
    return opened;
  }

  /// Records that this many searches have opened this many nodes. The first searches after a build are the standard for
  /// later ones.
  void count_searches(std::size_t searches, std::size_t opened)
  {
    Searches& now = new_.count < count_ ? new_ : worn_;
    now.count += searches;
    now.opened += opened;
  }

  /// True when a rebuild would have cost less than the nodes that searches opened beyond their cost when the tree was
  /// new.
  bool is_worn() const
  {
    if (worn_.count == 0) return false;
    const double usual = double(new_.opened) / double(new_.count) * double(worn_.count);
    return double(worn_.opened) > usual + nodes_a_build * double(count_);
  }

  std::size_t bytes() const { return nodes_.capacity() * sizeof(Node) + place_.capacity() * sizeof(place_[0]); }

 private:
  static constexpr int lanes = 8;
  static constexpr std::uint32_t no_place = ~std::uint32_t(0);
  static constexpr double nodes_a_build = 16;  // nodes that searches open in the time that a build takes for one item
  static constexpr World_box nothing{{World_box::infinity, World_box::infinity, World_box::infinity},
                                     {-World_box::infinity, -World_box::infinity, -World_box::infinity}};

  struct alignas(32) Node {
    float low[3][lanes], high[3][lanes];
    std::int32_t child[lanes];  // a node, or ~item
    std::uint32_t used = 0;     // lanes that hold something, as bits
    std::uint32_t marked = 0;   // lanes that are marked items, or hold some
    std::uint32_t parent;       // lane k of node n is 8 n + k

    World_box box(int lane) const
    {
      World_box box;
      for (int k = 0; k < 3; ++k) {
        box.low[k] = low[k][lane];
        box.high[k] = high[k][lane];
      }
      return box;
    }
    void set(int lane, const World_box& box)
    {
      for (int k = 0; k < 3; ++k) {
        low[k][lane] = box.low[k];
        high[k][lane] = box.high[k];
      }
    }
    /// Returns the lanes whose boxes meet this one, as bits.
    unsigned meeting(const World_box& box) const
    {
      using kernel::Four_floats, kernel::Four_ints;
      Four_ints apart[2] = {};
      for (int half = 0; half < 2; ++half)
        for (int k = 0; k < 3; ++k) {
          Four_floats from, to;
          std::memcpy(&from, low[k] + 4 * half, sizeof from);
          std::memcpy(&to, high[k] + 4 * half, sizeof to);
          apart[half] |= (from > Four_floats{} + box.high[k]) | (to < Four_floats{} + box.low[k]);
        }
      return used & unsigned(kernel::sum_of_lanes((~apart[0] & Four_ints{1, 2, 4, 8}) +
                                                  (~apart[1] & Four_ints{16, 32, 64, 128}))[0]);
    }
  };

  static int lane_of(std::uint32_t place) { return int(place % lanes); }
  static std::uint32_t bit_of(std::uint32_t place) { return 1u << place % lanes; }
  Node& node_of(std::uint32_t place) { return nodes_[place / lanes]; }
  const Node& node_of(std::uint32_t place) const { return nodes_[place / lanes]; }
  std::int32_t child_at(std::uint32_t place) const { return node_of(place).child[lane_of(place)]; }
  Item item_at(std::uint32_t place) const { return Item(~child_at(place)); }
  World_box box_at(std::uint32_t place) const { return node_of(place).box(lane_of(place)); }
  bool is_marked(std::uint32_t place) const { return (node_of(place).marked & bit_of(place)) != 0; }

  /// True when it is two items.
  bool is_pair(const Part& part) const
  {
    return part.first != no_place && child_at(part.first) < 0 && child_at(part.second) < 0;
  }

  /// Calls push(part) for the smaller parts that have a marked item. It opens one lane that has a child, the first lane
  /// if both have; the other lane comes first in the new parts.
  template <class Push>
  void open(const Part& part, const Push& push) const
  {
    const auto for_lanes = [](unsigned bits, const auto& what) {
      for (; bits != 0; bits &= bits - 1) what(std::uint32_t(std::countr_zero(bits)));
    };
    const auto meeting = [this](const Node& node, std::uint32_t place) {
      return node.meeting(box_at(place)) & (is_marked(place) ? node.used : node.marked);
    };
    if (part.first != no_place) {
      const bool has_child = child_at(part.first) >= 0;
      const std::uint32_t opened = has_child ? part.first : part.second, other = has_child ? part.second : part.first,
                          number = std::uint32_t(child_at(opened));
      for_lanes(meeting(nodes_[number], other), [&](std::uint32_t lane) { push(Part{other, lanes * number + lane}); });
      return;
    }
    const std::uint32_t number = part.second;
    const Node& node = nodes_[number];
    for_lanes(node.used, [&](std::uint32_t lane) {
      const std::uint32_t place = lanes * number + lane;
      if (is_marked(place) && child_at(place) >= 0) push(Part{no_place, std::uint32_t(child_at(place))});
      const unsigned later = ~0u << lane << 1;
      for_lanes(meeting(node, place) & later, [&](std::uint32_t other) { push(Part{place, lanes * number + other}); });
    });
  }

  static World_box union_of(const Node& node)
  {
    World_box all;
    for (int k = 0; k < 3; ++k) {
      all.low[k] = extreme(node.low[k], [](const auto& x, const auto& y) { return kernel::select(x < y, x, y); });
      all.high[k] = extreme(node.high[k], [](const auto& x, const auto& y) { return kernel::select(x > y, x, y); });
    }
    return all;
  }
  /// Returns the extreme of eight numbers by `of_two`. Requires that none is NaN.
  template <class Of_two>
  static float extreme(const float* numbers, const Of_two& of_two)
  {
    kernel::Four_floats first, last;
    std::memcpy(&first, numbers, sizeof first);
    std::memcpy(&last, numbers + 4, sizeof last);
    const kernel::Four_floats four = of_two(first, last),
                              two = of_two(four, __builtin_shufflevector(four, four, 2, 3, 0, 1));
    return of_two(two, __builtin_shufflevector(two, two, 1, 0, 3, 2))[0];
  }

  /// An item during the build, with the centre of its box; a coordinate is 0 where it is not finite.
  struct alignas(16) Centre {
    std::array<float, 3> at;
    Item item;
  };
  static Centre centre_of(const World_box& box, Item item)
  {
    Centre centre{{}, item};
    for (int k = 0; k < 3; ++k) {
      const float at = 0.5f * box.low[k] + 0.5f * box.high[k];
      centre.at[k] = at - at == 0 ? at : 0;
    }
    return centre;
  }

  /// Makes the node of the items of `order`; returns its number. Nodes that hold only items are full, except the last
  /// one.
  std::uint32_t make(std::span<const World_box> boxes, std::span<Centre> order, std::uint32_t parent)
  {
    const auto number = std::uint32_t(nodes_.size());
    nodes_.emplace_back();
    nodes_[number].parent = parent;
    std::array<std::size_t, lanes + 1> ends;  // of the ranges of items, one a lane
    ends[0] = 0;
    ends[lanes] = order.size();
    for (int step = lanes / 2; step > 0; step /= 2)
      for (int lane = 0; lane < lanes; lane += 2 * step) {
        const std::size_t first = ends[lane], last = ends[lane + 2 * step], middle = middle_of(last - first, step);
        ends[lane + step] = first + middle;
        if (order.size() > lanes && middle < last - first) split(order.subspan(first, last - first), middle);
      }
    for (int lane = 0; lane < lanes; ++lane) {
      nodes_[number].set(lane, nothing);
      const std::span<Centre> part = order.subspan(ends[lane], ends[lane + 1] - ends[lane]);
      if (part.empty()) continue;
      nodes_[number].used |= 1u << lane;
      const std::uint32_t place = lanes * number + std::uint32_t(lane);
      if (part.size() == 1) {
        const Item item = part[0].item;
        place_[item] = place;
        nodes_[number].child[lane] = ~std::int32_t(item);
        nodes_[number].set(lane, boxes[item]);
      } else {
        const std::uint32_t child = make(boxes, part, place);
        nodes_[number].child[lane] = std::int32_t(child);
        nodes_[number].set(lane, union_of(nodes_[child]));
      }
    }
    return number;
  }

  /// Returns how many of the items come first when they are split between two halves of `half_of_lanes` lanes each. It
  /// is half of the items, in whole nodes where there are nodes.
  static std::size_t middle_of(std::size_t items, int half_of_lanes)
  {
    const std::size_t half = items - items / 2, in_node = items > 2 * std::size_t(half_of_lanes) ? lanes : 1;
    return kernel::minimum(items, (half + in_node - 1) / in_node * in_node);
  }

  /// Partitions `order` so that its first `middle` items come first along the axis on which they spread most.
  static void split(std::span<Centre> order, std::size_t middle)
  {
    kernel::Four_floats low = kernel::Four_floats{} + std::numeric_limits<float>::infinity(), high = -low;
    for (const Centre& centre : order) {
      const kernel::Four_floats at = {centre.at[0], centre.at[1], centre.at[2], 0};
      low = kernel::select(at < low, at, low);
      high = kernel::select(at > high, at, high);
    }
    const kernel::Four_floats spread = high - low;
    const std::size_t first_two = spread[0] >= spread[1] ? 0 : 1,
                      axis = spread[2] > spread[int(first_two)] ? 2 : first_two;
    std::nth_element(order.begin(), order.begin() + std::ptrdiff_t(middle), order.end(),
                     [axis](const Centre& p, const Centre& q) { return p.at[axis] < q.at[axis]; });
  }

  Large_vector<Node> nodes_;
  std::vector<std::uint32_t> place_;  // the lane of each item
  std::size_t count_ = 0;             // of items at the last `build`

  struct Searches {
    std::size_t count = 0, opened = 0;
  };
  Searches new_, worn_;
};

}  // namespace tetracone::tetratree

#endif
