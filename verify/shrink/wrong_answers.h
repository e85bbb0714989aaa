#ifndef TETRACONE_VERIFY_SHRINK_WRONG_ANSWERS_H
#define TETRACONE_VERIFY_SHRINK_WRONG_ANSWERS_H

#include "verify/cases/case_file.h"
#include "verify/subjects/object_subject.h"
#include "verify/subjects/predicate_subject.h"

#include <optional>
#include <string>
#include <vector>

/// Subjects that answer a case wrong, and the cause, as a case file records them.
namespace tetracone::verify {

/// Our own subjects, of all kernels and methods, that answer the question wrong.
std::vector<Wrong> wrong_answers(const Object_case& c, kernel::Question question, bool truth);
std::vector<Wrong> wrong_answers(const Predicate_case& c, Predicate predicate, int truth);

/// Relative position of the two placed bodies: "vertex-face" and the like, after the most special kind among all
/// contacts; "nested" where only the solids share a point, "apart" where nothing does.
std::string contact_of(const Object_case& c);

/// A case file of the case with its truth, everyone who is wrong, and the cause: `subject` first, with the stage that
/// is to blame where it is one of our rounding trees.
Case_file case_file_of(const Object_case& c, kernel::Question question, const Object_subject& subject, Outcome answer);
/// For a list of features: the case asks for the surfaces, and the cause gives the numbers of missed and invented
/// pairs.
Case_file case_file_of(const Object_case& c, const Object_subject& subject, const Listed& listed);
Case_file case_file_of(const Predicate_case& c, Predicate predicate, const Predicate_subject& subject, int answer);

}  // namespace tetracone::verify

#endif
