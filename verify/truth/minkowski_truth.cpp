#include "verify/truth/exit_truth.h"

#include "verify/truth/placed_body.h"

#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/minkowski_sum_3.h>

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace tetracone::verify {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using kernel::Rational;
using Nef = CGAL::Nef_polyhedron_3<Exact>;
using Mesh = CGAL::Surface_mesh<Exact::Point_3>;
using Point = Exact::Point_3;

/// Returns the interior of a placed solid, or that of its image under the map x -> -x; nothing for a solid that this
/// file refuses.
std::optional<Nef> interior(const Placed_body& placed, bool is_mirrored)
{
  std::map<Point, std::size_t> number;
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const Element& element : placed.body().elements()) {
    if (element.dimension != 2) return std::nullopt;
    std::array<std::size_t, 3>& triangle = triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& x = placed.image<Exact>(element.corners[k]);
      const auto [at, is_new] = number.try_emplace(x, points.size());
      if (is_new) points.push_back(is_mirrored ? Point(-x.x(), -x.y(), -x.z()) : x);
      triangle[k] = at->second;
    }
  }
  if (triangles.empty() || !pmp::orient_polygon_soup(points, triangles)) return std::nullopt;
  if (!pmp::is_polygon_soup_a_polygon_mesh(triangles)) return std::nullopt;
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  auto part = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part").first;
  if (!CGAL::is_closed(mesh) || pmp::connected_components(mesh, part) != 1 || pmp::does_self_intersect(mesh))
    return std::nullopt;
  if (!pmp::is_outward_oriented(mesh)) pmp::reverse_face_orientations(mesh);
  return Nef(mesh).interior();
}

bool holds(const Nef& set, const Point& x)
{
  const auto part = set.locate(x);
  Nef::Vertex_const_handle vertex;
  Nef::Halfedge_const_handle edge;
  Nef::Halffacet_const_handle facet;
  Nef::Volume_const_handle volume;
  if (CGAL::assign(vertex, part)) return vertex->mark();
  if (CGAL::assign(edge, part)) return edge->mark();
  if (CGAL::assign(facet, part)) return facet->mark();
  return CGAL::assign(volume, part) && volume->mark();
}

}  // namespace

std::optional<Rational> minkowski_squared_depth(const Object_case& c)
{
  const Brute_body body_a(*c.a), body_b(*c.b);
  std::optional<Nef> a = interior(Placed_body(body_a, c.pose_a), true),
                     b = interior(Placed_body(body_b, c.pose_b), false);
  if (!a || !b) return std::nullopt;
  const Nef overlapping = CGAL::minkowski_sum_3(*a, *b);
  const Point zero(0, 0, 0);
  if (!holds(overlapping, zero)) return Rational(0);
  // The nearest point of the complement is a vertex, or the foot on an edge's line or on a facet's plane. Any such
  // point of the complement is an upper bound.
  std::optional<Rational> least;
  const auto add = [&](const Point& x) {
    const Rational square = x.x() * x.x() + x.y() * x.y() + x.z() * x.z();
    if ((!least || square < *least) && !holds(overlapping, x)) least = square;
  };
  for (auto v = overlapping.vertices_begin(); v != overlapping.vertices_end(); ++v) add(v->point());
  for (auto e = overlapping.halfedges_begin(); e != overlapping.halfedges_end(); ++e)
    add(Exact::Line_3(e->source()->point(), e->twin()->source()->point()).projection(zero));
  for (auto f = overlapping.halffacets_begin(); f != overlapping.halffacets_end(); ++f)
    add(f->plane().projection(zero));
  return least;
}

}  // namespace tetracone::verify
