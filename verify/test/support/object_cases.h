#ifndef TETRACONE_VERIFY_TEST_SUPPORT_OBJECT_CASES_H
#define TETRACONE_VERIFY_TEST_SUPPORT_OBJECT_CASES_H

#include "verify/cases/case.h"
#include "verify/test/support/segment_truth.h"

#include <memory>
#include <utility>
#include <vector>

/// Cases of two bodies, and bodies that no family makes: with faces of no area, and of loops that cross.
namespace tetracone::verify::scenes {

/// Returns a case of two bodies in these poses, whose answers are not known.
inline Object_case object_case(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b, const Pose& pose_b)
{
  return {std::make_shared<const Polyhedron>(a), std::make_shared<const Polyhedron>(b), pose_a, pose_b, {}, {}, {}};
}

/// A body of one face with these corners in order.
inline Polyhedron polygon(std::vector<Vertex> corners)
{
  Polyhedron polygon;
  polygon.vertices = std::move(corners);
  std::vector<Index> loop(polygon.vertices.size());
  for (std::size_t k = 0; k < loop.size(); ++k) loop[k] = Index(k);
  polygon.add_polygon(loop);
  return polygon;
}

/// A square about (x, 0, 0) with a square hole, in the plane z = 0: half widths `outer` and `inner`.
inline Polyhedron holed_square(double outer, double inner, double x = 0)
{
  Polyhedron frame;
  for (const double half : {outer, inner})
    for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      frame.vertices.push_back({x + half * i, half * j, 0});
  frame.add_face({{0, 1, 2, 3}, {7, 6, 5, 4}});
  return frame;
}

/// A face of random loops: some run back the way they came, without area, and yet with a plane.
inline Polyhedron any_loops(Random& random, int radius) { return face_of(random_loops(random, radius)); }

}  // namespace tetracone::verify::scenes

#endif
