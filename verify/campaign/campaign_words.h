#ifndef TETRACONE_VERIFY_CAMPAIGN_CAMPAIGN_WORDS_H
#define TETRACONE_VERIFY_CAMPAIGN_CAMPAIGN_WORDS_H

#include "verify/campaign/campaign.h"
#include "verify/campaign/database.h"

#include <cstdint>
#include <filesystem>
#include <vector>

/// The command lines that made a database's rows: the parts that shards of one campaign have in common, and the
/// progress of each.
namespace tetracone::verify {

/// Records the questions about to be asked, with `answers` as their number including the truth's, and the commands of
/// the external subjects. Throws covering::Input_error, and changes nothing, when the database knows such a subject by
/// another command, or by another hello or other files.
void record_words(Database& database, const Campaign& campaign, std::uint64_t answers);

/// Throws covering::Input_error when two campaigns differ in more than their shards: version, seed, cases, frames,
/// families, subjects and their commands, real meshes, number of shards. The two are those of `into`, if it has any,
/// and of the database attached to it as `other`, which is the file `from`.
void refuse_other_words(Database& into, const std::filesystem::path& from);

/// The progress of the campaign that a database was last asked for.
struct Campaign_progress {
  std::vector<int> begun;      ///< the shards with some rows in the database, in order
  int shards = 1;              ///< the number of all shards
  std::uint64_t done = 0;      ///< number of answers, including the truth's
  std::uint64_t of_begun = 0;  ///< number of answers of the begun shards when they are complete
};

/// Returns the progress. Throws covering::Input_error when nothing was ever asked.
Campaign_progress progress(Database& database);

}  // namespace tetracone::verify

#endif
