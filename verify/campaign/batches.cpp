#include "verify/campaign/batches.h"

#include <algorithm>

namespace tetracone::verify {
namespace {

constexpr std::uint64_t predicate_batch = 200, object_batch = 10, feature_batch = 3;

std::size_t subject_count(const Campaign& campaign, Asked_for what)
{
  switch (what) {
    case Asked_for::predicates: return campaign.predicate_subjects.size();
    case Asked_for::collision: return campaign.object_subjects.size();
    case Asked_for::features: return campaign.feature_subjects.size();
    case Asked_for::contacts: break;
  }
  return campaign.contact_subjects.size();
}

}  // namespace

std::vector<Batch> batches(const Campaign& campaign, const std::vector<Sequence>& sequences)
{
  std::vector<Batch> all;
  const auto add = [&](Asked_for what, const Family* family, std::uint64_t cases, std::uint64_t size) {
    for (std::uint64_t number = 0; number * size < cases; ++number)
      if (int((family->number + number) % std::uint64_t(campaign.shards)) == campaign.shard)
        all.push_back({what, family, nullptr, number, number * size, std::min(cases, (number + 1) * size)});
  };
  for (const Family* family : campaign.families)
    add(Asked_for::predicates, family, campaign.predicate_cases, predicate_batch);
  for (const Family* family : campaign.families) add(Asked_for::collision, family, campaign.object_cases, object_batch);
  for (const Family* family : campaign.families)
    if (campaign.lists_features) add(Asked_for::features, family, campaign.feature_cases, feature_batch);
  for (const Family* family : campaign.families)
    if (!campaign.contact_subjects.empty()) add(Asked_for::contacts, family, campaign.feature_cases, feature_batch);
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
