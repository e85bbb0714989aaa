#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/tetratree/solver/bvh8_solver.inl"
#include "tetracone/tetratree/solver/tetra_tree_solver.inl"

namespace tetracone::detail {

template std::unique_ptr<Solver> tetra_tree_solver<kernel::Tolerant>(const Shared_body& a, const Shared_body& b,
                                                                     const Query_options& options);
template std::unique_ptr<Solver> bvh8_solver<kernel::Tolerant>(const Shared_body& a, const Shared_body& b,
                                                               const Query_options& options);

}  // namespace tetracone::detail
