#ifndef TETRACONE_TETRATREE_DOOR_METHOD_CONFIG_H
#define TETRACONE_TETRATREE_DOOR_METHOD_CONFIG_H

#include "tetracone/tetratree/door/query_options.h"
#include "tetracone/tetratree/paper/config.h"

namespace tetracone {

/// The choices of trees and queries that the method stands for.
inline tetratree::Config config_of(Method method)
{
  switch (method) {
    case Method::tree: return tetratree::Config::fastest();
    case Method::paper: return {};
    case Method::brute: return tetratree::Config::brute();
  }
  return {};
}

}  // namespace tetracone

#endif
