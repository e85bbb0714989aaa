#ifndef TETRACONE_VERIFY_CAMPAIGN_BATCHES_H
#define TETRACONE_VERIFY_CAMPAIGN_BATCHES_H

#include "verify/campaign/campaign.h"
#include "verify/campaign/database.h"
#include "verify/families/sequences.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace tetracone::verify {

/// The truth's name among the subjects.
inline constexpr const char* truth_name = "truth";

/// The unit of work: the cases first to last - 1 of a family, or one sequence.
struct Batch {
  std::string_view level;        ///< the level's name
  std::string family;            ///< its name in the database
  std::size_t number_of_family;  ///< among the level's families in the campaign
  const Sequence* sequence;      ///< instead of a family; may be null
  std::uint64_t number, first, last;
};

/// Returns the batches of this campaign's shard, in the order in which they are asked.
std::vector<Batch> batches(const Campaign& campaign, const std::vector<Sequence>& sequences);

/// Returns the number of answers of all subjects and of the truth to these batches.
std::uint64_t answer_count(const Campaign& campaign, const std::vector<Batch>& batches);

/// Returns the campaign's sequences of exact contact.
std::vector<Sequence> sequences_of(const Campaign& campaign);

/// The cases of a seed that are already in the database, by batch and subject.
class Done {
 public:
  Done(Database& database, std::uint64_t seed)
  {
    Database::Statement rows(database, "SELECT level, family, batch, subject, cases FROM done WHERE seed = ?1");
    for (rows.with(seed); rows.next();)
      cases_[{rows.text(0), rows.text(1), std::uint64_t(rows.integer(2)), rows.text(3)}] =
          std::uint64_t(rows.integer(4));
  }

  /// Returns the first case of the batch that the subject has not been asked.
  std::uint64_t next(const Batch& batch, const std::string& subject) const
  {
    const auto found = cases_.find({std::string(batch.level), batch.family, batch.number, subject});
    return batch.first + (found == cases_.end() ? 0 : found->second);
  }

 private:
  std::map<std::tuple<std::string, std::string, std::uint64_t, std::string>, std::uint64_t> cases_;
};

}  // namespace tetracone::verify

#endif
