#ifndef TETRACONE_TETRATREE_WIDE_NODE_H
#define TETRACONE_TETRATREE_WIDE_NODE_H

#include "kernel/wide_boxes.h"

#include <array>
#include <cstdint>

namespace tetracone::tetratree {

/// Up to eight parts of a body, each in a box: see `Wide_tree`.
struct alignas(64) Wide_node {
  kernel::Wide_boxes boxes;
  std::array<std::int32_t, 8> child;   ///< of lane k: its node; `not_made`; or `leaf`, where it holds one element
  std::array<std::uint32_t, 9> first;  ///< lane k holds elements first[k] .. first[k+1] of the tree's order
  int lane_count;

  static constexpr std::int32_t not_made = -1, leaf = -2;
};

}  // namespace tetracone::tetratree

#endif
