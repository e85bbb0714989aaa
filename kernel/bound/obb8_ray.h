#ifndef TETRACONE_KERNEL_BOUND_OBB8_RAY_H
#define TETRACONE_KERNEL_BOUND_OBB8_RAY_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/simd/simd.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace tetracone::kernel {

/// A ray in a body's local units, for boxes: o + s d, with d of length 1, starting where it may first meet the body.
///
/// `error` covers these terms. A coordinate of the origin, within `farthest`, is a difference rounded once. The
/// direction has an error of 4 u, by the root of its square and a quotient. The origin is moved along it by at most
/// sqrt(3) times `farthest`, with two more roundings.
struct Local_ray {
  std::array<double, 3> origin, direction;
  double skipped;                                ///< the length from the ray's own origin to `origin`
  static constexpr double length = 4;            ///< upper bound of the s at which the ray meets the body
  static constexpr double farthest = 0x1p29;     ///< upper bound of the coordinates of the ray's own origin
  static constexpr double error = 0x1p-20;       ///< upper bound of the error of a coordinate
                                                 ///< (verify/proofs/obb8_ray_proofs.h)
  static constexpr float slack = 0x1p-16f;       ///< upper bound of the errors of `ray_lanes`, the same file
  static constexpr float least_step = 0x1p-30f;  ///< a smaller step along an axis is replaced by it: see `ray_lanes`

  /// Returns the local ray of a ray in the model's units; nothing where it does not come near the body. Requires
  /// `may_be_local`, and a d whose components are at most 2, one of them at least 1.
  static std::optional<Local_ray> of(const Local_scale& scale, const Vertex& origin, const Vertex& direction)
  {
    Local_ray ray{{}, direction, 0};
    const double norm = std::sqrt(dot(direction, direction));
    for (int k = 0; k < 3; ++k) {
      ray.direction[k] /= norm;
      ray.origin[k] = (0.5 * origin[k] - 0.5 * scale.origin[k]) * (2 / scale.unit);
    }
    const double square = dot(ray.origin, ray.origin);
    if (square <= 4) return ray;
    // The body is within sqrt(3) of the local origin.
    ray.skipped = -dot(ray.origin, ray.direction) - 2;
    if (ray.skipped <= -2) return std::nullopt;
    for (int k = 0; k < 3; ++k) ray.origin[k] = farther(ray.origin[k], ray.skipped, ray.direction[k]);
    if (dot(ray.origin, ray.origin) > 8) return std::nullopt;
    return ray;
  }

  /// Returns a coordinate moved along the direction.
  template <class Number>
  static Number farther(const Number& at, const Number& way, const Number& direction)
  {
    return at + way * direction;
  }

  /// True when `error` holds: the body is in range, and the ray's own origin is within `farthest`.
  static bool may_be_local(const Local_scale& scale, const Vertex& origin)
  {
    if (!scale.is_in_range()) return false;
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(0.5 * origin[k] - 0.5 * scale.origin[k]) * (2 / scale.unit) <= farthest)) return false;
    return true;
  }
};

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/obb8_ray_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// For each lane, a lower bound of the s at which a ray comes in.
using Lane_entries = std::array<float, lanes>;

/// Returns the lanes, as bits, whose boxes the ray may meet before s = `limit` at a point x of |x_k| <= 1. `nearest`
/// becomes, in each lane, a lower bound of the s of any such point. Requires boxes of parts of a body in its local
/// units. That means |a_i . (c - l)| + e_i <= sqrt(3), where l is the local origin, and their own origin within 1 in
/// each coordinate.
///
/// By the axes' defect d, |a_i . (x - c)| <= e_i + d (e_0 + e_1 + e_2) for a point in the box, at most 3 sqrt(3) d more
/// than e_i. The error of the ray's point o + s d is Local_ray::error in a coordinate, and sqrt(3) times that along an
/// axis. In float, the error of at = a_i . (o - c) is a fraction of the vectors' lengths, which are at most sqrt(8) +
/// sqrt(3) and 3 + sqrt(3). The error of s times the step along the axis is a fraction of Local_ray::length. A step
/// below `least_step` is replaced by it, which moves the point along the axis by at most 2 `length` times it. Then the
/// error of the entry into the slab, times the step, is a fraction of |at| <= sqrt(8) + 3 and of the extent. The sum of
/// all is below `slack` (verify/proofs/obb8_ray_proofs.h).
inline unsigned ray_lanes(const Obb8& boxes, const Local_ray& ray, double limit, Lane_entries& nearest)
{
  static auto* const fastest = TETRACONE_SIMD_FASTEST(ray_lanes_simd);
  return fastest(boxes, ray, limit, nearest.data());
}

}  // namespace tetracone::kernel

#endif
