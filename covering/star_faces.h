#ifndef TETRACONE_COVERING_STAR_FACES_H
#define TETRACONE_COVERING_STAR_FACES_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/predicate/signs.h"

#include <cstddef>
#include <vector>

namespace tetracone::covering {

/// Returns a fan of triangles from the first corner of each suitable face; nothing for other faces. The decision is
/// exact. A suitable face has one loop of more than three corners. Seen from the first, the others follow in one
/// direction within less than 180 degrees. Every strictly convex face is suitable. The triangles cover a planar face
/// exactly.
inline std::vector<Face_triangle> star_faces(const Polyhedron& polyhedron)
{
  using kernel::Adaptive;
  std::vector<Face_triangle> all;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const Loop loop = polyhedron.loop(f, 0);
    if (polyhedron.loop_count(f) != 1 || loop.size() < 4) continue;
    const auto point = [&](std::size_t k) { return Adaptive::unmoved(polyhedron.vertices[loop[k]]); };
    const int axis = kernel::projection_axis<Adaptive>(point(0), point(1), point(2));
    if (axis < 0) continue;
    const auto turn = [&](std::size_t j, std::size_t k) {
      return kernel::normal_sign<Adaptive>(point(0), point(j), point(k), axis);
    };
    const kernel::Sign way = turn(1, 2);
    bool goes_round = true;
    for (std::size_t k = 2; goes_round && k + 1 < loop.size(); ++k)
      goes_round = turn(k, k + 1) == way && turn(1, k + 1) == way;
    if (!goes_round) continue;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) all.push_back({f, {loop[0], loop[k], loop[k + 1]}});
  }
  return all;
}

}  // namespace tetracone::covering

#endif
