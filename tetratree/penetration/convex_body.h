#ifndef TETRACONE_TETRATREE_PENETRATION_CONVEX_BODY_H
#define TETRACONE_TETRATREE_PENETRATION_CONVEX_BODY_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/covering/union_find.h"
#include "tetracone/kernel/contact/convex_depth.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "tetracone/tetratree/relation/solid_sides.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace tetracone::tetratree {

/// Groups the triangles of a simple solid: two are in one group where a chain of coplanar neighbours joins them. The
/// groups are in the order of their first triangles.
inline std::vector<std::vector<Index>> triangles_of_planes(const covering::Polyhedron& polyhedron,
                                                           const Solid_sides& sides)
{
  covering::Union_find planes(polyhedron.face_count());
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for (int k = 0; k < 3; ++k)
      if (const auto& beyond = sides.beyond(f, k); beyond.side == kernel::ZERO) planes.join(f, beyond.face);
  return covering::grouped_faces(polyhedron.face_count(), planes, std::identity());
}

/// The most pairs of a plane and a corner of a solid that is taken as convex. The time of its depths grows with their
/// number.
inline constexpr std::size_t most_pairs_of_convex = 20'000'000;

/// True only if the solid is convex, and no face lies inside it. Then each triangle parts the solid from its outside,
/// and no two corners are on different sides of a plane. False also where there are more pairs of a plane and a corner
/// than `most_pairs_of_convex`.
inline bool is_known_convex(const covering::Polyhedron& polyhedron, const Solid_sides& sides)
{
  using K = kernel::Adaptive;
  if (!sides.is_simple()) return false;
  std::vector<K::Point_3> corners;
  std::vector<bool> is_used(polyhedron.vertices.size(), false);
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for (int k = 0; k < 3; ++k) {
      if (sides.beyond(f, k).side == kernel::NEGATIVE) return false;
      const Index v = polyhedron.loop(f, 0)[std::size_t(k)];
      if (!is_used[sides.place(v)]) corners.push_back(K::unmoved(polyhedron.vertices[v]));
      is_used[sides.place(v)] = true;
    }
  const auto planes = triangles_of_planes(polyhedron, sides);
  if (planes.size() * corners.size() > most_pairs_of_convex) return false;
  for (const std::vector<Index>& plane : planes) {
    const covering::Loop t = polyhedron.loop(plane.front(), 0);
    const auto at = [&](std::size_t k) { return K::unmoved(polyhedron.vertices[t[k]]); };
    const std::array<K::Point_3, 3> triangle = {at(0), at(1), at(2)};
    CGAL::Sign side = CGAL::ZERO;
    for (const K::Point_3& corner : corners) {
      const CGAL::Sign of_corner = K::volume_sign(triangle[0], triangle[1], triangle[2], corner);
      if (of_corner * side == CGAL::NEGATIVE) return false;
      if (of_corner != CGAL::ZERO) side = of_corner;
    }
  }
  return true;
}

/// Returns the corners, faces and edges of a convex solid. Requires `is_convex`.
///
/// The triangles of a plane are one face. Otherwise the end of a cylinder over a polygon of many corners would give its
/// normal once a triangle.
inline kernel::Convex_solid convex_solid(const covering::Polyhedron& polyhedron, const Solid_sides& sides)
{
  kernel::Convex_solid solid;
  std::vector<std::uint32_t> number(polyhedron.vertices.size(), covering::none);
  const auto corner = [&](Index vertex) {
    const Index v = sides.place(vertex);
    if (number[v] == covering::none) {
      number[v] = std::uint32_t(solid.corners.size());
      solid.corners.push_back(polyhedron.vertices[v]);
    }
    return number[v];
  };
  std::vector<std::uint32_t> face(polyhedron.face_count());
  for (const std::vector<Index>& plane : triangles_of_planes(polyhedron, sides)) {
    for (const Index f : plane) face[f] = std::uint32_t(solid.faces.size());
    const covering::Loop t = polyhedron.loop(plane.front(), 0);
    solid.faces.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
  }
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for (int k = 0; k < 3; ++k) {
      const covering::Loop t = polyhedron.loop(f, 0);
      const std::array<std::uint32_t, 2> faces = {face[f], face[sides.beyond(f, k).face]};
      if (faces[0] < faces[1])
        solid.edges.push_back({{corner(t[std::size_t(k)]), corner(t[std::size_t(k + 1) % 3])}, faces});
    }
  return solid;
}

}  // namespace tetracone::tetratree

#endif
