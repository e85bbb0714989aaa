#ifndef TETRACONE_KERNEL_PREDICATE_PLANE_BASIS_H
#define TETRACONE_KERNEL_PREDICATE_PLANE_BASIS_H

#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "tetracone/kernel/predicate/signs.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace tetracone::kernel {

/// Returns the numbers of three corners that are not collinear, which is decided exactly; nothing when all are on one
/// line. The triangle is a large one where double can tell, so that kernels that round keep its plane. It has the
/// corner farthest from the first, and the corner that spans the largest area with both. `vertex_of(k)` returns corner
/// k. Requires a corner.
template <class Vertex_of>
std::optional<std::array<std::size_t, 3>> plane_basis(std::size_t corner_count, const Vertex_of& vertex_of)
{
  const auto way = [&](std::size_t i, std::size_t j) {
    const Vertex &a = vertex_of(i), &b = vertex_of(j);
    return difference(b, a);
  };
  const auto length = [](const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); };
  const auto spans = [&](std::size_t i, std::size_t j, std::size_t k) {
    return projection_axis<Adaptive>(Adaptive::unmoved(vertex_of(i)), Adaptive::unmoved(vertex_of(j)),
                                     Adaptive::unmoved(vertex_of(k))) >= 0;
  };

  if (corner_count == 3) return spans(0, 1, 2) ? std::optional(std::array<std::size_t, 3>{0, 1, 2}) : std::nullopt;

  std::size_t farthest = 0, widest = 0;
  double distance = 0, area = 0;
  for (std::size_t k = 1; k < corner_count; ++k) {
    if (const double d = length(way(0, k)); d > distance) {
      distance = d;
      farthest = k;
    }
  }
  const auto base = way(0, farthest);
  for (std::size_t k = 1; k < corner_count; ++k) {
    if (const double a = length(cross(base, way(0, k))); a > area) {
      area = a;
      widest = k;
    }
  }
  if (spans(0, farthest, widest)) return std::array<std::size_t, 3>{0, farthest, widest};

  // The face is too thin, too small or too large for double. Any corner off the first one serves, then any corner off
  // their line.
  for (std::size_t j = 1; j < corner_count; ++j) {
    if (vertex_of(j) == vertex_of(0)) continue;
    for (std::size_t k = j + 1; k < corner_count; ++k)
      if (spans(0, j, k)) return std::array<std::size_t, 3>{0, j, k};
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace tetracone::kernel

#endif
