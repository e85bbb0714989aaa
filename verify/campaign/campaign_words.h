#ifndef TETRACONE_VERIFY_CAMPAIGN_CAMPAIGN_WORDS_H
#define TETRACONE_VERIFY_CAMPAIGN_CAMPAIGN_WORDS_H

#include "verify/campaign/campaign.h"
#include "verify/campaign/database.h"

#include <cstdint>
#include <filesystem>
#include <vector>

/// The words that a database's rows were asked for: what shards of one campaign have in common, and how far each is.
namespace tetracone::verify {

/// Records what is about to be asked, `answers` in all, the truth's included, and the commands of the subjects that are
/// somebody else's programs. Throws covering::Input_error, and changes nothing, when the database knows such a subject
/// by another command.
void record_words(Database& database, const Campaign& campaign, std::uint64_t answers);

/// Throws covering::Input_error when the campaigns of `into`, if it has any, and of the database attached to it as
/// `other`, which is the file `from`, differ in more than their shards: version, seed, cases, frames, families,
/// subjects and their commands, real meshes, number of shards.
void refuse_other_words(Database& into, const std::filesystem::path& from);

/// How far the campaign is that a database was last asked for.
struct Campaign_progress {
  std::vector<int> begun;      ///< its shards that the database has something of, in order
  int shards = 1;              ///< of how many
  std::uint64_t done = 0;      ///< answers, the truth's included
  std::uint64_t of_begun = 0;  ///< answers that the shards begun have in all
};

/// Throws covering::Input_error when nothing was ever asked.
Campaign_progress progress(Database& database);

}  // namespace tetracone::verify

#endif
