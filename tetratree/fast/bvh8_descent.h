#ifndef TETRACONE_TETRATREE_FAST_BVH8_DESCENT_H
#define TETRACONE_TETRATREE_FAST_BVH8_DESCENT_H

#include "tetracone/kernel/bound/obb8_overlap.h"
#include "tetracone/kernel/simd/simd.h"
#include "tetracone/tetratree/fast/box_id.h"
#include "tetracone/tetratree/fast/bvh8_node.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// True when the first box of a pair is the larger one, which is opened.
inline bool first_is_larger(float size_a, float size_b) { return size_a > size_b; }

/// A stack of pairs of boxes, one of each body, that may meet. A size is a `Bvh8_node::signed_size`, in the units of
/// the second body: negative for a leaf.
class Pair_stack {
 public:
  std::size_t count() const { return count_; }
  bool empty() const { return count_ == 0; }
  /// Return the boxes of the top pair. Require that there is one.
  Box_id box(int body) const { return Box_id::from_number(box_[body][count_ - 1]); }
  Box_ids boxes() const { return {box(0), box(1)}; }
  /// Returns the body whose box is larger in the top pair. That box is opened.
  int larger_body() const { return first_is_larger(size(0), size(1)) ? 0 : 1; }
  float size(int body) const { return size_[body][count_ - 1]; }

  void clear() { count_ = 0; }
  void pop() { --count_; }
  void push(const Box_ids& boxes, float size_a, float size_b)
  {
    reserve();
    box_[0][count_] = boxes[0].number();
    box_[1][count_] = boxes[1].number();
    size_[0][count_] = size_a;
    size_[1][count_] = size_b;
    ++count_;
  }

  // These serve the descent, which writes whole vectors of lanes and then sets how many count.
  void reserve()
  {
    if (count_ + 5 * kernel::lanes <= box_[0].size()) return;
    for (int body = 0; body < 2; ++body) {
      box_[body].resize(2 * count_ + 256);
      size_[body].resize(2 * count_ + 256);
    }
  }
  std::uint32_t* numbers(int body) { return box_[body].data(); }
  float* sizes(int body) { return size_[body].data(); }
  void set_count(std::size_t count) { count_ = count; }

  void swap(Pair_stack& other) noexcept
  {
    std::swap(box_, other.box_);
    std::swap(size_, other.size_);
    std::swap(count_, other.count_);
  }

 private:
  std::vector<std::uint32_t> box_[2];
  std::vector<float> size_[2];
  std::size_t count_ = 0;
};

/// The two bodies of a descent.
struct Both_trees {
  const Bvh8_node* nodes[2];       ///< all nodes of body k
  const kernel::Box_map* into[2];  ///< maps body k into the frame of the other
  float scale;                     ///< from the first body's units to the second's

  const Bvh8_node& node_of(int body, Box_id box) const { return nodes[body][box.node()]; }
  /// Returns the size of a box in the units of the second body.
  float size(int body, Box_id box) const
  {
    return node_of(body, box).signed_size(box.lane()) * (body == 0 ? scale : 1.0f);
  }

  std::uint64_t opened = 0, compared = 0;  ///< pairs opened and boxes compared so far
};

/// The reason why a descent has stopped:
/// - `nothing_left`: the stack is empty;
/// - `leaves`: the top pair is two leaves;
/// - `no_child`: the node below the larger box of the top pair must be made first.
enum class Stop { nothing_left, leaves, no_child };

/// The number of openings after which a descent may open four pairs per round instead of two.
constexpr std::uint64_t opened_by_two = 32;

/// Maps a set of lanes, as bits, to their numbers in order, followed by zeros.
inline constexpr auto lanes_in = [] {
  std::array<std::array<std::uint8_t, kernel::lanes>, 1 << kernel::lanes> lanes{};
  for (unsigned set = 0; set < lanes.size(); ++set)
    for (unsigned lane = 0, count = 0; lane < kernel::lanes; ++lane)
      if (set >> lane & 1) lanes[set][count++] = std::uint8_t(lane);
  return lanes;
}();

/// Maps a set of lanes, as bits, to the sign bit in these lanes.
inline constexpr auto signs_in = [] {
  std::array<std::array<std::uint32_t, kernel::lanes>, 1 << kernel::lanes> signs{};
  for (unsigned set = 0; set < signs.size(); ++set)
    for (unsigned lane = 0; lane < kernel::lanes; ++lane) signs[set][lane] = (set >> lane & 1) << 31;
  return signs;
}();

}  // namespace tetracone::tetratree

#define TETRACONE_SIMD_FILE "tetracone/tetratree/fast/bvh8_descent_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::tetratree {

/// Opens pairs, the top one first, and returns why it stopped. The parts of the larger box are tested against the other
/// box, and parts that may meet it are pushed.
inline Stop descend(Pair_stack& stack, Both_trees& trees)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(descend_simd);
  return fastest(stack, trees);
}

/// Opens all pairs, level by level, and returns why it stopped. It takes the pairs of `level`, the top one first, and
/// writes their parts to `next`. It adds pairs of leaves that it finds to `leaves`, and stops at one that it is given.
/// After a stop, both stacks hold the pairs that are left for the next call.
inline Stop descend_to_leaves(Pair_stack& level, Pair_stack& next, Both_trees& trees, std::vector<Box_ids>& leaves)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(descend_to_leaves_simd);
  return fastest(level, next, trees, leaves);
}

}  // namespace tetracone::tetratree

#endif
