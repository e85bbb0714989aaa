#ifndef TETRACONE_COVERING_PROJECTION_H
#define TETRACONE_COVERING_PROJECTION_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/number.h"

namespace tetracone::covering {

/// Returns twice the signed area of a loop in the projection along coordinate `axis`, exactly.
inline kernel::Rational projected_area(const Polyhedron& polyhedron, Loop loop, int axis)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  kernel::Rational area = 0;
  for (std::size_t j = 0; j < loop.size(); ++j) {
    const kernel::Vertex& p = polyhedron.vertices[loop[j]];
    const kernel::Vertex& q = polyhedron.vertices[loop[j + 1 < loop.size() ? j + 1 : 0]];
    area += kernel::Rational(p[u]) * kernel::Rational(q[v]) - kernel::Rational(p[v]) * kernel::Rational(q[u]);
  }
  return area;
}

/// Returns the coordinate along which the projection of a loop has the largest area, the first of equals, exactly. It
/// is the largest component of the loop's Newell normal.
inline int projection_axis(const Polyhedron& polyhedron, Loop loop)
{
  int best = 0;
  kernel::Rational largest = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const kernel::Rational area = abs(projected_area(polyhedron, loop, axis));
    if (area > largest) {
      largest = area;
      best = axis;
    }
  }
  return best;
}

}  // namespace tetracone::covering

#endif
