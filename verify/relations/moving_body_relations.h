#ifndef TETRACONE_VERIFY_RELATIONS_MOVING_BODY_RELATIONS_H
#define TETRACONE_VERIFY_RELATIONS_MOVING_BODY_RELATIONS_H

#include "verify/cases/moving_bodies.h"
#include "verify/cases/random.h"
#include "verify/relations/metamorphic_relations.h"
#include "verify/subjects/moving_bodies_subject.h"

#include <span>
#include <string_view>

namespace tetracone::verify {

/// A relation between a subject's first contacts of the surfaces of moving bodies and of twins that were made without
/// rounding. It is not applicable if the subject gives no answer.
struct Moving_body_relation {
  std::string_view name, what;
  Verdict (*check)(const Moving_bodies& bodies, Running_motion& subject, Random& random);
};

/// swapped, reversed-time, split, common-motion, finer-steps.
std::span<const Moving_body_relation> moving_body_relations();

}  // namespace tetracone::verify

#endif
