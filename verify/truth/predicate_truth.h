#ifndef TETRACONE_VERIFY_TRUTH_PREDICATE_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_PREDICATE_TRUTH_H

#include "verify/cases/case.h"

#include <optional>

namespace tetracone::verify {

/// Returns the answer to a predicate: the first truth, by CGAL's objects and constructions over rationals. Each
/// predicate is computed by its geometric definition and not by the signs that the subjects use. Nothing if `Predicate`
/// states that the case is not asked.
std::optional<int> true_answer(Predicate predicate, const Predicate_case& c);

}  // namespace tetracone::verify

#endif
