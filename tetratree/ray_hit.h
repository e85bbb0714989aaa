#ifndef TETRACONE_TETRATREE_RAY_HIT_H
#define TETRACONE_TETRATREE_RAY_HIT_H

#include "tetracone/covering/polyhedron.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace tetracone::tetratree {

/// The points origin + t direction, t >= 0. Each number is taken exactly; the direction may have any length but 0.
struct Ray {
  std::array<double, 3> origin;     ///< where t = 0
  std::array<double, 3> direction;  ///< what t counts
};

/// Where a ray meets a face first.
struct Ray_hit {
  covering::Index face;  ///< the face's number
  double t;              ///< the double nearest to the exact t; infinite where that is beyond the largest double
  /// Equal in both.
  bool operator==(const Ray_hit&) const = default;
};

/// How a ray goes through a face, by the face's normal.
enum class Crossing : std::uint8_t {
  entering,  ///< against the normal
  leaving,   ///< along it
  along      ///< in the face's plane, or through a face without a normal
};

/// Returns the enumerator's own name.
constexpr std::string_view to_string(Crossing crossing)
{
  return crossing == Crossing::entering ? "entering" : crossing == Crossing::leaving ? "leaving" : "along";
}

}  // namespace tetracone::tetratree

#endif
