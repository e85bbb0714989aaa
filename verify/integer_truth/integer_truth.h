#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_TRUTH_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_TRUTH_H

#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case.h"

#include <optional>

/// The second truth: integers of GMP and nothing else. Every placed coordinate is an integer over one common
/// denominator, which changes no sign. It shares neither arithmetic nor formulation with `cgal_truth.h` and
/// `predicate_truth.h`, which are CGAL's, nor with the subjects. Faces are never triangulated. Quadrants give a point's
/// position in loops, and the faces above it its position in solids. Hulls and cones meet if a system of linear
/// equations has a non-negative solution.
namespace tetracone::verify::integer_truth {

/// True when the two placed polyhedra collide. Requires det M != 0, planar faces, and closed polyhedra for
/// `Question::solid`.
bool collide(const Object_case& c, kernel::Question question);

/// Returns the answer to a predicate; nothing if `Predicate` states that the case is not asked.
std::optional<int> answer(Predicate predicate, const Predicate_case& c);

}  // namespace tetracone::verify::integer_truth

#endif
