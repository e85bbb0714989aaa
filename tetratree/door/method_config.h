#ifndef TETRACONE_TETRATREE_DOOR_METHOD_CONFIG_H
#define TETRACONE_TETRATREE_DOOR_METHOD_CONFIG_H

#include "tetracone/tetratree/door/query_options.h"
#include "tetracone/tetratree/paper/config.h"

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

}  // namespace tetracone

#endif
