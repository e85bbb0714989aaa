#ifndef TETRACONE_VERIFY_TRUTH_PLANAR_FACE_H
#define TETRACONE_VERIFY_TRUTH_PLANAR_FACE_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/number.h"

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify {

/// The kernel of the truth: every coordinate is a rational, every construction exact.
using Exact = CGAL::Simple_cartesian<kernel::Rational>;

/// The element of a face whose relative interior contains a point.
enum class Place { outside, face, edge, vertex };

/// One face in rational arithmetic, as closed loops of points. Its points are the loops themselves, and the points of
/// its plane whose winding number about the loops is not zero.
class Planar_face {
 public:
  using Point_2 = Exact::Point_2;
  using Point_3 = Exact::Point_3;

  /// Requires at least one loop, no loop empty.
  explicit Planar_face(std::vector<std::vector<Point_3>> loops);

  const std::vector<std::vector<Point_3>>& loops() const { return loops_; }

  /// Returns three corners that are not on one line; nothing when all corners are on one line.
  const std::optional<std::array<Point_3, 3>>& base() const { return base_; }

  /// True when all corners are in one plane.
  bool is_planar() const;

  /// Returns the side of the face's plane that contains `p`. Requires a base.
  CGAL::Sign side(const Point_3& p) const;

  /// Returns the element of the face that contains `p`.
  Place locate(const Point_3& p) const;

  /// Returns the point without its coordinate along the largest component of the face's normal. Requires a base.
  Point_2 project(const Point_3& p) const;

  /// Returns the point of the face's plane whose projection is `p`. Requires a base.
  Point_3 lift(const Point_2& p) const;

  /// Returns the winding number of the projected loops about `p`: the signed crossings of the ray from p along the
  /// first axis. Requires a base, and p on no loop.
  int winding(const Point_2& p) const;

 private:
  void find_base();

  std::vector<std::vector<Point_3>> loops_;
  std::vector<std::vector<Point_2>> projected_;
  std::optional<std::array<Point_3, 3>> base_;
  int dropped_ = 0;
};

/// Returns face `f` of a polyhedron, with the point at(v) for each vertex v.
template <class At>
Planar_face planar_face(const covering::Polyhedron& polyhedron, covering::Index f, const At& at)
{
  std::vector<std::vector<Exact::Point_3>> loops(polyhedron.loop_count(f));
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (const covering::Index v : polyhedron.loop(f, k)) loops[k].push_back(at(v));
  return Planar_face(std::move(loops));
}

}  // namespace tetracone::verify

#endif
