#ifndef TETRACONE_VERIFY_TEST_EXPERIMENTS_RECIPES_LONG_DOUBLE_H
#define TETRACONE_VERIFY_TEST_EXPERIMENTS_RECIPES_LONG_DOUBLE_H
// Recipe "A kernel": what stands in kernel/predicate/kernels.h.

#include "tetracone/kernel/predicate/kernels.h"

namespace tetracone::kernel {

using Long_double = CGAL::Simple_cartesian<long double>;

template <>
struct Kernel_traits<Long_double> {
  static constexpr bool exact_signs = false, exact_motion = false;
  using Bound = double;
  using Fixed = Long_double;
};

}  // namespace tetracone::kernel

#endif
