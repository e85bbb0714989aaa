#include "verify/truth/brute_body.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::verify {

namespace {

using Plane_vertex = CGAL::Triangulation_vertex_base_with_info_2<std::optional<Index>, Exact>;
using Plane_face =
    CGAL::Constrained_triangulation_face_base_2<Exact, CGAL::Triangulation_face_base_with_info_2<int, Exact>>;
using Plane_triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Exact, CGAL::Triangulation_data_structure_2<Plane_vertex, Plane_face>,
                                               CGAL::Exact_intersections_tag>;

}  // namespace

Brute_body::Brute_body(const covering::Polyhedron& polyhedron) : polyhedron_(polyhedron)
{
  for (const auto& [x, y, z] : polyhedron.vertices) points_.emplace_back(x, y, z);
  for (Index f = 0; f < polyhedron.face_count(); ++f) add_face(f);
  for (const Exact::Point_3& p : points_)
    bounds_.push_back({CGAL::to_interval(p.x()), CGAL::to_interval(p.y()), CGAL::to_interval(p.z())});
  find_edges();
  find_components();
}

void Brute_body::add_face(Index f)
{
  const Planar_face face = planar_face(polyhedron_, f, [this](Index v) { return points_[v]; });
  bases_.push_back(base_corners(f, face));
  if (!face.base()) {
    add_loops(f, face);
  } else if (polyhedron_.is_triangle(f)) {
    const auto loop = polyhedron_.loop(f, 0);
    elements_.push_back({{loop[0], loop[1], loop[2]}, 2, 1});
  } else if (face.is_planar()) {
    triangulate(f, face);
  } else {
    throw std::invalid_argument("face " + std::to_string(f) + " is not exactly planar");
  }
}

std::optional<std::array<Index, 3>> Brute_body::base_corners(Index f, const Planar_face& face) const
{
  if (!face.base()) return std::nullopt;
  std::array<Index, 3> corners{};
  for (std::size_t k = 0; k < polyhedron_.loop_count(f); ++k)
    for (const Index v : polyhedron_.loop(f, k))
      for (int i = 0; i < 3; ++i)
        if (points_[v] == (*face.base())[i]) corners[i] = v;
  return corners;
}

void Brute_body::add_loops(Index f, const Planar_face& face)
{
  for (std::size_t k = 0; k < face.loops().size(); ++k) {
    const auto loop = polyhedron_.loop(f, k);
    if (add_lone_point(loop)) continue;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index from = loop[i], to = loop[(i + 1) % loop.size()];
      if (points_[from] != points_[to]) elements_.push_back({{from, to, to}, 1, 0});
    }
  }
}

bool Brute_body::add_lone_point(covering::Loop loop)
{
  for (const Index v : loop)
    if (points_[v] != points_[loop[0]]) return false;
  elements_.push_back({{loop[0], loop[0], loop[0]}, 0, 0});
  return true;
}

void Brute_body::triangulate(Index f, const Planar_face& face)
{
  Plane_triangulation plane;
  std::vector<std::vector<Plane_triangulation::Vertex_handle>> corners;
  for (std::size_t k = 0; k < polyhedron_.loop_count(f); ++k) {
    corners.emplace_back();
    for (const Index v : polyhedron_.loop(f, k)) {
      const auto corner = plane.insert(face.project(points_[v]));
      if (!corner->info()) corner->info() = v;
      corners.back().push_back(corner);
    }
    add_lone_point(polyhedron_.loop(f, k));
  }
  for (const auto& loop : corners)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto from = loop[i], to = loop[(i + 1) % loop.size()];
      if (from != to) plane.insert_constraint(from, to);
    }
  const auto number = [&](Plane_triangulation::Vertex_handle v) {
    if (!v->info()) {
      v->info() = Index(points_.size());
      points_.push_back(face.lift(v->point()));
    }
    return *v->info();
  };
  for (const auto triangle : plane.all_face_handles()) {
    triangle->info() = 0;
    if (plane.is_infinite(triangle)) continue;
    const auto p = [&](int i) { return triangle->vertex(i)->point(); };
    triangle->info() = face.winding(CGAL::centroid(p(0), p(1), p(2)));
    if (triangle->info() == 0) continue;
    elements_.push_back(
        {{number(triangle->vertex(0)), number(triangle->vertex(1)), number(triangle->vertex(2))}, 2, triangle->info()});
  }
  for (const auto& [triangle, i] : plane.constrained_edges()) {
    if (triangle->info() != 0 || triangle->neighbor(i)->info() != 0) continue;
    const Index from = number(triangle->vertex(plane.cw(i))), to = number(triangle->vertex(plane.ccw(i)));
    elements_.push_back({{from, to, to}, 1, 0});
  }
}

void Brute_body::find_edges()
{
  std::map<std::pair<Index, Index>, long> balance;  // from <= to -> times forward minus times backward
  for (Index f = 0; f < polyhedron_.face_count(); ++f)
    for (std::size_t k = 0; k < polyhedron_.loop_count(f); ++k) {
      const auto loop = polyhedron_.loop(f, k);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index from = loop[i], to = loop[(i + 1) % loop.size()];
        balance[std::minmax(from, to)] += from < to ? 1 : from > to ? -1 : 0;
      }
    }
  for (const auto& [edge, sum] : balance) {
    edges_.push_back(edge);
    closed_ = closed_ && sum == 0;
  }
}

void Brute_body::find_components()
{
  std::vector<Index> parent(points_.size());
  std::iota(parent.begin(), parent.end(), Index(0));
  const auto root = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Element& element : elements_)
    for (int i = 1; i <= element.dimension; ++i) parent[root(element.corners[i])] = root(element.corners[0]);
  for (const Element& element : elements_) component_points_.push_back(root(element.corners[0]));
  std::sort(component_points_.begin(), component_points_.end());
  component_points_.erase(std::unique(component_points_.begin(), component_points_.end()), component_points_.end());
}

covering::Polyhedron face_alone(const covering::Polyhedron& polyhedron, Index f)
{
  covering::Polyhedron face;
  std::map<Index, Index> number;
  std::vector<std::vector<Index>> loops;
  for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) {
    loops.emplace_back();
    for (const Index v : polyhedron.loop(f, k)) {
      const auto [at, is_new] = number.try_emplace(v, Index(face.vertices.size()));
      if (is_new) face.vertices.push_back(polyhedron.vertices[v]);
      loops.back().push_back(at->second);
    }
  }
  face.add_face(loops);
  return face;
}

}  // namespace tetracone::verify
