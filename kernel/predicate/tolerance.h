#ifndef TETRACONE_KERNEL_PREDICATE_TOLERANCE_H
#define TETRACONE_KERNEL_PREDICATE_TOLERANCE_H

namespace tetracone::kernel {

/// The tolerance within which a computed value counts as zero: |value| <= absolute, or |value| <= relative * terms. The
/// terms are the sum of the absolute values of the products it was summed from. With both zero, it is plain double.
struct Tolerance {
  double absolute = 0;  ///< in units of the value
  double relative = 0;  ///< as a fraction of that sum
};

}  // namespace tetracone::kernel

#endif
