#ifndef TETRACONE_VERIFY_SHRINK_WRONG_ANSWERS_H
#define TETRACONE_VERIFY_SHRINK_WRONG_ANSWERS_H

#include "verify/cases/case_file.h"
#include "verify/subjects/object_subject.h"
#include "verify/subjects/predicate_subject.h"

#include <optional>
#include <string>
#include <vector>

/// The subjects that answer a case wrong, and the cause, as a case file records them.
namespace tetracone::verify {

/// Returns those of our own subjects that answer the question wrong or fail, of all kernels and methods. For a
/// predicate, published formulations are asked too.
std::vector<Wrong> wrong_answers(const Object_case& c, kernel::Question question, bool truth);
std::vector<Wrong> wrong_answers(const Predicate_case& c, Predicate predicate, int truth);

/// Returns the relative position of the two placed bodies. It is "vertex-face" and the like, by the most special kind
/// among all contacts, except that a coplanar overlap comes first. It is "nested" if only the solids share a point, and
/// "apart" if nothing does.
std::string contact_of(const Object_case& c);

/// Returns a case file of the case with its truth, all wrong subjects, and the cause. The cause begins with `subject`,
/// names the stage to blame if it is one of our rounding trees, and ends with `contact_of`.
Case_file case_file_of(const Object_case& c, kernel::Question question, const Object_subject& subject, Outcome answer);
/// Returns a case file for a list of features. It asks for the surfaces, and the cause gives the numbers of missed and
/// invented pairs.
Case_file case_file_of(const Object_case& c, const Object_subject& subject, const Told<Feature_pairs>& listed);
/// Returns a case file of a predicate's case. The cause begins with `subject`, and ends with the predicate's name.
/// Requires a case that has a truth.
Case_file case_file_of(const Predicate_case& c, Predicate predicate, const Predicate_subject& subject, int answer);

}  // namespace tetracone::verify

#endif
