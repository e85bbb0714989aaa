#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/distance_solver.h"
#include "tetracone/tetratree/door/query_data.h"
#include "tetracone/tetratree/door/tetracone.h"

#include <cmath>
#include <string>
#include <vector>

namespace tetracone {
namespace {

detail::Distance_solver& distance_of(detail::Query_data& data)
{
  if (!data.distance) data.distance = detail::distance_solver(data.a, data.b, data.options.kernel);
  if (!data.distance)
    throw Error("query: kernel " + kernel_name(data.options.kernel, data.options.tolerance) +
                " tells no distance; expected adaptive, double or rational");
  return *data.distance;
}

kernel::Rational limit_of(const std::string& text) { return kernel::required_number(text, "query: limit "); }

}  // namespace

double Query::distance(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  return distance_of(data()).distance(pose_a, pose_b, data().question);
}

Nearest Query::nearest(const kernel::Pose& pose_a, const kernel::Pose& pose_b)
{
  return distance_of(data()).nearest(pose_a, pose_b, data().question);
}

bool Query::within(const Pose& pose_a, const Pose& pose_b, double limit)
{
  const kernel::Rational exact = std::isfinite(limit) ? kernel::Rational(limit) : limit_of(kernel::shortest(limit));
  return distance_of(data()).within(pose_a.exact(), pose_b.exact(), data().question, exact);
}
bool Query::within(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::string& limit)
{
  const kernel::Rational exact = limit_of(limit);
  return distance_of(data()).within(pose_a, pose_b, data().question, exact);
}

std::vector<Index> Query::zone(const Pose& pose_a, const Pose& pose_b, const std::string& limit)
{
  return zone(pose_a.exact(), pose_b.exact(), limit);
}
std::vector<Index> Query::zone(const kernel::Pose& pose_a, const kernel::Pose& pose_b, const std::string& limit)
{
  const kernel::Rational exact = limit_of(limit);
  return distance_of(data()).zone(pose_a, pose_b, data().question, exact);
}

}  // namespace tetracone
