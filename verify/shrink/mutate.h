#ifndef TETRACONE_VERIFY_SHRINK_MUTATE_H
#define TETRACONE_VERIFY_SHRINK_MUTATE_H

#include "verify/cases/case.h"
#include "verify/cases/random.h"

namespace tetracone::verify {

/// The case with one to three small changes, each one of these: a coordinate or an entry of a pose moved by some ulps,
/// the bodies swapped, a point moved to where the other body has one. Faces that are bent by it are triangulated, what
/// was closed stays closed; nothing is known about the answers. The case as it is where the changes would flatten a
/// pose.
Object_case mutated(const Object_case& c, Random& random);
Predicate_case mutated(const Predicate_case& c, Random& random);

}  // namespace tetracone::verify

#endif
