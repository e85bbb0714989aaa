#ifndef TETRACONE_VERIFY_RELATIONS_LEVEL_H
#define TETRACONE_VERIFY_RELATIONS_LEVEL_H

#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/random.h"
#include "verify/subjects/running.h"

#include <string_view>

namespace tetracone::verify {

enum class Verdict { holds, violated, not_applicable };

inline Verdict verdict(bool holds) { return holds ? Verdict::holds : Verdict::violated; }

/// Returns whether holds(answer) for a subject's answer to a twin; `not_applicable` where it has none.
template <class Answer, class Holds>
Verdict verdict(const Told<Answer>& told, const Holds& holds)
{
  return told.outcome == Outcome::yes ? verdict(holds(told.answer)) : Verdict::not_applicable;
}

/// The types of a level: the cases that it asks, what a subject answers, who answers, and the questions about a case.
template <class Case_, class Answer_, class Running_ = verify::Running<Case_, Answer_>,
          class Question_ = kernel::Question>
struct Level {
  using Case = Case_;
  using Answer = Answer_;
  using Running = Running_;
  using Question = Question_;

  /// A subject, and a question about a case that it has answered.
  struct Trial {
    const Case& c;
    Question question;
    Running& subject;
    const Answer& given;  ///< to this question
    Random& random;       ///< the state from which twins are drawn
  };

  /// A relation between a subject's answers for a case and for twins of it that were made without rounding. It shows
  /// errors without a known right answer. It is not applicable if the subject does not answer the case or a twin, or if
  /// a twin would have to be rounded.
  struct Relation {
    std::string_view name;  ///< "R5 swap": unique on its level
    std::string_view what;  ///< what must hold, in a line
    Verdict (*check)(const Trial& trial);
  };
};

}  // namespace tetracone::verify

#endif
