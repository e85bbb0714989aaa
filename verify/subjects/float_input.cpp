#include "verify/subjects/float_input.h"

#include "tetracone/covering/planarity.h"
#include "tetracone/covering/repair/repair.h"
#include "tetracone/kernel/number/floating_point.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace tetracone::verify {
namespace {

/// Rounds the number; false where it has no finite float.
bool round_to_float(double& number)
{
  number = double(kernel::to_float(number));
  return std::isfinite(number);
}

std::shared_ptr<const covering::Polyhedron> rounded(const covering::Polyhedron& body)
{
  const auto triangles = triangles_of(body);
  if (!triangles) return nullptr;
  auto result = std::make_shared<covering::Polyhedron>();
  result->vertices = body.vertices;
  for (kernel::Vertex& v : result->vertices)
    if (!std::ranges::all_of(v, round_to_float)) return nullptr;
  for (const auto& [i, j, k] : *triangles) result->add_polygon({i, j, k});
  return result;
}

std::optional<kernel::Pose> rounded(const kernel::Pose& pose)
{
  auto entries = pose.entries();
  if (!std::ranges::all_of(entries, round_to_float)) return std::nullopt;
  const kernel::Pose result(entries);
  return result.determinant_sign() == CGAL::ZERO ? std::nullopt : std::optional(result);
}

}  // namespace

std::optional<Triangles> triangles_of(const covering::Polyhedron& polyhedron)
{
  Triangles triangles;
  for (covering::Index f = 0; f < polyhedron.face_count(); ++f) {
    if (polyhedron.is_triangle(f)) {
      const auto loop = polyhedron.loop(f, 0);
      triangles.push_back({loop[0], loop[1], loop[2]});
      continue;
    }
    auto parts = covering::repair::constrained_delaunay(polyhedron, f);
    if (!parts && covering::planarity(polyhedron, f) == covering::Planarity::degenerate)
      parts = covering::repair::fan(polyhedron, f);
    if (!parts) return std::nullopt;
    triangles.insert(triangles.end(), parts->begin(), parts->end());
  }
  if (triangles.empty()) return std::nullopt;
  return triangles;
}

std::optional<Object_case> float_input(const Object_case& c, In_floats in_floats)
{
  assert(in_floats != In_floats::nothing);
  Object_case result{rounded(*c.a), c.a == c.b ? nullptr : rounded(*c.b), c.pose_a, c.pose_b, c.origin, {}, {}};
  if (c.a == c.b) result.b = result.a;
  if (!result.a || !result.b) return std::nullopt;
  if (in_floats == In_floats::vertices) return result;
  const auto pose_a = rounded(c.pose_a), pose_b = rounded(c.pose_b);
  if (!pose_a || !pose_b) return std::nullopt;
  result.pose_a = *pose_a;
  result.pose_b = *pose_b;
  return result;
}

}  // namespace tetracone::verify
