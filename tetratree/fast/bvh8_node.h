#ifndef TETRACONE_TETRATREE_FAST_BVH8_NODE_H
#define TETRACONE_TETRATREE_FAST_BVH8_NODE_H

#include "tetracone/kernel/bound/obb8.h"

#include <array>
#include <cstdint>
#include <limits>

namespace tetracone::tetratree {

/// Up to eight parts of a body, each in a box: see `Bvh8`.
struct alignas(64) Bvh8_node {
  kernel::Obb8 boxes;
  std::array<std::int32_t, 8> child;   ///< of lane k: its node; or, negative, `not_made`; or, below these, a `leaf`, which holds one element
  std::array<std::uint32_t, 8> first;  ///< lane k holds elements of the tree's order from first[k] on

  /// A lane whose node is not made yet says where its elements end. Requires last <= most_elements.
  static constexpr std::int32_t not_made(std::uint32_t last) { return -1 - std::int32_t(last); }
  static constexpr std::uint32_t last_of(std::int32_t code) { return std::uint32_t(-1 - code); }
  static constexpr std::uint32_t most_elements = 0x7ffeffff;

  /// A leaf says where its triangle lies in its box.
  static constexpr std::int32_t leaf(kernel::Apex_code apex) { return first_leaf + apex; }
  static constexpr bool is_leaf(std::int32_t code) { return code <= last_leaf; }
  static constexpr kernel::Apex_code apex(std::int32_t code) { return kernel::Apex_code(code - first_leaf); }
  static constexpr std::int32_t first_leaf = std::numeric_limits<std::int32_t>::min(), last_leaf = first_leaf + 0xffff;
};

}  // namespace tetracone::tetratree

#endif
