#ifndef TETRACONE_VERIFY_RELATIONS_MOTION_RELATIONS_H
#define TETRACONE_VERIFY_RELATIONS_MOTION_RELATIONS_H

#include "tetracone/kernel/motion/moving_pair.h"
#include "verify/cases/random.h"
#include "verify/relations/level.h"

#include <span>
#include <string_view>

namespace tetracone::verify {

/// A relation between the first contact times of a moving pair and of twins that were made without rounding.
struct Motion_relation {
  std::string_view name, what;
  Verdict (*check)(const kernel::Moving_pair& pair, Random& random);
};

/// Returns the relations reversed-time, permuted, translated and split.
std::span<const Motion_relation> motion_relations();

}  // namespace tetracone::verify

#endif
