#ifndef TETRACONE_TETRATREE_FAST_PAIR_MEMORY_H
#define TETRACONE_TETRATREE_FAST_PAIR_MEMORY_H

#include "tetracone/tetratree/fast/bvh8_front.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace tetracone::tetratree {

/// What is kept from one question to the next of one of many pairs of placed bodies that a query object is asked of.
/// No answer depends on it. Of bodies of the same two trees, in the same order, whatever query object asks; not for two
/// threads at a time.
struct Pair_memory {
  std::optional<Bvh8_front::Boxes>
      witness;                        ///< the leaves that met the last time, tried first; while there is no front
  std::unique_ptr<Bvh8_front> front;  ///< where one is made
  std::uint32_t opened = 0;           ///< boxes, by the last descent without a front
  bool is_front_allowed = false;

  /// Whether descents cost so much that a front may save it.
  bool is_front_worth() const { return opened >= fewest_opened; }
  static constexpr std::uint32_t fewest_opened = 24;

  /// Of bodies that are near where they were asked last; of others it saves nothing, and is dropped.
  void allow_front(bool is_allowed)
  {
    is_front_allowed = is_allowed;
    if (!is_allowed) front.reset();
  }

  /// Beside its own.
  std::size_t bytes() const { return front ? sizeof(Bvh8_front) + front->bytes() : 0; }
};

}  // namespace tetracone::tetratree

#endif
