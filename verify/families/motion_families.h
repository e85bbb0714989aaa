#ifndef TETRACONE_VERIFY_FAMILIES_MOTION_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_MOTION_FAMILIES_H

#include "tetracone/kernel/motion/moving_pair.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace tetracone::verify {

class Random;

/// Moving pairs of one kind of difficulty, both vertex-face and edge-edge.
struct Motion_family {
  std::string_view name, what;
  kernel::Moving_pair (*make)(Random& random, kernel::Moving_kind kind);
};

std::span<const Motion_family> motion_families();

/// Pair `index` of a family: even ones are vertex-face, odd ones edge-edge. The pair is equal on every machine.
kernel::Moving_pair motion_case(const Motion_family& family, std::uint64_t seed, std::uint64_t index);

}  // namespace tetracone::verify

#endif
