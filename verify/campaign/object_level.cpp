#include "verify/campaign/level_judge.h"
#include "verify/integer_truth/distance_to_degeneracy.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/truth/cgal_truth.h"

#include <map>

namespace tetracone::verify {
namespace {

using kernel::Question;

int changes(const std::vector<int>& answers)
{
  int count = 0;
  for (std::size_t k = 1; k < answers.size(); ++k) count += answers[k] != answers[k - 1];
  return count;
}

int differences(const std::vector<int>& answers, const std::vector<int>& truths)
{
  int count = 0;
  for (std::size_t k = 0; k < answers.size(); ++k) count += answers[k] != truths[k];
  return count;
}

class Object_page : public Two_questions<levels::Objects> {
 public:
  auto relations() const { return object_relations(); }
  bool tries_relations(std::uint64_t k, Question question, const Told&) const
  {
    return question == both[k / relation_stride % 2];
  }

  void learn(const Object_case& c)
  {
    c_ = &c;
    rounded_.clear();
    away_ = distance(c);
    const Brute_body body_a(*c.a), body_b(*c.b);
    const Placed_body a(body_a, c.pose_a), b(body_b, c.pose_b);
    for (const Question question : both) {
      const bool truth = collide(a, b, question);
      if (truth != integer_truth::collide(c, question)) throw Truths_disagree("the two truths disagree", c, question);
      if (c.known(question) && *c.known(question) != truth)
        throw Truths_disagree("the truths disagree with what the family knows by construction", c, question);
      truths_[question].push_back(truth);
    }
  }
  Truths truths(Question question) const
  {
    return {{name(question), truths_.at(question).back() == 1, c_->known(question).has_value()}};
  }

  Told ask(Running_subject& subject, const Object_case& c, Question question) const
  {
    subject.forget();
    const Outcome outcome = subject(c, question);
    return {outcome, {}, subject.spent()};
  }

  Statements statements(const Answered& a)
  {
    const int truth = truths_[a.question].back();
    Statement statement{name(a.question), truth, {}, away_, has_fractions(a.c)};
    const bool is_asked = a.told.outcome != Outcome::not_asked;
    if (is_asked && a.told.outcome != Outcome::failed) statement.value = a.told.outcome == Outcome::yes;
    if (a.subject.own && statement.value && *statement.value != truth)
      statement.stage = blame(*a.subject.own, a.c, a.question, truth == 1);
    if (statement.value && a.subject.in_floats != In_floats::nothing)
      statement.rounded_truth = rounded_truth(a.subject.in_floats, a.question);
    answers_[{a.number, a.question}].push_back(is_asked ? std::optional(statement.value.value_or(-1)) : std::nullopt);
    return {statement};
  }

  /// Counts the changes of answers along a sequence, and of the truth.
  void end(const Job<levels::Objects>& job, Findings& found)
  {
    if (!job.batch.sequence) return;
    for (const auto& [asked, given] : answers_) {
      const auto& [s, question] = asked;
      const std::vector<int>& truths = truths_[question];
      if (given.size() != truths.size()) continue;  // asked before: counted before
      std::vector<int> answers, right;              // of the frames that the subject takes
      for (std::size_t k = 0; k < given.size(); ++k) {
        if (!given[k]) continue;
        answers.push_back(*given[k]);
        right.push_back(truths[k]);
      }
      if (!answers.empty())
        found.add_flips(job.subjects[s].name, name(question), int(answers.size()), differences(answers, right),
                        changes(answers), changes(right));
    }
  }

 private:
  /// The truth of the case as such a subject holds it; nothing where it cannot.
  std::optional<int> rounded_truth(In_floats in_floats, Question question)
  {
    const auto [known, is_new] = rounded_.try_emplace({in_floats, question});
    if (!is_new) return known->second;
    const auto c = float_input(*c_, in_floats);
    if (!c) return std::nullopt;
    const bool truth = collide(Brute_body(*c->a), c->pose_a, Brute_body(*c->b), c->pose_b, question);
    if (truth != integer_truth::collide(*c, question))
      throw Truths_disagree("the two truths of the input in floats disagree", *c, question);
    known->second = truth;
    return known->second;
  }

  const Object_case* c_ = nullptr;
  Distance away_{};
  std::map<std::pair<In_floats, Question>, std::optional<int>> rounded_;  // truths of this case
  // The truths and answers of all cases in order, by question, and by subject and question. Nothing stands for a case
  // that was not asked, -1 for a failure.
  std::map<Question, std::vector<int>> truths_;
  std::map<std::pair<std::size_t, Question>, std::vector<std::optional<int>>> answers_;
};

}  // namespace

Findings levels::Objects::judge(const Job<Objects>& job) { return Level_judge<Object_page>(job).run(); }

}  // namespace tetracone::verify
