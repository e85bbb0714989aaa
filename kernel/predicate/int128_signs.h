#ifndef TETRACONE_KERNEL_PREDICATE_INT128_SIGNS_H
#define TETRACONE_KERNEL_PREDICATE_INT128_SIGNS_H

#include "tetracone/kernel/number/fixed_integer.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"

#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

/// Exact signs, by integers of 128 bits, of points on a common grid of 2^38 steps in each direction. Models made by
/// hand or by CAD mostly lie on one, and so do most points that touch exactly.
namespace tetracone::kernel {

/// Returns the coordinates as whole multiples, below 2^38, of a common power of two. Returns nothing where there is no
/// such power, and where the largest magnitude is not within 2^-300 and 2^300.
template <std::size_t count>
std::optional<std::array<std::array<std::int64_t, 3>, count>> on_grid(const std::array<const Vertex*, count>& points)
{
  double largest = 0;
  for (const Vertex* p : points) largest = maximum(largest, std::abs((*p)[0]), std::abs((*p)[1]), std::abs((*p)[2]));
  if (!(largest >= 0x1p-300 && largest <= 0x1p300)) return std::nullopt;
  const double per_step = std::ldexp(1.0, 37 - std::ilogb(largest));
  std::array<std::array<std::int64_t, 3>, count> grid;
  for (std::size_t n = 0; n < count; ++n)
    for (int k = 0; k < 3; ++k) {
      const double x = (*points[n])[k], steps = x * per_step;
      if (!(std::abs(steps) < 0x1p38)) return std::nullopt;  // undefined
      grid[n][k] = std::int64_t(steps);
      // A product that underflows is no whole number, or 0.
      if (double(grid[n][k]) != steps || (steps == 0 && x != 0)) return std::nullopt;
    }
  return grid;
}

/// Returns the sign of det[b-a, c-a, d-a], or nothing where the points are on no such grid. Differences are below 2^39.
/// So their 2x2 minors are below 2^79, and the sum of three products below 2^120.
inline std::optional<CGAL::Sign> int128_volume_sign(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d)
{
  const auto grid = on_grid<4>({&a, &b, &c, &d});
  if (!grid) return std::nullopt;
  const auto& [p, q, r, s] = *grid;
  const Int128 bx = q[0] - p[0], by = q[1] - p[1], bz = q[2] - p[2], cx = r[0] - p[0], cy = r[1] - p[1],
               cz = r[2] - p[2];
  const Int128 dx = s[0] - p[0], dy = s[1] - p[1], dz = s[2] - p[2];
  const Int128 determinant = (by * cz - bz * cy) * dx + (bz * cx - bx * cz) * dy + (bx * cy - by * cx) * dz;
  return determinant > 0 ? CGAL::POSITIVE : determinant < 0 ? CGAL::NEGATIVE : CGAL::ZERO;
}

/// Returns the sign of component `axis` of (b-a) x (c-a), or nothing where the points are on no such grid.
inline std::optional<CGAL::Sign> int128_normal_sign(const Vertex& a, const Vertex& b, const Vertex& c, int axis)
{
  const auto grid = on_grid<3>({&a, &b, &c});
  if (!grid) return std::nullopt;
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto& [p, q, r] = *grid;
  const Int128 component = Int128(q[i] - p[i]) * (r[j] - p[j]) - Int128(q[j] - p[j]) * (r[i] - p[i]);
  return component > 0 ? CGAL::POSITIVE : component < 0 ? CGAL::NEGATIVE : CGAL::ZERO;
}

}  // namespace tetracone::kernel

#endif
