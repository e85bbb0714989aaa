#ifndef TETRACONE_VERIFY_TEST_SUPPORT_LOCATOR_SCENES_H
#define TETRACONE_VERIFY_TEST_SUPPORT_LOCATOR_SCENES_H

#include "verify/test/support/scenes.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// Closed bodies, and points in degenerate positions to them.
namespace tetracone::verify::scenes {

/// The factor by which long runs by hand multiply the cases of a usual test; from the environment variable
/// TETRACONE_ROUNDS.
inline int rounds()
{
  const char* text = std::getenv("TETRACONE_ROUNDS");
  return text ? std::max(1, std::atoi(text)) : 1;
}

inline Polyhedron joined(Polyhedron body, const Polyhedron& other)
{
  append(body, other);
  return body;
}

/// Returns faces on a line and in a point, each with its reverse, beside a cube.
inline Polyhedron with_flat_faces()
{
  Polyhedron body = cube(1);
  body.vertices.insert(body.vertices.end(), {{2, 2, 2}, {3, 3, 3}, {0.5, 0.5, 0.5}});
  body.add_polygon({8, 9});
  body.add_polygon({10, 10, 10});
  body.add_polygon({8, 10, 9});
  body.add_polygon({9, 10, 8});
  return body;
}

/// Returns bodies with names: convex, with holes, cavities, tunnels, overlapping and repeated shells, inward and
/// non-manifold ones; some have the covering's origin on faces, edges or vertices, or are far from 0, tiny or huge.
inline std::vector<std::pair<std::string, Polyhedron>> locator_bodies(Random& random)
{
  const Polyhedron round = triangulated(torus(9, 7));
  std::vector<std::pair<std::string, Polyhedron>> bodies = {
      {"cube", cube(1)},
      {"triangulated cube", triangulated(box({-1, -2, -3}, {2, 1, 0.5}))},
      {"inward", turned(cube(1))},
      {"cavity", cube_with_cavity()},
      {"tunnel", cube_with_tunnel()},
      {"frame", square_frame()},
      {"star", star_prism()},
      {"tetrahedron", tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})},
      {"torus", round},
      {"two overlap", joined(cube(1), moved(cube(1), 1, {0.5, 0.5, 0.5}))},
      {"overlap cancels", joined(cube(2), turned(moved(cube(1), 1, {1.5, 0, 0})))},
      {"twice", joined(cube(1), cube(1))},
      {"apart", joined(cube(1), moved(cube(1), 1, {5, 0, 0}))},
      {"origin on a vertex", joined(cube(1), moved(cube(1), 1, {2, 2, 2}))},
      {"origin on a face", joined(cube(1), moved(cube(1), 1, {2, 0, 0}))},
      {"origin on an edge", joined(cube(1), moved(cube(1), 1, {2, 2, 0}))},
      {"flat faces", with_flat_faces()},
      {"far", moved(cube_with_tunnel(), 1, {0x1p40, -0x1p41, 0x1p39})},
      {"farther", moved(round, 0x1p-4, {0x1p20 + 1, 0x1p21, 3})},
      {"tiny", moved(square_frame(), 0x1p-1060, {0, 0, 0})},
      {"small", moved(star_prism(), 0x1p-300, {0, 0, 0})},
      {"large", moved(cube_with_tunnel(), 0x1p300, {0, 0, 0})},
      {"huge", moved(cube(1), 0x1.8p1023, {0, 0, 0})},
  };
  for (int k = 0; k < 3; ++k) bodies.push_back({"tetrahedra", random_tetrahedra(random, 8, 3)});
  for (int k = 0; k < 4; ++k) bodies.push_back({"voxels", Voxels(random, 3 + k % 2, 0.4).solid()});
  return bodies;
}

/// Returns a point in, on or near the body. It is random, a vertex, a point of an edge or face, or the origin; or on a
/// line through the origin and one of these, on a border of cells of a lattice of directions about it, or far away. A
/// third of the points are moved by an ulp or a few.
inline Vertex degenerate_point(Random& random, const Polyhedron& body, const Vertex& origin)
{
  const Vertex& first = body.vertices[0];
  Vertex low = first, high = first;
  for (const Vertex& v : body.vertices)
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], v[k]);
      high[k] = std::max(high[k], v[k]);
    }
  const auto between = [](const Vertex& a, const Vertex& b, double share) {
    Vertex p;
    for (int k = 0; k < 3; ++k) p[k] = a[k] * (1 - share) + b[k] * share;
    return p;
  };
  const Index f = Index(integer(random, 0, int(body.face_count()) - 1));
  const auto loop = body.loop(f, std::size_t(integer(random, 0, int(body.loop_count(f)) - 1)));
  const auto corner = [&](std::size_t k) -> const Vertex& { return body.vertices[loop[k % loop.size()]]; };
  const std::size_t at = std::size_t(integer(random, 0, int(loop.size()) - 1));
  const double share = integer(random, 0, 3) == 0 ? real(random, 0, 1) : integer(random, 0, 8) / 8.0;
  const auto on_surface = [&] {
    switch (integer(random, 0, 3)) {
      case 0: return corner(at);
      case 1: return between(corner(at), corner(at + 1), share);
      case 2: return between(between(corner(at), corner(at + 1), share), corner(at + 2), integer(random, 0, 4) / 4.0);
      default: return between(corner(0), corner(at + 1), share);
    }
  };
  Vertex p;
  switch (integer(random, 0, 8)) {
    case 0:
    case 1:
      for (int k = 0; k < 3; ++k) p[k] = low[k] + (high[k] - low[k]) * real(random, -0.1, 1.1);
      break;
    case 2:
      for (int k = 0; k < 3; ++k) p[k] = low[k] + (high[k] - low[k]) * (integer(random, 0, 12) / 12.0);
      break;
    case 3: p = between(origin, on_surface(), integer(random, 0, 12) / 8.0); break;
    case 4: {  // borders of cells
      const int n = 1 << integer(random, 0, 4), i = integer(random, 0, n), j = integer(random, 0, n - i);
      const Vertex step = {double(i) / n, double(j) / n, double(n - i - j) / n};
      const double size = (high[0] / 2 - low[0] / 2) * integer(random, 0, 16) / 8;
      for (int k = 0; k < 3; ++k) p[k] = origin[k] + (integer(random, 0, 1) ? size : -size) * step[k];
      break;
    }
    case 5:
      p = integer(random, 0, 3) == 0 ? origin : between(on_surface(), origin, std::ldexp(1, -integer(random, 1, 60)));
      break;
    case 6:
      if (integer(random, 0, 9) == 0) {
        for (double& x : p) x = std::ldexp(real(random, -1, 1), integer(random, -1070, 1024));
        break;
      }
      [[fallthrough]];
    default: p = on_surface();
  }
  if (integer(random, 0, 2) == 0) {
    double& x = p[std::size_t(integer(random, 0, 2))];
    const double to = integer(random, 0, 1) ? HUGE_VAL : -HUGE_VAL;
    for (int steps = integer(random, 1, 3); steps > 0; --steps) x = std::nextafter(x, to);
  }
  for (double& x : p)
    if (!std::isfinite(x)) x = std::copysign(std::numeric_limits<double>::max(), x);
  return p;
}

}  // namespace tetracone::verify::scenes

#endif
