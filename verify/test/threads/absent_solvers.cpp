// Of the kernels that no body is asked by in this test there is no solver: ThreadSanitizer would take half as long again to
// instrument them.

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
