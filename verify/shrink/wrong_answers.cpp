#include "verify/shrink/wrong_answers.h"

#include "tetracone/covering/edge_uses.h"
#include "tetracone/kernel/predicate/contact.h"
#include "verify/integer_truth/integer_features.h"
#include "verify/shrink/shrink.h"
#include "verify/subjects/blame.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/predicate_truth.h"

#include <algorithm>
#include <iterator>

namespace tetracone::verify {
namespace {

using kernel::Question;

/// Returns the kind of error of an answer.
std::string direction(std::optional<int> answer, int truth)
{
  return !answer ? "fails" : *answer > truth ? "false positive" : "false negative";
}

bool is_closed(const Object_case& c) { return covering::is_closed(*c.a) && covering::is_closed(*c.b); }

/// The case with its truth and everyone who answers the question wrong.
Case_file with_truth(const Object_case& c, Question question)
{
  Case_file file;
  file.level = Case_kind::object;
  file.object = c;
  file.question = question;
  file.object->surface = true_answer(c, Question::surface);
  if (is_closed(c)) file.object->solid = true_answer(c, Question::solid);
  file.truth = *file.object->known(question);
  file.wrong = wrong_answers(c, question, file.truth);
  return file;
}

}  // namespace

std::vector<Wrong> wrong_answers(const Object_case& c, Question question, bool truth)
{
  std::vector<Wrong> wrong;
  for (const Object_subject& subject : object_subjects()) {
    const Outcome answer = (*subject.make())(c, question);
    if (answer == Outcome::failed)
      wrong.push_back({subject.name, std::nullopt});
    else if (answer != Outcome::not_asked && (answer == Outcome::yes) != truth)
      wrong.push_back({subject.name, answer == Outcome::yes});
  }
  return wrong;
}

std::vector<Wrong> wrong_answers(const Predicate_case& c, Predicate predicate, int truth)
{
  std::vector<Wrong> wrong;
  for (const Predicate_subject& subject : predicate_subjects()) {
    const std::optional<int> answer = subject.answer(predicate, c);
    if (answer && *answer != truth) wrong.push_back({subject.name, *answer == no_answer ? std::nullopt : answer});
  }
  return wrong;
}

std::string contact_of(const Object_case& c)
{
  const auto pairs = features(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b);
  if (pairs.empty()) return is_closed(c) && true_answer(c, Question::solid) ? "nested" : "apart";
  // The kinds are ordered from the most special one on; an overlap comes with others and says more.
  const auto least =
      std::min_element(pairs.begin(), pairs.end(), [](const auto& x, const auto& y) { return x.kind < y.kind; });
  const bool overlap = std::any_of(pairs.begin(), pairs.end(),
                                   [](const auto& pair) { return pair.kind == kernel::Contact::coplanar_overlap; });
  return std::string(to_string(overlap ? kernel::Contact::coplanar_overlap : least->kind));
}

Case_file case_file_of(const Object_case& c, Question question, const Object_subject& subject, Outcome answer)
{
  Case_file file = with_truth(c, question);
  const std::optional<int> given =
      answer == Outcome::failed ? std::nullopt : std::optional<int>(answer == Outcome::yes);
  if (!subject.own) file.wrong.push_back({subject.name, given});
  file.cause = subject.name + ": " + direction(given, file.truth);
  if (given && subject.own) {
    const auto stage = blame(*subject.own, c, question, file.truth);
    if (stage) file.cause += " by " + std::string(to_string(*stage));
  }
  file.cause += ", " + contact_of(c);
  return file;
}

Case_file case_file_of(const Object_case& c, const Object_subject& subject, const Told<Feature_pairs>& listed)
{
  Case_file file = with_truth(c, Question::surface);
  file.cause = subject.name + ": features";
  if (listed.outcome == Outcome::yes) {
    const auto truth = integer_truth::features(c);
    std::vector<kernel::Feature_pair> missed, invented;
    std::ranges::set_difference(truth, listed.answer, std::back_inserter(missed));
    std::ranges::set_difference(listed.answer, truth, std::back_inserter(invented));
    file.cause += ", " + std::to_string(missed.size()) + " missed of " + std::to_string(truth.size()) + ", " +
                  std::to_string(invented.size()) + " invented";
  } else {
    file.cause += " fails";
  }
  file.cause += ", " + contact_of(c);
  return file;
}

Case_file case_file_of(const Predicate_case& c, Predicate predicate, const Predicate_subject& subject, int answer)
{
  Case_file file;
  file.level = Case_kind::predicate;
  file.points = c;
  file.predicate = predicate;
  file.truth = *true_answer(predicate, c);
  file.wrong = wrong_answers(c, predicate, file.truth);
  file.cause = subject.name + ": " + direction(answer == no_answer ? std::nullopt : std::optional(answer), file.truth) +
               " of " + to_string(predicate);
  return file;
}

}  // namespace tetracone::verify
