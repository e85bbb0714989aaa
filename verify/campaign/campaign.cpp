#include "verify/campaign/campaign.h"

#include "tetracone/covering/io/input_error.h"
#include "verify/campaign/campaign_schema.h"
#include "verify/campaign/campaign_words.h"
#include "verify/campaign/findings.h"
#include "verify/cases/shape_library.h"
#include "verify/families/sequences.h"
#include "verify/relations/metamorphic_relations.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/distance_to_degeneracy.h"
#include "verify/truth/integer_features.h"
#include "verify/truth/integer_truth.h"
#include "verify/truth/predicate_truth.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

namespace tetracone::verify {
namespace {

using kernel::Question;

constexpr std::uint64_t predicate_batch = 200, object_batch = 10, feature_batch = 3;
constexpr std::uint64_t relation_stride = 4;  // each such case is tried with one relation, all of them in turn
constexpr const char* truth_name = "truth";
constexpr std::array questions = {Question::surface, Question::solid};

std::string name_of(Question question) { return std::string(kernel::to_string(question)); }

/// What is asked of a case: its predicates, whether its bodies collide, which of their features meet.
enum class Asked_for { predicates, collision, features };

/// The name of that in the database.
constexpr const char* level_name(Asked_for what)
{
  switch (what) {
    case Asked_for::predicates: return "predicate";
    case Asked_for::collision: return "object";
    case Asked_for::features: break;
  }
  return "features";
}

/// Unit of work: the cases first to last - 1 of a family, or one sequence.
struct Batch {
  Asked_for what;
  const Family* family;
  const Sequence* sequence;  // instead of a family
  std::uint64_t number, first, last;

  std::string family_name() const { return sequence ? "sequence " + sequence->name : std::string(family->name); }
};

/// Number of the relation that case k is tried with, modulo their count: each family begins with another one.
std::size_t relation_turn(const Batch& batch, std::uint64_t k)
{
  return k / relation_stride + std::size_t(batch.family->number);
}

std::vector<Batch> batches(const Campaign& campaign, const std::vector<Sequence>& sequences)
{
  std::vector<Batch> all;
  const auto add = [&](Asked_for what, const Family* family, std::uint64_t cases, std::uint64_t size) {
    for (std::uint64_t number = 0; number * size < cases; ++number)
      if (int((family->number + number) % std::uint64_t(campaign.shards)) == campaign.shard)
        all.push_back({what, family, nullptr, number, number * size, std::min(cases, (number + 1) * size)});
  };
  for (const Family* family : campaign.families)
    add(Asked_for::predicates, family, campaign.predicate_cases, predicate_batch);
  for (const Family* family : campaign.families) add(Asked_for::collision, family, campaign.object_cases, object_batch);
  for (const Family* family : campaign.families)
    add(Asked_for::features, family, campaign.feature_cases, feature_batch);
  for (std::size_t k = 0; k < sequences.size(); ++k)
    if (int(k % std::size_t(campaign.shards)) == campaign.shard)
      all.push_back({Asked_for::collision, nullptr, &sequences[k], 0, 0, sequences[k].frames.size()});
  return all;
}

std::size_t subject_count(const Campaign& campaign, Asked_for what)
{
  switch (what) {
    case Asked_for::predicates: return campaign.predicate_subjects.size();
    case Asked_for::collision: return campaign.object_subjects.size();
    case Asked_for::features: break;
  }
  return campaign.feature_subjects.size();
}

/// Answers of all subjects and of the truth to these batches.
std::uint64_t answer_count(const Campaign& campaign, const std::vector<Batch>& batches)
{
  std::uint64_t count = 0;
  for (const Batch& batch : batches) count += (batch.last - batch.first) * (1 + subject_count(campaign, batch.what));
  return count;
}

std::vector<Sequence> sequences_of(const Campaign& campaign)
{
  if (campaign.sequence_frames == 0) return {};
  return sequences(campaign.seed, campaign.sequence_frames);
}

/// Cases of a seed that are in the database already, by batch and subject.
class Done {
 public:
  Done(Database& database, std::uint64_t seed)
  {
    Database::Statement rows(database, "SELECT level, family, batch, subject, cases FROM done WHERE seed = ?1");
    for (rows.with(seed); rows.next();)
      cases_[{rows.text(0), rows.text(1), std::uint64_t(rows.integer(2)), rows.text(3)}] =
          std::uint64_t(rows.integer(4));
  }

  /// The first case of the batch that the subject has not been asked.
  std::uint64_t next(const Batch& batch, const std::string& subject) const
  {
    const auto found = cases_.find({level_name(batch.what), batch.family_name(), batch.number, subject});
    return batch.first + (found == cases_.end() ? 0 : found->second);
  }

 private:
  std::map<std::tuple<std::string, std::string, std::uint64_t, std::string>, std::uint64_t> cases_;
};

/// Subjects that have not been asked all cases of a batch before; the truth is one of them.
class Wanted {
 public:
  template <class Subject>
  Wanted(const Batch& batch, const std::vector<Subject>& subjects, const Done& done) : last_(batch.last)
  {
    for (const Subject& subject : subjects) names_.push_back(subject.name);
    names_.push_back(truth_name);
    for (const std::string& name : names_) next_.push_back(done.next(batch, name));
  }

  bool subject(std::size_t s, std::uint64_t k) const { return next_[s] <= k; }
  bool truth(std::uint64_t k) const { return next_.back() <= k; }
  bool anyone(std::uint64_t k) const
  {
    return std::ranges::any_of(next_, [k](std::uint64_t next) { return next <= k; });
  }

  /// Records for each the cases asked now. Call when the batch is done.
  void add_done(Findings& found) const
  {
    for (std::size_t s = 0; s < names_.size(); ++s)
      if (next_[s] < last_) found.add_done(names_[s], last_ - next_[s]);
  }

 private:
  std::vector<std::string> names_;   // the truth's is the last
  std::vector<std::uint64_t> next_;  // the first case that each has not been asked
  std::uint64_t last_;
};

/// Calls what() and returns its result and the nanoseconds that it took.
template <class What>
auto timed(const What& what)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  auto result = what();
  return std::pair(std::move(result),
                   std::uint64_t(std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count()));
}

Random random_of(const Origin& origin, std::size_t relation)
{
  return Random(origin.seed * 1'000'003 + origin.index * 101 + relation);
}

// --- predicates -----------------------------------------------------------------------------------------------------

std::optional<int> truth_of(const Predicate_case& c, Predicate predicate)
{
  const auto first = true_answer(predicate, c), second = integer_truth::answer(predicate, c);
  if (first != second) throw Truths_disagree("the two truths of a predicate disagree", c, predicate);
  return first;
}

/// A batch of predicate cases at work.
class Predicate_batch {
 public:
  Predicate_batch(const Campaign& campaign, const Batch& batch, const Done& done)
      : seed_(campaign.seed),
        subjects_(campaign.predicate_subjects),
        batch_(batch),
        wanted_(batch, subjects_, done),
        found_(level_name(batch.what), batch.family_name())
  {}

  Findings judge()
  {
    for (std::uint64_t k = batch_.first; k < batch_.last; ++k) {
      if (!wanted_.anyone(k)) continue;
      const Predicate_case c = batch_.family->predicate_case(seed_, k);
      for (const Predicate predicate : all_predicates) judge_answers(c, k, predicate);
      if (k % relation_stride == 0) try_relation(c, k);
    }
    wanted_.add_done(found_);
    return std::move(found_);
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
      found_.add_answer(subjects_[s].name, question, away, *truth, answer, ns);
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

  std::uint64_t seed_;
  const std::vector<Predicate_subject>& subjects_;
  const Batch& batch_;
  Wanted wanted_;
  Findings found_;
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

/// All subjects of a campaign, running in one thread.
using Running_subjects = std::vector<std::unique_ptr<Running_subject>>;

Running_subjects make_running(const std::vector<Object_subject>& subjects)
{
  Running_subjects running;
  for (const Object_subject& subject : subjects) running.push_back(subject.make());
  return running;
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

/// A batch of object cases, or a sequence, at work.
class Object_batch {
 public:
  Object_batch(const Campaign& campaign, const Batch& batch, const Done& done, Running_subjects& running)
      : seed_(campaign.seed),
        subjects_(campaign.object_subjects),
        running_(running),
        batch_(batch),
        wanted_(batch, subjects_, done),
        found_(level_name(batch.what), batch.family_name())
  {}

  Findings judge()
  {
    for (std::uint64_t k = batch_.first; k < batch_.last; ++k)
      if (wanted_.anyone(k))
        judge(batch_.sequence ? batch_.sequence->frames[k] : batch_.family->object_case(seed_, k), k);
    if (batch_.sequence) count_flips();
    wanted_.add_done(found_);
    return std::move(found_);
  }

 private:
  /// The truth of both questions of a case.
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
    const auto [outcome, ns] = timed([&] { return (*running_[s])(c, question); });
    const Findings::Answer answer = as_answer(outcome);
    found_.add_answer(subject.name, name_of(question), away, truth, answer, ns);
    answers_[{s, question}].push_back(answer.value.value_or(-1));
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

  /// Counts how often answers change along the sequence, and how often the truth does.
  void count_flips()
  {
    for (const auto& [asked, given] : answers_) {
      const auto& [s, question] = asked;
      const std::vector<int>& right = truths_[question];
      if (given.size() != right.size()) continue;  // asked before: counted before
      found_.add_flips(subjects_[s].name, name_of(question), int(given.size()), differences(given, right),
                       changes(given), changes(right));
    }
  }

  std::uint64_t seed_;
  const std::vector<Object_subject>& subjects_;
  Running_subjects& running_;
  const Batch& batch_;
  Wanted wanted_;
  Findings found_;
  std::map<std::pair<std::size_t, Question>, std::vector<int>> answers_;  // case after case, by subject and question
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

/// A list as an answer: the number of pairs of the truth that it has, and where it has all of them, of its own.
int as_number(const Pairs& listed, const Pairs& truth)
{
  Pairs right;
  std::ranges::set_intersection(listed, truth, std::back_inserter(right));
  return int(right.size() < truth.size() ? right.size() : listed.size());
}

/// A batch of cases whose features are asked for, at work.
class Feature_batch {
 public:
  Feature_batch(const Campaign& campaign, const Batch& batch, const Done& done, Running_subjects& running)
      : seed_(campaign.seed),
        subjects_(campaign.feature_subjects),
        running_(running),
        batch_(batch),
        wanted_(batch, subjects_, done),
        found_(level_name(batch.what), batch.family_name())
  {}

  Findings judge()
  {
    for (std::uint64_t k = batch_.first; k < batch_.last; ++k)
      if (wanted_.anyone(k)) judge(batch_.family->object_case(seed_, k), k);
    wanted_.add_done(found_);
    return std::move(found_);
  }

 private:
  void judge(const Object_case& c, std::uint64_t k)
  {
    const Pairs truth = true_features(c);
    if (wanted_.truth(k)) found_.add_truth(question, !truth.empty(), false);
    const Distance away = distance(c);
    for (std::size_t s = 0; s < subjects_.size(); ++s) {
      if (!wanted_.subject(s, k)) continue;
      const auto [listed, ns] = timed([&] { return running_[s]->features(c); });
      Findings::Answer answer{{}, listed.outcome == Outcome::not_asked};
      if (listed.outcome == Outcome::yes) answer.value = as_number(listed.pairs, truth);
      found_.add_answer(subjects_[s].name, question, away, int(truth.size()), answer, ns);
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
  std::uint64_t seed_;
  const std::vector<Object_subject>& subjects_;
  Running_subjects& running_;
  const Batch& batch_;
  Wanted wanted_;
  Findings found_;
};

// --- the database ----------------------------------------------------------------------------------------------------

/// Makes all tables or none: a file with only some of them is another program's.
void make_tables(Database& database)
{
  Database::Transaction transaction(database);
  database.run(campaign_schema);
  transaction.commit();
}

void require_tables(Database& database)
{
  Database::Statement(database, "SELECT real_meshes, cases, not_asked FROM run, done, tally");
}

std::int64_t run_number(Database& database, const Campaign& campaign)
{
  const Provenance& p = campaign.made_by;
  const bool meshes = real_meshes_available();
  Database::Transaction transaction(database);
  Database::Statement(database,
                      "INSERT OR IGNORE INTO run (version, compiler, flags, processor, seed, real_meshes) VALUES (?1, "
                      "?2, ?3, ?4, ?5, ?6)")
      .run(p.version, p.compiler, p.flags, p.processor, campaign.seed, meshes);
  Database::Statement row(
      database,
      "SELECT id FROM run WHERE version = ?1 AND compiler = ?2 AND flags = ?3 AND processor = ?4 AND seed = ?5 "
      "AND real_meshes = ?6");
  row.with(p.version, p.compiler, p.flags, p.processor, campaign.seed, meshes).next();
  const std::int64_t id = row.integer(0);
  row.next();
  transaction.commit();
  return id;
}

/// The database of another campaign, as `other`, while this lives.
class Attached {
 public:
  Attached(Database& database, const std::filesystem::path& other) : database_(database)
  {
    Database::Statement(database, "ATTACH ?1 AS other").run(other.native());
  }
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;
  ~Attached()
  {
    try {
      database_.run("DETACH other");
    } catch (const covering::Input_error&) {
    }
  }

 private:
  Database& database_;
};

/// True when the attached database has no batch that `into` does not have, to the same case.
bool has_all(Database& into)
{
  return !Database::Statement(into, "SELECT 1 FROM (SELECT * FROM other.done EXCEPT SELECT * FROM main.done) LIMIT 1")
              .with()
              .next();
}

/// Throws covering::Input_error when `into` and the attached database `from` have a batch of the same cases and
/// subject.
void refuse_common_batches(Database& into, const std::filesystem::path& from)
{
  Database::Statement twice(into,
                            "SELECT level, family, batch, subject FROM done JOIN other.done USING (seed, level, "
                            "family, batch, subject) LIMIT 1");
  if (twice.with().next())
    throw covering::Input_error(from.native(), 0,
                                "batch " + twice.text(2) + " of " + twice.text(0) + " " + twice.text(1) + " asked of " +
                                    twice.text(3) + " is in " + into.file().native() + " already",
                                "expected each shard once, or a new file that takes all");
}

/// Adds all rows of the attached database, its runs renumbered.
constexpr const char* merge_attached = R"(
    INSERT OR IGNORE INTO run (version, compiler, flags, processor, seed, real_meshes)
      SELECT version, compiler, flags, processor, seed, real_meshes FROM other.run;
    CREATE TEMP TABLE renumbered AS SELECT there.id AS there, here.id AS here FROM other.run AS there
      JOIN main.run AS here USING (version, compiler, flags, processor, seed, real_meshes);
    INSERT INTO main.done SELECT * FROM other.done;
    INSERT INTO main.tally SELECT here, level, family, subject, question, axis, bin, n, false_positives, false_negatives, failures, not_asked
      FROM other.tally JOIN renumbered ON run = there WHERE true ON CONFLICT DO UPDATE SET n = n + excluded.n,
      false_positives = false_positives + excluded.false_positives, false_negatives = false_negatives + excluded.false_negatives,
      failures = failures + excluded.failures, not_asked = not_asked + excluded.not_asked;
    INSERT INTO main.truth SELECT here, level, family, question, n, positives, by_construction FROM other.truth JOIN renumbered ON run = there
      WHERE true ON CONFLICT DO UPDATE SET n = n + excluded.n, positives = positives + excluded.positives,
      by_construction = by_construction + excluded.by_construction;
    INSERT INTO main.wrong SELECT here, level, family, number, parameter, subject, question, truth, answer, log2_rho, log2_ulps, stage
      FROM other.wrong JOIN renumbered ON run = there WHERE true;
    INSERT INTO main.blame SELECT here, level, family, subject, question, stage, n FROM other.blame JOIN renumbered ON run = there
      WHERE true ON CONFLICT DO UPDATE SET n = n + excluded.n;
    INSERT INTO main.relation SELECT here, level, family, relation, subject, question, tried, violated, not_applicable
      FROM other.relation JOIN renumbered ON run = there WHERE true ON CONFLICT DO UPDATE SET tried = tried + excluded.tried,
      violated = violated + excluded.violated, not_applicable = not_applicable + excluded.not_applicable;
    INSERT INTO main.flips SELECT here, sequence, subject, question, frames, wrong, changes, true_changes
      FROM other.flips JOIN renumbered ON run = there WHERE true;
    INSERT INTO main.time SELECT here, level, family, subject, question, n, nanoseconds FROM other.time JOIN renumbered ON run = there
      WHERE true ON CONFLICT DO UPDATE SET n = n + excluded.n, nanoseconds = nanoseconds + excluded.nanoseconds;
    DROP TABLE renumbered;
  )";

}  // namespace

std::uint64_t case_count(const Campaign& campaign)
{
  std::uint64_t count = 0;
  const auto sequences = sequences_of(campaign);
  for (const Batch& batch : batches(campaign, sequences)) count += batch.last - batch.first;
  return count;
}

void run_campaign(Database& database, const Campaign& campaign, const std::function<void(std::uint64_t)>& done)
{
  const auto sequences = sequences_of(campaign);
  const auto todo = batches(campaign, sequences);
  make_tables(database);
  record_words(database, campaign, answer_count(campaign, todo));
  const std::int64_t run = run_number(database, campaign);
  const Done before(database, campaign.seed);
  tbb::enumerable_thread_specific<Running_subjects> running([&] { return make_running(campaign.object_subjects); });
  tbb::enumerable_thread_specific<Running_subjects> listing([&] { return make_running(campaign.feature_subjects); });
  const auto judged = [&](const Batch& batch) {
    switch (batch.what) {
      case Asked_for::predicates: return Predicate_batch(campaign, batch, before).judge();
      case Asked_for::collision: return Object_batch(campaign, batch, before, running.local()).judge();
      case Asked_for::features: break;
    }
    return Feature_batch(campaign, batch, before, listing.local()).judge();
  };
  std::mutex one_at_a_time;
  tbb::parallel_for_each(todo, [&](const Batch& batch) {
    const Findings found = judged(batch);
    const std::lock_guard lock(one_at_a_time);
    Database::Transaction transaction(database);
    found.store(database, run, campaign.seed, batch.number);
    transaction.commit();
    done(batch.last - batch.first);
  });
}

void require_campaign(const std::filesystem::path& file)
{
  Database database(file, Database::Mode::read);
  require_tables(database);
}

Database open_campaign(const std::filesystem::path& file)
{
  std::error_code missing;
  if (std::filesystem::file_size(file, missing) != 0 && !missing) {
    Database there(file, Database::Mode::read);
    if (Database::Statement(there, "SELECT 1 FROM sqlite_master").with().next()) require_tables(there);
  }
  return Database(file, Database::Mode::write);
}

void merge(Database& into, const std::filesystem::path& from)
{
  require_campaign(from);
  make_tables(into);
  const Attached attached(into, from);
  Database::Transaction transaction(into);
  refuse_other_words(into, from);
  if (!has_all(into)) {
    refuse_common_batches(into, from);
    into.run(merge_attached);
  }
  into.run(
      "INSERT OR IGNORE INTO main.words SELECT * FROM other.words ORDER BY rowid;"
      "INSERT OR IGNORE INTO main.command SELECT * FROM other.command");
  transaction.commit();
}

}  // namespace tetracone::verify
