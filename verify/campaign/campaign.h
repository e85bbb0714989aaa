#ifndef TETRACONE_VERIFY_CAMPAIGN_CAMPAIGN_H
#define TETRACONE_VERIFY_CAMPAIGN_CAMPAIGN_H

#include "verify/campaign/database.h"
#include "verify/cases/case.h"
#include "verify/cases/probe_case.h"
#include "verify/families/families.h"
#include "verify/families/moving_body_families.h"
#include "verify/families/probe_families.h"
#include "verify/families/scene_families.h"
#include "verify/subjects/moving_bodies_subject.h"
#include "verify/subjects/object_subject.h"
#include "verify/subjects/predicate_subject.h"
#include "verify/subjects/probe_subject.h"
#include "verify/subjects/scene_subject.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace tetracone::verify {

/// The origin of a row.
struct Provenance {
  std::string version, compiler, flags, processor;
  std::string again = {};  ///< the command line that repeats the whole campaign, without its database
};

/// The cases of a campaign and the subjects that are asked them. Default sizes take a few minutes on two cores.
struct Campaign {
  std::uint64_t seed = 1;
  std::uint64_t predicate_cases = 400, object_cases = 24, feature_cases = 6;  ///< per family; 0 skips the level
  std::uint64_t probe_cases = 64;                                             ///< per family of points and of rays
  bool lists_features = true;  ///< of feature_cases; if false, only contacts, distances, scenes and motions are asked
  int sequence_frames = 16;    ///< of each exact sequence; 0: none
  int shard = 0, shards = 1;   ///< this process does each `shards`-th batch, from `shard`
  std::vector<const Family*> families;
  std::vector<const Family*> distance_families;  ///< asked for distances only
  std::vector<const Probe_family*> point_families, ray_families;
  std::vector<const Scene_family*> scene_families;         ///< of feature_cases
  std::vector<const Moving_body_family*> motion_families;  ///< of feature_cases
  std::vector<Predicate_subject> predicate_subjects;
  std::vector<Object_subject> object_subjects, feature_subjects, contact_subjects, distance_subjects;
  std::vector<Probe_subject> point_subjects, ray_subjects;
  std::vector<Scene_subject> scene_subjects;
  std::vector<Moving_bodies_subject> motion_subjects;
  Provenance made_by;
};

/// Thrown when the two truths, or a truth and a family's known answer, differ for one case. One of them is wrong, and
/// no result of the campaign could be trusted.
class Truths_disagree : public std::runtime_error {
 public:
  Truths_disagree(const std::string& what, Object_case c, kernel::Question question)
      : std::runtime_error(what), object(std::move(c)), question(question)
  {}
  Truths_disagree(const std::string& what, const Probe_case& c)
      : Truths_disagree(what, as_objects(c), kernel::Question::surface)
  {}
  Truths_disagree(const std::string& what, Predicate_case c, Predicate predicate)
      : std::runtime_error(what), points(std::move(c)), predicate(predicate)
  {}

  std::optional<Object_case> object;
  kernel::Question question = kernel::Question::solid;
  std::optional<Predicate_case> points;
  Predicate predicate = Predicate::orientation;
};

/// Returns the number of cases of the campaign, including those already in the database.
std::uint64_t case_count(const Campaign& campaign);

/// Judges all subjects on all cases, on all cores, and adds the findings to the database (schema: campaign_schema.h).
/// It resumes: cases of this seed that are in the database are not asked again, after a stop or a kill, with more cases
/// or with other subjects. The rows depend on the campaign only, not on threads, shards or interruptions, except in the
/// table `time`. `done` is called with the number of cases just done or found, from several threads, one at a time.
/// Throws Truths_disagree; covering::Input_error when the database cannot be used, or knows a subject by another
/// command.
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
