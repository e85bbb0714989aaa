#ifndef TETRACONE_TETRATREE_FAST_SURFACE_AREA_HEURISTIC_H
#define TETRACONE_TETRATREE_FAST_SURFACE_AREA_HEURISTIC_H

#include "tetracone/kernel/bound/oriented_box.h"

#include <cmath>
#include <limits>

namespace tetracone::tetratree {

/// The bounds of elements along three axes.
struct Axis_bounds {
  using Four = kernel::Four_floats;  // the fourth is 0

  Four low = kernel::four_times(std::numeric_limits<float>::infinity()), high = -low;

  void add(const Four& other_low, const Four& other_high)
  {
    low = kernel::smaller(low, other_low);
    high = kernel::larger(high, other_high);
  }
  void add(const Axis_bounds& other) { add(other.low, other.high); }

  /// Returns half the surface of the box. Requires an element.
  float half_surface() const
  {
    const Four e = high - low;
    return e[0] * e[1] + e[1] * e[2] + e[2] * e[0];
  }
};

/// Returns count^(1/2), the factor of a part's surface in the cost of a cut.
///
/// The surface area heuristic (SAH) charges a cut, for either side, the surface of its box times count^exponent. Rays
/// take the exponent 1. For pairs of boxes 1/2 is better: with 1, or with lengths in place of surfaces, trees had more
/// boxes to compare.
inline double sah_weight(int count) { return std::sqrt(double(count)); }

/// Returns half the SAH's cost of one side of a cut, which orders cuts alike; `weight` is the `sah_weight` of its
/// count.
template <class Number>
Number sah_cost(Number weight, const Axis_bounds& bounds)
{
  return weight * bounds.half_surface();
}

}  // namespace tetracone::tetratree

#endif
