#include "verify/cases/shape_generators.h"

#include "tetracone/covering/io/read.h"
#include "tetracone/kernel/number/products.h"
#include "verify/cases/random.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace tetracone::verify {
namespace {

using covering::Index;
using covering::Loop;
using kernel::cross;
using kernel::dot;
using Corners = std::vector<Index>;

std::vector<Vertex> moved(std::vector<Vertex> points, const Vertex& way)
{
  for (Vertex& v : points)
    for (int i = 0; i < 3; ++i) v[i] += way[i];
  return points;
}

/// A solid that grows by prisms and pyramids on its faces, outward or inward.
class Block {
 public:
  /// The prism over a polygon that runs counter-clockwise in the plane, between z = bottom(x, y) and z = top(x, y).
  template <class Bottom, class Top>
  Block(const std::vector<std::array<double, 2>>& outline, const Bottom& bottom, const Top& top)
  {
    std::vector<Vertex> low, high;
    for (const auto& [x, y] : outline) {
      low.push_back({x, y, bottom(x, y)});
      high.push_back({x, y, top(x, y)});
    }
    const Corners l = add(low), h = add(high);
    faces_ = {{reversed(l)}, {h}};
    add_walls(l, h);
  }

  static constexpr Index bottom = 0, top = 1;
  /// The wall over the edge from corner k of the outline to the next one.
  static constexpr Index wall(Index k) { return 2 + k; }

  /// A tunnel from the polygon `entry` in face `from`, counter-clockwise seen from outside, to the polygon `exit` in
  /// face `to`, corner by corner. Requires walls that are planar.
  void tunnel(Index from, const std::vector<Vertex>& entry, Index to, const std::vector<Vertex>& exit)
  {
    const Corners there = join(from, entry, exit);
    faces_[to].push_back(there);
  }

  /// A prism on the face: a pit where `way` leads inward, else a boss. The base lies in the face, counter-clockwise
  /// seen from outside.
  void prism(Index face, const std::vector<Vertex>& base, const Vertex& way)
  {
    const Corners there = join(face, base, moved(base, way));
    faces_.push_back({there});
  }

  /// A pyramid on the face, sunk or raised. The base lies in the face, counter-clockwise seen from outside.
  void pyramid(Index face, const std::vector<Vertex>& base, const Vertex& apex)
  {
    const Corners corners = add(base), tip = add({apex});
    faces_[face].push_back(reversed(corners));
    for (std::size_t k = 0; k < corners.size(); ++k)
      faces_.push_back({{corners[k], corners[(k + 1) % corners.size()], tip[0]}});
  }

  /// The solid, all coordinates times `scale`.
  Polyhedron polyhedron(double scale = 1) const
  {
    Polyhedron result;
    for (const Vertex& v : vertices_) result.vertices.push_back({scale * v[0], scale * v[1], scale * v[2]});
    for (const auto& loops : faces_) result.add_face(loops);
    return result;
  }

 private:
  static Corners reversed(Corners corners)
  {
    std::ranges::reverse(corners);
    return corners;
  }

  Corners add(const std::vector<Vertex>& points)
  {
    Corners corners;
    for (const Vertex& p : points) {
      corners.push_back(static_cast<Index>(vertices_.size()));
      vertices_.push_back(p);
    }
    return corners;
  }

  void add_walls(const Corners& from, const Corners& to)
  {
    for (std::size_t k = 0; k < from.size(); ++k) {
      const std::size_t next = (k + 1) % from.size();
      faces_.push_back({{from[k], from[next], to[next], to[k]}});
    }
  }

  // Cuts `here` out of the face and joins it to `there` by walls. Returns the corners of `there`.
  Corners join(Index face, const std::vector<Vertex>& here, const std::vector<Vertex>& there)
  {
    const Corners from = add(here), to = add(there);
    faces_[face].push_back(reversed(from));
    add_walls(from, to);
    return to;
  }

  std::vector<Vertex> vertices_;
  std::vector<std::vector<Corners>> faces_;
};

/// A function of x and y: the plane z = height.
auto level(double height)
{
  return [height](double, double) { return height; };
}

/// Appends a quad as two triangles.
void add_quad(Polyhedron& polyhedron, Index a, Index b, Index c, Index d)
{
  polyhedron.add_polygon({a, b, c});
  polyhedron.add_polygon({a, c, d});
}

Vertex sum(const Vertex& a, double s, const Vertex& b) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }
Vertex unit(const Vertex& a)
{
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

}  // namespace

Polyhedron box(const Vertex& low, const Vertex& high)
{
  assert(low[0] < high[0] && low[1] < high[1] && low[2] < high[2]);
  const auto [x, y, z] = low;
  const auto [u, v, w] = high;
  return Block({{x, y}, {u, y}, {u, v}, {x, v}}, level(z), level(w)).polyhedron();
}

Polyhedron unit_cube() { return box({0, 0, 0}, {1, 1, 1}); }

Polyhedron box_with_cavity(double outer, double inner)
{
  assert(0 < inner && inner < outer);
  Polyhedron result = box({-outer, -outer, -outer}, {outer, outer, outer});
  const Polyhedron cavity = box({-inner, -inner, -inner}, {inner, inner, inner});
  append(result, cavity, true);
  return result;
}

Polyhedron prism_with_tunnel()
{
  Block block({{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}, level(-3), level(3));
  const std::vector<Vertex> mouth = {{-2, -2, 3}, {2, -2, 3}, {2, 2, 3}, {-2, 2, 3}};
  block.tunnel(Block::top, mouth, Block::bottom, moved(mouth, {0, 0, -6}));
  return block.polyhedron(1 / 8.0);
}

Polyhedron complex_one()
{
  const auto bottom = [](double, double y) { return -3 + y / 4; };
  const auto top = [](double x, double y) { return 3 + x / 8 - y / 8; };
  Block block({{8, -2}, {8, 2}, {2, 3}, {-2, 8}, {-6, 5}, {-3, 0}, {-6, -5}, {-2, -8}, {2, -3}}, bottom, top);
  const auto tunnel = [&](const std::vector<std::array<double, 2>>& outline) {
    std::vector<Vertex> upper, lower;
    for (const auto& [x, y] : outline) {
      upper.push_back({x, y, top(x, y)});
      lower.push_back({x, y, bottom(x, y)});
    }
    block.tunnel(Block::top, upper, Block::bottom, lower);
  };
  tunnel({{4, -1}, {6, -1}, {6, 1}, {4, 1}});
  tunnel({{-2, 1}, {0, 2}, {-2, 4}});
  return block.polyhedron(1 / 8.0);
}

Polyhedron complex_two()
{
  Block block({{-12, -8}, {12, -8}, {12, 0}, {-2, 0}, {-2, 8}, {-12, 8}}, level(-6), level(6));
  const Index front = Block::wall(0), back = Block::wall(2), left = Block::wall(5);
  const std::vector<Vertex> mouth = {{3, -8, -2}, {8, -8, -2}, {8, -8, 3}, {3, -8, 3}};
  block.tunnel(front, mouth, back, moved(mouth, {-1, 8, 1}));
  block.prism(Block::top, {{-9, 2, 6}, {-5, 3, 6}, {-7, 6, 6}}, {0, 0, -5});
  block.prism(left, {{-12, 0, 4}, {-12, 4, -3}, {-12, 0, -1}, {-12, -4, -3}}, {-2, 0, 0});
  block.pyramid(Block::bottom, {{-8, -2, -6}, {-4, -2, -6}, {-4, -6, -6}, {-8, -6, -6}}, {-6, -4, 0});
  block.pyramid(Block::top, {{4, -6, 6}, {8, -6, 6}, {8, -2, 6}, {4, -2, 6}}, {6, -4, 9});
  return block.polyhedron(1 / 16.0);
}

Polyhedron voxel_solid(const std::vector<bool>& bits, int nx, int ny, int nz)
{
  assert(nx >= 0 && ny >= 0 && nz >= 0 && bits.size() == std::size_t(nx) * ny * nz);
  using Cell = std::array<int, 3>;
  const Cell size = {nx, ny, nz};
  const auto full = [&](const Cell& c) {
    for (int i = 0; i < 3; ++i)
      if (c[i] < 0 || c[i] >= size[i]) return false;
    return bool(bits[c[0] + std::size_t(nx) * (c[1] + std::size_t(ny) * c[2])]);
  };
  Polyhedron result;
  std::map<Cell, Index> numbers;
  const auto corner = [&](const Cell& c) {
    const auto [found, is_new] = numbers.try_emplace(c, static_cast<Index>(result.vertices.size()));
    if (is_new) result.vertices.push_back({double(c[0]), double(c[1]), double(c[2])});
    return found->second;
  };
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
        for (int axis = 0; axis < 3; ++axis)
          for (const int side : {0, 1}) {
            const Cell cell = {x, y, z};
            Cell beyond = cell;
            beyond[axis] += side == 1 ? 1 : -1;
            if (!full(cell) || full(beyond)) continue;
            Cell c = cell;
            c[axis] += side;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            Corners square;
            for (const auto& [du, dv] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
              Cell at = c;
              at[u] += du;
              at[v] += dv;
              square.push_back(corner(at));
            }
            if (side == 0) std::ranges::reverse(square);
            result.add_polygon(square);
          }
  return result;
}

Polyhedron blob(std::size_t triangles, std::uint64_t seed)
{
  assert(triangles >= 8);
  const int n = static_cast<int>(std::lround(std::sqrt(triangles / 8.0)));
  // The radius: Chebyshev waves of degree 3 to 5 along six random directions, each of amplitude 1/12.
  Random random(seed);
  std::array<Vector, 6> waves;
  for (Vector& wave : waves) wave = random.direction();
  const auto radius_towards = [&waves](const Vector& d) {
    double radius = 1;
    for (std::size_t k = 0; k < waves.size(); ++k) {
      const double x = std::clamp(dot(d, waves[k]), -1.0, 1.0), degree_2 = 2 * x * x - 1;
      const double degree_3 = 2 * x * degree_2 - x, degree_4 = 2 * x * degree_3 - degree_2;
      const double degree_5 = 2 * x * degree_4 - degree_3;
      radius += std::array{degree_3, degree_4, degree_5}[k % 3] / 12;
    }
    return radius;
  };
  // The lattice points |x| + |y| + |z| = n of the octahedron, blown up.
  Polyhedron result;
  std::map<std::array<int, 3>, Index> numbers;
  const auto corner = [&](const std::array<int, 3>& lattice) {
    const auto [found, is_new] = numbers.try_emplace(lattice, static_cast<Index>(result.vertices.size()));
    if (is_new) {
      const Vector d = unit({double(lattice[0]), double(lattice[1]), double(lattice[2])});
      result.vertices.push_back(sum({0, 0, 0}, radius_towards(d), d));
    }
    return found->second;
  };
  for (int octant = 0; octant < 8; ++octant) {
    const int sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
    const auto at = [&](int i, int j) { return corner({sx * i, sy * j, sz * (n - i - j)}); };
    const auto add = [&](Index a, Index b, Index c) {
      if (sx * sy * sz < 0) std::swap(b, c);
      result.add_polygon({a, b, c});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        // These are statements, since they number the corners, and the compiler chooses the order of arguments.
        const Index above = at(i, j + 1), beside = at(i + 1, j), here = at(i, j);
        add(here, beside, above);
        if (i + j + 1 < n) add(beside, at(i + 1, j + 1), above);
      }
  }
  return result;
}

namespace {

/// A tube of radius 1/7 along the trefoil knot on a torus of radii 4/7 and 2/7.
Polyhedron tube_along_knot(Index rings, Index sides)
{
  constexpr double thickness = 0.5, scale = 1 / 3.5;
  // The curve winds three times round the tube of a torus of radii 2 and 1 while it winds twice along it.
  const auto core = [](double along) -> Vector {
    const auto [c, s] = turn(2 * along);
    return {2 * c, 2 * s, 0};
  };
  const auto knot = [&](double along) -> Vector {
    const auto [c, s] = turn(2 * along);
    const auto [u, v] = turn(3 * along);
    return {(2 + u) * c, (2 + u) * s, v};
  };
  Polyhedron result;
  for (Index ring = 0; ring < rings; ++ring) {
    const double along = double(ring) / rings;
    const Vector centre = knot(along);
    const Vector forward = unit(sum(knot(along + 1 / 1024.0), -1, knot(along - 1 / 1024.0)));
    const Vector outward = sum(centre, -1, core(along));
    const Vector normal = unit(sum(outward, -dot(outward, forward), forward)), beside = cross(forward, normal);
    for (Index side = 0; side < sides; ++side) {
      const auto [c, s] = turn(double(side) / sides);
      const Vector p = sum(sum(centre, thickness * c, normal), thickness * s, beside);
      result.vertices.push_back({scale * p[0], scale * p[1], scale * p[2]});
    }
  }
  for (Index ring = 0; ring < rings; ++ring)
    for (Index side = 0; side < sides; ++side) {
      const Index here = sides * ring, there = sides * ((ring + 1) % rings), next = (side + 1) % sides;
      add_quad(result, here + side, here + next, there + next, there + side);
    }
  return result;
}

}  // namespace

Polyhedron torus_knot(std::size_t triangles)
{
  assert(triangles >= 640);
  constexpr Index sides = 8;
  return tube_along_knot(static_cast<Index>((triangles + sides) / (2 * sides)), sides);
}

Polyhedron round_torus_knot(std::size_t triangles)
{
  assert(triangles >= 640);
  // The tube is about ten times as long as round: triangles of about equal sides.
  const Index sides = static_cast<Index>(std::lround(std::sqrt(triangles / 20.0)));
  return tube_along_knot(static_cast<Index>((triangles + sides) / (2 * sides)), sides);
}

std::optional<Polyhedron> demo_mesh(const std::filesystem::path& folder, const std::string& name)
{
  const std::filesystem::path file = folder / "meshes" / (name + ".off");
  if (!std::filesystem::exists(file)) return std::nullopt;
  return covering::read(file);
}

Polyhedron decimate(const Polyhedron& polyhedron, std::size_t faces)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  namespace simplification = CGAL::Surface_mesh_simplification;
  const auto refuse = [](const std::string& why) { throw std::invalid_argument("decimate: " + why); };

  if (faces % 2 != 0) refuse("an odd number of triangles, which no closed mesh has");
  if (faces > polyhedron.face_count()) refuse("fewer triangles than are to be left");
  Mesh mesh;
  for (const Vertex& v : polyhedron.vertices) mesh.add_vertex(Point(v[0], v[1], v[2]));
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    if (!polyhedron.is_triangle(f)) refuse("a face that is no triangle");
    const Loop loop = polyhedron.loop(f, 0);
    if (mesh.add_face(Mesh::Vertex_index(loop[0]), Mesh::Vertex_index(loop[1]), Mesh::Vertex_index(loop[2])) ==
        Mesh::null_face())
      refuse("no manifold");
  }
  if (!CGAL::is_closed(mesh)) refuse("not closed");

  // Each collapse removes 3 edges and 2 faces, and 3 F = 2 E. CGAL 6 has another name for the predicate that counts.
  const auto is_done = [faces](const auto&, const auto&, std::size_t, std::size_t edges) {
    return edges <= 3 * faces / 2;
  };
  simplification::edge_collapse(mesh, is_done);
  mesh.collect_garbage();
  if (mesh.number_of_faces() != faces) refuse("no edge can be collapsed any more");

  Polyhedron result;
  for (const auto v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    result.vertices.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : mesh.faces()) {
    Corners corners;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) corners.push_back(static_cast<Index>(v));
    result.add_polygon(corners);
  }
  return result;
}

Vertex centroid(const Polyhedron& polyhedron)
{
  assert(!polyhedron.vertices.empty());
  Vertex total = {0, 0, 0};
  for (const Vertex& v : polyhedron.vertices) total = sum(total, 1, v);
  const double count = static_cast<double>(polyhedron.vertices.size());
  return {total[0] / count, total[1] / count, total[2] / count};
}

double radius(const Polyhedron& polyhedron)
{
  const Vertex centre = centroid(polyhedron);
  double squared = 0;
  for (const Vertex& v : polyhedron.vertices) {
    const Vertex d = sum(v, -1, centre);
    squared = std::max(squared, dot(d, d));
  }
  return std::sqrt(squared);
}

Polyhedron normalised(const Polyhedron& polyhedron)
{
  const Vertex centre = centroid(polyhedron);
  const double size = radius(polyhedron);
  Polyhedron result = polyhedron;
  for (Vertex& v : result.vertices)
    for (int i = 0; i < 3; ++i) v[i] = (v[i] - centre[i]) / size;
  return result;
}

std::optional<Polyhedron> small_mesh(const std::filesystem::path& folder)
{
  const auto mesh = demo_mesh(folder, "bunny00");
  if (!mesh) return std::nullopt;
  return normalised(decimate(*mesh, 760));
}

std::optional<Polyhedron> large_mesh(const std::filesystem::path& folder)
{
  const auto mesh = demo_mesh(folder, "dino");
  if (!mesh) return std::nullopt;
  return normalised(decimate(*mesh, 7172));
}

}  // namespace tetracone::verify
