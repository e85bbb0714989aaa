#ifndef TETRACONE_VERIFY_CAMPAIGN_MOTION_BATCH_H
#define TETRACONE_VERIFY_CAMPAIGN_MOTION_BATCH_H

#include "verify/campaign/batches.h"
#include "verify/campaign/findings.h"
#include "verify/subjects/moving_bodies_subject.h"

#include <memory>
#include <vector>

namespace tetracone::verify {

/// Running subjects of motions of one thread.
using Running_motions = std::vector<std::unique_ptr<Running_motion>>;

/// Judges a batch of bodies in motion, of surfaces and of solids. It judges whether they meet and, where truth and
/// answer say that they do, whether the time is the exact one (see campaign_schema.h). An exact subject must give the
/// doubles around the time; another subject must give one of these. Throws Truths_disagree.
Findings judge_motions(const Campaign& campaign, const Batch& batch, const Done& done, Running_motions& running);

}  // namespace tetracone::verify

#endif
