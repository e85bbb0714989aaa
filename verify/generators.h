#ifndef TETRACONE_VERIFY_GENERATORS_H
#define TETRACONE_VERIFY_GENERATORS_H

#include "verify/case.h"
#include "verify/random.h"

#include <array>

/// The generators behind `families()`: entry k makes the cases of family k + 1, from a random state and the family's parameter. They
/// fill everything but `origin`.
namespace tetracone::verify {

inline constexpr std::size_t family_count = 47;

extern const std::array<Predicate_case (*)(Random&, double), family_count> predicate_generators;
extern const std::array<Object_case (*)(Random&, double), family_count> object_generators;

}  // namespace tetracone::verify

#endif
