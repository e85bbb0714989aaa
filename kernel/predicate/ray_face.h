#ifndef TETRACONE_KERNEL_PREDICATE_RAY_FACE_H
#define TETRACONE_KERNEL_PREDICATE_RAY_FACE_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/kernel/predicate/segment_face.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::kernel {

using Rational_vector = std::array<Rational, 3>;

/// A ray o + t d, t >= 0, in rationals.
struct Rational_ray {
  Rational_vector origin, direction;
};

namespace detail {

inline Rational_vector coordinates(const Point<Rational_kernel>& p) { return {p.x(), p.y(), p.z()}; }

/// Returns the least t >= 0 at which the ray meets the closed segment ab, which may be a point; nothing elsewhere.
inline std::optional<Rational> ray_segment(const Rational_ray& ray, const Rational_vector& a, const Rational_vector& b)
{
  const Rational_vector along = difference(b, a), to_a = difference(a, ray.origin), &d = ray.direction;
  const Rational_vector normal = cross(d, along);
  if (is_zero(normal)) {
    if (!is_zero(cross(to_a, d))) return std::nullopt;
    const Rational length = dot(d, d), at_a = dot(to_a, d) / length, at_b = at_a + dot(along, d) / length;
    const Rational &first = at_a < at_b ? at_a : at_b, &last = at_a < at_b ? at_b : at_a;
    if (last < 0) return std::nullopt;
    return first < 0 ? Rational(0) : first;
  }
  if (dot(to_a, normal) != 0) return std::nullopt;
  const int axis = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  const Rational t = cross(to_a, along)[axis] / normal[axis], s = cross(to_a, d)[axis] / normal[axis];
  if (t < 0 || s < 0 || s > 1) return std::nullopt;
  return t;
}

}  // namespace detail

using Integer_vector = std::array<mpz_class, 3>;

/// A planar face in integers. All points are relative to a ray's origin. Edge k goes from `from[k]` to `to[k]`.
struct Integer_face {
  std::vector<Integer_vector> from, to;
  std::array<Integer_vector, 3> basis;  ///< three points that are not on one line
};

namespace detail {

using Integer_pair = std::array<mpz_class, 2>;

/// Returns the sign of a cross b.
inline int turn(const Integer_pair& a, const Integer_pair& b) { return cmp(a[0] * b[1], a[1] * b[0]); }

/// Calls what(a, b) for the ends of each edge of a face, as seen from somewhere, while it returns true.
template <class Seen, class What>
void for_seen_edges(const Integer_face& face, const Seen& seen, const What& what)
{
  Integer_pair a, b;
  for (std::size_t k = 0; k < face.from.size(); ++k) {
    a = k > 0 && face.to[k - 1] == face.from[k] ? b : seen(face.from[k]);
    b = seen(face.to[k]);
    if (!what(a, b)) return;
  }
}

/// True when 0 is seen on an edge of a face, or has a winding number other than 0.
template <class Seen>
bool holds_zero(const Integer_face& face, const Seen& seen)
{
  int winding = 0;
  bool is_on_edge = false;
  for_seen_edges(face, seen, [&](const Integer_pair& a, const Integer_pair& b) {
    const int side = turn(a, b);
    is_on_edge = side == 0 && sgn(a[0]) * sgn(b[0]) <= 0 && sgn(a[1]) * sgn(b[1]) <= 0;
    if (a[1] <= 0 && b[1] > 0 && side > 0) ++winding;
    if (a[1] > 0 && b[1] <= 0 && side < 0) --winding;
    return !is_on_edge;
  });
  return is_on_edge || winding != 0;
}

}  // namespace detail

/// Returns the least t >= 0 at which the ray t d meets the closed face; nothing where it does not. Requires d != 0.
inline std::optional<Rational> ray_face(const Integer_vector& d, const Integer_face& face)
{
  using detail::Integer_pair, detail::turn;
  const auto fraction = [](const mpz_class& n, const mpz_class& m) {
    Rational t(n, m);
    t.canonicalize();
    return t;
  };
  const Integer_vector normal = normal_of(face.basis);
  const mpz_class ascent = dot(normal, d), height = dot(normal, face.basis[0]);
  if (ascent != 0) {
    if (sgn(height) * sgn(ascent) < 0) return std::nullopt;
    // Seen along d, the ray's line is a point. Two coordinates of x cross d tell the third.
    const int axis = largest_axis(d), i = (axis + 1) % 3, j = (axis + 2) % 3;
    const auto seen = [&](const Integer_vector& x) {
      return Integer_pair{x[j] * d[axis] - x[axis] * d[j], x[axis] * d[i] - x[i] * d[axis]};
    };
    return detail::holds_zero(face, seen) ? std::optional(fraction(height, ascent)) : std::nullopt;
  }
  if (height != 0) return std::nullopt;
  const int axis = largest_axis(normal), i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto seen = [&](const Integer_vector& x) { return Integer_pair{x[i], x[j]}; };
  if (detail::holds_zero(face, seen)) return Rational(0);
  // The ray begins outside the face, in its plane: it comes in over an edge.
  const Integer_pair along = seen(d);
  std::optional<Rational> least;
  const auto try_t = [&](const mpz_class& n, const mpz_class& m) {
    if (const Rational t = fraction(n, m); sgn(t) >= 0 && (!least || t < *least)) least = t;
  };
  const auto times_along = [&](const Integer_pair& x) { return mpz_class(x[0] * along[0] + x[1] * along[1]); };
  detail::for_seen_edges(face, seen, [&](const Integer_pair& a, const Integer_pair& b) {
    const int at_a = turn(along, a), at_b = turn(along, b);
    if (at_a == 0 && at_b == 0) {
      for (const Integer_pair* end : {&a, &b}) try_t(times_along(*end), times_along(along));
    } else if (at_a * at_b <= 0) {
      const Integer_pair edge = {b[0] - a[0], b[1] - a[1]};
      try_t(a[0] * edge[1] - a[1] * edge[0], along[0] * edge[1] - along[1] * edge[0]);
    }
    return true;
  });
  return least;
}

/// Returns the least t >= 0 at which the ray meets the closed planar face; nothing where it does not. The face has the
/// points that `segment_face` takes. It may be a segment or a point, and the ray may lie in its plane. Requires d != 0.
template <Covered_face<Rational_kernel> Face>
std::optional<Rational> ray_face(const Rational_ray& ray, const Face& face)
{
  using detail::coordinates;
  const auto is_on_face = [&](const Rational_vector& x) {
    const Point<Rational_kernel> p(x[0], x[1], x[2]);
    return segment_face<Rational_kernel>(p, p, face) != Contact::none;
  };
  if (!face.is_degenerate()) {
    const Rational_vector a = coordinates(face.plane_basis(0));
    const Rational_vector normal =
        normal_of(std::array{a, coordinates(face.plane_basis(1)), coordinates(face.plane_basis(2))});
    const Rational ascent = dot(normal, ray.direction), height = dot(normal, difference(a, ray.origin));
    if (ascent != 0) {
      const Rational t = height / ascent;
      if (t < 0) return std::nullopt;
      return is_on_face(sum(ray.origin, scaled(ray.direction, t))) ? std::optional(t) : std::nullopt;
    }
    if (height != 0) return std::nullopt;
    if (is_on_face(ray.origin)) return Rational(0);
  }
  // The ray begins outside the face, in its plane: it comes in over an edge.
  std::optional<Rational> least;
  for (std::size_t k = 0; k < face.edge_count(); ++k) {
    const auto t = detail::ray_segment(ray, coordinates(face.from(k)), coordinates(face.to(k)));
    if (t && (!least || *t < *least)) least = t;
  }
  return least;
}

}  // namespace tetracone::kernel

#endif
