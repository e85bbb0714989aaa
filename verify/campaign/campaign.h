#ifndef TETRACONE_VERIFY_CAMPAIGN_CAMPAIGN_H
#define TETRACONE_VERIFY_CAMPAIGN_CAMPAIGN_H

#include "verify/campaign/database.h"
#include "verify/campaign/levels.h"
#include "verify/campaign/truths_disagree.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <tuple>

namespace tetracone::verify {

/// The origin of a row.
struct Provenance {
  std::string version, compiler, flags, processor;
  std::string again = {};  ///< the command line that repeats the whole campaign, without its database
};

/// The cases of a campaign and the subjects that are asked them.
struct Campaign : Sizes {
  std::uint64_t seed = 1;
  int sequence_frames = 16;   ///< of each exact sequence, which the level `Objects` asks; 0: none
  int shard = 0, shards = 1;  ///< this process does each `shards`-th batch, from `shard`
  For_levels<Asked> levels;
  Provenance made_by;

  template <class Level>
  Asked<Level>& at()
  {
    return std::get<Asked<Level>>(levels);
  }
  template <class Level>
  const Asked<Level>& at() const
  {
    return std::get<Asked<Level>>(levels);
  }
};

/// Returns the number of cases of the campaign, including those already in the database.
std::uint64_t case_count(const Campaign& campaign);

/// Judges all subjects on all cases, on all cores, and adds the findings to the database (schema: campaign_schema.h).
/// It resumes. Cases of this seed that are in the database are not asked again. That is so after a stop or a kill, with
/// more cases or with other subjects. The rows depend on the campaign only, not on threads, shards or interruptions,
/// except in the table `time`, and unless a program is too slow. `done` is called with the number of cases just done or
/// found, from several threads, one at a time. Throws Truths_disagree; covering::Input_error when the database cannot
/// be used, or knows a subject by another command or program.
void run_campaign(Database& database, const Campaign& campaign, const std::function<void(std::uint64_t)>& done);

/// Opens a campaign's database for writing; creates it if it does not exist. Throws covering::Input_error, and changes
/// nothing, when the file is something else, or has the tables of another version.
Database open_campaign(const std::filesystem::path& file);

/// Throws covering::Input_error when the file is no database of a campaign, or has the tables of another version.
void require_campaign(const std::filesystem::path& file);

/// Adds the rows of `from`, a shard of the same campaign, to `into`; nothing if `into` has them all. Throws
/// covering::Input_error, and changes nothing, when the two were made by different command lines (campaign_words.h) or
/// when `from` has the tables of another version. It throws too when `into` has a part of the shard: an earlier state
/// of it.
void merge(Database& into, const std::filesystem::path& from);

}  // namespace tetracone::verify

#endif
