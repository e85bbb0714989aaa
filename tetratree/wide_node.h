#ifndef TETRACONE_TETRATREE_WIDE_NODE_H
#define TETRACONE_TETRATREE_WIDE_NODE_H

#include "kernel/wide_boxes.h"

#include <array>
#include <cstdint>

namespace tetracone::tetratree {

/// Up to eight parts of a body, each in a box: see `Wide_tree`.
struct alignas(64) Wide_node {
  kernel::Wide_boxes boxes;
  std::array<std::int32_t, 8> child;   ///< of lane k: its node; `leaf`, where it holds one element; or, below that, `not_made`
  std::array<std::uint32_t, 8> first;  ///< lane k holds elements of the tree's order from first[k] on

  /// A lane whose node is not made yet says where its elements end.
  static constexpr std::int32_t leaf = -1;
  static constexpr std::int32_t not_made(std::uint32_t last) { return -2 - std::int32_t(last); }
  static constexpr std::uint32_t last_of(std::int32_t code) { return std::uint32_t(-2 - code); }
};

}  // namespace tetracone::tetratree

#endif
