#ifndef TETRACONE_VERIFY_CAMPAIGN_BATCH_PARTS_H
#define TETRACONE_VERIFY_CAMPAIGN_BATCH_PARTS_H

#include "verify/campaign/batches.h"
#include "verify/campaign/findings.h"
#include "verify/cases/random.h"
#include "verify/subjects/spent.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// The parts that judges of all levels have in common.
namespace tetracone::verify {

/// Every such case is tried with one relation, each of them in turn; lists are tried with all relations at once.
inline constexpr std::uint64_t relation_stride = 4;

/// The subjects that have not been asked all cases of a batch before; the truth is one of them.
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

  /// Records the cases now asked of each subject. Call it when the batch is done.
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

/// A running batch of a campaign: the subjects, the cases to ask each of them, and the findings.
template <class Subject>
class Working_batch {
 protected:
  Working_batch(const Campaign& campaign, const Batch& batch, const Done& done, const std::vector<Subject>& subjects)
      : seed_(campaign.seed),
        subjects_(subjects),
        batch_(batch),
        wanted_(batch, subjects, done),
        found_(level_name(batch.what), batch.family_name())
  {}

  /// Calls judge(k) for each case k of the batch that some subject has not been asked.
  template <class Judge>
  void for_wanted(const Judge& judge)
  {
    for (std::uint64_t k = batch_.first; k < batch_.last; ++k)
      if (wanted_.anyone(k)) judge(k);
  }

  /// Returns the findings and the numbers of asked cases. Call it once, last.
  Findings finish()
  {
    wanted_.add_done(found_);
    return std::move(found_);
  }

  std::uint64_t seed_;
  const std::vector<Subject>& subjects_;
  const Batch& batch_;
  Wanted wanted_;
  Findings found_;
};

/// The kind by which a case of two placed bodies, or of points under two poses, is counted.
template <class Case>
Findings::Kind kind_of(const Case& c, const Distance& away)
{
  return {away, c.pose_a.is_rational() || c.pose_b.is_rational()};
}

inline std::string name_of(kernel::Question question) { return std::string(kernel::to_string(question)); }

inline Random random_of(const Origin& origin, std::size_t relation)
{
  return Random(origin.seed * 1'000'003 + origin.index * 101 + relation);
}

}  // namespace tetracone::verify

#endif
