#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_H

#include "kernel/question.h"
#include "verify/case.h"

#include <optional>

/// The second truth: integers of GMP and nothing else. Every placed coordinate is an integer over one common denominator, which scales
/// nothing that matters. Shares no arithmetic with `brute.h`, which is CGAL's, nor with the subjects.
namespace tetracone::verify::integer_truth {

/// Whether the two placed polyhedra collide. Requires det M != 0, planar faces, and closed polyhedra for `Question::solid`.
bool collide(const Object_case& c, kernel::Question question);

/// The answer to a predicate; nothing where `Predicate` says that it is not asked.
std::optional<int> answer(Predicate predicate, const Predicate_case& c);

}  // namespace tetracone::verify::integer_truth

#endif
