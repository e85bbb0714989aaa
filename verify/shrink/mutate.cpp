#include "verify/shrink/mutate.h"

#include "tetracone/covering/planarity.h"
#include "tetracone/covering/repair/repair.h"
#include "verify/cases/case_numbers.h"
#include "verify/cases/exact_map.h"
#include "verify/cases/exact_motion.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace tetracone::verify {
namespace {

using kernel::Pose;
using kernel::Vertex;

/// x moved by 1 to 2^10 ulps, small moves more often.
double nudged(double x, Random& random)
{
  const double end = random.bits() % 2 == 0 ? HUGE_VAL : -HUGE_VAL;
  double moved = x;
  for (std::size_t step = std::max<std::size_t>(1, 1024 >> one_of(random, 11) >> one_of(random, 11)); step-- > 0;)
    moved = std::nextafter(moved, end);
  return std::isfinite(moved) ? moved : x;
}

/// The point of body `body` whose image is nearest to the image of point `i` of the other; nothing when it is beyond
/// the doubles.
std::optional<Vertex> across(const Case_numbers& n, int body, std::size_t i)
{
  using namespace object_family;
  const Vertex result = rounded(preimage(n.poses[body], image(n.poses[1 - body], exact(n.points[1 - body][i]))));
  return std::all_of(result.begin(), result.end(), [](double coordinate) { return std::isfinite(coordinate); })
             ? std::optional(result)
             : std::nullopt;
}

void change(Case_numbers& n, Random& random)
{
  const int body = int(one_of(random, 2));
  auto& points = n.points[body];
  switch (one_of(random, 3)) {
    case 0: {
      double& x = points[one_of(random, points.size())][one_of(random, 3)];
      x = nudged(x, random);
      break;
    }
    case 1: {
      Entries m = entries_of(n.poses[body]);
      const std::size_t k = one_of(random, 12);
      m[k] = nudged(n.poses[body][int(k)], random);
      n.poses[body] = Pose(m);
      break;
    }
    default: {
      const auto point = across(n, body, one_of(random, n.points[1 - body].size()));
      if (point) points[one_of(random, points.size())] = *point;
    }
  }
}

/// False where a pose became flat.
bool change_some(Case_numbers& n, Random& random)
{
  for (std::size_t k = 1 + one_of(random, 3); k-- > 0;) {
    change(n, random);
    for (const Pose& pose : n.poses)
      if (pose.determinant_sign() == CGAL::ZERO) return false;
  }
  return true;
}

std::shared_ptr<const covering::Polyhedron> planar(const std::shared_ptr<const covering::Polyhedron>& polyhedron)
{
  for (covering::Index f = 0; f < polyhedron->face_count(); ++f)
    if (covering::planarity(*polyhedron, f) == covering::Planarity::off_plane)
      return std::make_shared<covering::Polyhedron>(covering::triangulate_non_planar(*polyhedron).polyhedron);
  return polyhedron;
}

}  // namespace

Object_case mutated(const Object_case& c, Random& random)
{
  Case_numbers numbers = numbers_of(c);
  const bool swap = one_of(random, 4) == 0;
  if (!change_some(numbers, random)) return c;
  Object_case result = with_numbers(c, numbers);
  result.a = planar(result.a);
  result.b = planar(result.b);
  if (swap) {
    std::swap(result.a, result.b);
    std::swap(result.pose_a, result.pose_b);
  }
  return result;
}

Predicate_case mutated(const Predicate_case& c, Random& random)
{
  Case_numbers numbers = numbers_of(c);
  const bool swap = one_of(random, 4) == 0;
  if (!change_some(numbers, random)) return c;
  if (swap) {
    // Three points of the one for three of the other.
    for (int k = 0; k < 3; ++k) std::swap(numbers.points[0][k + 1], numbers.points[1][k]);
    std::swap(numbers.poses[0], numbers.poses[1]);
  }
  return with_numbers(c, numbers);
}

}  // namespace tetracone::verify
