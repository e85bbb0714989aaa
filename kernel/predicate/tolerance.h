#ifndef TETRACONE_KERNEL_PREDICATE_TOLERANCE_H
#define TETRACONE_KERNEL_PREDICATE_TOLERANCE_H

namespace tetracone::kernel {

/// The tolerance within which a computed value counts as zero: |value| <= absolute, or |value| <= relative * terms.
/// `terms` is the sum of the absolute values of the products that sum to the value. With both zero, only 0 counts.
struct Tolerance {
  double absolute = 0;  ///< in units of the value
  double relative = 0;  ///< as a fraction of `terms`
};

}  // namespace tetracone::kernel

#endif
