#ifndef TETRACONE_VERIFY_TEST_SUPPORT_EMPTY_CAMPAIGN_H
#define TETRACONE_VERIFY_TEST_SUPPORT_EMPTY_CAMPAIGN_H

#include "verify/campaign/campaign.h"

#include <cstdint>

namespace tetracone::verify {

/// Returns a campaign without cases, families and subjects, to which a test adds its own.
inline Campaign empty_campaign(std::uint64_t seed)
{
  Campaign campaign;
  campaign.seed = seed;
  campaign.predicate_cases = campaign.object_cases = campaign.feature_cases = campaign.probe_cases = 0;
  campaign.lists_features = false;
  campaign.sequence_frames = 0;
  campaign.made_by = {"0", "compiler", "flags", "processor"};
  return campaign;
}

}  // namespace tetracone::verify

#endif
