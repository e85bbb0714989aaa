#ifndef TETRACONE_TETRATREE_QUERY_PAIR_QUEUE_H
#define TETRACONE_TETRATREE_QUERY_PAIR_QUEUE_H

#include "tetracone/tetratree/fast/box_id.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetracone::tetratree {

/// A box of each body, a lower bound `low` of their distance, and their sizes in one unit, negative for leaves.
struct Box_pair {
  float low;
  std::array<float, 2> size;
  Box_ids box;

  bool is_of_leaves() const { return size[0] < 0 && size[1] < 0; }
};

/// A pair of boxes of which one, of `body`, is replaced by the lanes of its node.
template <class Pair>
struct Opened_pair {
  Pair pair;
  int body;
  std::uint32_t node;
};

/// A queue of pairs of boxes, roughly by their lower bound `low`. It has 64 times `words` steps; within a step the last
/// pair comes first. Neither push nor pop takes longer for many pairs.
template <class Pair, std::size_t words>
class Pair_queue {
 public:
  /// Empties the queue. Its steps divide the lower bounds from `nearest` to `farthest`; there is one step if that range
  /// is unusable.
  void clear(double nearest, double farthest)
  {
    pairs_.clear();
    filled_.fill(0);
    word_ = words - 1;
    free_ = none;
    const double range = farthest - nearest;
    nearest_ = float(nearest);
    steps_per_unit_ = range > 0x1p-60 && range < 0x1p60 ? float(steps / range) : 0;
  }

  /// True when no pair is left. Finds the first step that has one.
  bool empty()
  {
    while (word_ + 1 < words && filled_[word_] == 0) ++word_;
    return filled_[word_] == 0;
  }

  void push(const Pair& pair)
  {
    // Branchless, since the branches would be unpredictable.
    const float at = (pair.low - nearest_) * steps_per_unit_, above = at > 0 ? at : 0;
    const auto step = std::size_t(std::int32_t(above < steps - 1 ? above : float(steps - 1)));
    const std::size_t word = step / 64;
    const auto is_filled = std::uint32_t(filled_[word] >> step % 64 & 1);
    const std::uint32_t next = top_[step] | (is_filled - 1);
    filled_[word] |= std::uint64_t(1) << step % 64;
    word_ = word < word_ ? word : word_;
    std::uint32_t& top = top_[step];
    if (free_ == none) {
      top = std::uint32_t(pairs_.size());
      pairs_.push_back({pair, next});
    } else {
      top = free_;
      free_ = pairs_[top].next;
      pairs_[top] = {pair, next};
    }
  }

  /// Lower bound of `low` over all pairs, except for the rounding of a step and pairs below `nearest`. Requires that
  /// `empty` has just returned false, and more than one step.
  float lowest() const { return nearest_ + float(first_step()) / steps_per_unit_; }

  /// Removes and returns a pair of the first step. Requires that `empty` has just returned false.
  Pair pop()
  {
    std::uint32_t& top = top_[first_step()];
    const std::uint32_t popped = top;
    auto& [pair, next] = pairs_[popped];
    top = next;
    const std::uint64_t filled = filled_[word_];
    filled_[word_] = filled & (filled - std::uint64_t(top == none));
    next = free_;
    free_ = popped;
    return pair;
  }

 private:
  static constexpr int steps = 64 * int(words);
  static constexpr std::uint32_t none = ~std::uint32_t(0);

  struct Linked {
    Pair pair;
    std::uint32_t next;  // the next in the same step, or the next unused
  };
  std::size_t first_step() const { return 64 * word_ + std::size_t(std::countr_zero(filled_[word_])); }

  std::vector<Linked> pairs_;
  std::array<std::uint32_t, steps> top_{};
  std::array<std::uint64_t, words> filled_{};  // steps that hold a pair
  std::size_t word_ = 0;                       // no earlier word has a pair
  std::uint32_t free_ = none;
  float nearest_ = 0, steps_per_unit_ = 0;
};

}  // namespace tetracone::tetratree

#endif
