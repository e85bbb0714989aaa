#ifndef TETRACONE_TETRATREE_FAST_BOX_ID_H
#define TETRACONE_TETRATREE_FAST_BOX_ID_H

#include "tetracone/kernel/bound/obb8.h"

#include <array>
#include <compare>
#include <cstdint>

namespace tetracone::tetratree {

/// A box of a tree: a lane of a node. It is kept as one number, 8 node + lane, of which a vector holds eight.
class Box_id {
 public:
  /// The box of the whole tree: lane 0 of node 0.
  constexpr Box_id() = default;
  constexpr Box_id(std::uint32_t node, int lane) : number_(per_node * node + std::uint32_t(lane)) {}
  static constexpr Box_id from_number(std::uint32_t number)
  {
    Box_id box;
    box.number_ = number;
    return box;
  }

  constexpr std::uint32_t node() const { return number_ / per_node; }
  constexpr int lane() const { return int(number_ % per_node); }
  constexpr std::uint32_t number() const { return number_; }

  friend constexpr auto operator<=>(const Box_id&, const Box_id&) = default;

 private:
  static constexpr std::uint32_t per_node = kernel::lanes;

  std::uint32_t number_ = 0;
};

/// A box of each body.
using Box_ids = std::array<Box_id, 2>;

}  // namespace tetracone::tetratree

#endif
