#ifndef TETRACONE_TETRATREE_QUERY_POINT_ORDER_H
#define TETRACONE_TETRATREE_QUERY_POINT_ORDER_H

#include "tetracone/covering/polyhedron.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace tetracone::tetratree {

/// Returns the numbers of points, cell by cell of a grid about them. Most points that follow one another are near, so
/// that the memory that one has read serves the next. Requires finite coordinates, and 1 to 2^32 - 1 points.
inline std::vector<std::uint32_t> order_by_cells(std::span<const covering::Vertex> points)
{
  constexpr std::uint32_t along_edge = 16;  // more cells cost more than they gain
  covering::Vertex low, per_unit;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto half = [k](const covering::Vertex& x) { return x[k] / 2; };  // a difference does not overflow
    const auto [least, most] = std::ranges::minmax(points, {}, half);
    low[k] = half(least);
    const double extent = half(most) - low[k];
    per_unit[k] = extent > 0x1p-1000 ? (along_edge - 0.5) / extent : 0;
  }
  std::vector<std::uint32_t> cell_of, end(along_edge * along_edge * along_edge + 1), order(points.size());
  cell_of.reserve(points.size());
  for (const covering::Vertex& x : points) {
    std::uint32_t cell = 0;
    for (std::size_t k = 0; k < 3; ++k) cell = along_edge * cell + std::uint32_t((x[k] / 2 - low[k]) * per_unit[k]);
    cell_of.push_back(cell);
    ++end[cell + 1];
  }
  std::partial_sum(end.begin(), end.end(), end.begin());
  for (std::uint32_t k = 0; k < points.size(); ++k) order[end[cell_of[k]]++] = k;
  return order;
}

}  // namespace tetracone::tetratree

#endif
