#ifndef TETRACONE_VERIFY_RELATIONS_DISTANCE_RELATIONS_H
#define TETRACONE_VERIFY_RELATIONS_DISTANCE_RELATIONS_H

#include "verify/relations/metamorphic_relations.h"

#include <span>
#include <string_view>

namespace tetracone::verify {

/// What must hold between what a subject says of a case's distance, which is given, and its other answers and those to
/// twins.
struct Distance_relation {
  using Check = Verdict(const Object_case& c, kernel::Question question, Running_subject& subject,
                        const Told_distance& given, Random& random);

  std::string_view name, what;
  Check* check;
};

/// All of them.
std::span<const Distance_relation> distance_relations();

}  // namespace tetracone::verify

#endif
