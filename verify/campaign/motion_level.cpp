#include "tetracone/kernel/number/number.h"
#include "verify/campaign/level_judge.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/truth/moving_bodies_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tetracone::verify {
namespace {

using kernel::Question;
using kernel::Time_bounds;
using First_time = std::optional<Time_bounds>;

/// Returns -1, 0 or 1 for a time before, at or after the true one.
int place_in_time(const Time_bounds& told, const Time_bounds& truth, bool is_exact)
{
  if (!is_exact && truth.lo <= told.lo && told.hi <= truth.hi) return 0;
  if (told.lo != truth.lo) return told.lo < truth.lo ? -1 : 1;
  return told.hi == truth.hi ? 0 : told.hi < truth.hi ? -1 : 1;
}

/// True when a number of the motions is no double.
bool moves_by_fractions(const Moving_bodies& c)
{
  const auto is_fraction = [](const kernel::Rational& number) {
    const double nearest = kernel::nearest_double(number);
    return !std::isfinite(nearest) || kernel::Rational(nearest) != number;
  };
  for (const Motion_ends* ends : {&c.motion_a, &c.motion_b})
    for (const auto& numbers : *ends)
      if (std::ranges::any_of(numbers, is_fraction)) return true;
  return false;
}

/// Judges whether the bodies meet and, where truth and answer say that they do, whether the time is the exact one (see
/// campaign_schema.h). An exact subject must give the doubles around the time; another subject must give one of these.
class Motion_page : public Two_questions<levels::Motions> {
 public:
  auto relations() const { return moving_body_relations(); }
  bool tries_relations(std::uint64_t, Question question, const Told&) const { return question == Question::surface; }

  void learn(const Moving_bodies& c)
  {
    start_ = at_start(c, c.origin);
    for (const Question question : {Question::surface, Question::solid})
      collide_at_once_[question == Question::solid] = truly_collide_at_start(c, question);
    const Told guess = (*guessing_)(c, Question::surface);
    of_surfaces_ = true_first_contact(c, Question::surface,
                                      guess.outcome == Outcome::yes ? First_time(guess.answer) : std::nullopt);
    bracket_ = truly_first_by_distances(c, Question::surface, of_surfaces_, most_distances);
    if (bracket_ == Bracket::violated)
      throw Truths_disagree("the two truths of a first contact disagree; the bodies at its start", start_,
                            Question::surface);
  }
  Truths truths(Question question)
  {
    const bool at_once = collide_at_once_[question == Question::solid];
    if (at_once != integer_truth::collide(start_, question))
      throw Truths_disagree("the two truths disagree", start_, question);
    truth_ = at_once ? Time_bounds{0, 0} : of_surfaces_;
    return {{name(question), truth_.has_value(), at_once || bracket_ == Bracket::holds}};
  }

  Statements statements(const Answered& a) const
  {
    Statement whether{name(a.question), truth_.has_value()};
    whether.has_fractions = moves_by_fractions(a.c);
    if (a.told.outcome == Outcome::yes || a.told.outcome == Outcome::no) whether.value = a.told.outcome == Outcome::yes;
    if (a.told.outcome != Outcome::yes || !truth_) return {whether};
    Statement when = whether;
    when.question += " time";
    when.truth = 0;
    when.value = place_in_time(a.told.answer, *truth_, a.subject.is_exact);
    return {whether, when};
  }

 private:
  /// The largest number of distances that the second truth computes for one case.
  static constexpr int most_distances = 32;

  std::unique_ptr<Running_motion> guessing_ = moving_bodies_subjects().front().make();
  Object_case start_;
  std::array<bool, 2> collide_at_once_{};  // surfaces, solids
  First_time of_surfaces_, truth_;
  Bracket bracket_{};
};

}  // namespace

Findings levels::Motions::judge(const Job<Motions>& job) { return Level_judge<Motion_page>(job).run(); }

}  // namespace tetracone::verify
