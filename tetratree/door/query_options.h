#ifndef TETRACONE_TETRATREE_DOOR_QUERY_OPTIONS_H
#define TETRACONE_TETRATREE_DOOR_QUERY_OPTIONS_H

#include "tetracone/kernel/predicate/tolerance.h"

#include <string_view>

namespace tetracone {

using kernel::Tolerance;

/// The arithmetic that decides. Exact are adaptive, epeck and rational; epick is exact of images that it rounds.
enum class Kernel { adaptive, double_, float_, double_eps, epick, epeck, rational };

/// How a query finds its answer.
enum class Method {
  tree,   ///< the fastest tree that the kernel has
  paper,  ///< the tetra-tree of JS08 with the paper's choices
  brute   ///< every edge against every face
};

/// The enumerator's own name.
constexpr std::string_view to_string(Method method)
{
  return method == Method::tree ? "tree" : method == Method::paper ? "paper" : "brute";
}

/// What else a query can be told.
struct Query_options {
  Kernel kernel = Kernel::adaptive;  ///< the arithmetic
  Method method = Method::tree;      ///< the way to the answer
  Tolerance tolerance = {};          ///< of Kernel::double_eps
  bool remember = false;  ///< keep from pose to pose what decided the last one: for motions in small steps. Changes no
                          ///< answer
};

}  // namespace tetracone

#endif
