#include "verify/campaign/level_judge.h"
#include "verify/integer_truth/distance_to_degeneracy.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/truth/predicate_truth.h"

namespace tetracone::verify {
namespace {

class Predicate_page : public Page<levels::Predicates> {
 public:
  static constexpr bool counts_not_applicable = false;  // most relations are about one predicate

  const auto& questions(const Predicate_case&) const { return all_predicates; }
  std::string name(Predicate predicate) const { return to_string(predicate); }
  auto relations() const { return predicate_relations(); }

  void learn(const Predicate_case& c)
  {
    for (const Predicate predicate : all_predicates) {
      truths_[std::size_t(predicate)] = true_answer(predicate, c);
      if (truths_[std::size_t(predicate)] != integer_truth::answer(predicate, c))
        throw Truths_disagree("the two truths of a predicate disagree", c, predicate);
    }
  }
  Truths truths(Predicate predicate) const
  {
    const auto& truth = truths_[std::size_t(predicate)];
    return truth ? Truths{{name(predicate), *truth > 0}} : Truths();
  }

  Statements statements(const Answered& a) const
  {
    const bool can_decline = a.subject.start && a.question == Predicate::triangle_triangle;
    if (a.told.outcome == Outcome::not_asked && !can_decline) return {};  // another predicate's formulation
    const auto value = a.told.outcome == Outcome::yes ? std::optional(a.told.answer) : std::nullopt;
    return {
        {name(a.question), *truths_[std::size_t(a.question)], value, distance(a.question, a.c), has_fractions(a.c)}};
  }

 private:
  std::array<std::optional<int>, all_predicates.size()> truths_;
};

}  // namespace

Findings levels::Predicates::judge(const Job<Predicates>& job) { return Level_judge<Predicate_page>(job).run(); }

}  // namespace tetracone::verify
