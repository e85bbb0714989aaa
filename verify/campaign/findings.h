#ifndef TETRACONE_VERIFY_CAMPAIGN_FINDINGS_H
#define TETRACONE_VERIFY_CAMPAIGN_FINDINGS_H

#include "verify/campaign/database.h"
#include "verify/cases/case.h"
#include "verify/integer_truth/distance_to_degeneracy.h"
#include "verify/subjects/blame.h"
#include "verify/subjects/object_subject.h"
#include "verify/subjects/spent.h"

#include <cmath>
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace tetracone::verify {

/// What an answer says of one question, as it is counted.
struct Statement {
  std::string question;
  int truth;
  std::optional<int> value{};            ///< nothing where the subject failed
  Distance away = {HUGE_VAL, HUGE_VAL};  ///< of the case to degeneracy
  bool has_fractions = false;            ///< an entry of the case's poses is no double
  std::optional<Stage> stage{};          ///< that made the answer wrong
  std::optional<int> rounded_truth{};    ///< of the input in floats, where the subject holds it so
};

/// The results of a batch of cases, stored in the database as one transaction. Members are named after its tables.
class Findings {
 public:
  Findings(std::string level, std::string family) : level_(std::move(level)), family_(std::move(family)) {}

  void add_truth(const std::string& question, bool positive, bool by_construction);
  /// `is_asked`: false if the subject declines; `spent`: nothing if the subject's own time is not known.
  void add_answer(const std::string& subject, const Statement& statement, bool is_asked,
                  const std::optional<Spent>& spent);
  void add_wrong(const Origin& origin, const std::string& subject, const Statement& statement);
  /// Adds the traces of a subject that failed on the case with this number.
  void add_failure(const std::string& subject, const std::string& question, std::uint64_t number,
                   const Failure& failure);
  /// Adds a question that the subject was not asked.
  void add_declined(const Origin& origin, const std::string& subject, const std::string& question,
                    const std::string& why);
  /// Adds lines of the subject that are no answers.
  void add_skipped(const std::string& subject, std::uint64_t lines) { skipped_[subject] += std::int64_t(lines); }
  void add_blame(const std::string& subject, const std::string& question, Stage stage);
  void add_relation(const std::string& relation, const std::string& subject, const std::string& question,
                    bool applicable, bool violated);
  void add_flips(const std::string& subject, const std::string& question, int frames, int wrong, int changes,
                 int true_changes);

  /// Records that the subject has been asked `cases` more cases of the batch.
  void add_done(const std::string& subject, std::uint64_t cases) { done_[subject] += cases; }

  /// Adds everything to the tables. Call within a transaction.
  void store(Database& database, std::int64_t run, std::uint64_t seed, std::uint64_t batch) const;

 private:
  using Asked = std::pair<std::string, std::string>;  // subject or relation, question
  struct Tally {
    std::int64_t n = 0, false_positives = 0, false_negatives = 0, failures = 0, not_asked = 0;
  };
  struct Truth {
    std::int64_t n = 0, positives = 0, by_construction = 0;
  };
  struct Tried {
    std::int64_t tried = 0, violated = 0, not_applicable = 0;
  };
  struct Rounded {
    std::int64_t n = 0, changed = 0, wrong = 0, excused = 0, false_positives = 0, false_negatives = 0;
  };
  struct Time {
    std::int64_t n = 0, nanoseconds = 0;
    std::optional<std::int64_t> making;
  };
  struct Place {
    std::string axis;
    int bin;
    bool has_fractions;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  struct Flips {
    std::int64_t frames = 0, wrong = 0, changes = 0, true_changes = 0;
  };
  struct Failures {
    std::int64_t n = 0;
    std::uint64_t first = 0;  // the number of the case
    std::string said;         // then
  };
  struct Wrong {
    Origin origin;
    std::string subject;
    Statement statement;
  };

  struct Declined {
    std::uint64_t number;
    std::string subject, question, why;
  };

  std::string level_, family_;
  std::map<std::string, Truth> truth_;
  std::map<std::pair<Asked, Place>, Tally> tally_;
  std::map<std::pair<Asked, int>, Rounded> rounded_;  // the bin of ulps
  std::map<Asked, Time> time_;
  std::map<std::pair<Asked, std::string>, std::int64_t> blame_;
  std::map<std::tuple<std::string, std::string, std::string>, Tried> relation_;  // relation, subject, question
  std::map<Asked, Flips> flips_;
  std::map<std::pair<Asked, std::string>, Failures> failures_;  // how
  std::vector<Wrong> wrong_;
  std::vector<Declined> declined_;
  std::map<std::string, std::int64_t> skipped_;
  std::map<std::string, std::uint64_t> done_;
};

}  // namespace tetracone::verify

#endif
