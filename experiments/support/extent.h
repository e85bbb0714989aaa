#ifndef TETRACONE_EXPERIMENTS_SUPPORT_EXTENT_H
#define TETRACONE_EXPERIMENTS_SUPPORT_EXTENT_H

#include "tetracone/covering/polyhedron.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tetracone::experiments {

/// The least and the greatest coordinate of a body along each axis.
struct Extent {
  kernel::Vertex low, high;

  double longest_side() const { return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
};

/// Returns the extent of all vertices, whether faces use them or not. Requires a vertex.
inline Extent extent_of(const covering::Polyhedron& body)
{
  Extent extent;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::ranges::minmax(body.vertices, {}, [k](const kernel::Vertex& v) { return v[k]; });
    extent.low[k] = low[k];
    extent.high[k] = high[k];
  }
  return extent;
}

}  // namespace tetracone::experiments

#endif
