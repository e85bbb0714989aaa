#include "verify/cases/shape_library.h"

#include "tetracone/covering/repair/repair.h"
#include "verify/cases/shape_generators.h"
#include "verify/cases/tetrahedron.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

namespace tetracone::verify {

static const std::filesystem::path models = std::filesystem::path(TETRACONE_SOURCE_DIR) / ".cache" / "models";

bool real_meshes_available()
{
  static const bool available = std::filesystem::exists(models / "meshes" / "elephant.off");
  return available;
}

}  // namespace tetracone::verify

namespace tetracone::verify::object_family {
namespace {

using covering::Polyhedron;
using kernel::Rational;
using kernel::Vertex;

/// Newell's normal over all loops. It is exact, and so normal to the plane of a planar face and zero for a flat one.
Exact_vector normal_of(const Polyhedron& body, Index f)
{
  Exact_vector normal{0, 0, 0};
  for (std::size_t l = 0; l < body.loop_count(f); ++l) {
    const covering::Loop loop = body.loop(f, l);
    const Exact_vector first = exact(body.vertices[loop[0]]);
    for (std::size_t k = 1; k + 1 < loop.size(); ++k)
      normal = sum(normal, cross(difference(exact(body.vertices[loop[k]]), first),
                                 difference(exact(body.vertices[loop[k + 1]]), first)));
  }
  return normal;
}

std::vector<std::array<Index, 3>> triangles_of(const Polyhedron& body, Index f)
{
  if (body.is_triangle(f)) return {{body.loop(f, 0)[0], body.loop(f, 0)[1], body.loop(f, 0)[2]}};
  if (const auto triangles = covering::repair::constrained_delaunay(body, f)) return *triangles;
  return {};
}

bool supports(const Polyhedron& body, const Exact_vector& normal, Index corner)
{
  const std::vector<Index> least = lowest(body.vertices, times(Rational(-1), normal));
  return std::ranges::binary_search(least, corner);
}

bool is_axis_box(const Polyhedron& body, const std::vector<Exact_vector>& normals)
{
  const auto along_axis = [](const Exact_vector& n) { return std::ranges::count(n, Rational(0)) == 2; };
  return body.vertices.size() == 8 && body.face_count() == 6 && std::ranges::all_of(normals, along_axis);
}

Polyhedron prism(const std::vector<std::array<double, 2>>& outline, double low, double high)
{
  Polyhedron result;
  const Index n = outline.size();
  for (const double z : {low, high})
    for (const auto& [x, y] : outline) result.vertices.push_back({x, y, z});
  std::vector<Index> top, bottom;
  for (Index k = 0; k < n; ++k) {
    top.push_back(n + k);
    bottom.push_back(n - 1 - k);
    result.add_polygon({k, (k + 1) % n, n + (k + 1) % n, n + k});
  }
  result.add_polygon(top);
  result.add_polygon(bottom);
  return result;
}

Polyhedron octahedron()
{
  Polyhedron result;
  result.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (Index k = 0; k < 8; ++k) {
    const Index x = k & 1, y = 2 + (k >> 1 & 1), z = 4 + (k >> 2 & 1);
    const bool odd = ((k ^ (k >> 1) ^ (k >> 2)) & 1) != 0;
    odd ? result.add_polygon({x, z, y}) : result.add_polygon({x, y, z});
  }
  return result;
}

Polyhedron scaled(Polyhedron body, double scale)
{
  for (Vertex& v : body.vertices)
    for (double& x : v) x *= scale;
  return body;
}

/// Rounds coordinates to multiples of 2^-30, so that sums and differences of a few of them are doubles.
Polyhedron snapped(Polyhedron body)
{
  for (Vertex& v : body.vertices)
    for (double& x : v) x = std::floor(x * 0x1p30 + 0.5) * 0x1p-30;
  return body;
}

/// A roof that stands on its ridge, which runs along x.
Polyhedron roof()
{
  Polyhedron result;
  result.vertices = {{-1, 0, 0}, {1, 0, 0}, {-1, 0.5, 0.5}, {1, 0.5, 0.5}, {-1, -0.5, 0.5}, {1, -0.5, 0.5}};
  for (const auto& face : {std::array<Index, 4>{0, 1, 3, 2}, {0, 4, 5, 1}, {2, 3, 5, 4}}) {
    std::vector<Index> turned(face.rbegin(), face.rend());
    result.add_polygon(turned);
  }
  result.add_polygon({0, 4, 2});
  result.add_polygon({1, 3, 5});
  return result;
}

std::vector<Shape> made_blocks()
{
  const std::vector<bool> corner = {1, 1, 1, 0, 1, 0, 0, 0}, across = {1, 0, 0, 1, 0, 1, 1, 0};
  const std::vector<bool> ring = {1, 1, 1, 1, 0, 1, 1, 1, 1};
  std::vector<Shape> result;
  for (Polyhedron& body :
       std::array{unit_cube(), box({-1, -0.5, -0.25}, {1, 0.5, 0.25}),
                  *tetrahedron({Vertex{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), octahedron(), roof(),
                  prism({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}}, 0, 0.5),
                  prism({{-0.5, -0.75}, {0, -0.25}, {0.5, -0.75}, {0, 1}}, -0.25, 0.25), prism_with_tunnel(),
                  complex_one(), complex_two(), box_with_cavity(1, 0.5), scaled(voxel_solid(corner, 2, 2, 2), 0.5),
                  scaled(voxel_solid(across, 2, 2, 2), 0.5), scaled(voxel_solid(ring, 3, 3, 1), 0.5)})
    result.emplace_back(shared(std::move(body)));
  return result;
}

std::vector<Shape> made_pebbles()
{
  std::vector<Shape> result;
  for (const std::size_t k : {0, 2, 3, 1, 5}) result.emplace_back(shared(scaled(*blocks()[k].body, 0.125)));
  return result;
}

std::vector<Shape> made_meshes()
{
  std::vector<Shape> result;
  result.emplace_back(shared(snapped(blob(72, 1))));
  result.emplace_back(shared(blob(128, 2)));
  if (real_meshes_available()) {
    for (const auto& [name, faces] :
         {std::pair{"elephant", 120}, {"cow", 160}, {"anchor", 100}, {"eight", 120}, {"hand", 200}})
      result.emplace_back(shared(snapped(normalised(decimate(*demo_mesh(models, name), faces)))));
  } else {
    for (std::uint64_t seed = 3; seed < 8; ++seed)
      result.emplace_back(shared(snapped(blob(seed % 2 == 0 ? 200 : 128, seed))));
  }
  result.emplace_back(shared(torus_knot(640)));
  return result;
}

}  // namespace

Body shared(Polyhedron polyhedron) { return std::make_shared<const Polyhedron>(std::move(polyhedron)); }

std::vector<Index> lowest(const std::vector<Vertex>& vertices, const Exact_vector& direction)
{
  // Doubles find the candidates: the error of each value is below 2^-48 of the largest sum of absolute products. Beyond
  // the range of doubles, all vertices are candidates.
  std::vector<double> values;
  double least = HUGE_VAL, largest = 0;
  std::array<double, 3> d;
  for (int i = 0; i < 3; ++i) d[i] = direction[i].get_d();
  for (const Vertex& v : vertices) {
    values.push_back(d[0] * v[0] + d[1] * v[1] + d[2] * v[2]);
    least = std::min(least, values.back());
    largest = std::max(largest, std::abs(d[0] * v[0]) + std::abs(d[1] * v[1]) + std::abs(d[2] * v[2]));
  }
  const bool filtered = largest > 1e-200 && largest < 1e200;
  std::vector<Index> result;
  Rational lowest_value = 0;
  for (Index v = 0; v < vertices.size(); ++v) {
    if (filtered && values[v] > least + 0x1p-46 * largest) continue;
    const Rational value = dot(direction, exact(vertices[v]));
    if (!result.empty() && value > lowest_value) continue;
    if (result.empty() || value < lowest_value) result.clear();
    lowest_value = value;
    result.push_back(v);
  }
  return result;
}

Shape::Shape(Body the_body) : body(std::move(the_body))
{
  const Polyhedron& polyhedron = *body;
  std::map<std::array<Index, 2>, std::vector<Index>> faces_of;
  std::vector<bool> supporting;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    normals.push_back(normal_of(polyhedron, f));
    supporting.push_back(!is_zero(normals[f]) && supports(polyhedron, normals[f], polyhedron.loop(f, 0)[0]));
    covering::for_each_directed_edge(polyhedron, f, [&](Index a, Index b) {
      faces_of[{std::min(a, b), std::max(a, b)}].push_back(f);
    });
    if (is_zero(normals[f])) continue;
    for (const auto& corners : triangles_of(polyhedron, f)) {
      (supporting[f] ? hull : inner).push_back(triangles.size());
      triangles.push_back({f, corners});
    }
  }
  for (const auto& [edge, faces] : faces_of) {
    if (edge[0] == edge[1]) continue;
    edges.push_back(edge);
    if (faces.size() == 2 && supporting[faces[0]] && supporting[faces[1]] &&
        !is_zero(cross(normals[faces[0]], normals[faces[1]])))
      hull_edges.push_back({edge[0], edge[1], {faces[0], faces[1]}});
  }
  is_box = is_axis_box(polyhedron, normals);
}

const std::vector<Shape>& blocks()
{
  static const std::vector<Shape> all = made_blocks();
  return all;
}

const std::vector<Shape>& pebbles()
{
  static const std::vector<Shape> all = made_pebbles();
  return all;
}

const std::vector<Shape>& meshes()
{
  static const std::vector<Shape> all = made_meshes();
  return all;
}

const Shape& any_block(Random& random) { return blocks()[random.bits() % blocks().size()]; }
const Shape& any_pebble(Random& random) { return pebbles()[random.bits() % pebbles().size()]; }
const Shape& any_convex(Random& random) { return blocks()[random.bits() % 5]; }

const Shape& any_shape(Random& random)
{
  const std::uint64_t draw = random.bits() % 100;
  if (draw < 88) return any_block(random);
  return draw == 99 ? meshes().back() : meshes()[random.bits() % (meshes().size() - 1)];
}

const Shape& with_hull_edges(Random& random)
{
  for (;;) {
    const Shape& shape = any_shape(random);
    if (!shape.hull_edges.empty()) return shape;
  }
}

Body moved_copy(const Shape& shape, const std::array<int, 3>& exponents, double shift)
{
  static std::mutex mutex;
  static std::map<std::tuple<const Polyhedron*, std::array<int, 3>, double>, Body> copies;
  const std::lock_guard lock(mutex);
  Body& copy = copies[{shape.body.get(), exponents, shift}];
  if (!copy) {
    Polyhedron body = *shape.body;
    for (Vertex& v : body.vertices)
      for (int i = 0; i < 3; ++i) v[i] = std::ldexp(v[i], exponents[i]) + shift;
    copy = shared(std::move(body));
  }
  return copy;
}

Body tetrahedron(const std::array<Vertex, 4>& corners)
{
  const auto& [a, b, c, d] = corners;
  const Exact_vector origin = exact(a);
  const Rational volume =
      dot(difference(exact(b), origin), cross(difference(exact(c), origin), difference(exact(d), origin)));
  Polyhedron result;
  add_tetrahedron(result, volume < 0 ? std::array{a, b, d, c} : corners);
  return shared(std::move(result));
}

Body pyramid(const std::vector<Vertex>& base, const Vertex& apex)
{
  Polyhedron result;
  result.vertices = base;
  result.vertices.push_back(apex);
  const Index n = base.size();
  std::vector<Index> bottom(n);
  for (Index k = 0; k < n; ++k) {
    bottom[k] = k;
    result.add_polygon({(k + 1) % n, k, n});
  }
  result.add_polygon(bottom);
  return shared(std::move(result));
}

}  // namespace tetracone::verify::object_family
