#include "verify/campaign/batches.h"

#include <algorithm>

namespace tetracone::verify {
namespace {

constexpr std::uint64_t predicate_batch = 200, object_batch = 10, feature_batch = 3, scene_batch = 1, motion_batch = 4,
                        probe_batch = 4 * Probe_family::cases_a_body;

std::size_t subject_count(const Campaign& campaign, Asked_for what)
{
  switch (what) {
    case Asked_for::predicates: return campaign.predicate_subjects.size();
    case Asked_for::collision: return campaign.object_subjects.size();
    case Asked_for::features: return campaign.feature_subjects.size();
    case Asked_for::contacts: return campaign.contact_subjects.size();
    case Asked_for::distances: return campaign.distance_subjects.size();
    case Asked_for::points: return campaign.point_subjects.size();
    case Asked_for::rays: return campaign.ray_subjects.size();
    case Asked_for::scenes: return campaign.scene_subjects.size();
    case Asked_for::motions: break;
  }
  return campaign.motion_subjects.size();
}

}  // namespace

std::vector<Batch> batches(const Campaign& campaign, const std::vector<Sequence>& sequences)
{
  std::vector<Batch> all;
  const auto add_any = [&](Batch batch, int of_family, std::uint64_t cases, std::uint64_t size) {
    for (; batch.number * size < cases; ++batch.number) {
      if (int((std::uint64_t(of_family) + batch.number) % std::uint64_t(campaign.shards)) != campaign.shard) continue;
      batch.first = batch.number * size;
      batch.last = std::min(cases, (batch.number + 1) * size);
      all.push_back(batch);
    }
  };
  const auto add = [&](Asked_for what, const Family* family, std::uint64_t cases, std::uint64_t size) {
    add_any({what, family, nullptr, 0, 0, 0}, family->number, cases, size);
  };
  const auto add_probes = [&](Asked_for what, const std::vector<const Probe_family*>& families) {
    for (const Probe_family* family : families)
      add_any({what, nullptr, nullptr, 0, 0, 0, family}, family->number, campaign.probe_cases, probe_batch);
  };
  for (const Family* family : campaign.families)
    add(Asked_for::predicates, family, campaign.predicate_cases, predicate_batch);
  for (const Family* family : campaign.families) add(Asked_for::collision, family, campaign.object_cases, object_batch);
  for (const Family* family : campaign.families)
    if (campaign.lists_features) add(Asked_for::features, family, campaign.feature_cases, feature_batch);
  for (const Family* family : campaign.families)
    if (!campaign.contact_subjects.empty()) add(Asked_for::contacts, family, campaign.feature_cases, feature_batch);
  for (const auto* families : {&campaign.families, &campaign.distance_families})
    for (const Family* family : *families)
      if (!campaign.distance_subjects.empty()) add(Asked_for::distances, family, campaign.feature_cases, feature_batch);
  if (!campaign.point_subjects.empty()) add_probes(Asked_for::points, campaign.point_families);
  if (!campaign.ray_subjects.empty()) add_probes(Asked_for::rays, campaign.ray_families);
  for (const Scene_family* family : campaign.scene_families)
    if (!campaign.scene_subjects.empty())
      add_any({Asked_for::scenes, nullptr, nullptr, 0, 0, 0, nullptr, family}, family->number, campaign.feature_cases,
              scene_batch);
  for (const Moving_body_family* family : campaign.motion_families)
    if (!campaign.motion_subjects.empty())
      add_any({Asked_for::motions, nullptr, nullptr, 0, 0, 0, nullptr, nullptr, family}, family->number,
              campaign.feature_cases, motion_batch);
  for (std::size_t k = 0; k < sequences.size(); ++k)
    if (int(k % std::size_t(campaign.shards)) == campaign.shard)
      all.push_back({Asked_for::collision, nullptr, &sequences[k], 0, 0, sequences[k].frames.size()});
  return all;
}

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

}  // namespace tetracone::verify
