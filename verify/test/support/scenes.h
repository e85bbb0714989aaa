#ifndef TETRACONE_VERIFY_TEST_SUPPORT_SCENES_H
#define TETRACONE_VERIFY_TEST_SUPPORT_SCENES_H

#include "tetracone/covering/orient.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "verify/cases/tetrahedron.h"
#include "verify/test/support/rationals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Small bodies and poses for tests. Faces are outward unless stated otherwise; coordinates are small integers.
namespace tetracone::verify::scenes {

using covering::append;
using covering::append_face;
using covering::Index;
using covering::Polyhedron;
using kernel::Pose;
using kernel::Rational;
using kernel::Vertex;

namespace rationals = verify::rationals;

using Random = std::mt19937_64;

/// Returns an integer from `low` to `high`, or a number between them. Vertices have such coordinates from -radius to
/// radius.
inline int integer(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }
inline double real(Random& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}
inline Vertex grid_vertex(Random& random, int radius)
{
  return {double(integer(random, -radius, radius)), double(integer(random, -radius, radius)),
          double(integer(random, -radius, radius))};
}
inline Vertex real_vertex(Random& random, double radius)
{
  return {real(random, -radius, radius), real(random, -radius, radius), real(random, -radius, radius)};
}

/// Returns the faces of two bodies as one body.
inline Polyhedron both(Polyhedron a, const Polyhedron& b)
{
  append(a, b);
  return a;
}

/// Returns the body with its faces reversed.
inline Polyhedron turned(const Polyhedron& what)
{
  Polyhedron result;
  append(result, what, true);
  return result;
}

/// Returns the body with those faces reversed whose bits are set. Requires at most 64 faces, or all bits set.
inline Polyhedron turn_some(const Polyhedron& body, std::uint64_t faces)
{
  Polyhedron result;
  result.vertices = body.vertices;
  for (Index f = 0; f < body.face_count(); ++f) append_face(result, body, f, faces >> f % 64 & 1);
  return result;
}

/// Returns a body of one face, of these loops.
inline Polyhedron one_face(const std::vector<Vertex>& vertices, const std::vector<std::vector<Index>>& loops)
{
  Polyhedron result;
  result.vertices = vertices;
  result.add_face(loops);
  return result;
}

/// Returns a body of one face, of these loops in the plane z = x + 2 y.
inline Polyhedron slanted_face(const std::vector<std::array<double, 2>>& corners,
                               const std::vector<std::vector<Index>>& loops)
{
  std::vector<Vertex> vertices;
  for (const auto& [x, y] : corners) vertices.push_back({x, y, x + 2 * y});
  return one_face(vertices, loops);
}

/// Returns the body without the faces f for which goes(f) is true.
template <class Goes>
Polyhedron without(const Polyhedron& body, const Goes& goes)
{
  Polyhedron result;
  result.vertices = body.vertices;
  for (Index f = 0; f < body.face_count(); ++f)
    if (!goes(f)) append_face(result, body, f, false);
  return result;
}
/// Returns the body without its last face.
inline Polyhedron without_last_face(const Polyhedron& body)
{
  return without(body, [&](Index f) { return f + 1 == body.face_count(); });
}

/// Six squares. Vertex k has x, y, z high where bit 0, 1, 2 of k is set.
inline Polyhedron box(const Vertex& low, const Vertex& high)
{
  Polyhedron result;
  for (int k = 0; k < 8; ++k)
    result.vertices.push_back({k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]});
  for (const auto& face :
       {std::array<Index, 4>{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}})
    result.add_polygon(face);
  return result;
}
inline Polyhedron unit_cube() { return box({0, 0, 0}, {1, 1, 1}); }
inline Polyhedron cube(double half) { return box({-half, -half, -half}, {half, half, half}); }

/// Returns every face as a fan of triangles. Requires convex faces without holes.
inline Polyhedron triangulated(const Polyhedron& body)
{
  Polyhedron result;
  result.vertices = body.vertices;
  for (Index f = 0; f < body.face_count(); ++f) {
    const auto loop = body.loop(f, 0);
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) result.add_polygon({loop[0], loop[k], loop[k + 1]});
  }
  return result;
}

/// Four triangles; outward when a, b, c, d has a positive determinant.
inline Polyhedron tetrahedron(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d)
{
  Polyhedron result;
  add_tetrahedron(result, {a, b, c, d});
  return result;
}

/// Returns `outer` with `inner` as a cavity.
inline Polyhedron with_cavity(Polyhedron outer, const Polyhedron& inner)
{
  append(outer, inner, true);
  return outer;
}
inline Polyhedron cube_with_cavity() { return with_cavity(cube(3), cube(2)); }

/// The cube [-3, 3]^3 with a square tunnel of half width 1 along z: top and bottom are faces with a hole.
inline Polyhedron cube_with_tunnel()
{
  const Polyhedron outer = box({-3, -3, -3}, {3, 3, 3}), tunnel = turned(box({-1, -1, -3}, {1, 1, 3}));
  Polyhedron body = both(outer, tunnel), result;
  result.vertices = body.vertices;
  for (Index f = 0; f < 4; ++f) {
    result.add_polygon(body.loop(f, 0));
    result.add_polygon(body.loop(6 + f, 0));
  }
  for (const Index f : {4u, 5u}) result.add_face(std::vector{body.loop(f, 0), body.loop(6 + f, 0)});
  return result;
}

/// The frame [0,3]x[0,3]x[0,1] with the tunnel [1,2]x[1,2]: two holed faces. The corner (3,3,1) is lifted by `lift`.
inline Polyhedron square_frame(double lift = 0)
{
  Polyhedron result;
  for (const double z : {0, 1})
    for (const auto& [x, y] : {std::pair{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}})
      result.vertices.push_back({double(x), double(y), z});
  result.vertices[10][2] += lift;
  result.add_face({{0, 3, 2, 1}, {4, 5, 6, 7}});
  result.add_face({{8, 9, 10, 11}, {15, 14, 13, 12}});
  for (Index k = 0; k < 4; ++k) {
    const Index next = (k + 1) % 4;
    result.add_polygon({k, next, 8 + next, 8 + k});
    result.add_polygon({4 + next, 4 + k, 12 + k, 12 + next});
  }
  return result;
}

/// A torus of n x m quads; since its vertices are rounded, most of these are not exactly planar.
inline Polyhedron torus(Index n, Index m)
{
  Polyhedron result;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j) {
      const double a = 2 * M_PI * i / n, b = 2 * M_PI * j / m, r = 3 + std::cos(b);
      result.vertices.push_back({r * std::cos(a), r * std::sin(a), std::sin(b)});
    }
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j)
      result.add_polygon({i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m});
  return result;
}

/// The prism over a closed polygon of the plane z = 0, counterclockwise, up to z = height: top and bottom need not be
/// convex.
inline Polyhedron prism(const std::vector<std::array<double, 2>>& polygon, double height)
{
  Polyhedron result;
  const Index n = polygon.size();
  for (const double z : {0.0, height})
    for (const auto& [x, y] : polygon) result.vertices.push_back({x, y, z});
  std::vector<Index> top(n), bottom(n);
  for (Index k = 0; k < n; ++k) {
    top[k] = n + k;
    bottom[k] = n - 1 - k;
  }
  result.add_polygon(top);
  result.add_polygon(bottom);
  for (Index k = 0; k < n; ++k) result.add_polygon({k, (k + 1) % n, n + (k + 1) % n, n + k});
  return result;
}
/// Returns a prism of height 2 over a star of four points.
inline Polyhedron star_prism()
{
  return prism({{3, 0}, {1, 1}, {0, 3}, {-1, 1}, {-3, 0}, {-1, -1}, {0, -3}, {1, -1}}, 2);
}

/// Cells of the grid n x n x n as one solid, with one square for each side between a full and an empty cell. Vertices
/// are shared.
struct Voxels {
  int n;
  std::vector<bool> full;

  Voxels(Random& random, int size, double share = 0.5) : n(size), full(size * size * size)
  {
    for (std::size_t k = 0; k < full.size(); ++k) full[k] = real(random, 0, 1) < share;
    full[0] = true;
  }
  bool operator()(int x, int y, int z) const
  {
    const auto in = [this](int c) { return 0 <= c && c < n; };
    return in(x) && in(y) && in(z) && full[(x * n + y) * n + z];
  }

  Polyhedron solid() const
  {
    Polyhedron result;
    const int m = n + 1;
    for (int k = 0; k < m * m * m; ++k)
      result.vertices.push_back({double(k / (m * m)), double(k / m % m), double(k % m)});
    const auto corner = [m](std::array<int, 3> p) { return Index((p[0] * m + p[1]) * m + p[2]); };
    for (int x = 0; x < n; ++x)
      for (int y = 0; y < n; ++y)
        for (int z = 0; z < n; ++z)
          for (int axis = 0; axis < 3 && (*this)(x, y, z); ++axis)
            for (const int side : {0, 1}) {
              std::array<int, 3> beside = {x, y, z};
              beside[axis] += side == 1 ? 1 : -1;
              if ((*this)(beside[0], beside[1], beside[2])) continue;
              std::array<int, 3> p = {x, y, z};
              p[axis] += side;
              std::vector<Index> square;
              for (const auto& [du, dv] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                std::array<int, 3> q = p;
                q[(axis + 1) % 3] += du;
                q[(axis + 2) % 3] += dv;
                square.push_back(corner(q));
              }
              if (side == 0) std::reverse(square.begin(), square.end());
              result.add_polygon(square);
            }
    return result;
  }

  /// Returns 1 inside, 0 on the surface, -1 outside the closed solid, for the point (x, y, z) / 2, by the cells that
  /// contain it.
  int where(int x, int y, int z) const
  {
    // Shifted right, a negative number is rounded down.
    int cells = 0, filled = 0;
    for (int i = (x - 1) >> 1; i <= x >> 1; ++i)
      for (int j = (y - 1) >> 1; j <= y >> 1; ++j)
        for (int k = (z - 1) >> 1; k <= z >> 1; ++k) {
          ++cells;
          filled += (*this)(i, j, k);
        }
    return filled == 0 ? -1 : filled == cells ? 1 : 0;
  }
};

/// Tetrahedra on small integers, overlapping at will, turned at random: closed, with any winding numbers.
inline Polyhedron random_tetrahedra(Random& random, int count, int radius)
{
  Polyhedron result;
  for (int k = 0; k < count; ++k)
    append(result, tetrahedron(grid_vertex(random, radius), grid_vertex(random, radius), grid_vertex(random, radius),
                               grid_vertex(random, radius)));
  return result;
}

/// A sphere-like body of triangles: an octahedron divided `divisions` times, its vertices at radius `low` to `high`.
inline Polyhedron blob(Random& random, int divisions, double low, double high)
{
  using Corner = std::array<int, 3>;
  std::vector<std::array<Corner, 3>> triangles;
  const int n = 1 << divisions;
  for (int k = 0; k < 8; ++k) {
    const Corner x{k & 1 ? -n : n, 0, 0}, y{0, k & 2 ? -n : n, 0}, z{0, 0, k & 4 ? -n : n};
    const bool odd = ((k ^ (k >> 1) ^ (k >> 2)) & 1) != 0;
    triangles.push_back(odd ? std::array{x, z, y} : std::array{x, y, z});
  }
  const auto middle = [](const Corner& a, const Corner& b) {
    return Corner{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  };
  for (int d = 0; d < divisions; ++d) {
    std::vector<std::array<Corner, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const Corner ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.push_back({a, ab, ca});
      finer.push_back({ab, b, bc});
      finer.push_back({ca, bc, c});
      finer.push_back({ab, bc, ca});
    }
    triangles = finer;
  }
  Polyhedron result;
  std::map<Corner, Index> corners;
  for (const auto& triangle : triangles) {
    std::array<Index, 3> face;
    for (int i = 0; i < 3; ++i) {
      const auto [at, is_new] = corners.try_emplace(triangle[i], Index(corners.size()));
      face[i] = at->second;
      if (!is_new) continue;
      const auto& [x, y, z] = triangle[i];
      const double r = real(random, low, high) / std::sqrt(double(x) * x + double(y) * y + double(z) * z);
      result.vertices.push_back({r * x, r * y, r * z});
    }
    result.add_polygon(face);
  }
  return result;
}

/// Returns the body with each coordinate times `scale`, plus `shift`. The result is exact if these operations are.
inline Polyhedron moved(Polyhedron body, double scale, const Vertex& shift = {0, 0, 0})
{
  for (Vertex& v : body.vertices)
    for (int k = 0; k < 3; ++k) v[k] = scale * v[k] + shift[k];
  return body;
}

/// The body with vertices and faces in another order and loops that begin elsewhere.
inline Polyhedron shuffled(const Polyhedron& body, Random& random)
{
  std::vector<Index> place(body.vertices.size()), order(body.face_count());
  std::iota(place.begin(), place.end(), Index(0));
  std::iota(order.begin(), order.end(), Index(0));
  std::shuffle(place.begin(), place.end(), random);
  std::shuffle(order.begin(), order.end(), random);
  Polyhedron result;
  result.vertices.resize(body.vertices.size());
  for (std::size_t v = 0; v < place.size(); ++v) result.vertices[place[v]] = body.vertices[v];
  for (const Index f : order) {
    std::vector<std::vector<Index>> loops;
    for (std::size_t l = 0; l < body.loop_count(f); ++l) {
      loops.emplace_back();
      for (const Index v : body.loop(f, l)) loops.back().push_back(place[v]);
      std::rotate(loops.back().begin(), loops.back().begin() + integer(random, 0, int(loops.back().size()) - 1),
                  loops.back().end());
    }
    result.add_face(loops);
  }
  return result;
}

/// Returns the translation by (x, y, z).
inline Pose translation(double x, double y, double z)
{
  return Pose(std::array<double, 12>{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z});
}

/// A random rotation with rational entries, exactly rigid.
inline Pose random_rotation(Random& random, int radius = 5, const std::array<Rational, 3>& t = {0, 0, 0})
{
  for (;;) {
    const int w = integer(random, -radius, radius), x = integer(random, -radius, radius);
    const int y = integer(random, -radius, radius), z = integer(random, -radius, radius);
    if (w != 0 || x != 0 || y != 0 || z != 0) return Pose::from_quaternion(w, x, y, z, t);
  }
}

/// Rounds each entry to the nearest double.
inline Pose rounded(const Pose& pose) { return Pose(pose.entries()); }

/// Returns the map that applies `first`, then `second`, exactly.
inline Pose composed(const Pose& second, const Pose& first)
{
  std::array<Rational, 12> entries;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) {
      Rational sum = j == 3 ? second.exact(4 * i + 3) : Rational(0);
      for (int k = 0; k < 3; ++k) sum += second.exact(4 * i + k) * first.exact(4 * k + j);
      entries[4 * i + j] = sum;
    }
  return Pose(entries);
}

/// Any affine map of small integers whose determinant is not zero: sheared, scaled, reflected.
inline Pose random_affine(Random& random, int radius = 3)
{
  for (;;) {
    std::array<double, 12> entries;
    for (double& entry : entries) entry = integer(random, -radius, radius);
    const Pose pose(entries);
    if (pose.determinant_sign() != CGAL::ZERO) return pose;
  }
}

/// A body and its name in messages.
struct Named {
  std::string name;
  Polyhedron body;
};

/// Returns closed bodies with every kind of face and shell. Some have winding numbers other than 0 and 1.
inline std::vector<Named> closed_bodies()
{
  Random random(11);
  std::vector<Named> bodies;
  bodies.push_back({"cube", cube(2)});
  bodies.push_back({"cube of triangles", triangulated(cube(2))});
  bodies.push_back({"inward cube", turned(cube(2))});
  bodies.push_back({"tetrahedron", tetrahedron({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3})});
  bodies.push_back({"star prism", star_prism()});
  bodies.push_back({"tunnel", cube_with_tunnel()});
  bodies.push_back({"cavity", cube_with_cavity()});
  bodies.push_back({"nested shells", with_cavity(cube_with_cavity(), turned(cube(1)))});
  bodies.push_back({"shells in one another", with_cavity(cube(3), turned(cube(2)))});
  bodies.push_back({"voxels", Voxels(random, 3).solid()});
  bodies.push_back({"tetrahedra", random_tetrahedra(random, 4, 3)});
  // A spur: the edge from a corner to a point inside the face and back.
  Polyhedron spur = cube(2);
  spur.vertices.push_back({0, 0, 2});
  Polyhedron spurred;
  spurred.vertices = spur.vertices;
  for (Index f = 0; f < 5; ++f) spurred.add_polygon(spur.loop(f, 0));
  spurred.add_polygon({4, 8, 4, 5, 7, 6});
  bodies.push_back({"spur", spurred});
  // Degenerate faces that keep it closed: an edge doubled, a point.
  Polyhedron degenerate = cube(2);
  degenerate.vertices.push_back({1, 1, 4});
  degenerate.add_polygon({0, 7});
  degenerate.add_polygon({8});
  degenerate.add_polygon({1, 1, 2});
  degenerate.add_polygon({2, 1});
  degenerate.add_polygon({1, 2, 2});
  bodies.push_back({"degenerate faces", degenerate});
  return bodies;
}

/// Returns `closed_bodies`, a torus of triangles, and bodies that are far from 0, tiny or huge.
inline std::vector<Named> bodies_of_any_size()
{
  std::vector<Named> bodies = closed_bodies();
  const Polyhedron round = triangulated(torus(9, 7)), tunnel = cube_with_tunnel();
  bodies.push_back({"torus", round});
  bodies.push_back({"far torus", moved(round, 0x1p-4, {0x1p20 + 1, 0x1p21, 3})});
  bodies.push_back({"far", moved(tunnel, 1, {0x1p40, -0x1p41, 0x1p39})});
  for (const double size : {0x1p-1060, 0x1p-300, 0x1p300, 0x1p1020}) bodies.push_back({"scaled", moved(tunnel, size)});
  return bodies;
}

/// Points where the covering of a body is degenerate: the origin, small integers, and points between vertices. These
/// are also in faces and on the way to the origin.
inline std::vector<Vertex> hard_points(const Polyhedron& body, const Vertex& origin, Random& random)
{
  std::vector<Vertex> points = {origin};
  for (int n = 0; n < 40; ++n) points.push_back(grid_vertex(random, 4));
  for (int n = 0; n < 60; ++n) {
    const auto any = [&]() -> Vertex {
      return integer(random, 0, 3) == 0 ? origin : body.vertices[integer(random, 0, int(body.vertices.size()) - 1)];
    };
    // On an inner facet O W A, an inner edge O W, or the plane of faces.
    const Vertex a = any(), b = any(), c = any();
    Vertex p;
    for (int k = 0; k < 3; ++k) p[k] = n % 2 == 0 ? a[k] / 2 + b[k] / 2 : a[k] / 2 + b[k] / 4 + c[k] / 4;
    points.push_back(p);
  }
  return points;
}

}  // namespace tetracone::verify::scenes

#endif
