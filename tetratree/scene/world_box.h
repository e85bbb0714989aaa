#ifndef TETRACONE_TETRATREE_SCENE_WORLD_BOX_H
#define TETRACONE_TETRATREE_SCENE_WORLD_BOX_H

#include "tetracone/kernel/number/floating_point.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tetracone::tetratree {

/// Returns the least float that is not below x, for magnitudes below the largest float; infinity for NaN and above.
inline float rounded_above(double x)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  if (!(x < std::numeric_limits<float>::max())) return infinity;
  const float nearest = kernel::to_float(x);
  // Above 0 the next float has the next larger bits, below 0 the next smaller ones. The nearest float is never -0 and
  // below x. This has no branch, since no processor could predict it.
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  return std::bit_cast<float>(bits + int(double(nearest) < x) * (1 | bits >> 31));
}
/// Returns the greatest float that is not above x, for magnitudes below the largest float; -infinity for NaN and below.
inline float rounded_below(double x) { return -rounded_above(-x); }

/// A closed box with sides along the world's axes. A body lies in its box, so bodies whose boxes share no point are
/// apart.
struct World_box {
  static constexpr float infinity = std::numeric_limits<float>::infinity();

  std::array<float, 3> low{-infinity, -infinity, -infinity}, high{infinity, infinity, infinity};

  bool meets(const World_box& other) const
  {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] && other.low[1] <= high[1] &&
           low[2] <= other.high[2] && other.low[2] <= high[2];
  }
  /// True when every side is finite.
  bool is_bounded() const
  {
    for (int k = 0; k < 3; ++k)
      if (low[k] == -infinity || high[k] == infinity) return false;
    return true;
  }

  /// Returns a box about this one, larger by `margin` on every side up to a rounding in double. Requires margin >= 0.
  World_box grown(double margin) const
  {
    World_box larger;
    for (int k = 0; k < 3; ++k) {
      larger.low[k] = rounded_below(double(low[k]) - margin);
      larger.high[k] = rounded_above(double(high[k]) + margin);
    }
    return larger;
  }

  /// Returns a box that holds all points at most `distance` from this one, whatever is rounded.
  World_box reached(double distance) const
  {
    double largest = distance;
    for (int k = 0; k < 3; ++k) largest = kernel::maximum(largest, double(-low[k]), double(high[k]));
    for (int k = 0; k < 3; ++k) largest = kernel::maximum(largest, double(low[k]), double(-high[k]));
    return grown(distance + 0x1p-50 * largest);
  }

  /// Returns the least box about both.
  World_box joined(const World_box& other) const
  {
    World_box both;
    for (int k = 0; k < 3; ++k) {
      both.low[k] = kernel::minimum(low[k], other.low[k]);
      both.high[k] = kernel::maximum(high[k], other.high[k]);
    }
    return both;
  }

  /// Returns an upper bound of the distance between any point of this box and any point of the other.
  double farthest(const World_box& other) const
  {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double up = double(high[k]) - double(other.low[k]), down = double(other.high[k]) - double(low[k]);
      sum += std::abs(up) > std::abs(down) ? std::abs(up) : std::abs(down);
    }
    return sum * (1 + 0x1p-50);
  }

  friend bool operator==(const World_box&, const World_box&) = default;
};

}  // namespace tetracone::tetratree

#endif
