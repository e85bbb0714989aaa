#ifndef TETRACONE_VERIFY_FAMILIES_MOVING_BODY_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_MOVING_BODY_FAMILIES_H

#include "verify/cases/moving_bodies.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace tetracone::verify {

class Random;

/// Two small bodies in motions of one kind of difficulty.
struct Moving_body_family {
  int number;             ///< from 1
  std::string_view name;  ///< of lower-case words joined by '-'; the first is motion
  std::string_view what;
  Moving_bodies (*make)(Random& random);
};

std::span<const Moving_body_family> moving_body_families();

/// Returns the family of this name; null when there is none.
const Moving_body_family* find_moving_body_family(std::string_view name);

/// Case `index` of a family. The case is equal on every machine.
Moving_bodies moving_bodies_case(const Moving_body_family& family, std::uint64_t seed, std::uint64_t index);

}  // namespace tetracone::verify

#endif
