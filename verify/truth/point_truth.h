#ifndef TETRACONE_VERIFY_TRUTH_POINT_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_POINT_TRUTH_H

#include "verify/truth/cgal_truth.h"

#include <array>

namespace tetracone::verify {

/// Decides whether points are inside one body, by all of its elements in rationals. A point is on the surface where an
/// element holds it. The signed crossings of a ray decide other points. Not thread-safe.
class Point_truth {
 public:
  /// Requires a closed polyhedron. Throws as `Brute_body`.
  explicit Point_truth(const covering::Polyhedron& polyhedron) : body_(polyhedron), solid_(body_, Pose()) {}
  Point_truth(const Point_truth&) = delete;

  /// Returns 1 inside, 0 on the surface, -1 outside.
  int operator()(const std::array<kernel::Rational, 3>& p) const { return inside(solid_, p); }
  int operator()(const kernel::Vertex& p) const
  {
    return (*this)(
        std::array<kernel::Rational, 3>{kernel::Rational(p[0]), kernel::Rational(p[1]), kernel::Rational(p[2])});
  }

 private:
  Brute_body body_;
  Placed_body solid_;
};

}  // namespace tetracone::verify

#endif
