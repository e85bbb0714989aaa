#ifndef TETRACONE_VERIFY_FAMILIES_FAMILIES_H
#define TETRACONE_VERIFY_FAMILIES_FAMILIES_H

#include "verify/cases/case.h"
#include "verify/cases/random.h"
#include "verify/families/named_family.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace tetracone::verify {

/// A family of cases of predicates and of two bodies.
struct Family : Named_family {
  Predicate_case (*predicate)(Random& random, double parameter);
  Object_case (*object)(Random& random, double parameter);

  /// Case `index` of the family. All but its parameter is drawn from (seed, number, kind, index).
  Predicate_case predicate_case(std::uint64_t seed, std::uint64_t index) const;
  Object_case object_case(std::uint64_t seed, std::uint64_t index) const;
};

/// Returns all families, in the order of their numbers.
const std::vector<Family>& families();

/// Returns the family of this name; null when there is none.
const Family* find_family(std::string_view name);

}  // namespace tetracone::verify

#endif
