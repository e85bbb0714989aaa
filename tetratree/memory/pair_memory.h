#ifndef TETRACONE_TETRATREE_MEMORY_PAIR_MEMORY_H
#define TETRACONE_TETRATREE_MEMORY_PAIR_MEMORY_H

#include "tetracone/tetratree/memory/bvh8_front.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace tetracone::tetratree {

/// The memory of one pair of placed bodies from pose to pose. It changes speed, never an answer.
///
/// It belongs to the pair, whichever query object of the same two trees, in the same order, uses it. One query object
/// may so serve many pairs. It is not for two threads at a time.
struct Pair_memory {
  std::optional<Box_ids> witness;     ///< the leaves that met in the last pose, tried first in the next
  std::unique_ptr<Bvh8_front> front;  ///< null until `is_front_due`, except `with_front`
  std::uint32_t opened = 0;           ///< boxes opened by the last descent without a front
  bool is_front_allowed = false;
  bool was_plane_found = true;  ///< whether the last plane that was looked for was found; true at first

  /// Returns a memory that has a front from the start, for a pair that moves little from pose to pose.
  static Pair_memory with_front()
  {
    Pair_memory memory;
    memory.front = std::make_unique<Bvh8_front>();
    return memory;
  }

  /// True when a plane between the bodies is to be tried before anything else.
  bool is_plane_first() const { return !witness && (was_plane_found || !holds_front()); }
  /// True when there is a front that can be followed.
  bool holds_front() const { return front && front->holds(); }

  /// True when a front is to be made: it is allowed, and descents cost so much that it may pay.
  bool is_front_due() const { return !front && is_front_allowed && is_front_worth(); }
  bool is_front_worth() const { return opened >= fewest_opened; }
  /// Opened boxes from which on a front may pay.
  static constexpr std::uint32_t fewest_opened = 24;

  /// Allows a front, or drops an existing one and the witness. It pays for bodies near where they were last.
  void allow_front(bool is_allowed)
  {
    is_front_allowed = is_allowed;
    if (is_allowed || !front) return;
    front.reset();
    witness.reset();
  }

  /// Returns the bytes beside this object's own.
  std::size_t bytes() const { return front ? sizeof(Bvh8_front) + front->bytes() : 0; }
};

}  // namespace tetracone::tetratree

#endif
