#ifndef TETRACONE_VERIFY_SUBJECTS_PREDICATE_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_PREDICATE_SUBJECT_H

#include "verify/cases/case.h"
#include "verify/subjects/running.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::verify {

/// The answer of a subject that has none: an assertion of a library failed. No predicate has this value, so it is
/// always wrong.
inline constexpr int no_answer = -2;

/// A running method that answers predicates, for one thread.
class Running_predicates : public Running<Predicate_case, int, Predicate> {
 public:
  explicit Running_predicates(std::string name) : name_(std::move(name)) {}

  const std::string& name() const { return name_; }
  /// Returns the traces of the last answer, which was `failed`.
  virtual Failure failure() const { return {}; }
  /// Returns the number of lines that a program wrote with the last answer and that are not for us.
  virtual std::uint64_t skipped_lines() const { return 0; }

 private:
  std::string name_;
};

/// A method that answers predicates: a kernel, with one of the formulations of the predicate where there are several.
/// A program of others answers `triangle_triangle` alone.
struct Predicate_subject {
  std::string name;  ///< "double", "double moeller-trumbore-eps-0"
  bool is_exact = false;
  std::string note;  ///< source and limits of a formulation that is not ours

  /// Returns the answer as `Predicate` defines it; nothing if the subject has no such predicate, or the case is one
  /// that is not asked.
  std::optional<int> (*answer)(Predicate predicate, const Predicate_case& c) = nullptr;

  /// Starts a program of others, which has no `answer`; empty for a method of our own process.
  std::function<std::unique_ptr<Running_predicates>()> start{};

  /// Returns the subject for a thread.
  std::unique_ptr<Running_predicates> make() const;
};

/// Returns every kernel with our predicates, and the other known formulations in the arithmetic for which they were
/// published.
const std::vector<Predicate_subject>& predicate_subjects();

}  // namespace tetracone::verify

#endif
