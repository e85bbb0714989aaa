#ifndef TETRACONE_VERIFY_SHRINK_MUTATE_H
#define TETRACONE_VERIFY_SHRINK_MUTATE_H

#include "verify/cases/case.h"
#include "verify/cases/random.h"

namespace tetracone::verify {

/// Returns the case with one to three small changes, and in one call of four with the bodies swapped. A change moves a
/// coordinate or an entry of a pose by some ulps, or moves a point onto one of the other body. Faces that become bent
/// are triangulated; a closed body stays closed. The answers are unknown. Returns the case unchanged if a change would
/// make det M = 0. A predicate's swap exchanges v1 v2 v3 and p q r.
Object_case mutated(const Object_case& c, Random& random);
Predicate_case mutated(const Predicate_case& c, Random& random);

}  // namespace tetracone::verify

#endif
