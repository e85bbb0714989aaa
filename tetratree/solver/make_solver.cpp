// The factory: a query's options to its solver.

#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/solver.h"

#include <memory>

namespace tetracone::detail {
namespace {

template <class K>
std::unique_ptr<Solver> solver_of(const Shared_body& a, const Shared_body& b, const Query_options& options)
{
  return options.method == Method::tree ? bvh8_solver<K>(a, b, options) : tetra_tree_solver<K>(a, b, options);
}

}  // namespace

std::unique_ptr<Solver> make_solver(const Shared_body& a, const Shared_body& b, const Query_options& options)
{
  switch (options.kernel) {
#define TETRACONE_CASE(kernel_, name, type, exact)                               \
  case Kernel::kernel_:                                                          \
    static_assert(exact == (kernel::Kernel_traits<kernel::type>::exact_signs &&  \
                            kernel::Kernel_traits<kernel::type>::exact_motion)); \
    return solver_of<kernel::type>(a, b, options);
    TETRACONE_FOR_EACH_KERNEL(TETRACONE_CASE)
#undef TETRACONE_CASE
  }
  throw Error("query: no such kernel; expected one of Kernel's");
}

}  // namespace tetracone::detail
