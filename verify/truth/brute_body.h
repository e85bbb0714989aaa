#ifndef TETRACONE_VERIFY_TRUTH_BRUTE_BODY_H
#define TETRACONE_VERIFY_TRUTH_BRUTE_BODY_H

#include "tetracone/covering/polyhedron.h"
#include "verify/truth/planar_face.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify {

using covering::Index;

/// A convex piece of a surface: the hull of one point, of two different points, or of three points that are not on one
/// line.
struct Element {
  std::array<Index, 3> corners;  ///< numbers of points; only dimension + 1 of them are used
  int dimension;                 ///< 0: point, 1: segment, 2: triangle
  int winding;                   ///< for a triangle: the winding number of its face's loops about it, never 0; else 0
};

/// A polyhedron prepared for the truth: its surface as a set of exact points, segments and triangles.
///
/// CGAL's constrained Delaunay triangulation with exact intersections triangulates each face that is not a triangle, on
/// its projection along the largest component of its normal. Triangles whose winding number about the loops is not zero
/// are kept, and those parts of the loops that bound no such triangle. A face on a line becomes the segments of its
/// loops, and a loop of one point becomes that point. The triangles, each counted with its winding number, bound the
/// same set as the faces. Winding numbers about the polyhedron can therefore be counted on them.
class Brute_body {
 public:
  /// Throws std::invalid_argument when a face is not exactly planar.
  explicit Brute_body(const covering::Polyhedron& polyhedron);

  const covering::Polyhedron& polyhedron() const { return polyhedron_; }

  /// Returns the polyhedron's vertices, then the points where loops of a face cross.
  const std::vector<Exact::Point_3>& points() const { return points_; }

  /// Doubles that enclose each point's coordinates: lower and upper, of x, y and z.
  using Bounds = std::array<std::pair<double, double>, 3>;
  const std::vector<Bounds>& bounds() const { return bounds_; }

  const std::vector<Element>& elements() const { return elements_; }

  /// Returns the edges of all loops without their direction, (from, to) with from <= to, sorted and unique.
  const std::vector<std::pair<Index, Index>>& edges() const { return edges_; }

  /// Returns three corners of face `f` that are not on one line; nothing for a face on a line.
  const std::optional<std::array<Index, 3>>& base(Index f) const { return bases_[f]; }

  /// True when every directed edge occurs as often as its reverse: the polyhedron bounds a solid.
  bool is_closed() const { return closed_; }

  /// Returns at least one point of each connected part of the surface.
  const std::vector<Index>& component_points() const { return component_points_; }

 private:
  void add_face(Index f);

  std::optional<std::array<Index, 3>> base_corners(Index f, const Planar_face& face) const;

  /// Adds all edges of the loops of a face on a line.
  void add_loops(Index f, const Planar_face& face);

  /// Adds a loop that consists of one point; false when it does not.
  bool add_lone_point(covering::Loop loop);

  void triangulate(Index f, const Planar_face& face);

  void find_edges();

  /// Elements that share a point's number count as connected. This is enough: a part that is split in two is only asked
  /// twice.
  void find_components();

  covering::Polyhedron polyhedron_;
  std::vector<Exact::Point_3> points_;
  std::vector<Bounds> bounds_;
  std::vector<Element> elements_;
  std::vector<std::pair<Index, Index>> edges_;
  std::vector<std::optional<std::array<Index, 3>>> bases_;
  std::vector<Index> component_points_;
  bool closed_ = true;
};

/// Returns one face of a polyhedron as a body of its own, with its vertices renumbered.
covering::Polyhedron face_alone(const covering::Polyhedron& polyhedron, Index f);

}  // namespace tetracone::verify

#endif
