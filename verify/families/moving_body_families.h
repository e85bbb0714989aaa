#ifndef TETRACONE_VERIFY_FAMILIES_MOVING_BODY_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_MOVING_BODY_FAMILIES_H

#include "verify/cases/moving_bodies.h"
#include "verify/families/named_family.h"

#include <cstdint>
#include <vector>

namespace tetracone::verify {

class Random;

/// A family of two small bodies in motions of one kind of difficulty, without a parameter. Names begin with "motion".
struct Moving_body_family : Named_family {
  Moving_bodies (*make)(Random& random);
};

const std::vector<Moving_body_family>& moving_body_families();

/// Case `index` of a family.
Moving_bodies moving_bodies_case(const Moving_body_family& family, std::uint64_t seed, std::uint64_t index);

}  // namespace tetracone::verify

#endif
