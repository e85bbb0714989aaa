#include "verify/campaign/batch_judge.h"

#include "verify/campaign/batch_parts.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/integer_truth/distance_to_degeneracy.h"
#include "verify/integer_truth/integer_contacts.h"
#include "verify/integer_truth/integer_features.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/relations/contact_relations.h"
#include "verify/relations/metamorphic_relations.h"
#include "verify/truth/cgal_contacts.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/predicate_truth.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace tetracone::verify {
namespace {

using kernel::Question;

constexpr std::array questions = {Question::surface, Question::solid};

/// Returns the number of the relation with which case k is tried, modulo the number of relations. Each family begins
/// with another relation.
std::size_t relation_turn(const Batch& batch, std::uint64_t k)
{
  return k / relation_stride + std::size_t(batch.family->number);
}

// --- predicates -----------------------------------------------------------------------------------------------------

std::optional<int> truth_of(const Predicate_case& c, Predicate predicate)
{
  const auto first = true_answer(predicate, c), second = integer_truth::answer(predicate, c);
  if (first != second) throw Truths_disagree("the two truths of a predicate disagree", c, predicate);
  return first;
}

/// A running batch of predicate cases.
class Predicate_batch : Working_batch<Predicate_subject> {
 public:
  Predicate_batch(const Campaign& campaign, const Batch& batch, const Done& done)
      : Working_batch(campaign, batch, done, campaign.predicate_subjects)
  {}

  Findings judge()
  {
    for_wanted([this](std::uint64_t k) {
      const Predicate_case c = batch_.family->predicate_case(seed_, k);
      for (const Predicate predicate : all_predicates) judge_answers(c, k, predicate);
      if (k % relation_stride == 0) try_relation(c, k);
    });
    return finish();
  }

 private:
  void judge_answers(const Predicate_case& c, std::uint64_t k, Predicate predicate)
  {
    const std::string question = verify::to_string(predicate);
    const auto truth = truth_of(c, predicate);
    if (!truth) return;
    if (wanted_.truth(k)) found_.add_truth(question, *truth > 0, false);
    const Distance away = distance(predicate, c);
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      if (!wanted_.subject(s, k)) continue;
      const auto [value, ns] = timed([&] { return subjects_[s].answer(predicate, c); });
      if (!value) continue;  // another predicate's formulation
      const Findings::Answer answer{value, false};
      found_.add_answer(subjects_[s].name, question, kind_of(c, away), *truth, answer, Spent{0, ns});
      if (*value != *truth && k < kept_one_by_one)
        found_.add_wrong(c.origin, subjects_[s].name, question, away, *truth, answer, {});
    }
  }

  void try_relation(const Predicate_case& c, std::uint64_t k)
  {
    static const std::vector<Relation> relations = predicate_relations();
    const std::size_t number = relation_turn(batch_, k) % relations.size();
    const Relation& relation = relations[number];
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      if (!wanted_.subject(s, k)) continue;
      for (const Predicate predicate : all_predicates) {
        Random random = random_of(c.origin, number);
        const Verdict verdict = check(relation, c, predicate, subjects_[s], random);
        if (verdict == Verdict::not_applicable) continue;  // most relations are about one predicate
        found_.add_relation(std::string(relation.name), subjects_[s].name, verify::to_string(predicate), true,
                            verdict == Verdict::violated);
      }
    }
  }
};

// --- objects --------------------------------------------------------------------------------------------------------

bool truth_of(const Object_case& c, const Placed_body& a, const Placed_body& b, Question question)
{
  const bool first = verify::collide(a, b, question), second = integer_truth::collide(c, question);
  if (first != second) throw Truths_disagree("the two truths disagree", c, question);
  if (c.known(question) && *c.known(question) != first)
    throw Truths_disagree("the truths disagree with what the family knows by construction", c, question);
  return first;
}

Findings::Answer as_answer(Outcome outcome)
{
  if (outcome == Outcome::not_asked) return {{}, true};
  if (outcome == Outcome::failed) return {};
  return {outcome == Outcome::yes ? 1 : 0, false};
}

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

/// A running batch of object cases, or of a sequence.
class Object_batch : Working_batch<Object_subject> {
 public:
  Object_batch(const Campaign& campaign, const Batch& batch, const Done& done, Running_subjects& running)
      : Working_batch(campaign, batch, done, campaign.object_subjects), running_(running)
  {}

  Findings judge()
  {
    for_wanted([this](std::uint64_t k) {
      judge(batch_.sequence ? batch_.sequence->frames[k] : batch_.family->object_case(seed_, k), k);
    });
    if (batch_.sequence) count_flips();
    return finish();
  }

 private:
  /// The truth of a case for both questions.
  using Truth = std::map<Question, bool>;

  void judge(const Object_case& c, std::uint64_t k)
  {
    const Truth truth = find_truth(c, k);
    const Distance away = distance(c);
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      if (!wanted_.subject(s, k)) continue;
      for (const Question question : questions) judge_answer(c, k, s, question, truth.at(question), away);
      if (!batch_.sequence && k % relation_stride == 0) try_relation(c, k, s);
    }
  }

  Truth find_truth(const Object_case& c, std::uint64_t k)
  {
    const Brute_body body_a(*c.a), body_b(*c.b);
    const Placed_body a(body_a, c.pose_a), b(body_b, c.pose_b);
    Truth truth;
    for (const Question question : questions) {
      truth[question] = truth_of(c, a, b, question);
      if (wanted_.truth(k)) found_.add_truth(name_of(question), truth[question], c.known(question).has_value());
      truths_[question].push_back(truth[question]);
    }
    return truth;
  }

  void judge_answer(const Object_case& c, std::uint64_t k, std::size_t s, Question question, bool truth,
                    const Distance& away)
  {
    const Object_subject& subject = subjects_[s];
    running_[s]->forget();
    const Outcome outcome = (*running_[s])(c, question);
    const Findings::Answer answer = as_answer(outcome);
    found_.add_answer(subject.name, name_of(question), kind_of(c, away), truth, answer, running_[s]->spent());
    answers_[{s, question}].push_back(answer.not_asked ? std::nullopt : std::optional(answer.value.value_or(-1)));
    if (outcome == Outcome::failed) found_.add_failure(subject.name, name_of(question), k, running_[s]->failure());
    if (answer.not_asked || answer.value == int(truth)) return;
    const auto stage = subject.own && answer.value ? blame(*subject.own, c, question, truth) : std::nullopt;
    if (stage) found_.add_blame(subject.name, name_of(question), *stage);
    if (k < kept_one_by_one) found_.add_wrong(c.origin, subject.name, name_of(question), away, truth, answer, stage);
  }

  void try_relation(const Object_case& c, std::uint64_t k, std::size_t s)
  {
    static const std::vector<Relation> relations = object_relations();
    const std::size_t number = relation_turn(batch_, k) % relations.size();
    const Question question = questions[k / relation_stride % 2];
    Random random = random_of(c.origin, number);
    const Verdict verdict = check(relations[number], c, question, *running_[s], random);
    found_.add_relation(std::string(relations[number].name), subjects_[s].name, name_of(question),
                        verdict != Verdict::not_applicable, verdict == Verdict::violated);
  }

  /// Counts the changes of answers along the sequence, and of the truth.
  void count_flips()
  {
    for (const auto& [asked, given] : answers_) {
      const auto& [s, question] = asked;
      if (given.size() != truths_[question].size()) continue;  // asked before: counted before
      std::vector<int> answers, right;                         // of the frames that the subject takes
      for (std::size_t k = 0; k < given.size(); ++k) {
        if (!given[k]) continue;
        answers.push_back(*given[k]);
        right.push_back(truths_[question][k]);
      }
      if (answers.empty()) continue;
      found_.add_flips(subjects_[s].name, name_of(question), int(answers.size()), differences(answers, right),
                       changes(answers), changes(right));
    }
  }

  Running_subjects& running_;
  // The answers of all cases in order, by subject and question; nothing for a case that was not asked, -1 for a
  // failure.
  std::map<std::pair<std::size_t, Question>, std::vector<std::optional<int>>> answers_;
  std::map<Question, std::vector<int>> truths_;
};

// --- features --------------------------------------------------------------------------------------------------------

using Pairs = std::vector<kernel::Feature_pair>;

Pairs true_features(const Object_case& c)
{
  Pairs first = features(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b);
  if (first != integer_truth::features(c))
    throw Truths_disagree("the two truths of features disagree", c, Question::surface);
  return first;
}

/// A running batch of cases that ask for features.
class Feature_batch : Working_batch<Object_subject> {
 public:
  Feature_batch(const Campaign& campaign, const Batch& batch, const Done& done, Running_subjects& running)
      : Working_batch(campaign, batch, done, campaign.feature_subjects), running_(running)
  {}

  Findings judge()
  {
    for_wanted([this](std::uint64_t k) { judge(batch_.family->object_case(seed_, k), k); });
    return finish();
  }

 private:
  void judge(const Object_case& c, std::uint64_t k)
  {
    const Pairs truth = true_features(c);
    if (wanted_.truth(k)) found_.add_truth(question, !truth.empty(), false);
    const Distance away = distance(c);
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      if (!wanted_.subject(s, k)) continue;
      running_[s]->forget();
      const Listed listed = running_[s]->features(c);
      Findings::Answer answer{{}, listed.outcome == Outcome::not_asked};
      if (listed.outcome == Outcome::yes) answer.value = as_number(listed.pairs, truth);
      if (listed.outcome == Outcome::failed) found_.add_failure(subjects_[s].name, question, k, running_[s]->failure());
      found_.add_answer(subjects_[s].name, question, kind_of(c, away), int(truth.size()), answer, running_[s]->spent());
      if (!answer.not_asked && answer.value != int(truth.size()) && k < kept_one_by_one)
        found_.add_wrong(c.origin, subjects_[s].name, question, away, int(truth.size()), answer, {});
      if (k % relation_stride == 0) try_swap(c, s);
    }
  }

  void try_swap(const Object_case& c, std::size_t s)
  {
    const Verdict verdict = check_swapped_features(c, *running_[s]);
    found_.add_relation("R5 swap", subjects_[s].name, question, verdict != Verdict::not_applicable,
                        verdict == Verdict::violated);
  }

  static constexpr const char* question = "features";
  Running_subjects& running_;
};

// --- contacts --------------------------------------------------------------------------------------------------------

Contact_forms true_contacts(const Object_case& c)
{
  const Contact_forms first = contacts(c);
  if (with_joined_polygons(first) != integer_truth::contacts(c))
    throw Truths_disagree("the two truths of contacts disagree", c, Question::surface);
  return first;
}

/// Runs a batch of cases that ask for contacts. Subjects are not asked about bodies of more than `most_faces` faces.
class Contact_batch : Working_batch<Object_subject> {
 public:
  Contact_batch(const Campaign& campaign, const Batch& batch, const Done& done, Running_subjects& running)
      : Working_batch(campaign, batch, done, campaign.contact_subjects), running_(running)
  {}

  Findings judge()
  {
    for_wanted([this](std::uint64_t k) {
      const Object_case c = batch_.family->object_case(seed_, k);
      if (c.a->face_count() <= most_faces && c.b->face_count() <= most_faces) judge(c, k);
    });
    return finish();
  }

 private:
  void judge(const Object_case& c, std::uint64_t k)
  {
    const Contact_forms truth = true_contacts(c);
    if (wanted_.truth(k)) found_.add_truth(question, !truth.empty(), false);
    const Distance away = distance(c);
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      if (!wanted_.subject(s, k)) continue;
      running_[s]->forget();
      const Listed_contacts listed = running_[s]->contacts(c);
      Findings::Answer answer{{}, listed.outcome == Outcome::not_asked};
      if (listed.outcome == Outcome::yes) answer.value = as_number(listed.forms, truth);
      if (listed.outcome == Outcome::failed) found_.add_failure(subjects_[s].name, question, k, running_[s]->failure());
      found_.add_answer(subjects_[s].name, question, kind_of(c, away), int(truth.size()), answer, running_[s]->spent());
      if (!answer.not_asked && answer.value != int(truth.size()) && k < kept_one_by_one)
        found_.add_wrong(c.origin, subjects_[s].name, question, away, int(truth.size()), answer, {});
      if (listed.outcome == Outcome::yes && k % relation_stride == 0) try_relations(c, s, listed.forms);
    }
  }

  void try_relations(const Object_case& c, std::size_t s, const Contact_forms& given)
  {
    for (const Contact_relation& relation : contact_relations()) {
      const Verdict verdict = relation.check(c, *running_[s], given);
      found_.add_relation(std::string(relation.name), subjects_[s].name, question, verdict != Verdict::not_applicable,
                          verdict == Verdict::violated);
    }
  }

  static constexpr const char* question = "contacts";
  Running_subjects& running_;
};

template <class Subject>
auto make_running(const std::vector<Subject>& subjects)
{
  std::vector<decltype(subjects[0].make())> running;
  for (const Subject& subject : subjects) running.push_back(subject.make());
  return running;
}

}  // namespace

Batch_judge::Batch_judge(const Campaign& campaign, const Done& done)
    : campaign_(campaign),
      done_(done),
      colliding_([&campaign] { return make_running(campaign.object_subjects); }),
      listing_([&campaign] { return make_running(campaign.feature_subjects); }),
      locating_([&campaign] { return make_running(campaign.contact_subjects); }),
      measuring_([&campaign] { return make_running(campaign.distance_subjects); }),
      placing_([&campaign] { return make_running(campaign.point_subjects); }),
      casting_([&campaign] { return make_running(campaign.ray_subjects); }),
      playing_([&campaign] { return make_running(campaign.scene_subjects); }),
      following_([&campaign] { return make_running(campaign.motion_subjects); })
{}

Findings Batch_judge::operator()(const Batch& batch)
{
  switch (batch.what) {
    case Asked_for::predicates: return Predicate_batch(campaign_, batch, done_).judge();
    case Asked_for::collision: return Object_batch(campaign_, batch, done_, colliding_.local()).judge();
    case Asked_for::features: return Feature_batch(campaign_, batch, done_, listing_.local()).judge();
    case Asked_for::contacts: return Contact_batch(campaign_, batch, done_, locating_.local()).judge();
    case Asked_for::distances: return judge_distances(campaign_, batch, done_, measuring_.local());
    case Asked_for::points: return judge_points(campaign_, batch, done_, placing_.local());
    case Asked_for::rays: return judge_rays(campaign_, batch, done_, casting_.local());
    case Asked_for::scenes: return judge_scenes(campaign_, batch, done_, playing_.local());
    case Asked_for::motions: break;
  }
  return judge_motions(campaign_, batch, done_, following_.local());
}

}  // namespace tetracone::verify
