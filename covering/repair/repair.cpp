#include "tetracone/covering/repair/repair.h"

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/face_cover.h"
#include "tetracone/covering/planarity.h"
#include "tetracone/covering/projection.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::covering {

namespace repair {

void add_edge(Boundary& boundary, Index a, Index b)
{
  if (a == b) return;
  const std::array edge{std::min(a, b), std::max(a, b)};
  const int change = a < b ? 1 : -1;
  if ((boundary[edge] += change) == 0) boundary.erase(edge);
}

Boundary boundary_of(const std::vector<Triangle>& triangles)
{
  Boundary boundary;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) add_edge(boundary, t[k], t[(k + 1) % 3]);
  return boundary;
}

namespace {

struct Label {
  bool reached = false;
  int winding = 0;
};
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using Face_base =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<Label, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
// The tag makes the insertion throw where constraints cross, since no triangulation is wanted there.
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

}  // namespace

std::optional<std::vector<Triangle>> constrained_delaunay(const Polyhedron& polyhedron, Index f)
{
  const int axis = projection_axis(polyhedron, polyhedron.loop(f, 0));
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Boundary boundary;
  Triangulation triangulation;
  std::map<Index, Triangulation::Vertex_handle> handles;
  for (const Index corner : corners(polyhedron, f)) {
    if (handles.contains(corner)) continue;
    const Vertex& p = polyhedron.vertices[corner];
    const std::size_t before = triangulation.number_of_vertices();
    const auto handle = triangulation.insert(Kernel::Point_2(p[u], p[v]));
    if (triangulation.number_of_vertices() == before) return std::nullopt;
    handle->info() = corner;
    handles[corner] = handle;
  }
  for_each_directed_edge(polyhedron, f, [&boundary](Index a, Index b) { add_edge(boundary, a, b); });
  try {
    // Each edge is inserted once, since the tag takes a second time for a crossing; edges that cancel bound nothing.
    for (const auto& [edge, uses] : boundary) triangulation.insert_constraint(handles[edge[0]], handles[edge[1]]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  if (triangulation.dimension() < 2) return std::nullopt;

  // Winding numbers spread from the infinite face; crossing the directed edge (a, b) from its right to its left adds 1.
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face) face->info() = {};
  std::vector<Triangulation::Face_handle> queue{triangulation.infinite_face()};
  queue[0]->info() = {true, 0};
  std::vector<Triangle> triangles;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const auto face = queue[next];
    const int winding = face->info().winding;
    if (!triangulation.is_infinite(face)) {
      Triangle t;
      for (int k = 0; k < 3; ++k) t[k] = face->vertex(k)->info();
      if (winding < 0) std::swap(t[1], t[2]);
      triangles.insert(triangles.end(), std::abs(winding), t);
    }
    for (int k = 0; k < 3; ++k) {
      const auto neighbour = face->neighbor(k);
      if (neighbour->info().reached) continue;
      int beyond = winding;
      const auto a = face->vertex((k + 1) % 3), b = face->vertex((k + 2) % 3);
      if (!triangulation.is_infinite(a) && !triangulation.is_infinite(b)) {
        // This face is on the left of (a, b), the neighbour on its right.
        const Index i = a->info(), j = b->info();
        if (const auto found = boundary.find({std::min(i, j), std::max(i, j)}); found != boundary.end())
          beyond -= i < j ? found->second : -found->second;
      }
      neighbour->info() = {true, beyond};
      queue.push_back(neighbour);
    }
  }
  if (boundary_of(triangles) != boundary) return std::nullopt;
  return triangles;
}

std::vector<Triangle> fan(const Polyhedron& polyhedron, Index f)
{
  std::vector<Triangle> triangles;
  for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) {
    const Loop loop = polyhedron.loop(f, k);
    for (std::size_t j = 1; j + 1 < loop.size(); ++j) triangles.push_back({loop[0], loop[j], loop[j + 1]});
  }
  return triangles;
}

namespace {

/// Collects the polygons that CGAL turned round.
struct Turn_visitor : CGAL::Polygon_mesh_processing::Default_orientation_visitor {
  explicit Turn_visitor(std::vector<bool>& turns) : turned(turns) {}
  void polygon_orientation_reversed(std::size_t polygon) { turned[polygon] = !turned[polygon]; }
  std::vector<bool>& turned;
};

/// Returns `turns_across_edges` by CGAL's orient_polygon_soup, which takes only single loops that visit a vertex once.
/// The vertices that it duplicates are not taken over. Nothing where the polyhedron has other faces.
std::optional<std::vector<bool>> turns_by_cgal(const Polyhedron& polyhedron)
{
  std::vector<Kernel::Point_3> points(polyhedron.vertices.size());
  std::vector<std::vector<std::size_t>> polygons;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    if (polyhedron.loop_count(f) != 1) return std::nullopt;
    const Loop loop = polyhedron.loop(f, 0);
    polygons.emplace_back(loop.begin(), loop.end());
    auto sorted = polygons.back();
    std::ranges::sort(sorted);
    if (sorted.size() < 3 || std::ranges::adjacent_find(sorted) != sorted.end()) return std::nullopt;
  }
  std::vector<bool> turned(polygons.size());
  Turn_visitor visitor(turned);
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, polygons, CGAL::parameters::visitor(visitor));
  return turned;
}

}  // namespace
}  // namespace repair

std::vector<Face_triangle> triangulate_faces(const Polyhedron& polyhedron)
{
  std::vector<Face_triangle> all;
  Face_cover cover(polyhedron);
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    if (polyhedron.is_triangle(f)) continue;
    const auto triangles = repair::constrained_delaunay(polyhedron, f);
    if (!triangles || cover.flaw(f, *triangles)) continue;
    for (const auto& t : *triangles) all.push_back({f, t});
  }
  return all;
}

Triangulated triangulate_non_planar(Polyhedron polyhedron)
{
  Triangulated result;
  const auto is_planar = [&](Index f) {
    return polyhedron.is_triangle(f) || planarity(polyhedron, f) != Planarity::off_plane;
  };
  result.source.resize(polyhedron.face_count());
  std::iota(result.source.begin(), result.source.end(), Index(0));
  if (std::ranges::all_of(result.source, is_planar)) {
    result.polyhedron = std::move(polyhedron);
    return result;
  }
  result.source.clear();
  result.polyhedron.vertices = polyhedron.vertices;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    if (is_planar(f)) {
      append_face(result.polyhedron, polyhedron, f, false);
      result.source.push_back(f);
      continue;
    }
    result.replaced.push_back(f);
    auto triangles = repair::constrained_delaunay(polyhedron, f);
    if (!triangles) {
      result.fanned.push_back(f);
      triangles = repair::fan(polyhedron, f);
    }
    for (const auto& triangle : *triangles) {
      result.polyhedron.add_polygon(triangle);
      result.source.push_back(f);
    }
  }
  return result;
}

Oriented orient(const Polyhedron& polyhedron)
{
  const auto turned = repair::turns_by_cgal(polyhedron);
  return apply_orientation(polyhedron, turned ? *turned : turns_across_edges(polyhedron),
                           [](const Polyhedron& group) { return volume(triangulate_non_planar(group).polyhedron); });
}

bool closes_if_oriented(const Polyhedron& polyhedron) { return is_closed(orient(polyhedron).polyhedron); }

}  // namespace tetracone::covering
