#ifndef TETRACONE_TETRATREE_FAST_BVH8_NODE_H
#define TETRACONE_TETRATREE_FAST_BVH8_NODE_H

#include "tetracone/kernel/bound/obb8.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace tetracone::tetratree {

/// A node of a `Bvh8`: up to eight parts of a body, each in a box.
struct alignas(64) Bvh8_node {
  kernel::Obb8 boxes;
  std::array<std::int32_t, 8> child;   ///< lane k's node; if negative, `not_made` or, below these, `leaf`, which holds
                                       ///< elements and is marked
  std::array<std::uint32_t, 8> first;  ///< the position in the tree's order of lane k's first element

  bool is_leaf(int lane) const { return boxes.marked >> lane & 1; }

  /// Returns the sum of a box's extents, negative for a leaf.
  float signed_size(int lane) const
  {
    const float size = boxes.extent[0][lane] + (boxes.extent[1][lane] + boxes.extent[2][lane]);
    return is_leaf(lane) ? -size : size;
  }

  /// True when the lane is a leaf or its node exists. Only for the thread that makes nodes.
  bool is_made(int lane) const { return is_leaf(lane) || child[std::size_t(lane)] >= 0; }

  /// Returns the code of a lane whose node another thread may be making. A node that `publish` announced is visible,
  /// with all that was written before.
  std::int32_t child_of(int lane) const { return __atomic_load_n(&child[std::size_t(lane)], __ATOMIC_ACQUIRE); }
  void publish(int lane, std::uint32_t made)
  {
    __atomic_store_n(&child[std::size_t(lane)], std::int32_t(made), __ATOMIC_RELEASE);
  }

  /// Returns this node with 0 in all bytes that mean nothing.
  Bvh8_node without_padding() const
  {
    Bvh8_node node;
    std::memset(static_cast<void*>(&node), 0, sizeof node);
    std::memcpy(static_cast<void*>(&node), this, bytes_of_boxes);
    node.child = child;
    node.first = first;
    return node;
  }

  /// The code of a lane whose node is not made says where its elements end. Requires last <= most_elements.
  static constexpr std::int32_t not_made(std::uint32_t last) { return -1 - std::int32_t(last); }
  static constexpr std::uint32_t last_of(std::int32_t code) { return std::uint32_t(-1 - code); }
  static constexpr std::uint32_t most_elements = 0x7ffeffff;

  /// The code of a leaf says where its triangle lies in its box.
  static constexpr std::int32_t leaf(kernel::Apex_code apex) { return first_leaf + apex; }
  static constexpr kernel::Apex_code apex(std::int32_t code) { return kernel::Apex_code(code - first_leaf); }
  static constexpr std::int32_t first_leaf = std::numeric_limits<std::int32_t>::min(), last_leaf = first_leaf + 0xffff;

 private:
  static constexpr std::size_t bytes_of_boxes = offsetof(kernel::Obb8, marked) + sizeof(kernel::Obb8::marked);
};

}  // namespace tetracone::tetratree

#endif
