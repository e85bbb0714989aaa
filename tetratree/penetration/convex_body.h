#ifndef TETRACONE_TETRATREE_PENETRATION_CONVEX_BODY_H
#define TETRACONE_TETRATREE_PENETRATION_CONVEX_BODY_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/contact/convex_depth.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "tetracone/tetratree/relation/solid_sides.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace tetracone::tetratree {

/// True when the solid is convex, and no face lies inside it. Then each triangle parts the solid from its outside, and
/// no two corners are on different sides of its plane. Bodies with more pairs of a triangle and a corner than
/// `most_pairs` are not looked at: false.
inline bool is_convex(const covering::Polyhedron& polyhedron, const Solid_sides& sides)
{
  constexpr std::size_t most_pairs = 20'000'000;
  using K = kernel::Adaptive;
  if (!sides.is_simple() || polyhedron.face_count() * polyhedron.vertices.size() > most_pairs) return false;
  std::set<Index> used;
  for (Index f = 0; f < polyhedron.face_count(); ++f)
    for (const Index v : polyhedron.loop(f, 0)) used.insert(v);
  std::vector<K::Point_3> corners;
  for (const kernel::Vertex& v : polyhedron.vertices) corners.push_back(K::unmoved(v));
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const covering::Loop t = polyhedron.loop(f, 0);
    CGAL::Sign side = CGAL::ZERO;
    for (const Index v : used) {
      const CGAL::Sign of_v = K::volume_sign(corners[t[0]], corners[t[1]], corners[t[2]], corners[v]);
      if (of_v * side == CGAL::NEGATIVE) return false;
      if (of_v != CGAL::ZERO) side = of_v;
    }
  }
  return true;
}

/// Returns the corners, triangles and edges of a convex solid. Requires `is_convex`.
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
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> half_edges;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const covering::Loop t = polyhedron.loop(f, 0);
    solid.triangles.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
    for (int k = 0; k < 3; ++k) half_edges[{corner(t[k]), corner(t[(k + 1) % 3])}] = f;
  }
  for (const auto& [ends, f] : half_edges)
    if (ends[0] < ends[1]) solid.edges.push_back({ends, {f, half_edges.at({ends[1], ends[0]})}});
  return solid;
}

}  // namespace tetracone::tetratree

#endif
