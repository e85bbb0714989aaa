#ifndef TETRACONE_VERIFY_CAMPAIGN_MOTION_BATCH_H
#define TETRACONE_VERIFY_CAMPAIGN_MOTION_BATCH_H

#include "verify/campaign/batches.h"
#include "verify/campaign/findings.h"
#include "verify/subjects/moving_bodies_subject.h"

#include <memory>
#include <vector>

namespace tetracone::verify {

/// Subjects of motions at work in one thread.
using Running_motions = std::vector<std::unique_ptr<Running_motion>>;

/// Judges a batch of bodies in motion, of surfaces and of solids: whether they meet, and, of those that do and are told
/// to, whether the time is the exact one (see campaign_schema.h). An exact subject's must be the doubles about it, the
/// one time of another one of these. Throws Truths_disagree.
Findings judge_motions(const Campaign& campaign, const Batch& batch, const Done& done, Running_motions& running);

}  // namespace tetracone::verify

#endif
