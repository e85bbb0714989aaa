#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/query_data.h"
#include "tetracone/tetratree/door/relation_solver.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <array>
#include <cstddef>
#include <string>

namespace tetracone {

detail::Relation_solver& detail::relation_of(Query_data& data)
{
  if (data.question != Question::solid)
    throw Error("query: Question::surface tells no relation of solids; expected Question::solid");
  if (data.options.kernel != Kernel::adaptive)
    throw Error("query: kernel " + kernel_name(data.options.kernel, data.options.tolerance) +
                " tells no relation of solids; expected adaptive");
  if (!data.relation) data.relation = relation_solver(data.a, data.b);
  return *data.relation;
}

namespace {

std::array<std::string, 3> texts(const std::array<kernel::Wide_fraction, 3>& x)
{
  return {kernel::to_string(x[0].reduced()), kernel::to_string(x[1].reduced()), kernel::to_string(x[2].reduced())};
}

/// Returns the exact direction of three texts. Throws Error as `Query::exits`.
std::array<kernel::Rational, 3> direction_of(const std::array<std::string, 3>& texts)
{
  std::array<kernel::Rational, 3> direction;
  for (std::size_t k = 0; k < 3; ++k) direction[k] = kernel::required_number(texts[k], "exits: ", " in the direction");
  if (direction == std::array<kernel::Rational, 3>{0, 0, 0})
    throw Error("exits: the direction is 0; expected a vector of some length");
  return direction;
}

}  // namespace

std::string Overlap::exact_volume() const { return data ? kernel::to_string(data->solid.volume.reduced()) : "0"; }
std::array<std::string, 3> Overlap::exact_centroid() const
{
  return data && data->has_volume() ? texts(data->solid.centroid) : texts({});
}
std::array<std::string, 3> Overlap::exact_contact_vector() const
{
  if (!data) return texts({});
  const auto& [x, y, z] = data->contact_vector;
  return texts({x, y, z});
}

Solid_contact Query::solid_relation(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  return detail::relation_of(data()).relation(pose_a, pose_b);
}

Solid_relation Query::solid_relation_alone(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  return detail::relation_of(data()).relation_alone(pose_a, pose_b);
}

Overlap Query::overlap(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  return detail::relation_of(data()).overlap(pose_a, pose_b);
}

Overlap_bounds Query::overlap_bounds(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  return detail::relation_of(data()).overlap_bounds(pose_a, pose_b);
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
