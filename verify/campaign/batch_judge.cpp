#include "verify/campaign/batch_judge.h"

#include "verify/campaign/level_judge.h"

#include <optional>

namespace tetracone::verify {

Findings Batch_judge::operator()(const Batch& batch)
{
  auto& running = running_.local();
  std::optional<Findings> found;
  for_each_level(campaign_.levels, [&]<class Level>(const Asked<Level>& asked) {
    if (batch.level != Level::name) return;
    auto& subjects = std::get<Running_subjects<Level>>(running).subjects;
    if (subjects.empty())
      for (const auto& subject : asked.subjects) subjects.push_back(subject.make());
    const auto* family = batch.sequence ? nullptr : asked.families[batch.number_of_family];
    found = Level::judge({batch, campaign_.seed, family, asked.subjects, subjects, done_});
  });
  return std::move(found).value();
}

}  // namespace tetracone::verify
