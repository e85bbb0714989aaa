#ifndef TETRACONE_VERIFY_RELATIONS_CONTACT_RELATIONS_H
#define TETRACONE_VERIFY_RELATIONS_CONTACT_RELATIONS_H

#include "verify/relations/metamorphic_relations.h"

#include <array>
#include <string_view>

namespace tetracone::verify {

/// A relation between a subject's contacts for a case, which are given, and its other answers and its answers for
/// twins.
struct Contact_relation {
  using Check = Verdict(const Object_case& c, Running_subject& subject, const Contact_forms& given);

  std::string_view name, what;
  Check* check;
};

/// Returns all of them.
const std::array<Contact_relation, 4>& contact_relations();

}  // namespace tetracone::verify

#endif
