#ifndef TETRACONE_VERIFY_TEST_SUPPORT_SELF_TOUCHING_H
#define TETRACONE_VERIFY_TEST_SUPPORT_SELF_TOUCHING_H

#include "verify/test/support/scenes.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// Bodies whose faces touch and cross in every way, for self-intersections.
namespace tetracone::verify::scenes {

/// Returns 2 n n triangles in the plane z = 0, on integers.
inline Polyhedron grid(int n)
{
  Polyhedron grid;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) grid.vertices.push_back({double(i), double(j), 0});
  for (Index i = 0; i < Index(n); ++i)
    for (Index j = 0; j < Index(n); ++j) {
      const Index v = i * Index(n + 1) + j, beyond = v + Index(n) + 1;
      grid.add_polygon({v, beyond, v + 1});
      grid.add_polygon({v + 1, beyond, beyond + 1});
    }
  return grid;
}

/// Returns faces of one or two loops on small integers, each in a plane across an axis: loops touch and cross
/// themselves and one another. Some vertices repeat others' coordinates.
inline Polyhedron soup_of_loops(Random& random, int faces)
{
  Polyhedron soup;
  for (int f = 0; f < faces; ++f) {
    const int axis = integer(random, 0, 2);
    const double height = integer(random, 0, 1);
    std::vector<std::vector<Index>> loops;
    for (int l = integer(random, 0, 3) == 0 ? 2 : 1; l > 0; --l) {
      loops.emplace_back();
      for (int k = integer(random, 1, 6); k > 0; --k) {
        Vertex v;
        v[std::size_t(axis)] = height;
        for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) v[std::size_t(other)] = integer(random, 0, 2);
        loops.back().push_back(Index(soup.vertices.size()));
        soup.vertices.push_back(v);
      }
    }
    soup.add_face(loops);
  }
  return soup;
}

/// Returns triangles on few points, `radius` from 0 at most; some have no area.
inline Polyhedron soup_of_triangles(Random& random, int faces, int radius)
{
  Polyhedron soup;
  for (int k = 0; k < 8; ++k) soup.vertices.push_back(grid_vertex(random, radius));
  const auto any = [&] { return Index(integer(random, 0, 7)); };
  for (int f = 0; f < faces; ++f) soup.add_polygon({any(), any(), any()});
  return soup;
}

/// Returns two faces that share a segment of the x axis. Its ends are common edges; the part between them is not.
inline Polyhedron gap_between_common_edges()
{
  Polyhedron body;
  body.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  for (const int axis : {1, 2}) {
    const Index first = Index(body.vertices.size());
    for (const auto& [x, height] : {std::pair(1.0, -1.0), {2.0, -1.0}, {3.0, 1.0}, {0.0, 1.0}}) {
      body.vertices.push_back({x, 0, 0});
      body.vertices.back()[std::size_t(axis)] = height;
    }
    body.add_polygon({0, 1, first, first + 1, 2, 3, first + 2, first + 3});
  }
  return body;
}

/// Returns closed bodies, bodies with copies of themselves moved by halves, and soups.
inline std::vector<Named> self_touching_bodies(Random& random, int soups)
{
  std::vector<Named> bodies = bodies_of_any_size();
  bodies.push_back({"gap between common edges", gap_between_common_edges()});
  for (const Named& of : closed_bodies()) {
    Vertex shift;
    for (double& x : shift) x = 0.5 * integer(random, 0, 2);
    Polyhedron two = of.body;
    append(two, moved(of.body, 1, shift));
    bodies.push_back({of.name + " twice", two});
  }
  for (int k = 0; k < soups; ++k) {
    bodies.push_back({"loops", soup_of_loops(random, 8)});
    bodies.push_back({"triangles", soup_of_triangles(random, 8, k % 3 + 1)});
  }
  return bodies;
}

}  // namespace tetracone::verify::scenes

#endif
