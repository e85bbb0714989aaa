#ifndef TETRACONE_COVERING_SIDE_WINDINGS_H
#define TETRACONE_COVERING_SIDE_WINDINGS_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tetracone::covering {

/// Returns a face with the points that `place` returns for its vertices. Requires points in one plane.
template <class Place>
kernel::Rational_face placed_face(const Polyhedron& polyhedron, Index f, const Place& place)
{
  std::vector<kernel::Rational_face::Edge> edges;
  for (std::size_t l = 0; l < polyhedron.loop_count(f); ++l) {
    const Loop loop = polyhedron.loop(f, l);
    std::vector<kernel::Rational_point> points;
    for (const Index v : loop) points.push_back(place(polyhedron.vertices[v]));
    for (std::size_t k = 0; k < points.size(); ++k)
      edges.push_back({points[k], points[k + 1 == points.size() ? 0 : k + 1]});
  }
  return kernel::Rational_face(std::move(edges));
}

/// Returns a face in rationals, under a pose.
inline kernel::Rational_face rational_face(const Polyhedron& polyhedron, Index f, const kernel::Pose& pose)
{
  const std::array<kernel::Rational, 12> m = kernel::rows_of(pose);
  return placed_face(polyhedron, f, [&](const kernel::Vertex& v) { return kernel::image(v, m); });
}

/// Whether the points just above and just below a point, along an axis, have a winding number other than 0.
struct Sides {
  bool above = false, below = false;
};

/// Returns the sides of x along axis k. Requires a closed polyhedron. Every face with area that holds x must lie in one
/// plane, which the axis crosses, and must hold x in its inside.
///
/// A ray goes upwards from x, which is moved first by an infinitesimal across the axis, then by a smaller one along it.
/// The ray meets no edge then. The winding number is the sum of the winding numbers of the faces that it crosses. Only
/// the ray from just below x crosses a face that holds x.
inline Sides sides(const Polyhedron& polyhedron, const kernel::Rational_point& x, int k)
{
  std::array<double, 3> low, high;  // bounds of x: a conversion truncates
  for (int i = 0; i < 3; ++i) {
    const double about = x[i].get_d();
    low[i] = std::nextafter(about, -HUGE_VAL);
    high[i] = std::nextafter(about, HUGE_VAL);
  }
  int above = 0, here = 0;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    // A face wholly below x, or beside it across the axis, is not crossed.
    unsigned beyond = 0x3f;
    for (std::size_t l = 0; l < polyhedron.loop_count(f) && beyond != 0; ++l)
      for (const Index v : polyhedron.loop(f, l))
        for (unsigned i = 0; i < 3; ++i) {
          const double at = polyhedron.vertices[v][i];
          if (!(at > high[i]) || int(i) == k) beyond &= ~(1u << 2 * i);
          if (!(at < low[i])) beyond &= ~(2u << 2 * i);
        }
    if (beyond != 0) continue;
    const kernel::Rational_face face = rational_face(polyhedron, f, kernel::Pose());
    if (!face.has_plane()) continue;
    const int winding = face.winding(x, k);
    if (winding == 0) continue;
    const int side = sgn(face.beyond(x)) * sgn(face.normal()[k]);
    if (side < 0) above += winding;
    if (side == 0) here += winding;
  }
  return {above != 0, above + here != 0};
}

}  // namespace tetracone::covering

#endif
