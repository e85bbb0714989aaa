#ifndef TETRACONE_KERNEL_BOUND_OBB8_RAY_H
#define TETRACONE_KERNEL_BOUND_OBB8_RAY_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/simd/simd.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace tetracone::kernel {

/// A ray as boxes see it: o + s d in local units, d of length 1, from where it may first meet the body on.
///
/// Its error: the origin is rounded by 2^-53 of at most 2^30 and the direction by 2^-51 over as far, so that a point of
/// the ray is off by less than 2^-19 where the body is.
struct Local_ray {
  std::array<double, 3> origin, direction;
  double skipped;                      ///< length, from the ray's own origin to `origin`
  static constexpr double length = 4;  ///< so far the ray may meet the body
  static constexpr double error = 0x1p-19;
  static constexpr float slack = 0x1p-15f;  ///< see `ray_lanes`

  /// Of a ray in the model's units; nothing where it does not come near the body. Requires d of components of at most
  /// 2, one of them at least 1, and `may_be_local`.
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
    if (!(ray.skipped > -2)) return std::nullopt;
    for (int k = 0; k < 3; ++k) ray.origin[k] += ray.skipped * ray.direction[k];
    if (dot(ray.origin, ray.origin) > 8) return std::nullopt;
    return ray;
  }

  /// Whether the bounds on errors hold.
  static bool may_be_local(const Local_scale& scale, const Vertex& origin)
  {
    if (!scale.is_in_range()) return false;
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(0.5 * origin[k] - 0.5 * scale.origin[k]) * (2 / scale.unit) <= 0x1p29)) return false;
    return true;
  }

 private:
  static double dot(const std::array<double, 3>& a, const std::array<double, 3>& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
};

}  // namespace tetracone::kernel

#define TETRACONE_SIMD_FILE "tetracone/kernel/bound/obb8_ray_simd.inl"
#include "tetracone/kernel/simd/simd_rounds.h"

namespace tetracone::kernel {

/// For each lane, where a ray may come in.
using Lane_entries = std::array<float, lanes>;

/// The lanes, as bits, that the ray may meet before s = `limit`; `nearest` becomes the s, in each lane, that is at most
/// that of any of its points in the box.
///
/// A point x of the exact ray in a box has |a_i . (x - c)| <= e_i + 3 d (1 + 4 d) |x - c|_1, d the axes' defect of
/// 2^-21 and |x - c|_1 <= 6; against o + s d it is off by Local_ray::error in a coordinate, twice that along an axis. In
/// float, a_i . (o - c) sums three products of at most 6 |a_ik|, rounded five times at most, by 2^-18, and s a_i . d is
/// off by 2^-19. The quotients, by four roundings, move along the axis by 4 u (e_i + |a_i . (o - c)|), below 2^-18; and
/// where the ray is nearly across an axis, its step along it is set to 2^-30, which over a length of 4 is as little. So
/// all is below `slack`.
inline unsigned ray_lanes(const Obb8& boxes, const Local_ray& ray, double limit, Lane_entries& nearest)
{
  using Function = unsigned(const Obb8&, const float*, const float*, float, float*);
  static Function* const fastest = fastest_version<Function>(TETRACONE_SIMD_VERSIONS(ray_lanes_simd));
  float from[3], direction[3];
  for (int k = 0; k < 3; ++k) {
    from[k] = float(ray.origin[k] - double(boxes.origin[k]));
    direction[k] = float(ray.direction[k]);
  }
  return fastest(boxes, from, direction, float(limit), nearest.data());
}

}  // namespace tetracone::kernel

#endif
