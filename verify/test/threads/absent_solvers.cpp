// Stubs for the kernels that this test never asks: with their solvers, ThreadSanitizer would take half as long again to
// instrument the test.

#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/solver.h"

#include <cstdlib>

namespace tetracone::detail {

#define ABSENT(solver, kernel)                                                                         \
  template <>                                                                                          \
  std::unique_ptr<Solver> solver<kernel>(const Shared_body&, const Shared_body&, const Query_options&) \
  {                                                                                                    \
    std::abort();                                                                                      \
  }
#define ABSENT_KERNEL(kernel) ABSENT(tetra_tree_solver, kernel) ABSENT(bvh8_solver, kernel)
ABSENT_KERNEL(kernel::Double)
ABSENT_KERNEL(kernel::Epeck)
ABSENT_KERNEL(kernel::Epick)
ABSENT_KERNEL(kernel::Float)
ABSENT_KERNEL(kernel::Rational_kernel)
ABSENT_KERNEL(kernel::Tolerant)

}  // namespace tetracone::detail
