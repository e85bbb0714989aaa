#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/query_data.h"
#include "tetracone/tetratree/door/relation_solver.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <array>
#include <cstddef>
#include <string>

namespace tetracone {
namespace {

detail::Relation_solver& relation_of(detail::Query_data& data)
{
  if (data.question != Question::solid)
    throw Error("query: Question::surface tells no relation of solids; expected Question::solid");
  if (data.options.kernel != Kernel::adaptive)
    throw Error("query: kernel " + kernel_name(data.options.kernel, data.options.tolerance) +
                " tells no relation of solids; expected adaptive");
  if (!data.relation) data.relation = detail::relation_solver(data.a, data.b);
  return *data.relation;
}

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

Solid_contact Query::solid_relation(const Pose& pose_a, const Pose& pose_b)
{
  return solid_relation(pose_a.exact(), pose_b.exact());
}
Solid_contact Query::solid_relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  return relation_of(data()).relation(pose_a, pose_b);
}

Solid_relation Query::solid_relation_alone(const Pose& pose_a, const Pose& pose_b)
{
  return solid_relation_alone(pose_a.exact(), pose_b.exact());
}
Solid_relation Query::solid_relation_alone(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  return relation_of(data()).relation_alone(pose_a, pose_b);
}

Overlap Query::overlap(const Pose& pose_a, const Pose& pose_b) { return overlap(pose_a.exact(), pose_b.exact()); }
Overlap Query::overlap(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  return relation_of(data()).overlap(pose_a, pose_b);
}

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
  return relation_of(data()).exits(pose_a, pose_b, direction_of(direction));
}

}  // namespace tetracone
