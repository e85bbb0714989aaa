#ifndef TETRACONE_KERNEL_PREDICATE_TOLERANCE_H
#define TETRACONE_KERNEL_PREDICATE_TOLERANCE_H

namespace tetracone::kernel {

/// When a computed value counts as zero: |value| <= absolute, or |value| <= relative * (the sum of the absolute values
/// of the products it was summed from). Both zero: plain double.
struct Tolerance {
  double absolute = 0;  ///< in units of the value
  double relative = 0;  ///< as a share of that sum
};

}  // namespace tetracone::kernel

#endif
