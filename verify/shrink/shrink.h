#ifndef TETRACONE_VERIFY_SHRINK_SHRINK_H
#define TETRACONE_VERIFY_SHRINK_SHRINK_H

#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case.h"
#include "verify/subjects/object_subject.h"
#include "verify/subjects/predicate_subject.h"

#include <compare>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

/// Makes a case that shows something as small as it can be made while it still shows it (delta debugging).
namespace tetracone::verify {

/// Complexity of a case, compared lexicographically.
struct Case_size {
  std::size_t corners = 0, vertices = 0;  ///< of all faces of both bodies; of a predicate's points always the same
  std::size_t bits = 0;  ///< of the coordinates, and of the entries of the poses that differ from the identity's

  friend auto operator<=>(const Case_size&, const Case_size&) = default;
};
Case_size size_of(const Object_case& c);
Case_size size_of(const Predicate_case& c);
std::size_t face_count(const Object_case& c);

/// Where shrinking stops, done or not.
struct Shrink_budget {
  std::size_t evaluations = 20000;  ///< of `still_wrong`
  double seconds = 3;
};

using Object_check = std::function<bool(const Object_case&)>;
using Predicate_check = std::function<bool(const Predicate_case&)>;

/// The smallest case found for which `still_wrong` holds, not larger than `c`. Steps: drop faces, shells, loops and
/// corners; replace vertices by others; take a body's triangles for its polygons, or a tetrahedron for the body; then
/// simpler poses, coordinates of fewer bits, exact translations and scalings; over and over while anything helps.
/// `still_wrong` is asked only of cases with planar faces, det M != 0, at least a face in each body and, for
/// `Question::solid`, closed bodies. Where a body has no degenerate face before, it has none later; for
/// `Question::solid` neither does its volume become 0. Requires such a `c`, for which it holds.
Object_case shrink(Object_case c, kernel::Question question, const Object_check& still_wrong,
                   const Shrink_budget& budget = {});
Predicate_case shrink(const Predicate_case& c, const Predicate_check& still_wrong, const Shrink_budget& budget = {});

/// The answer to an object case by `cgal_truth.h`.
bool true_answer(const Object_case& c, kernel::Question question);

/// That a subject answers just this, or fails, where the truth is just that: wrong in the same way. The subject must
/// outlive it.
Object_check same_error(Running_subject& subject, kernel::Question question, Outcome answer, bool truth);

/// That a subject lists some pair of features that is none, or misses one: as before, if both, the missed one counts.
Object_check same_error_of_features(Running_subject& subject, bool misses);

/// The same, as it was in `c`: where the triangles and the segment that the predicate takes are not degenerate there,
/// neither are they later.
Predicate_check same_error(const Predicate_subject& subject, Predicate predicate, const Predicate_case& c, int answer,
                           int truth);

}  // namespace tetracone::verify

#endif
