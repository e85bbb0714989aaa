#ifndef TETRACONE_KERNEL_PREDICATE_STAGE_COUNTS_H
#define TETRACONE_KERNEL_PREDICATE_STAGE_COUNTS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace tetracone::kernel {

/// The stages of the adaptive kernel, in the order in which they are asked; but `out_of_gate` comes after `fixed`.
enum class Adaptive_stage {
  filter,
  zero,         ///< found to be exactly 0 without arithmetic
  out_of_gate,  ///< the exact stage, of a point beyond the magnitude gate
  grid,         ///< exact, in integers: exact images on a common grid
  fixed,        ///< exact, in integers of a fixed width
  double_double,
  exact  ///< after all others were undecided
};
constexpr std::size_t stage_count = static_cast<std::size_t>(Adaptive_stage::exact) + 1;

/// The number of the adaptive kernel's signs that each stage decided. A sign that `sides` or `triangle_contacts8`
/// filters with others is not counted, nor one that `Kept_sides` has kept. The sign of four points of one pose counts
/// for the stage that decides the sign of their vertices.
class Stage_counts {
 public:
  std::uint64_t& operator[](Adaptive_stage stage) { return count_[static_cast<std::size_t>(stage)]; }
  std::uint64_t operator[](Adaptive_stage stage) const { return count_[static_cast<std::size_t>(stage)]; }

  std::uint64_t total() const { return std::accumulate(count_.begin(), count_.end(), std::uint64_t{0}); }

  friend Stage_counts operator-(Stage_counts a, const Stage_counts& b)
  {
    for (std::size_t k = 0; k < stage_count; ++k) a.count_[k] -= b.count_[k];
    return a;
  }
  friend bool operator==(const Stage_counts&, const Stage_counts&) = default;

 private:
  std::array<std::uint64_t, stage_count> count_{};
};

}  // namespace tetracone::kernel

#endif
