#include "verify/campaign/findings.h"

#include "verify/campaign/campaign_schema.h"

#include <algorithm>
#include <cmath>

namespace tetracone::verify {
namespace {

constexpr const char *on_rho = "rho", *on_ulps = "ulps";

int bin(double log2)
{
  if (log2 == -HUGE_VAL) return exactly_degenerate;
  if (log2 == HUGE_VAL) return not_near;
  return int(std::floor(std::clamp(log2, -4000.0, 4000.0)));
}

}  // namespace

void Findings::add_truth(const std::string& question, bool positive, bool by_construction)
{
  Truth& truth = truth_[question];
  ++truth.n;
  truth.positives += positive;
  truth.by_construction += by_construction;
}

void Findings::add_answer(const std::string& subject, const Statement& statement, bool is_asked,
                          const std::optional<Spent>& spent)
{
  const Asked asked{subject, statement.question};
  const auto& [question, truth, value, away, has_fractions, stage, rounded_truth] = statement;
  for (const auto& [axis, log2] : {std::pair{on_rho, away.log2_rho}, {on_ulps, away.log2_ulps}}) {
    Tally& tally = tally_[{asked, {axis, bin(log2), has_fractions}}];
    tally.not_asked += !is_asked;
    if (!is_asked) continue;
    ++tally.n;
    tally.failures += !value;
    tally.false_positives += value && *value > truth;
    tally.false_negatives += value && *value < truth;
  }
  if (is_asked && value && rounded_truth) {
    Rounded& rounded = rounded_[{asked, bin(away.log2_ulps)}];
    ++rounded.n;
    rounded.changed += *rounded_truth != truth;
    rounded.wrong += *value != truth;
    rounded.excused += *value != truth && *value == *rounded_truth;
    rounded.false_positives += *value > *rounded_truth;
    rounded.false_negatives += *value < *rounded_truth;
  }
  if (!is_asked || !spent) return;
  Time& time = time_[asked];
  ++time.n;
  time.nanoseconds += std::int64_t(spent->asking);
  if (spent->making) time.making = time.making.value_or(0) + std::int64_t(*spent->making);
}

void Findings::add_wrong(const Origin& origin, const std::string& subject, const Statement& statement)
{
  wrong_.push_back({origin, subject, statement});
}

void Findings::add_declined(const Origin& origin, const std::string& subject, const std::string& question,
                            const std::string& why)
{
  declined_.push_back({origin.index, subject, question, why});
}

void Findings::add_failure(const std::string& subject, const std::string& question, std::uint64_t number,
                           const Failure& failure)
{
  Failures& failures = failures_[{{subject, question}, failure.how}];
  if (failures.n++ > 0) return;
  failures.first = number;
  failures.said = failure.said;
}

void Findings::add_blame(const std::string& subject, const std::string& question, Stage stage)
{
  ++blame_[{{subject, question}, to_string(stage)}];
}

void Findings::add_relation(const std::string& relation, const std::string& subject, const std::string& question,
                            bool applicable, bool violated)
{
  Tried& tried = relation_[{relation, subject, question}];
  tried.not_applicable += !applicable;
  tried.tried += applicable;
  tried.violated += violated;
}

void Findings::add_flips(const std::string& subject, const std::string& question, int frames, int wrong, int changes,
                         int true_changes)
{
  flips_[{subject, question}] = {frames, wrong, changes, true_changes};
}

void Findings::store(Database& database, std::int64_t run, std::uint64_t seed, std::uint64_t batch) const
{
  using Sql = Database::Statement;
  Sql truth(database, insertion("truth", 7));
  for (const auto& [question, t] : truth_)
    truth.run(run, level_, family_, question, t.n, t.positives, t.by_construction);

  Sql tally(database, insertion("tally", 13));
  for (const auto& [key, t] : tally_) {
    const auto& [asked, place] = key;
    tally.run(run, level_, family_, asked.first, asked.second, place.has_fractions ? with_fractions : of_doubles,
              place.axis, place.bin, t.n, t.false_positives, t.false_negatives, t.failures, t.not_asked);
  }

  Sql rounded(database, insertion("rounded", 12));
  for (const auto& [key, r] : rounded_)
    rounded.run(run, level_, family_, key.first.first, key.first.second, key.second, r.n, r.changed, r.wrong, r.excused,
                r.false_positives, r.false_negatives);

  // -1 stands for NULL where the time of making is unknown.
  Sql time(database, "INSERT INTO time VALUES (?1, ?2, ?3, ?4, ?5, ?6, nullif(?7, -1), ?8)" + on_conflict("time"));
  for (const auto& [asked, t] : time_)
    time.run(run, level_, family_, asked.first, asked.second, t.n, t.making.value_or(-1), t.nanoseconds);

  Sql blame(database, insertion("blame", 7));
  for (const auto& [key, n] : blame_) blame.run(run, level_, family_, key.first.first, key.first.second, key.second, n);

  Sql relation(database, insertion("relation", 9));
  for (const auto& [key, t] : relation_) {
    const auto& [name, subject, question] = key;
    relation.run(run, level_, family_, name, subject, question, t.tried, t.violated, t.not_applicable);
  }

  Sql flips(database, "INSERT OR REPLACE INTO flips VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)");
  for (const auto& [asked, f] : flips_)
    flips.run(run, family_, asked.first, asked.second, f.frames, f.wrong, f.changes, f.true_changes);

  Sql failure(database, insertion("failure", 9));
  for (const auto& [key, f] : failures_)
    failure.run(run, level_, family_, key.first.first, key.first.second, key.second, f.n, f.first, f.said);

  // A failure has no answer: NULL.
  Sql wrong(database,
            "INSERT OR REPLACE INTO wrong VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, nullif(?9, 99), ?10, ?11, ?12)");
  for (const auto& [origin, subject, w] : wrong_)
    wrong.run(run, level_, family_, origin.index, origin.parameter, subject, w.question, w.truth, w.value.value_or(99),
              w.away.log2_rho, w.away.log2_ulps, w.stage ? to_string(*w.stage) : "");

  Sql declined(database, "INSERT OR REPLACE INTO declined VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)");
  for (const auto& [number, subject, question, why] : declined_)
    declined.run(run, level_, family_, number, subject, question, why);

  Sql skipped(database, insertion("skipped", 5));
  for (const auto& [subject, n] : skipped_)
    if (n > 0) skipped.run(run, level_, family_, subject, n);

  Sql done(database, insertion("done", 6));
  for (const auto& [subject, cases] : done_) done.run(seed, level_, family_, batch, subject, cases);
}

}  // namespace tetracone::verify
