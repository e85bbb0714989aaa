#ifndef TETRACONE_TETRATREE_DOOR_QUERY_OPTIONS_H
#define TETRACONE_TETRATREE_DOOR_QUERY_OPTIONS_H

#include "tetracone/kernel/predicate/tolerance.h"
#include "tetracone/tetratree/door/kernel_list.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetracone {

using kernel::Tolerance;

#define TETRACONE_ENUMERATOR(kernel, ...) kernel,
#define TETRACONE_KERNEL(kernel, ...) Kernel::kernel,
/// The arithmetic that decides. Each enumerator is a row of `TETRACONE_FOR_EACH_KERNEL`. `epick` rounds the images and
/// is exact after that.
enum class Kernel { TETRACONE_FOR_EACH_KERNEL(TETRACONE_ENUMERATOR) };
/// Every kernel, in the order of the list.
inline constexpr std::array all_kernels = {TETRACONE_FOR_EACH_KERNEL(TETRACONE_KERNEL)};
#undef TETRACONE_ENUMERATOR
#undef TETRACONE_KERNEL

/// True when every answer of the kernel is right by construction.
constexpr bool is_exact(Kernel kernel)
{
#define TETRACONE_EXACT(enumerator, name, type, exact) ((exact) && kernel == Kernel::enumerator) ||
  return TETRACONE_FOR_EACH_KERNEL(TETRACONE_EXACT) false;
#undef TETRACONE_EXACT
}

/// The way in which a query finds its answer.
enum class Method {
  tree,   ///< the fast tree: eight oriented boxes a node
  tuned,  ///< the tetra-tree of JS08 with the fastest choices
  paper,  ///< the tetra-tree of JS08 with the paper's choices
  brute   ///< every edge against every face
};

/// Every method.
inline constexpr std::array all_methods = {Method::tree, Method::tuned, Method::paper, Method::brute};

/// Returns the enumerator's own name.
constexpr std::string_view to_string(Method method)
{
  constexpr std::array<std::string_view, 4> names = {"tree", "tuned", "paper", "brute"};
  return names[std::size_t(method)];
}

/// Returns the method of this name, or nothing.
std::optional<Method> parse_method(std::string_view name);

/// What a query can be told besides its bodies and its question.
struct Query_options {
  Kernel kernel = Kernel::adaptive;  ///< the arithmetic
  Method method = Method::tree;      ///< the way to the answer
  Tolerance tolerance = {};          ///< for Kernel::double_eps alone
  /// Keeps from pose to pose what decided the last one, for small steps of Method::tree alone. It changes no answer.
  bool remember = false;
};

/// Returns the kernel and tolerance of a name that `kernel_names` lists, or nothing. Tolerances are double-eps=E and
/// double-eps=rel:E with E >= 0 finite: a sign is zero up to E, absolute, or relative to the sum of its products.
std::optional<Query_options> parse_kernel(std::string_view name);

/// Returns the name that `parse_kernel` reads. It has the relative tolerance if that is above 0, else the absolute.
std::string kernel_name(Kernel kernel, const Tolerance& tolerance = {});

/// Returns the names of all kernels as help and error lines show them: "adaptive, double, ... or rational".
std::string kernel_names();

/// Returns the names of the kernels whose every answer is right (`is_exact`).
std::vector<std::string> exact_kernel_names();

}  // namespace tetracone

#endif
