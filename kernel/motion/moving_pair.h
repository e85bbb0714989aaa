#ifndef TETRACONE_KERNEL_MOTION_MOVING_PAIR_H
#define TETRACONE_KERNEL_MOTION_MOVING_PAIR_H

#include "tetracone/kernel/number/vertex.h"

#include <array>
#include <cstddef>

namespace tetracone::kernel {

/// A point that moves on a line at constant speed: (1-t) start + t end at time t in [0, 1], exactly.
struct Moving_point {
  Vertex start, end;
};

enum class Moving_kind { vertex_face, edge_edge };

/// Two primitives that move. vertex_face: points[0] is the vertex, the others are the corners of a closed triangle.
/// edge_edge: the closed edges points[0] points[1] and points[2] points[3]. Coordinates are finite. Flat triangles and
/// edges of length zero are legal, at any time.
struct Moving_pair {
  Moving_kind kind;
  std::array<Moving_point, 4> points;
};

/// The differences of points that tell whether the boxes of the two primitives overlap. Each, points[to] -
/// points[from], leads from a point of the first primitive to one of the second. The boxes are apart where along some
/// axis all are positive or all are negative.
struct Between {
  std::size_t from, to;
};
inline constexpr std::array<Between, 3> vertex_face_differences = {{{0, 1}, {0, 2}, {0, 3}}};
inline constexpr std::array<Between, 4> edge_edge_differences = {{{0, 2}, {0, 3}, {1, 2}, {1, 3}}};

/// Calls `ask` with each such difference until it returns false. Returns true when it never did.
template <class Ask>
bool all_differences(Moving_kind kind, const Ask& ask)
{
  if (kind == Moving_kind::vertex_face) {
    for (const Between& difference : vertex_face_differences)
      if (!ask(difference)) return false;
  } else {
    for (const Between& difference : edge_edge_differences)
      if (!ask(difference)) return false;
  }
  return true;
}

}  // namespace tetracone::kernel

#endif
