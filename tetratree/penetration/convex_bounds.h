#ifndef TETRACONE_TETRATREE_PENETRATION_CONVEX_BOUNDS_H
#define TETRACONE_TETRATREE_PENETRATION_CONVEX_BOUNDS_H

#include "tetracone/covering/covering.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/contact/convex_hull.h"
#include "tetracone/tetratree/penetration/convex_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// Convex solids about a solid and inside of it. Most solids that are meant to be convex are not, since their corners
/// are rounded. The depths of both bracket the solid's own.
namespace tetracone::tetratree {

using covering::Index;

/// Returns the hull of points as triangles that face outward; nothing where the points lie in a plane, or nearly do.
inline std::optional<covering::Polyhedron> hull_of(std::span<const covering::Vertex> points)
{
  const auto hull = kernel::Convex_hull::of(points);
  if (!hull) return std::nullopt;
  covering::Polyhedron polyhedron;
  std::vector<Index> number(points.size(), covering::none);
  for (const auto& triangle : hull->triangles()) {
    std::array<Index, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      Index& n = number[triangle[k]];
      if (n == covering::none) {
        n = Index(polyhedron.vertices.size());
        polyhedron.vertices.push_back(points[triangle[k]]);
      }
      corners[k] = n;
    }
    polyhedron.add_polygon(corners);
  }
  return polyhedron;
}

/// Returns the volume that triangles enclose, rounded. Coordinates are taken from `about`.
inline double rounded_volume(const covering::Polyhedron& triangles, const covering::Vertex& about)
{
  double sum = 0;
  for (Index f = 0; f < triangles.face_count(); ++f) {
    const covering::Loop t = triangles.loop(f, 0);
    const auto at = [&](std::size_t k) { return kernel::difference(triangles.vertices[t[k]], about); };
    sum += kernel::dot(at(0), kernel::cross(at(1), at(2)));
  }
  return sum / 6;
}

/// Two convex polyhedra. The outer one is the hull of a solid, which holds the inner one.
struct Convex_bounds {
  covering::Polyhedron outer, inner;
};

/// Returns bounds of a solid of triangles; nothing where it is far from convex. Nor are there bounds where the hull has
/// more pairs of a triangle and a corner than `most_pairs_of_convex`. lies_in(inner) tells whether the solid holds
/// another one.
///
/// The inner one is the hull, made smaller about a point in it, by as little as is enough.
template <class Lies_in>
std::optional<Convex_bounds> convex_bounds(const covering::Polyhedron& solid, const Lies_in& lies_in)
{
  constexpr double most_lacking = 0x1p-6;                      // of a solid's volume in its hull
  constexpr std::array smaller = {44, 38, 32, 26, 20, 14, 8};  // the hull is made smaller by 2^-n of its size
  std::vector<bool> is_corner(solid.vertices.size(), false);
  for (Index f = 0; f < solid.face_count(); ++f) {
    if (!solid.is_triangle(f)) return std::nullopt;
    for (const Index v : solid.loop(f, 0)) is_corner[v] = true;
  }
  std::vector<covering::Vertex> corners;
  for (std::size_t v = 0; v < is_corner.size(); ++v)
    if (is_corner[v]) corners.push_back(solid.vertices[v]);
  auto outer = hull_of(corners);
  if (!outer || outer->face_count() * outer->vertices.size() > most_pairs_of_convex) return std::nullopt;
  covering::Vertex centre{};
  for (const covering::Vertex& v : outer->vertices)
    for (std::size_t k = 0; k < 3; ++k) centre[k] += v[k] / double(outer->vertices.size());
  const double whole = rounded_volume(*outer, centre), own = std::abs(rounded_volume(solid, centre));
  if (!(whole - own <= most_lacking * whole)) return std::nullopt;
  for (const int n : smaller) {
    std::vector<covering::Vertex> nearer = outer->vertices;
    for (covering::Vertex& v : nearer)
      for (std::size_t k = 0; k < 3; ++k) v[k] -= std::ldexp(v[k] - centre[k], -n);
    auto inner = hull_of(nearer);
    if (inner && lies_in(*inner)) return Convex_bounds{*std::move(outer), *std::move(inner)};
  }
  return std::nullopt;
}

}  // namespace tetracone::tetratree

#endif
