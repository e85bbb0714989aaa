#ifndef TETRACONE_KERNEL_PREDICATE_KEPT_IMAGES_H
#define TETRACONE_KERNEL_PREDICATE_KEPT_IMAGES_H

#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/fixed_integer.h"

#include <CGAL/Mpzf.h>

#include <array>
#include <memory>
#include <optional>

namespace tetracone::kernel {

/// An image in double-double, and an upper bound of its error.
struct Double_double_image {
  std::array<Double_double, 3> coordinate;
  double error;  ///< per coordinate; infinite: not known
};

/// An exact image times the weight of its pose: three integers times 2^exponent.
struct Fixed_image {
  static constexpr int limbs = 4;

  std::array<Fixed_integer<limbs>, 3> coordinate;
  int exponent = 0;
  int bits = 0;  ///< each coordinate is below 2^bits; undefined above `Adaptive_fixed::most_bits`
};

/// An exact image times the weight of its pose, in binary fractions of any width.
using Exact_image = std::array<CGAL::Mpzf, 3>;

/// What the stages of the adaptive kernel have computed of a placed point, each once while its pose stays.
struct Kept_images {
  std::optional<Double_double_image> double_double;
  std::optional<Fixed_image> fixed;
  std::unique_ptr<Exact_image> exact;

  void clear()
  {
    double_double.reset();
    fixed.reset();
    exact.reset();
  }
};

}  // namespace tetracone::kernel

#endif
