#ifndef TETRACONE_COVERING_IO_WRITE_H
#define TETRACONE_COVERING_IO_WRITE_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/covering/projection.h"
#include "tetracone/kernel/number/number.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <string>

namespace tetracone::covering {

namespace write {

/// Returns "x y z", each the shortest decimal that reads back as exactly that double.
inline std::string coordinates(const Vertex& v)
{
  return kernel::shortest(v[0]) + ' ' + kernel::shortest(v[1]) + ' ' + kernel::shortest(v[2]);
}

/// Returns a point inside the simple polygon `loop`, rounded. Its lexicographically least corner c in the projection is
/// convex. The point is the middle of the triangle of c and its neighbours, if that holds no other corner. Otherwise it
/// is the middle of c and the corner in the triangle that is farthest from the neighbours' line. Requires a loop with
/// an area.
inline Vertex point_inside(const Polyhedron& polyhedron, Loop loop)
{
  using Point = CGAL::Epick::Point_2;
  const int axis = projection_axis(polyhedron, loop);
  const auto vertex = [&](std::size_t k) -> const Vertex& { return polyhedron.vertices[loop[k % loop.size()]]; };
  const auto flat = [&](std::size_t k) { return Point(vertex(k)[(axis + 1) % 3], vertex(k)[(axis + 2) % 3]); };
  std::size_t least = 0;
  for (std::size_t k = 1; k < loop.size(); ++k)
    if (flat(k) < flat(least)) least = k;
  const std::size_t before = least + loop.size() - 1, after = least + 1;
  Point a = flat(before), c = flat(least), b = flat(after);
  if (CGAL::right_turn(a, c, b)) std::swap(a, b);  // now a, c, b turn left

  std::optional<std::size_t> farthest;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Point p = flat(k);
    if (p == a || p == b || p == c) continue;
    const bool in_triangle = !CGAL::right_turn(a, c, p) && !CGAL::right_turn(c, b, p) && !CGAL::right_turn(b, a, p);
    if (in_triangle && (!farthest || CGAL::has_smaller_signed_distance_to_line(b, a, flat(*farthest), p))) farthest = k;
  }
  Vertex inside;
  for (int i = 0; i < 3; ++i)
    inside[i] = farthest ? vertex(least)[i] / 2 + vertex(*farthest)[i] / 2
                         : vertex(before)[i] / 3 + vertex(least)[i] / 3 + vertex(after)[i] / 3;
  return inside;
}

}  // namespace write

/// Returns the polyhedron as the text of an OFF file; `read` gives exactly the same vertices and faces. Requires faces
/// of one loop each, since OFF has no holes.
inline std::string write_off(const Polyhedron& polyhedron)
{
  std::string text =
      "OFF\n" + std::to_string(polyhedron.vertices.size()) + ' ' + std::to_string(polyhedron.face_count()) + " 0\n";
  for (const Vertex& v : polyhedron.vertices) text += write::coordinates(v) + '\n';
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    assert(polyhedron.loop_count(f) == 1);
    const Loop loop = polyhedron.loop(f, 0);
    text += std::to_string(loop.size());
    for (const Index v : loop) text += ' ' + std::to_string(v);
    text += '\n';
  }
  return text;
}

/// Returns the polyhedron as the text of a TetGen .poly file: a facet a face, its outer loop first, and a point inside
/// each hole loop. `read` gives exactly the same vertices and faces if the polyhedron is closed. Requires hole loops
/// that are simple polygons.
inline std::string write_poly(const Polyhedron& polyhedron)
{
  std::string text = std::to_string(polyhedron.vertices.size()) + " 3 0 0\n";
  for (std::size_t v = 0; v < polyhedron.vertices.size(); ++v)
    text += std::to_string(v) + ' ' + write::coordinates(polyhedron.vertices[v]) + '\n';
  text += std::to_string(polyhedron.face_count()) + " 0\n";
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const std::size_t loops = polyhedron.loop_count(f);
    text += std::to_string(loops) + ' ' + std::to_string(loops - 1) + '\n';
    for (std::size_t k = 0; k < loops; ++k) {
      const Loop loop = polyhedron.loop(f, k);
      text += std::to_string(loop.size());
      for (const Index v : loop) text += ' ' + std::to_string(v);
      text += '\n';
    }
    for (std::size_t k = 1; k < loops; ++k)
      text +=
          std::to_string(k) + ' ' + write::coordinates(write::point_inside(polyhedron, polyhedron.loop(f, k))) + '\n';
  }
  return text + "0\n";
}

}  // namespace tetracone::covering

#endif
