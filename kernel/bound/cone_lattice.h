#ifndef TETRACONE_KERNEL_BOUND_CONE_LATTICE_H
#define TETRACONE_KERNEL_BOUND_CONE_LATTICE_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace tetracone::kernel {

/// A direction from the origin of a tetra-tree: an integer point of the octahedron |x| + |y| + |z| = lattice_size.
/// A cone of depth 1 is a face of the octahedron. So cones of depth `max_cone_depth` need its edges halved
/// `max_cone_depth` - 1 times, which gives integer points.
using Direction = std::array<std::int32_t, 3>;
inline constexpr int max_cone_depth = 12;
inline constexpr std::int32_t lattice_size = 1 << max_cone_depth;

/// Points of a model's space that stand for directions: direction d is through origin + step * d, which a double holds
/// exactly.
///
/// The origin is the centroid of the vertices, rounded to a multiple of step = 2^k. Let e be the extent and s the
/// largest coordinate of the model. Then step >= 2^-18 e and step >= 2^-51 s. Since |origin| <= s and the lattice has a
/// radius of 2^12 steps, every sum is a multiple of step below 2^53 steps. (Any origin serves: JS08's definitions of
/// the covering ask for none.)
struct Cone_lattice {
  Vertex origin{0, 0, 0};
  double step = 1;

  Vertex point(const Direction& direction) const
  {
    return {origin[0] + step * direction[0], origin[1] + step * direction[1], origin[2] + step * direction[2]};
  }
};

/// Returns the lattice for a model of these vertices; the default one where there are none.
inline Cone_lattice cone_lattice(std::span<const Vertex> vertices)
{
  if (vertices.empty()) return {};
  Vertex low = vertices[0], high = vertices[0], mean{0, 0, 0};
  double largest = 0;
  for (const Vertex& v : vertices) {
    for (int k = 0; k < 3; ++k) {
      low[k] = minimum(low[k], v[k]);
      high[k] = maximum(high[k], v[k]);
      mean[k] +=
          v[k] / static_cast<double>(vertices.size());  // divided first: a sum of huge coordinates must not overflow
      largest = maximum(largest, std::abs(v[k]));
    }
  }
  // Exponents, not values: the extent of a huge model overflows.
  const auto exponent = [](double x) { return x == 0 ? -1074 : std::ilogb(x) + 1; };
  int extent = -1074;
  for (int k = 0; k < 3; ++k) extent = maximum(extent, exponent(high[k] / 2 - low[k] / 2) + 1);
  const int step = maximum(extent - 18, exponent(largest) - 51, -1074);

  Cone_lattice lattice;
  lattice.step = std::ldexp(1.0, step);
  for (int k = 0; k < 3; ++k) {
    const double inside = std::clamp(mean[k], low[k], high[k]);
    const double steps = std::nearbyint(std::ldexp(inside, -step));  // below 2^52: exact
    lattice.origin[k] = std::ldexp(steps, step);
    // A cone beyond the largest double has no rays: move the origin of such a model inwards.
    constexpr double room = 0x1p1023;
    lattice.origin[k] = std::clamp(lattice.origin[k], -room, room);
  }
  return lattice;
}

}  // namespace tetracone::kernel

#endif
