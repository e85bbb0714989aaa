#ifndef TETRACONE_KERNEL_PREDICATE_STAGE_COUNTS_H
#define TETRACONE_KERNEL_PREDICATE_STAGE_COUNTS_H

#include <cstdint>

namespace tetracone::kernel {

/// How many of the adaptive kernel's signs each stage decided. The sign of four points of one pose is decided where
/// that of their vertices is.
struct Stage_counts {
  std::uint64_t filter = 0;
  std::uint64_t zero = 0;  ///< found to be exactly 0 without arithmetic
  std::uint64_t grid = 0;  ///< exact, by integers: of exact images on a common grid
  std::uint64_t double_double = 0;
  std::uint64_t exact = 0;        ///< after all others were undecided
  std::uint64_t out_of_gate = 0;  ///< by the exact stage too, which alone may be asked: a point beyond the magnitude
                                  ///< gate

  std::uint64_t total() const { return filter + zero + grid + double_double + exact + out_of_gate; }

  friend Stage_counts operator-(Stage_counts a, const Stage_counts& b)
  {
    a.filter -= b.filter, a.zero -= b.zero, a.grid -= b.grid, a.double_double -= b.double_double, a.exact -= b.exact,
        a.out_of_gate -= b.out_of_gate;
    return a;
  }
  friend bool operator==(const Stage_counts&, const Stage_counts&) = default;
};

}  // namespace tetracone::kernel

#endif
