// The factory: a query's options to its solver. The units of the kernels are made by CMake, one for each row of kernel_list.h.

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/solver.h"

#include <cstddef>
#include <future>
#include <memory>

namespace tetracone::detail {
namespace {

/// Makes what there is to be of both fast trees before the first pose, at the same time where that is worth a thread.
void make_roots(const Body_data& a, const Body_data& b)
{
  constexpr std::size_t worth_a_thread = 100'000;  // faces: some tens of milliseconds
  if (a.made_bvh8() || b.made_bvh8() ||
      kernel::minimum(a.polyhedron.face_count(), b.polyhedron.face_count()) < worth_a_thread)
    return;
  auto of_b = std::async(std::launch::async, [&] { b.bvh8(); });
  a.bvh8();
  of_b.get();
}

template <class K>
std::unique_ptr<Solver> solver_of(const Shared_body& a, const Shared_body& b, const Query_options& options)
{
  if (options.method != Method::tree) return tetra_tree_solver<K>(a, b, options);
  make_roots(*a, *b);
  return bvh8_solver<K>(a, b, options);
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
