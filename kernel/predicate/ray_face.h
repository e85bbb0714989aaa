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

/// Returns what `ray_face` returns of a triangle; nothing unless the ray's line crosses its plane in one point.
///
/// Let A, B, C be the corners less o. The line passes edge AB on the side that the sign of det[d, A, B] tells, and so
/// for the others. The sum of these determinants is n . d, with n = (B - A) x (C - A).
inline std::optional<std::optional<Rational>> ray_crossing(const Rational_ray& ray,
                                                           const std::array<Rational_vector, 3>& corner)
{
  std::array<Rational_vector, 3> from;
  for (std::size_t k = 0; k < 3; ++k) from[k] = difference(corner[k], ray.origin);
  const Rational ab = determinant(ray.direction, from[0], from[1]), bc = determinant(ray.direction, from[1], from[2]),
                 ca = determinant(ray.direction, from[2], from[0]), ascent = ab + bc + ca;
  if (ascent == 0) return std::nullopt;
  for (const Rational& side : {ab, bc, ca})
    if (sgn(side) * sgn(ascent) < 0) return std::optional<Rational>();
  Rational t = determinant(from[0], from[1], from[2]) / ascent;
  return t < 0 ? std::optional<Rational>() : std::optional(std::move(t));
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
