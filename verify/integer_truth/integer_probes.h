#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_PROBES_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_PROBES_H

#include "tetracone/kernel/number/number.h"
#include "verify/integer_truth/integer_body.h"

#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify::integer_truth {

/// The second truth of points and rays: all faces of one body in integers. Faces are not triangulated. Quadrants give a
/// point's position in a face, and the faces above it its position in the solid.
class Probed_body {
 public:
  /// Requires planar faces, and that the polyhedron outlives this.
  explicit Probed_body(const covering::Polyhedron& polyhedron);

  /// Returns 1 inside, 0 on the surface, -1 outside. Requires a closed polyhedron.
  int where(const kernel::Vertex& point) const;

  /// Returns every face that from + t direction meets with t >= 0, each with its least t, in order. Requires a
  /// direction that is not 0.
  std::vector<std::pair<kernel::Rational, Index>> hits(const kernel::Vertex& from,
                                                       const kernel::Vertex& direction) const;

 private:
  /// The points (x + t y) / w in the body's integers, w > 0.
  struct Ray {
    Integer_vector x, y;
    Integer w;
  };

  bool is_on(Index f, const Integer_vector& x, const Integer& w) const;
  std::optional<kernel::Rational> first_on(Index f, const Ray& ray) const;
  std::optional<kernel::Rational> first_on_loops(Index f, const Ray& ray) const;

  Integer denominator_;
  Integer_body body_;
  std::vector<std::optional<Integer_vector>> normals_;  // of faces
};

}  // namespace tetracone::verify::integer_truth

#endif
