#ifndef TETRACONE_TETRATREE_PAPER_BOUNDING_TETRAHEDRON_H
#define TETRACONE_TETRATREE_PAPER_BOUNDING_TETRAHEDRON_H

#include "tetracone/kernel/bound/cone_coordinates.h"
#include "tetracone/tetratree/paper/config.h"
#include "tetracone/tetratree/paper/tetra_cone.h"

namespace tetracone::tetratree {

/// Returns the bounding tetrahedron V0 V'1 V'2 V'3 of what lies in a tetra-cone (JS08 Definition 5): V'i is on ray i,
/// and every vertex of the classified tetrahedra is on the same side of the plane V'1 V'2 V'3 as V0. It is given by the
/// fractions `length[i]` = |V0 V'i| / |V0 Vi|.
///
/// `shortened` begins with an isosceles tetrahedron as long as the farthest vertex needs. Then it runs the loop of
/// section 2.3.1. Each edge in turn is shortened by a fraction. If the tetrahedron no longer bounds, the edge is
/// lengthened again by a fraction, and that is kept if it bounds. `tightest` takes the bounding plane of least volume.
///
/// Departures: the fractions are 3 % and 1.5 % where Fig. 8 shows 10 % and 5 % (`Config::shorten_by`). The test
/// "bounds" is the sign of the barycentric coordinate at V0 of all vertices at once. It takes the largest of the linear
/// forms sum_i c_i / length_i, where c are a vertex's coordinates along the rays.
template <class B, bool sound>
std::array<B, 3> bounding_tetrahedron(const kernel::Cone_coordinates<B, sound>& vertices, const Config& config)
{
  std::array<B, 3> length = vertices.isosceles();
  if (config.far_plane == Far_plane::tightest) return vertices.least_volume(length);
  const B shorter = B(1 - config.shorten_by), longer = B(1 + config.lengthen_by);
  for (int round = 0; round < config.shortening_rounds; ++round) {
    bool changed = false;
    for (int i = 0; i < 3; ++i) {
      const B before = length[i];
      length[i] = before * shorter;
      if (!vertices.bounded_by(length)) length[i] *= longer;
      if (!vertices.bounded_by(length)) length[i] = before;
      changed = changed || length[i] != before;
    }
    if (!changed) break;
  }
  return length;
}

}  // namespace tetracone::tetratree

#endif
