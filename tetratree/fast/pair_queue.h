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

/// Pairs of boxes, about the nearest first: by steps of their lower bounds, of one step the last one first. Neither end
/// takes longer where there are many.
class Pair_queue {
 public:
  /// Steps are of lower bounds from `nearest` to `farthest`, or one for all.
  void clear(double nearest, double farthest)
  {
    pairs_.clear();
    filled_ = 0;
    free_ = none;
    const double range = farthest - nearest;
    nearest_ = float(nearest);
    steps_per_unit_ = range > 0x1p-60 && range < 0x1p60 ? float(steps / range) : 0;
  }

  bool empty() const { return filled_ == 0; }

  void push(const Box_pair& pair)
  {
    const float at = (pair.low - nearest_) * steps_per_unit_;
    const int step = at >= steps - 1 ? steps - 1 : at > 0 ? int(at) : 0;
    const std::uint32_t next = filled_ >> step & 1 ? top_[std::size_t(step)] : none;
    filled_ |= std::uint64_t(1) << step;
    std::uint32_t& top = top_[std::size_t(step)];
    if (free_ == none) {
      top = std::uint32_t(pairs_.size());
      pairs_.push_back({pair, next});
    } else {
      top = free_;
      free_ = pairs_[top].next;
      pairs_[top] = {pair, next};
    }
  }

  /// Requires a pair.
  Box_pair pop()
  {
    std::uint32_t& top = top_[std::size_t(std::countr_zero(filled_))];
    const std::uint32_t popped = top;
    auto& [pair, next] = pairs_[popped];
    top = next;
    if (top == none) filled_ &= filled_ - 1;
    next = free_;
    free_ = popped;
    return pair;
  }

 private:
  static constexpr int steps = 64;
  static constexpr std::uint32_t none = ~std::uint32_t(0);

  struct Linked {
    Box_pair pair;
    std::uint32_t next;  // in the same step, or unused
  };
  std::vector<Linked> pairs_;
  std::array<std::uint32_t, steps> top_{};
  std::uint64_t filled_ = 0;  // steps that hold a pair
  std::uint32_t free_ = none;
  float nearest_ = 0, steps_per_unit_ = 0;
};

}  // namespace tetracone::tetratree

#endif
