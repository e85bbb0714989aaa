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

/// Shrinks a case as far as possible while it still shows an error (delta debugging).
namespace tetracone::verify {

/// The complexity of a case, compared lexicographically.
struct Case_size {
  std::size_t corners = 0, vertices = 0;  ///< of all faces of both bodies; of a predicate's points always the same
  std::size_t bits = 0;  ///< of the coordinates, and of the entries of the poses that differ from the identity's

  friend auto operator<=>(const Case_size&, const Case_size&) = default;
};

/// Returns the complexity of a case.
Case_size size_of(const Object_case& c);
Case_size size_of(const Predicate_case& c);

/// Returns the number of faces of both bodies.
std::size_t face_count(const Object_case& c);

/// The limits at which shrinking stops, finished or not.
struct Shrink_budget {
  std::size_t evaluations = 20000;  ///< of `still_wrong`
  double seconds = 3;
};

using Object_check = std::function<bool(const Object_case&)>;
using Predicate_check = std::function<bool(const Predicate_case&)>;

/// Returns the smallest case found for which `still_wrong` holds, not larger than `c`. It drops faces, shells, loops
/// and corners, replaces vertices by others, and takes a body's triangles for its polygons, or a tetrahedron for the
/// body. Then it tries simpler poses, coordinates of fewer bits, exact translations and scalings. It repeats all steps
/// while any helps. `still_wrong` is asked only of cases with planar faces, det M != 0, at least one face in each body
/// and, for `Question::solid`, closed bodies. A body without degenerate faces gets none; for `Question::solid` its
/// volume does not become 0 either. Requires such a `c`, for which it holds.
Object_case shrink(Object_case c, kernel::Question question, const Object_check& still_wrong,
                   const Shrink_budget& budget = {});

/// Returns the smallest case found for which `still_wrong` holds, by simpler numbers and poses. `still_wrong` is asked
/// only of cases with det M != 0. Requires that it holds for `c`.
Predicate_case shrink(const Predicate_case& c, const Predicate_check& still_wrong, const Shrink_budget& budget = {});

/// Returns the answer to an object case by `cgal_truth.h`.
bool true_answer(const Object_case& c, kernel::Question question);

/// Returns a check that a subject gives this answer to a case of this truth, so that it is wrong in the same way. The
/// answer may be that it fails. The subject must outlive the check.
Object_check same_error(Running_subject& subject, kernel::Question question, Outcome answer, bool truth);

/// Returns a check that a subject misses a pair of features that meets or, without `misses`, lists one that does not.
/// An original that did both is checked with `misses`. The subject must outlive the check.
Object_check same_error_of_features(Running_subject& subject, bool misses);

/// Returns such a check for a predicate. If the triangles and the segment of the predicate are not degenerate in `c`,
/// they must not become so.
Predicate_check same_error(const Predicate_subject& subject, Predicate predicate, const Predicate_case& c, int answer,
                           int truth);

}  // namespace tetracone::verify

#endif
