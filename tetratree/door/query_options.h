#ifndef TETRACONE_TETRATREE_DOOR_QUERY_OPTIONS_H
#define TETRACONE_TETRATREE_DOOR_QUERY_OPTIONS_H

#include "tetracone/kernel/predicate/tolerance.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace tetracone {

using kernel::Tolerance;

/// The arithmetic that decides. Exact are adaptive, epeck and rational; epick is exact of images that it rounds.
enum class Kernel { adaptive, double_, float_, double_eps, epick, epeck, rational };

/// How a query finds its answer.
enum class Method {
  tree,   ///< the fast tree: eight oriented boxes a node
  tuned,  ///< the tetra-tree of JS08 with the fastest choices
  paper,  ///< the tetra-tree of JS08 with the paper's choices
  brute   ///< every edge against every face
};

inline constexpr std::array all_methods = {Method::tree, Method::tuned, Method::paper, Method::brute};

/// The enumerator's own name.
constexpr std::string_view to_string(Method method)
{
  switch (method) {
    case Method::tree: return "tree";
    case Method::tuned: return "tuned";
    case Method::paper: return "paper";
    case Method::brute: break;
  }
  return "brute";
}

/// The method of that name; nothing when there is none.
std::optional<Method> parse_method(std::string_view name);

/// What else a query can be told.
struct Query_options {
  Kernel kernel = Kernel::adaptive;  ///< the arithmetic
  Method method = Method::tree;      ///< the way to the answer
  Tolerance tolerance = {};          ///< of Kernel::double_eps
  bool remember = false;  ///< keep from pose to pose what decided the last one: for motions in small steps. Changes no
                          ///< answer
};

/// The kernel, and where it has one the tolerance, of a name: adaptive, double, float, epick, epeck, rational,
/// double-eps=E or double-eps=rel:E with E >= 0 finite: a sign is zero up to E, absolute, or relative to the sum of its
/// products. Nothing when there is none such.
std::optional<Query_options> parse_kernel(std::string_view name);

/// The name that `parse_kernel` reads.
std::string kernel_name(Kernel kernel, const Tolerance& tolerance = {});

}  // namespace tetracone

#endif
