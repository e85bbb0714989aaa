#include "tetracone/tetratree/door/query_options.h"

#include "tetracone/kernel/number/number.h"

#include <cmath>
#include <cstddef>

namespace tetracone {
namespace {

constexpr std::string_view list_name(Kernel asked)
{
  switch (asked) {
#define TETRACONE_CASE(kernel, name, ...) \
  case Kernel::kernel: return name;
    TETRACONE_FOR_EACH_KERNEL(TETRACONE_CASE)
#undef TETRACONE_CASE
  }
  return "";
}

}  // namespace

std::optional<Method> parse_method(std::string_view name)
{
  for (const Method method : all_methods)
    if (name == to_string(method)) return method;
  return std::nullopt;
}

std::optional<Query_options> parse_kernel(std::string_view name)
{
  Query_options options;
  constexpr std::string_view eps = "double-eps=", relative = "rel:";
  if (name.starts_with(eps)) {
    name.remove_prefix(eps.size());
    const bool is_relative = name.starts_with(relative);
    if (is_relative) name.remove_prefix(relative.size());
    const auto value = kernel::parse_double(name);
    if (!value || std::signbit(*value)) return std::nullopt;
    options.kernel = Kernel::double_eps;
    (is_relative ? options.tolerance.relative : options.tolerance.absolute) = *value;
    return options;
  }
  for (const Kernel kernel : all_kernels) {
    options.kernel = kernel;
    if (kernel != Kernel::double_eps && name == list_name(kernel)) return options;
  }
  return std::nullopt;
}

std::string kernel_name(Kernel kernel, const Tolerance& tolerance)
{
  const std::string name(list_name(kernel));
  if (kernel != Kernel::double_eps) return name;
  return name + (tolerance.relative > 0 ? "=rel:" + kernel::shortest(tolerance.relative)
                                        : "=" + kernel::shortest(tolerance.absolute));
}

std::string kernel_names()
{
  std::string names;
  for (std::size_t k = 0; k < all_kernels.size(); ++k) {
    if (k > 0) names += k + 1 == all_kernels.size() ? " or " : ", ";
    names += list_name(all_kernels[k]);
    if (all_kernels[k] == Kernel::double_eps) names += "=E";
  }
  return names;
}

std::vector<std::string> exact_kernel_names()
{
  std::vector<std::string> names;
  for (const Kernel kernel : all_kernels)
    if (is_exact(kernel)) names.push_back(kernel_name(kernel));
  return names;
}

}  // namespace tetracone
