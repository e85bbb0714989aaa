#ifndef TETRACONE_VERIFY_SUBJECTS_PREDICATE_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_PREDICATE_SUBJECT_H

#include "verify/cases/case.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::verify {

/// The answer of a subject that has none: an assertion of a library failed. No predicate has this value, so it is
/// always wrong.
inline constexpr int no_answer = -2;

/// A method that answers predicates: a kernel, with one of the formulations of the predicate where there are several.
struct Predicate_subject {
  std::string name;  ///< "double", "double moeller-trumbore-eps-0"
  bool is_exact = false;
  std::string note;  ///< source and limits of a formulation that is not ours

  /// Returns the answer as `Predicate` defines it; nothing if the subject has no such predicate, or the case is one
  /// that is not asked.
  std::optional<int> (*answer)(Predicate predicate, const Predicate_case& c) = nullptr;

  /// Returns the subject for a thread: it keeps nothing.
  std::unique_ptr<const Predicate_subject> make() const { return std::make_unique<const Predicate_subject>(*this); }
};

/// Returns every kernel with our predicates, and the other known formulations in the arithmetic for which they were
/// published.
const std::vector<Predicate_subject>& predicate_subjects();

}  // namespace tetracone::verify

#endif
