#ifndef TETRACONE_TETRATREE_SOLVER_SOLVERS_INL
#define TETRACONE_TETRATREE_SOLVER_SOLVERS_INL
// Included by the units that CMake makes, one for each row of kernel_list.h: a kernel takes a minute to compile.

#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/door/kernel_list.h"
#include "tetracone/tetratree/solver/bvh8_solver.inl"
#include "tetracone/tetratree/solver/tetra_tree_solver.inl"

/// Instantiates the trees of a row of the list.
#define TETRACONE_INSTANTIATE_SOLVERS(enumerator, name, type, exact)                                                 \
  template std::unique_ptr<tetracone::detail::Solver> tetracone::detail::tetra_tree_solver<tetracone::kernel::type>( \
      const Shared_body& a, const Shared_body& b, const Query_options& options);                                     \
  template std::unique_ptr<tetracone::detail::Solver> tetracone::detail::bvh8_solver<tetracone::kernel::type>(       \
      const Shared_body& a, const Shared_body& b, const Query_options& options);

#endif
