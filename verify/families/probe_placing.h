#ifndef TETRACONE_VERIFY_FAMILIES_PROBE_PLACING_H
#define TETRACONE_VERIFY_FAMILIES_PROBE_PLACING_H

#include "verify/cases/exact_map.h"
#include "verify/cases/exact_motion.h"
#include "verify/families/probe_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

/// Points in, on and near a body, from which the families of points and rays are made. They are constructed in
/// rationals, and exact where doubles allow it. At most one argument of a call draws from `random`.
namespace tetracone::verify::probe_family {

using covering::Index;
using kernel::Rational;
using kernel::Vertex;
using object_family::exact;
using object_family::Exact_vector;

/// Returns an integer from `low` to `high`.
inline int integer(Random& random, int low, int high) { return low + int(one_of(random, std::size_t(high - low + 1))); }

/// Returns the vertex nearest to `v`; a coordinate beyond the doubles becomes the largest double.
inline Vertex nearest(const Exact_vector& v)
{
  Vertex rounded = object_family::rounded(v);
  for (double& x : rounded)
    if (!std::isfinite(x)) x = std::copysign(std::numeric_limits<double>::max(), x);
  return rounded;
}

/// Returns i / 2^bits, 0 < i < 2^bits; 1 <= bits <= 52.
inline double share(Random& random, int bits)
{
  return std::ldexp(1 + double(random.bits() % ((std::uint64_t(1) << bits) - 1)), -bits);
}

/// Returns a corner of a face and the two after it in its loop.
inline std::array<Vertex, 3> any_corners(Random& random, const Probed_body& of)
{
  const covering::Polyhedron& body = *of.body;
  const Index f = Index(one_of(random, body.face_count()));
  const covering::Loop loop = body.loop(f, one_of(random, body.loop_count(f)));
  const std::size_t at = one_of(random, loop.size());
  std::array<Vertex, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = body.vertices[loop[(at + k) % loop.size()]];
  return corners;
}

/// Returns a + s (b - a).
inline Exact_vector between(const Vertex& a, const Vertex& b, const Rational& s)
{
  return object_family::sum(exact(a), s, object_family::difference(exact(b), exact(a)));
}

/// Returns c0 + s (c1 - c0) + t (c2 - c0).
inline Exact_vector spanned(const std::array<Vertex, 3>& c, const Rational& s, const Rational& t)
{
  return object_family::sum(between(c[0], c[1], s), t, object_family::difference(exact(c[2]), exact(c[0])));
}

/// Returns a point of an edge at a parameter of `bits` bits, rounded.
inline Vertex on_edge(Random& random, const Probed_body& body, int bits)
{
  const auto corners = any_corners(random, body);
  return nearest(between(corners[0], corners[1], Rational(share(random, bits))));
}

/// A point spanned by three consecutive corners: inside a triangle or on its edge, and in the plane of any face.
inline Vertex on_face(Random& random, const Probed_body& body, int bits)
{
  const auto corners = any_corners(random, body);
  double s = share(random, bits), t = share(random, bits);
  if (s + t > 1) {
    s = 1 - s;
    t = 1 - t;
  }
  return nearest(spanned(corners, Rational(s), Rational(t)));
}

/// Returns a vertex for dimension 0, a point of an edge for 1, of a face for 2.
inline Vertex on_surface(Random& random, const Probed_body& body, int dimension)
{
  if (dimension == 0) return any_corners(random, body)[0];
  return dimension == 1 ? on_edge(random, body, 3) : on_face(random, body, 3);
}

/// Moves one coordinate or all, each `ulps` doubles up or down, but not beyond the largest double.
inline Vertex next_to(Random& random, Vertex p, int ulps)
{
  const std::size_t only = one_of(random, 4);
  for (std::size_t k = 0; k < 3; ++k) {
    const double to = std::copysign(std::numeric_limits<double>::max(), one_of(random, 2) == 0 ? 1.0 : -1.0);
    if (only < 3 && only != k) continue;
    for (int step = 0; step < ulps; ++step) p[k] = std::nextafter(p[k], to);
  }
  return p;
}

/// A point of the grid that divides each side of the body's box into `parts`; for 0, any in the box grown by a tenth.
inline Vertex anywhere(Random& random, const Probed_body& body, int parts)
{
  Vertex p;
  for (std::size_t k = 0; k < 3; ++k) {
    const double s = parts == 0 ? 1.2 * random.unit() - 0.1 : double(integer(random, 0, parts)) / parts;
    p[k] = body.low[k] * (1 - s) + body.high[k] * s;
    if (!std::isfinite(p[k])) p[k] = body.low[k];
  }
  return p;
}

/// A point with coordinates of vertices: on planes and lines of bodies that are parallel to the axes.
inline Vertex of_coordinates(Random& random, const Probed_body& body)
{
  Vertex p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = body.body->vertices[one_of(random, body.body->vertices.size())][k];
  return p;
}

}  // namespace tetracone::verify::probe_family

#endif
