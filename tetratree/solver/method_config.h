#ifndef TETRACONE_TETRATREE_SOLVER_METHOD_CONFIG_H
#define TETRACONE_TETRATREE_SOLVER_METHOD_CONFIG_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/query_options.h"
#include "tetracone/tetratree/paper/config.h"

#include <string>

namespace tetracone {

/// Returns the choices for a method's tetra-trees and their queries. `Method::tree` has no tetra-tree; it gets the
/// choices of `Method::tuned`.
inline tetratree::Config config_of(Method method)
{
  switch (method) {
    case Method::tree:
    case Method::tuned: return tetratree::Config::fastest();
    case Method::paper: return tetratree::Config::paper();
    case Method::brute: break;
  }
  return tetratree::Config::brute();
}

/// Returns the name under which a body keeps the tetra-tree that these options ask for. Options of the same kernel,
/// method and tolerance share a tree.
inline std::string tree_name(const Query_options& options)
{
  return std::to_string(int(options.kernel)) + ' ' + std::to_string(int(options.method)) + ' ' +
         kernel::shortest(options.tolerance.absolute) + ' ' + kernel::shortest(options.tolerance.relative);
}

}  // namespace tetracone

#endif
