#ifndef TETRACONE_TETRATREE_FAST_PAIR_MEMORY_H
#define TETRACONE_TETRATREE_FAST_PAIR_MEMORY_H

#include "tetracone/tetratree/fast/bvh8_front.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace tetracone::tetratree {

/// The memory of one pair of placed bodies, when one query object serves many pairs. It changes speed, never an answer.
/// The pairs are of the same two trees, in the same order; any query object of these may use it. It is not for two
/// threads at a time.
struct Pair_memory {
  std::optional<Bvh8_front::Boxes> witness;  ///< the leaves that met last, tried first; unused while there is a front
  std::unique_ptr<Bvh8_front> front;         ///< null until a front is made
  std::uint32_t opened = 0;                  ///< boxes opened by the last descent without a front
  bool is_front_allowed = false;

  /// True when descents cost so much that a front may pay.
  bool is_front_worth() const { return opened >= fewest_opened; }
  /// Opened boxes from which on a front may pay.
  static constexpr std::uint32_t fewest_opened = 24;

  /// Allows a front for bodies that are near where they were asked last. For others it saves nothing, and is dropped.
  void allow_front(bool is_allowed)
  {
    is_front_allowed = is_allowed;
    if (!is_allowed) front.reset();
  }

  /// Returns the bytes beside this object's own.
  std::size_t bytes() const { return front ? sizeof(Bvh8_front) + front->bytes() : 0; }
};

}  // namespace tetracone::tetratree

#endif
