#ifndef TETRACONE_COVERING_REPAIR_REPAIR_H
#define TETRACONE_COVERING_REPAIR_REPAIR_H

// By CGAL's triangulations and Polygon_mesh_processing, which are GPL, and so is what links this.

#include "tetracone/covering/orient.h"
#include "tetracone/covering/polyhedron.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace tetracone::covering {

namespace repair {

using Triangle = std::array<Index, 3>;

/// How often the directed edge (a, b), a < b, is used more than its reverse; edges that cancel have no entry.
using Boundary = std::map<std::array<Index, 2>, int>;
void add_edge(Boundary& boundary, Index a, Index b);
Boundary boundary_of(const std::vector<Triangle>& triangles);

/// The triangles of face `f` by constrained Delaunay triangulation of its projection along the largest component of the
/// outer loop's Newell normal: each triangle of the plane as often, and in the direction, as its winding number about
/// the loops says. Nothing where the projected loops cross, pass through another corner, or put two corners in one
/// point.
std::optional<std::vector<Triangle>> constrained_delaunay(const Polyhedron& polyhedron, Index f);

/// The triangles that join the first corner of each loop of face `f` to that loop's edges. As a chain they have the
/// face's boundary; a fan that folds over itself or fills a hole is there all the same, and the opposite fan cancels it
/// only in the winding number.
std::vector<Triangle> fan(const Polyhedron& polyhedron, Index f);

}  // namespace repair

/// Triangles that cover exactly each face of more than one triangle's corners, in its direction and as often as its
/// winding number says, without new vertices; none for triangles, and for faces where that is not possible: where loops
/// cross, pass through a corner, or have an edge that bounds nothing. Requires planar faces.
std::vector<Face_triangle> triangulate_faces(const Polyhedron& polyhedron);

/// A polyhedron whose faces are all planar, and where they come from.
struct Triangulated {
  Polyhedron polyhedron;
  std::vector<Index> source;    ///< of each face: the face that it is, or is a triangle of
  std::vector<Index> replaced;  ///< faces that were replaced by triangles, ascending
  std::vector<Index> fanned;    ///< those of them that had to be replaced by fans
};

/// Replaces each face that is not exactly planar, that face alone, by triangles with exactly its directed loop edges as
/// their boundary: what was closed stays closed. By CGAL's constrained Delaunay triangulation (see
/// `repair::constrained_delaunay`), and where that is impossible by `repair::fan`. Vertices stay as they are.
Triangulated triangulate_non_planar(Polyhedron polyhedron);

/// The polyhedron with its faces oriented consistently across edges that two faces share: by CGAL where all faces are
/// single loops that visit a vertex once, else breadth-first. What closes as it stands is left alone, what becomes
/// closed is turned outward (`apply_orientation`).
Oriented orient(const Polyhedron& polyhedron);

/// Whether consistent orientation alone closes the polyhedron (true for one that is closed already).
bool closes_if_oriented(const Polyhedron& polyhedron);

}  // namespace tetracone::covering

#endif
