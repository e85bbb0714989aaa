#ifndef TETRACONE_VERIFY_RELATIONS_METAMORPHIC_RELATIONS_H
#define TETRACONE_VERIFY_RELATIONS_METAMORPHIC_RELATIONS_H

#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case.h"
#include "verify/cases/random.h"
#include "verify/subjects/object_subject.h"
#include "verify/subjects/predicate_subject.h"

#include <string_view>
#include <vector>

/// Relations between a subject's answers for a case and for twins of it that were made without rounding. They show
/// errors without a known right answer. A twin is made in rational arithmetic or by operations on doubles that are
/// checked to be exact; if it would have to be rounded, the relation does not apply.
///
/// The numbers R1 to R13 are parts of the relations' names. R12 (signs in vectors equal scalar ones) is no relation of
/// cases: the tests of kernel/bound and tetratree/fast compare each version of the vectors with scalar arithmetic.
namespace tetracone::verify {

enum class Verdict { holds, violated, not_applicable };

inline const char* to_string(Verdict verdict)
{
  return verdict == Verdict::holds ? "holds" : verdict == Verdict::violated ? "violated" : "not applicable";
}

/// A relation of one level. Its check draws the twins from the random state. It is not applicable if the subject does
/// not answer the case or a twin.
struct Relation {
  using Object_check = Verdict(const Object_case& c, kernel::Question question, Running_subject& subject,
                               Random& random);
  using Predicate_check = Verdict(const Predicate_case& c, Predicate predicate, const Predicate_subject& subject,
                                  Random& random);

  Relation(std::string_view name, std::string_view what, Object_check* check)
      : name(name), what(what), level(Level::object), of_object(check)
  {}
  Relation(std::string_view name, std::string_view what, Predicate_check* check)
      : name(name), what(what), level(Level::predicate), of_predicate(check)
  {}

  std::string_view name;  ///< "R5 swap": unique on its level
  std::string_view what;  ///< what must hold, in a line
  Level level;
  Object_check* of_object = nullptr;  ///< the check of the level; the other is null
  Predicate_check* of_predicate = nullptr;
};

/// Returns all relations, those of predicates first, each level in the order of the numbers.
const std::vector<Relation>& relations();

/// Returns the relations of one level.
std::vector<Relation> predicate_relations();
std::vector<Relation> object_relations();

/// Asks the subject about the case and its twins. Requires a relation of the level, and the preconditions of
/// `Running_subject` and `Predicate`.
Verdict check(const Relation& relation, const Object_case& c, kernel::Question question, Running_subject& subject,
              Random& random);
Verdict check(const Relation& relation, const Predicate_case& c, Predicate predicate, const Predicate_subject& subject,
              Random& random);

/// The relation "R5 swap" of features: the pairs of A and B are those of B and A, with the bodies exchanged.
Verdict check_swapped_features(const Object_case& c, Running_subject& subject);

}  // namespace tetracone::verify

#endif
