#ifndef TETRACONE_VERIFY_RELATIONS_MOVING_BODY_RELATIONS_H
#define TETRACONE_VERIFY_RELATIONS_MOVING_BODY_RELATIONS_H

#include "verify/cases/moving_bodies.h"
#include "verify/cases/random.h"
#include "verify/relations/metamorphic_relations.h"

#include <span>
#include <string_view>

namespace tetracone::verify {

/// What must hold between the first contacts of the surfaces of moving bodies and of twins made of them without rounding.
struct Moving_body_relation {
  std::string_view name, what;
  Verdict (*check)(const Moving_bodies& bodies, Random& random);
};

/// swapped, reversed-time, split, common-motion, finer-steps.
std::span<const Moving_body_relation> moving_body_relations();

}  // namespace tetracone::verify

#endif
