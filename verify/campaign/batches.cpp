#include "verify/campaign/batches.h"

#include <algorithm>

namespace tetracone::verify {

std::vector<Batch> batches(const Campaign& campaign, const std::vector<Sequence>& sequences)
{
  std::vector<Batch> all;
  const auto is_of_shard = [&](std::uint64_t number) {
    return number % std::uint64_t(campaign.shards) == std::uint64_t(campaign.shard);
  };
  for_each_level(campaign.levels, [&]<class Level>(const Asked<Level>& asked) {
    if (!asked.is_asked) return;
    const std::uint64_t cases = campaign.*Level::size;
    for (std::size_t f = 0; f < asked.families.size(); ++f)
      for (std::uint64_t number = 0; number * Level::batch < cases; ++number)
        if (is_of_shard(std::uint64_t(asked.families[f]->number) + number))
          all.push_back({Level::name, std::string(asked.families[f]->name), f, nullptr, number, number * Level::batch,
                         std::min(cases, (number + 1) * Level::batch)});
  });
  for (std::size_t k = 0; k < sequences.size(); ++k)
    if (is_of_shard(k))
      all.push_back(
          {levels::Objects::name, "sequence " + sequences[k].name, 0, &sequences[k], 0, 0, sequences[k].frames.size()});
  return all;
}

std::uint64_t answer_count(const Campaign& campaign, const std::vector<Batch>& batches)
{
  std::map<std::string_view, std::size_t> answering;  // with the truth
  for_each_level(campaign.levels,
                 [&]<class Level>(const Asked<Level>& asked) { answering[Level::name] = 1 + asked.subjects.size(); });
  std::uint64_t count = 0;
  for (const Batch& batch : batches) count += (batch.last - batch.first) * answering[batch.level];
  return count;
}

std::vector<Sequence> sequences_of(const Campaign& campaign)
{
  if (campaign.sequence_frames == 0) return {};
  return sequences(campaign.seed, campaign.sequence_frames);
}

}  // namespace tetracone::verify
