#ifndef TETRACONE_COVERING_REPAIR_REPAIR_H
#define TETRACONE_COVERING_REPAIR_REPAIR_H

// This uses CGAL's triangulations and Polygon_mesh_processing, which are GPL, so whatever links it is GPL too.

#include "tetracone/covering/orient.h"
#include "tetracone/covering/polyhedron.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace tetracone::covering {

namespace repair {

using Triangle = std::array<Index, 3>;

/// The number of uses of the directed edge (a, b), a < b, minus the number of its reverse; edges that cancel have no
/// entry.
using Boundary = std::map<std::array<Index, 2>, int>;
void add_edge(Boundary& boundary, Index a, Index b);           ///< adds the directed edge (a, b), unless a == b
Boundary boundary_of(const std::vector<Triangle>& triangles);  ///< returns the sum of their directed sides

/// Returns the triangles of face `f` by constrained Delaunay triangulation of its projection along the largest
/// component of the outer loop's Newell normal. Each triangle of the plane occurs as often, and in the direction, as
/// its winding number about the loops says. Nothing where the projected loops cross, pass through another corner, put
/// two corners in one point, or lie on one line.
std::optional<std::vector<Triangle>> constrained_delaunay(const Polyhedron& polyhedron, Index f);

/// Returns the triangles that join the first corner of each loop of face `f` to that loop's edges. As a chain they have
/// the face's boundary. A fan that folds over itself or fills a hole remains as triangles; the opposite fan cancels it
/// in the winding number only.
std::vector<Triangle> fan(const Polyhedron& polyhedron, Index f);

}  // namespace repair

/// Returns triangles for each face of more than three corners that has them, without new vertices. They have the face's
/// direction, and cover it exactly, as often as its winding number says. A triangle has no entry. A face has none if
/// its loops cross, pass through a corner, or have an edge that bounds nothing. Requires planar faces.
std::vector<Face_triangle> triangulate_faces(const Polyhedron& polyhedron);

/// A polyhedron whose faces are all planar, and where they come from.
struct Triangulated {
  Polyhedron polyhedron;
  std::vector<Index> source;    ///< for each face: the number of the original face that it is or is a triangle of
  std::vector<Index> replaced;  ///< faces that were replaced by triangles, ascending
  std::vector<Index> fanned;    ///< faces among `replaced` whose triangles are those of `repair::fan`
};

/// Returns the polyhedron with each face that is not exactly planar replaced by triangles. Their boundary is exactly
/// its directed loop edges. A closed surface therefore stays closed. The triangles come from CGAL's constrained
/// Delaunay triangulation (see `repair::constrained_delaunay`), and where that is impossible from `repair::fan`.
/// Vertices stay as they are.
Triangulated triangulate_non_planar(Polyhedron polyhedron);

/// Returns the polyhedron with its faces oriented consistently across edges that two faces share. CGAL does it if
/// each face is one loop without a repeated vertex, else a breadth-first search. Parts that are closed already are
/// left alone; parts that become closed are turned outward, by the volume of `triangulate_non_planar`
/// (`apply_orientation`).
Oriented orient(const Polyhedron& polyhedron);

/// True when `orient` closes the polyhedron, or it is closed already.
bool closes_if_oriented(const Polyhedron& polyhedron);

}  // namespace tetracone::covering

#endif
