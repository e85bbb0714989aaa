#ifndef TETRACONE_VERIFY_RELATIONS_DISTANCE_RELATIONS_H
#define TETRACONE_VERIFY_RELATIONS_DISTANCE_RELATIONS_H

#include "verify/relations/metamorphic_relations.h"

#include <span>
#include <string_view>

namespace tetracone::verify {

/// A relation between a subject's distance for a case, which is given, and its other answers and its answers for twins.
struct Distance_relation {
  using Check = Verdict(const Object_case& c, kernel::Question question, Running_subject& subject,
                        const Told_distance& given, Random& random);

  std::string_view name, what;
  Check* check;
};

/// Returns all of them.
std::span<const Distance_relation> distance_relations();

}  // namespace tetracone::verify

#endif
