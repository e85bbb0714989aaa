#ifndef TETRACONE_VERIFY_SUBJECTS_RUNNING_H
#define TETRACONE_VERIFY_SUBJECTS_RUNNING_H

#include "verify/subjects/spent.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

/// Subjects of any level: what they are, how they run, and what they tell.
namespace tetracone::verify {

/// The result of asking a subject.
enum class Outcome {
  no,
  yes,
  not_asked,  ///< the subject does not take such input (a pose that is not rigid, for a peer whose transforms are;
              ///< all pairs of 10^5 faces)
  failed      ///< crash, hang, exception
};

/// The traces of a failed subject.
struct Failure {
  std::string how;   ///< "status 3", "signal 11", "silent", "wrong line" or "exception"
  std::string said;  ///< the last line of its standard error, and the fault in its answer's line
};

/// The answer of a subject whose outcome says all.
struct Nothing {};

/// A subject's answer to a question.
template <class Answer>
struct Told {
  Outcome outcome = Outcome::not_asked;  ///< yes: it has answered; no: it has answered "no", where that is an answer
  Answer answer{};
  std::optional<Spent> spent{};  ///< nothing if the subject gave no answer, or does not know it
};

/// Returns what answer() tells, timed. An exception is a failure.
template <class Answer>
Told<std::invoke_result_t<Answer>> told_by(const Answer& answer)
{
  using Result = std::invoke_result_t<Answer>;
  auto [result, ns] = timed([&]() -> std::optional<Result> {
    try {
      return answer();
    } catch (const std::exception&) {
      return std::nullopt;
    }
  });
  return {result ? Outcome::yes : Outcome::failed, std::move(result).value_or(Result{}), Spent{{}, ns}};
}

/// A running subject of a level, for one thread. It keeps what it prepared for the last case.
template <class Case, class Answer, class... Question>
class Running {
 public:
  virtual ~Running() = default;
  virtual Told<Answer> operator()(const Case& c, Question... question) = 0;
};

/// A method that answers the cases of a level.
template <class Running>
struct Subject_of {
  std::string name;  ///< "adaptive locator", "double covering"
  bool is_exact = false;
  std::string note;  ///< for inexact ones: the question that they really answer; may be empty
  std::function<std::unique_ptr<Running>()> make;
};

/// Returns the value of an answer that is a list: its number of right elements or, where none is missing, its length.
/// Requires sorted lists.
template <class List>
int as_number(const List& listed, const List& truth)
{
  List right;
  std::set_intersection(listed.begin(), listed.end(), truth.begin(), truth.end(), std::back_inserter(right));
  return int(right.size() < truth.size() ? right.size() : listed.size());
}

}  // namespace tetracone::verify

#endif
