#include "tetracone/tetratree/door/query_options.h"

#include "tetracone/kernel/number/number.h"

#include <cmath>
#include <cstddef>

namespace tetracone {
namespace {

constexpr std::array<std::string_view, 7> kernel_names = {"adaptive", "double", "float",   "double-eps",
                                                          "epick",    "epeck",  "rational"};

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
  for (std::size_t k = 0; k < kernel_names.size(); ++k) {
    options.kernel = Kernel(k);
    if (name == kernel_names[k] && options.kernel != Kernel::double_eps) return options;
  }
  return std::nullopt;
}

std::string kernel_name(Kernel kernel, const Tolerance& tolerance)
{
  const std::string name(kernel_names[static_cast<std::size_t>(kernel)]);
  if (kernel != Kernel::double_eps) return name;
  return name + (tolerance.relative > 0 ? "=rel:" + kernel::shortest(tolerance.relative)
                                        : "=" + kernel::shortest(tolerance.absolute));
}

}  // namespace tetracone
