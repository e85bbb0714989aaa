#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>

namespace tetracone {
namespace {

const tetratree::Point_locator& locator_of(const detail::Body_data& data)
{
  kernel::require_sound_floating_point();
  if (!data.is_closed()) [[unlikely]]
    detail::require_solid(data, "body", "points inside or outside");
  return data.point_locator();
}

[[noreturn]] void refuse_coordinate(const std::string& point, std::size_t k, const std::string& is,
                                    const char* expected)
{
  throw Error(point + ": " + "xyz"[k] + " is " + is + "; expected " + expected);
}

/// Throws Error, in the name of `name()`, for a coordinate that is not finite.
template <class Name>
void require_finite(const std::array<double, 3>& point, const Name& name)
{
  for (std::size_t k = 0; k < 3; ++k)
    if (!std::isfinite(point[k])) [[unlikely]]
      refuse_coordinate(name(), k, kernel::shortest(point[k]), "a finite number");
}

/// True when all coordinates are finite. It has no branch for each, since there are many.
bool all_finite(std::span<const std::array<double, 3>> points)
{
  int all = 1;
  for (const auto& p : points)
    for (const double x : p) all &= std::abs(x) <= std::numeric_limits<double>::max();
  return all != 0;
}

}  // namespace

Location Body::inside(const std::array<double, 3>& point) const
{
  require_finite(point, [] { return std::string("point"); });
  return locator_of(*data_).locate(point);
}

std::vector<Location> Body::inside(std::span<const std::array<double, 3>> points) const
{
  const tetratree::Point_locator& locator = locator_of(*data_);
  std::vector<Location> answers(points.size());
  // Few enough that they stay in the cache for the second pass.
  constexpr std::size_t at_a_time = 512;
  for (std::size_t first = 0; first < points.size(); first += at_a_time) {
    const std::size_t count = kernel::minimum(at_a_time, points.size() - first);
    const auto some = points.subspan(first, count);
    if (!all_finite(some)) [[unlikely]]
      for (std::size_t k = 0; k < count; ++k)
        require_finite(some[k], [k, first] { return "points[" + std::to_string(first + k) + "]"; });
    locator.locate(some, std::span(answers).subspan(first, count));
  }
  return answers;
}

Location Body::inside_text(const std::array<std::string, 3>& point) const
{
  std::array<kernel::Rational, 3> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto number = kernel::parse_number(point[k]);
    if (!number)
      refuse_coordinate("point", k, "'" + point[k].substr(0, 40) + "'", "a finite decimal number or a fraction n/d");
    exact[k] = *number;
  }
  return locator_of(*data_).locate(exact);
}

std::size_t Body::inside_bytes() const { return locator_of(*data_).bytes(); }

}  // namespace tetracone
