#ifndef TETRACONE_VERIFY_TRUTH_NEAREST_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_NEAREST_TRUTH_H

#include "tetracone/covering/polyhedron.h"
#include "verify/truth/planar_face.h"

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace tetracone::verify {

/// The points of a body's surface nearest to a point, by all of its faces in rationals.
class Nearest_truth {
 public:
  using Point = Exact::Point_3;

  /// Requires planar faces.
  explicit Nearest_truth(const covering::Polyhedron& polyhedron)
  {
    const auto at = [&](covering::Index v) {
      const auto& [x, y, z] = polyhedron.vertices[v];
      return Point(x, y, z);
    };
    for (covering::Index f = 0; f < polyhedron.face_count(); ++f) faces_.push_back(planar_face(polyhedron, f, at));
  }

  /// Returns the square of the distance, and all points of this distance.
  std::pair<kernel::Rational, std::set<Point>> operator()(const Point& x) const
  {
    std::pair<kernel::Rational, std::set<Point>> nearest;
    const auto add = [&](const Point& p) {
      const kernel::Rational square = CGAL::squared_distance(x, p);
      if (nearest.second.empty() || square < nearest.first) nearest = {square, {}};
      if (square == nearest.first) nearest.second.insert(p);
    };
    for (const Planar_face& face : faces_) {
      if (face.base()) {
        const auto& [a, b, c] = *face.base();
        const Point foot = Exact::Plane_3(a, b, c).projection(x);
        if (face.locate(foot) != Place::outside) add(foot);
      }
      for (const auto& loop : face.loops())
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const Point &a = loop[k], &b = loop[(k + 1) % loop.size()];
          add(a);
          if (a == b) continue;
          const Point foot = Exact::Line_3(a, b).projection(x);
          if (Exact::Segment_3(a, b).has_on(foot)) add(foot);
        }
    }
    return nearest;
  }

  /// Returns face f in rationals.
  const Planar_face& face(covering::Index f) const { return faces_[f]; }

 private:
  std::vector<Planar_face> faces_;
};

}  // namespace tetracone::verify

#endif
