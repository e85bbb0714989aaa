#ifndef TETRACONE_TETRATREE_FAST_PAIR_QUEUE_H
#define TETRACONE_TETRATREE_FAST_PAIR_QUEUE_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetracone::tetratree {

/// Boxes, one of each body, with a lower bound of their distance; and their sizes, negative of leaves. Box k of node n
/// is 8 n + k.
struct Box_pair {
  float low;
  std::array<float, 2> size;
  std::array<std::uint32_t, 2> box;

  bool is_of_leaves() const { return size[0] < 0 && size[1] < 0; }
};

/// Pairs of boxes, about those of the least lower bound `low` first: by 64 times `words` steps of it, of one step the last
/// one first. Neither end takes longer where there are many.
template <class Pair, std::size_t words>
class Pair_queue {
 public:
  /// Steps are of lower bounds from `nearest` to `farthest`, or one for all.
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

  bool empty()
  {
    while (word_ + 1 < words && filled_[word_] == 0) ++word_;
    return filled_[word_] == 0;
  }

  void push(const Pair& pair)
  {
    // Without branches that no processor could foretell.
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

  /// Of all pairs, at most the lower bound, but for the rounding of its step. Requires that `empty` has just found one.
  float lowest() const { return nearest_ + float(first_step()) / steps_per_unit_; }

  /// Requires that `empty` has just found a pair.
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
    std::uint32_t next;  // in the same step, or unused
  };
  std::size_t first_step() const { return 64 * word_ + std::size_t(std::countr_zero(filled_[word_])); }

  std::vector<Linked> pairs_;
  std::array<std::uint32_t, steps> top_{};
  std::array<std::uint64_t, words> filled_{};  // steps that hold a pair
  std::size_t word_ = 0;                       // no pair is in a word before
  std::uint32_t free_ = none;
  float nearest_ = 0, steps_per_unit_ = 0;
};

}  // namespace tetracone::tetratree

#endif
