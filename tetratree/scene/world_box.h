#ifndef TETRACONE_TETRATREE_SCENE_WORLD_BOX_H
#define TETRACONE_TETRATREE_SCENE_WORLD_BOX_H

#include "tetracone/kernel/number/floating_point.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tetracone::tetratree {

/// The least float that is not below x; infinity of what is undefined.
inline float rounded_above(double x)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  if (!(x < std::numeric_limits<float>::max())) return infinity;
  const float nearest = float(x);
  // Bits count up above 0, and down below; -0 is below nothing that it is nearest to. Without a branch, which no
  // processor could foretell.
  const auto bits = std::bit_cast<std::int32_t>(nearest);
  return std::bit_cast<float>(bits + int(double(nearest) < x) * (1 | bits >> 31));
}
inline float rounded_below(double x) { return -rounded_above(-x); }

/// A box with sides along the world's axes. What is bounded by one lies in it, so that bodies whose boxes share no point
/// are apart.
struct World_box {
  static constexpr float infinity = std::numeric_limits<float>::infinity();

  std::array<float, 3> low{-infinity, -infinity, -infinity}, high{infinity, infinity, infinity};

  bool meets(const World_box& other) const
  {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] && other.low[1] <= high[1] &&
           low[2] <= other.high[2] && other.low[2] <= high[2];
  }
  /// True when it is less than everything on every side.
  bool is_bounded() const
  {
    for (int k = 0; k < 3; ++k)
      if (low[k] == -infinity || high[k] == infinity) return false;
    return true;
  }

  /// Larger by `margin` >= 0 on every side, at least.
  World_box grown(double margin) const
  {
    World_box larger;
    for (int k = 0; k < 3; ++k) {
      larger.low[k] = rounded_below(double(low[k]) - margin);
      larger.high[k] = rounded_above(double(high[k]) + margin);
    }
    return larger;
  }

  /// The least about both.
  World_box joined(const World_box& other) const
  {
    World_box both;
    for (int k = 0; k < 3; ++k) {
      both.low[k] = kernel::minimum(low[k], other.low[k]);
      both.high[k] = kernel::maximum(high[k], other.high[k]);
    }
    return both;
  }

  /// At least the distance of any point of the one from any of the other.
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
