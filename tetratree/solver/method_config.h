#ifndef TETRACONE_TETRATREE_SOLVER_METHOD_CONFIG_H
#define TETRACONE_TETRATREE_SOLVER_METHOD_CONFIG_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/query_options.h"
#include "tetracone/tetratree/paper/config.h"

#include <string>

namespace tetracone {

/// The choices of tetra-trees and their queries that the method stands for; of the fast tree, which has none, those of
/// the tetra-tree that answers for it what it does not, features.
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

/// Under which bodies keep the tetra-tree of these options, for all queries that ask alike.
inline std::string tree_name(const Query_options& options)
{
  return std::to_string(int(options.kernel)) + ' ' + std::to_string(int(options.method)) + ' ' +
         kernel::shortest(options.tolerance.absolute) + ' ' + kernel::shortest(options.tolerance.relative);
}

}  // namespace tetracone

#endif
