#ifndef TETRACONE_VERIFY_TRUTH_RAY_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_RAY_TRUTH_H

#include "verify/truth/brute_body.h"

#include <utility>
#include <vector>

namespace tetracone::verify {

/// Finds every face that a ray meets, by testing all of them in rationals: CGAL intersects the ray's line with each
/// piece of the face's triangulation, and intersections behind the origin are dropped. (CGAL 5.5.1's own rays also meet
/// triangles behind them, where they lie in one plane.)
class Ray_truth {
 public:
  /// Throws as `Brute_body`.
  explicit Ray_truth(const covering::Polyhedron& polyhedron);

  /// Returns the least t >= 0 for each face that o + t d meets, with the face. The pairs ascend by t, then by face.
  /// Requires a direction other than 0.
  std::vector<std::pair<kernel::Rational, Index>> operator()(const kernel::Vertex& o, const kernel::Vertex& d) const;

 private:
  std::vector<Brute_body> faces_;
};

}  // namespace tetracone::verify

#endif
