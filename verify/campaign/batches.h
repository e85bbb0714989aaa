#ifndef TETRACONE_VERIFY_CAMPAIGN_BATCHES_H
#define TETRACONE_VERIFY_CAMPAIGN_BATCHES_H

#include "verify/campaign/campaign.h"
#include "verify/campaign/database.h"
#include "verify/families/sequences.h"

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace tetracone::verify {

/// The truth's name among the subjects.
inline constexpr const char* truth_name = "truth";

/// The question that a case is asked. For two bodies: its predicates, whether they collide, which features meet, where
/// faces meet, how far apart they are. For a body: where its point is, and which faces its ray meets. For more: which
/// of many bodies collide, and when two moving ones first meet.
enum class Asked_for { predicates, collision, features, contacts, distances, points, rays, scenes, motions };

/// Returns the level's name in the database.
constexpr const char* level_name(Asked_for what)
{
  switch (what) {
    case Asked_for::predicates: return "predicate";
    case Asked_for::collision: return "object";
    case Asked_for::features: return "features";
    case Asked_for::contacts: return "contacts";
    case Asked_for::distances: return "distances";
    case Asked_for::points: return "points";
    case Asked_for::rays: return "rays";
    case Asked_for::scenes: return "scenes";
    case Asked_for::motions: break;
  }
  return "motions";
}

/// The unit of work: the cases first to last - 1 of a family, or one sequence.
struct Batch {
  Asked_for what;
  const Family* family;
  const Sequence* sequence;  // instead of a family
  std::uint64_t number, first, last;
  const Probe_family* probes = nullptr;  // instead of a family, or these
  const Scene_family* scenes = nullptr;
  const Moving_body_family* motions = nullptr;

  std::string family_name() const
  {
    if (sequence) return "sequence " + sequence->name;
    return std::string(probes ? probes->name : scenes ? scenes->name : motions ? motions->name : family->name);
  }
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
    const auto found = cases_.find({level_name(batch.what), batch.family_name(), batch.number, subject});
    return batch.first + (found == cases_.end() ? 0 : found->second);
  }

 private:
  std::map<std::tuple<std::string, std::string, std::uint64_t, std::string>, std::uint64_t> cases_;
};

}  // namespace tetracone::verify

#endif
