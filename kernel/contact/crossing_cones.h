#ifndef TETRACONE_KERNEL_CONTACT_CROSSING_CONES_H
#define TETRACONE_KERNEL_CONTACT_CROSSING_CONES_H

#include "tetracone/kernel/contact/cone_sums.h"
#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/contact/rational_face.h"

#include <array>
#include <utility>
#include <vector>

namespace tetracone::kernel {

using Integer_point = std::array<mpz_class, 3>;  ///< also a vector

/// A triangle in integers, a scale times its coordinates. `outward` is 1 where its corners are anticlockwise as seen
/// from outside its solid, else -1.
struct Integer_triangle {
  std::array<Integer_point, 3> corner;
  int outward;

  /// Returns a normal towards the outside.
  Integer_point normal() const
  {
    Integer_point n = detail::product(detail::step(corner[0], corner[1]), detail::step(corner[0], corner[2]));
    for (mpz_class& x : n) x *= outward;
    return n;
  }
};

/// The point where an edge goes through the inside of a triangle: `top / bottom`.
struct Integer_crossing {
  Integer_point top;
  mpz_class bottom;  ///< positive
  Rational share;    ///< of the edge that lies before the point
  bool enters;       ///< whether the edge enters the triangle's solid there

  /// Requires an edge whose ends are on different sides of the triangle's plane.
  Integer_crossing(const Integer_point& from, const Integer_point& to, const Integer_triangle& triangle)
  {
    const Integer_point n = triangle.normal(), whole = detail::step(from, to);
    mpz_class part = detail::inner(n, detail::step(from, triangle.corner[0]));
    bottom = detail::inner(n, whole);
    enters = bottom < 0;
    if (enters) {
      bottom = -bottom;
      part = -part;
    }
    for (int k = 0; k < 3; ++k) top[k] = from[k] * bottom + part * whole[k];
    share = Rational(part, bottom);
    share.canonicalize();
  }
};

/// The cones over the common parts of the faces of two solids, of which each contact is a proper crossing: the volume
/// of the overlap, less the cones over faces that no other face meets.
///
/// Face f has the corners p, q, r. The part of f in the other solid is bounded by contacts and by parts of f's edges.
/// Its cone is the sum over these of the cones over the triangles (p, x, y), of which those on the edges at p are 0. So
/// the edge qr and the contacts suffice. At a contact of f and g both parts have the border xy, in opposite directions.
class Crossing_cones {
 public:
  /// Adds the part of the edge qr that is in the other solid, between its crossings. `ends_inside` tells of r.
  void add_edge(const Integer_triangle& face, const std::vector<Rational>& entering,
                const std::vector<Rational>& leaving, bool ends_inside)
  {
    Rational length = ends_inside, squares = ends_inside;
    for (const Rational& t : entering) {
      length -= t;
      squares -= t * t;
    }
    for (const Rational& t : leaving) {
      length += t;
      squares += t * t;
    }
    if (length == 0) return;
    const auto& [p, q, r] = face.corner;
    const Rational volume = face.outward * detail::inner(p, detail::product(q, r));
    volume_.add(volume * length);
    for (int k = 0; k < 3; ++k)
      moment_[k].add(volume * (length * Rational(p[k] + 2 * q[k]) + squares * Rational(r[k] - q[k])));
  }

  /// Adds the contact of a face of each body between two crossings.
  void add_contact(const Integer_triangle& f, const Integer_triangle& g, const Integer_crossing& x,
                   const Integer_crossing& y)
  {
    // As seen from outside f, the other solid is on the left of the product of both outward normals.
    Integer_point along;
    for (int k = 0; k < 3; ++k) along[k] = y.top[k] * x.bottom - x.top[k] * y.bottom;
    const int way = sgn(detail::inner(detail::product(f.normal(), g.normal()), along));
    const Integer_point xy = detail::product(x.top, y.top);
    const mpz_class of_f = way * detail::inner(f.corner[0], xy), of_g = way * detail::inner(g.corner[0], xy),
                    bottom = x.bottom * y.bottom;
    volume_.add(fraction(of_f - of_g, bottom));
    for (int k = 0; k < 3; ++k) {
      const mpz_class ends = x.top[k] * y.bottom + y.top[k] * x.bottom;
      moment_[k].add(
          fraction(of_f * (f.corner[0][k] * bottom + ends) - of_g * (g.corner[0][k] * bottom + ends), bottom * bottom));
    }
  }

  /// Returns the sums for coordinates without the scale.
  Volume_moment value(const mpz_class& scale) const
  {
    const mpz_class cube = scale * scale * scale;
    Volume_moment sums{Rational(volume_.value() / (6 * cube))};
    for (int k = 0; k < 3; ++k) sums.moment[k] = moment_[k].value() / Rational(24 * cube * scale);
    return sums;
  }

 private:
  static Rational fraction(const mpz_class& top, const mpz_class& bottom)
  {
    Rational fraction(top, bottom);
    fraction.canonicalize();
    return fraction;
  }

  Rational_sum volume_;                 // times 6
  std::array<Rational_sum, 3> moment_;  // times 24
};

}  // namespace tetracone::kernel

#endif
