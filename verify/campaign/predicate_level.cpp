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

  Told ask(const Predicate_subject& subject, const Predicate_case& c, Predicate predicate) const
  {
    const auto [value, ns] = timed([&] { return subject.answer(predicate, c); });
    return value ? Told{Outcome::yes, *value, Spent{0, ns}} : Told();
  }

  Statements statements(const Answered& a) const
  {
    if (a.told.outcome == Outcome::not_asked) return {};  // another predicate's formulation
    return {{name(a.question), *truths_[std::size_t(a.question)], a.told.answer, distance(a.question, a.c),
             has_fractions(a.c)}};
  }

 private:
  std::array<std::optional<int>, all_predicates.size()> truths_;
};

}  // namespace

Findings levels::Predicates::judge(const Job<Predicates>& job) { return Level_judge<Predicate_page>(job).run(); }

}  // namespace tetracone::verify
