#ifndef TETRACONE_TETRATREE_SCENE_BOX_TREE_H
#define TETRACONE_TETRATREE_SCENE_BOX_TREE_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/short_vectors.h"
#include "tetracone/tetratree/scene/world_box.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Which of many boxes meet a box: a tree of eight boxes a node. Boxes change in place; the tree is made anew by what
/// its age costs.
class Box_tree {
 public:
  using Item = std::uint32_t;

  /// Item i has boxes[i]; only those of `items` are in the tree.
  void build(std::span<const World_box> boxes, std::vector<Item> items)
  {
    nodes_.clear();
    place_.assign(boxes.size(), no_place);
    in_order_ = std::move(items);
    if (!in_order_.empty()) make(boxes, 0, in_order_.size(), no_place);
    new_ = worn_ = {};
  }

  bool holds(Item item) const { return item < place_.size() && place_[item] != no_place; }
  std::size_t count() const { return in_order_.size(); }

  /// Gives an item of the tree another box.
  void set(Item item, const World_box& box)
  {
    const auto lane_of = [](std::uint32_t place) { return int(place % lanes); };
    std::uint32_t place = place_[item];
    nodes_[place / lanes].set(lane_of(place), box);
    while ((place = nodes_[place / lanes].parent) != no_place) {
      Node& node = nodes_[place / lanes];
      const World_box all = union_of(nodes_[std::size_t(node.child[lane_of(place)])]);
      if (node.box(lane_of(place)) == all) break;
      node.set(lane_of(place), all);
    }
  }

  /// Takes an item out.
  void remove(Item item)
  {
    set(item, nothing);
    nodes_[place_[item] / lanes].used &= ~(1u << place_[item] % lanes);
    place_[item] = no_place;
  }

  /// Calls what(item) for the items whose boxes meet `box`; returns how many nodes were opened. Any number of threads
  /// may ask at once.
  template <class What>
  std::size_t for_meeting(const World_box& box, const What& what) const
  {
    if (nodes_.empty()) return 0;
    std::size_t opened = 0;
    std::vector<std::uint32_t> open = {0};
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      ++opened;
      for (unsigned met = node.meeting(box); met != 0; met &= met - 1) {
        const int lane = std::countr_zero(met);
        if (node.child[lane] >= 0)
          open.push_back(std::uint32_t(node.child[lane]));
        else
          what(Item(~node.child[lane]));
      }
    }
    return opened;
  }

  /// Tells the tree what searches have cost: the first ones after a build are what later ones are compared with.
  void count_searches(std::size_t searches, std::size_t opened)
  {
    Searches& now = new_.count < in_order_.size() ? new_ : worn_;
    now.count += searches;
    now.opened += opened;
  }

  /// Whether searches have opened so many more nodes than they did when the tree was new that building it would have
  /// cost less.
  bool is_worn() const
  {
    if (worn_.count == 0) return false;
    const double usual = double(new_.opened) / double(new_.count) * double(worn_.count);
    return double(worn_.opened) > usual + nodes_a_build * double(in_order_.size());
  }

  std::size_t bytes() const
  {
    return nodes_.capacity() * sizeof(Node) + place_.capacity() * sizeof(place_[0]) +
           in_order_.capacity() * sizeof(Item);
  }

 private:
  static constexpr int lanes = 8;
  static constexpr std::uint32_t no_place = ~std::uint32_t(0);
  static constexpr double nodes_a_build = 8;  // opened, in the time that building takes an item
  static constexpr World_box nothing{{World_box::infinity, World_box::infinity, World_box::infinity},
                                     {-World_box::infinity, -World_box::infinity, -World_box::infinity}};

  struct alignas(32) Node {
    float low[3][lanes], high[3][lanes];
    std::int32_t child[lanes];  // a node, or ~item
    std::uint32_t used = 0;     // lanes that hold something, as bits
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
    /// The lanes whose boxes meet it, as bits.
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

  static World_box union_of(const Node& node)
  {
    World_box all = nothing;
    for (int lane = 0; lane < lanes; ++lane)
      for (int k = 0; k < 3; ++k) {
        all.low[k] = kernel::minimum(all.low[k], node.low[k][lane]);
        all.high[k] = kernel::maximum(all.high[k], node.high[k][lane]);
      }
    return all;
  }

  /// The node of the items first .. last of the order; its number.
  std::uint32_t make(std::span<const World_box> boxes, std::size_t first, std::size_t last, std::uint32_t parent)
  {
    const auto number = std::uint32_t(nodes_.size());
    nodes_.emplace_back();
    nodes_[number].parent = parent;
    std::array<std::size_t, lanes + 1> ends;  // of the parts, one a lane
    const int parts = int(kernel::minimum(last - first, std::size_t(lanes)));
    if (parts < lanes) {
      for (int lane = 0; lane <= parts; ++lane) ends[lane] = first + std::size_t(lane);
    } else {
      ends[0] = first;
      ends[lanes] = last;
      for (int step = lanes / 2; step > 0; step /= 2)
        for (int lane = 0; lane < lanes; lane += 2 * step) {
          ends[lane + step] = ends[lane] + (ends[lane + 2 * step] - ends[lane]) / 2;
          split(boxes, ends[lane], ends[lane + step], ends[lane + 2 * step]);
        }
    }
    for (int lane = 0; lane < lanes; ++lane) {
      nodes_[number].set(lane, nothing);
      if (lane >= parts) continue;
      nodes_[number].used |= 1u << lane;
      const std::uint32_t place = lanes * number + std::uint32_t(lane);
      if (ends[lane + 1] - ends[lane] == 1) {
        const Item item = in_order_[ends[lane]];
        place_[item] = place;
        nodes_[number].child[lane] = ~std::int32_t(item);
        nodes_[number].set(lane, boxes[item]);
      } else {
        const std::uint32_t child = make(boxes, ends[lane], ends[lane + 1], place);
        nodes_[number].child[lane] = std::int32_t(child);
        nodes_[number].set(lane, union_of(nodes_[child]));
      }
    }
    return number;
  }

  /// Orders the items about the middle one, along the axis on which their centres spread most.
  void split(std::span<const World_box> boxes, std::size_t first, std::size_t middle, std::size_t last)
  {
    const auto centre = [&boxes](Item item, int k) {
      const double at = double(boxes[item].low[k]) + double(boxes[item].high[k]);
      return at == at ? at : 0;  // of a box about everything
    };
    int axis = 0;
    double widest = -1;
    for (int k = 0; k < 3; ++k) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (std::size_t i = first; i < last; ++i) {
        low = kernel::minimum(low, centre(in_order_[i], k));
        high = kernel::maximum(high, centre(in_order_[i], k));
      }
      if (high - low > widest) {
        widest = high - low;
        axis = k;
      }
    }
    const auto at = [&](std::size_t i) { return in_order_.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(first), at(middle), at(last),
                     [&](Item p, Item q) { return centre(p, axis) < centre(q, axis); });
  }

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> place_;  // of each item, its lane
  std::vector<Item> in_order_;

  struct Searches {
    std::size_t count = 0, opened = 0;
  };
  Searches new_, worn_;
};

}  // namespace tetracone::tetratree

#endif
