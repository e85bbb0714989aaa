#ifndef TETRACONE_VERIFY_SHRINK_MUTATE_H
#define TETRACONE_VERIFY_SHRINK_MUTATE_H

#include "verify/cases/case.h"
#include "verify/cases/random.h"

namespace tetracone::verify {

/// Returns the case with one to three small changes. A change moves a coordinate or an entry of a pose by some ulps, or
/// swaps the bodies. It may also move a point to a point of the other body. Faces that become bent are triangulated; a
/// closed body stays closed. The answers are unknown. Returns the case unchanged if the changes would make det M = 0.
Object_case mutated(const Object_case& c, Random& random);
Predicate_case mutated(const Predicate_case& c, Random& random);

}  // namespace tetracone::verify

#endif
