#include "verify/campaign/motion_batch.h"

#include "tetracone/kernel/number/number.h"
#include "verify/campaign/batch_parts.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/relations/moving_body_relations.h"
#include "verify/truth/moving_bodies_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

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

/// A running batch of moving bodies.
class Motion_batch : Working_batch<Moving_bodies_subject> {
 public:
  Motion_batch(const Campaign& campaign, const Batch& batch, const Done& done, Running_motions& running)
      : Working_batch(campaign, batch, done, campaign.motion_subjects), running_(running)
  {}

  Findings judge()
  {
    for_wanted([this](std::uint64_t k) {
      judge(moving_bodies_case(*batch_.motions, seed_, k), {std::string(batch_.motions->name), seed_, k, 0}, k);
    });
    return finish();
  }

 private:
  /// The largest number of distances that the second truth computes for one case.
  static constexpr int most_distances = 32;

  void judge(const Moving_bodies& c, const Origin& origin, std::uint64_t k)
  {
    const Object_case start = at_start(c, origin);
    const Told_contact guess = guessing_->first_contact(c, Question::surface);
    const First_time of_surfaces =
        true_first_contact(c, Question::surface, guess.outcome == Outcome::yes ? First_time(guess.time) : std::nullopt);
    const Bracket bracket = truly_first_by_distances(c, Question::surface, of_surfaces, most_distances);
    if (bracket == Bracket::violated)
      throw Truths_disagree("the two truths of a first contact disagree; the bodies at its start", start,
                            Question::surface);
    for (const Question question : {Question::surface, Question::solid}) {
      const bool at_once = truly_collide_at_start(c, question);
      if (at_once != integer_truth::collide(start, question))
        throw Truths_disagree("the two truths disagree", start, question);
      const First_time truth = at_once ? Time_bounds{0, 0} : of_surfaces;
      if (wanted_.truth(k))
        found_.add_truth(name_of(question), truth.has_value(), at_once || bracket == Bracket::holds);
      for (std::size_t s = 0; s < subjects_.size(); ++s)
        if (wanted_.subject(s, k)) judge_answer(c, origin, s, question, truth);
    }
    if (k % relation_stride == 0) try_relation(c, origin);
  }

  void judge_answer(const Moving_bodies& c, const Origin& origin, std::size_t s, Question question,
                    const First_time& truth)
  {
    const Told_contact told = running_[s]->first_contact(c, question);
    Findings::Answer answer{{}, told.outcome == Outcome::not_asked};
    if (told.outcome == Outcome::yes || told.outcome == Outcome::no) answer.value = told.outcome == Outcome::yes;
    const Findings::Kind kind{unknown, has_fractions(c)};
    const auto add = [&](const std::string& asked, int right, const Findings::Answer& given) {
      found_.add_answer(subjects_[s].name, asked, kind, right, given, told.spent);
      add_if_wrong(origin, s, asked, right, given);
    };
    add(name_of(question), truth.has_value(), answer);
    if (told.outcome == Outcome::yes && truth)
      add(name_of(question) + " time", 0, {place_in_time(told.time, *truth, subjects_[s].is_exact)});
  }

  /// True when a number of the motions is no double.
  static bool has_fractions(const Moving_bodies& c)
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

  static constexpr Distance unknown{HUGE_VAL, HUGE_VAL};

  void add_if_wrong(const Origin& origin, std::size_t s, const std::string& question, int truth,
                    const Findings::Answer& answer)
  {
    if (!answer.not_asked && answer.value != truth && origin.index < kept_one_by_one)
      found_.add_wrong(origin, subjects_[s].name, question, unknown, truth, answer, {});
  }

  void try_relation(const Moving_bodies& c, const Origin& origin)
  {
    const auto relations = moving_body_relations();
    const std::size_t number =
        (origin.index / relation_stride + std::size_t(batch_.motions->number)) % relations.size();
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      if (!wanted_.subject(s, origin.index)) continue;
      Random random = random_of(origin, number);
      const Verdict verdict = relations[number].check(c, *running_[s], random);
      found_.add_relation(std::string(relations[number].name), subjects_[s].name, name_of(Question::surface),
                          verdict != Verdict::not_applicable, verdict == Verdict::violated);
    }
  }

  Running_motions& running_;
  std::unique_ptr<Running_motion> guessing_ = moving_bodies_subjects().front().make();
};

}  // namespace

Findings judge_motions(const Campaign& campaign, const Batch& batch, const Done& done, Running_motions& running)
{
  return Motion_batch(campaign, batch, done, running).judge();
}

}  // namespace tetracone::verify
