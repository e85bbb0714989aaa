#ifndef TETRACONE_VERIFY_CASES_TETRAHEDRON_H
#define TETRACONE_VERIFY_CASES_TETRAHEDRON_H

#include "tetracone/covering/polyhedron.h"

#include <array>

namespace tetracone::verify {

/// Adds four vertices and four triangles to the polyhedron; outward when a, b, c, d has a positive determinant.
inline void add_tetrahedron(covering::Polyhedron& polyhedron, const std::array<kernel::Vertex, 4>& corners)
{
  using covering::Index;
  const Index first = static_cast<Index>(polyhedron.vertices.size());
  polyhedron.vertices.insert(polyhedron.vertices.end(), corners.begin(), corners.end());
  for (const auto& [i, j, k] : {std::array<Index, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    polyhedron.add_polygon({first + i, first + j, first + k});
}

}  // namespace tetracone::verify

#endif
