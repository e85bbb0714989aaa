#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/query_data.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <array>
#include <cstddef>
#include <string>

namespace tetracone {
namespace {

/// Returns the exact direction of three texts. Throws Error as `Query::exits`.
std::array<kernel::Rational, 3> direction_of(const std::array<std::string, 3>& texts)
{
  std::array<kernel::Rational, 3> direction;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto number = kernel::parse_number(texts[k]);
    if (!number)
      throw Error("exits: '" + texts[k].substr(0, 40) +
                  "' in the direction; expected a finite decimal number or a fraction n/d");
    direction[k] = *number;
  }
  if (direction == std::array<kernel::Rational, 3>{0, 0, 0})
    throw Error("exits: the direction is 0; expected a vector of some length");
  return direction;
}

}  // namespace

Exits Query::exits(const Pose& pose_a, const Pose& pose_b, const std::array<double, 3>& direction)
{
  const auto text = [](double x) { return kernel::shortest(x); };
  return exits(pose_a.exact(), pose_b.exact(), {text(direction[0]), text(direction[1]), text(direction[2])});
}
Exits Query::exits(const Pose& pose_a, const Pose& pose_b, const std::array<std::string, 3>& direction)
{
  return exits(pose_a.exact(), pose_b.exact(), direction);
}
Exits Query::exits(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::array<std::string, 3>& direction)
{
  return detail::relation_of(data()).exits(pose_a, pose_b, direction_of(direction));
}

Depth Query::depth(const Pose& pose_a, const Pose& pose_b, const Depth_options& options)
{
  return depth(pose_a.exact(), pose_b.exact(), options);
}
Depth Query::depth(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const Depth_options& options)
{
  if (!(options.relative >= 0 && options.relative < 1))
    throw Error("depth: a relative width of " + kernel::shortest(options.relative) +
                "; expected a number from 0 to below 1");
  return detail::relation_of(data()).depth(pose_a, pose_b, options);
}

}  // namespace tetracone
