#ifndef TETRACONE_VERIFY_CAMPAIGN_PROBE_BATCH_H
#define TETRACONE_VERIFY_CAMPAIGN_PROBE_BATCH_H

#include "verify/campaign/batches.h"
#include "verify/campaign/findings.h"
#include "verify/subjects/probe_subject.h"

#include <memory>
#include <vector>

namespace tetracone::verify {

/// Running subjects of points or rays of one thread.
using Running_probes = std::vector<std::unique_ptr<Running_probe>>;

/// Judges a batch of points: where each subject places them. Throws Truths_disagree.
Findings judge_points(const Campaign& campaign, const Batch& batch, const Done& done, Running_probes& running);

/// Judges a batch of rays by three questions: the first face with its t, all faces with their t, and all faces. An
/// answer is a list. Throws Truths_disagree.
Findings judge_rays(const Campaign& campaign, const Batch& batch, const Done& done, Running_probes& running);

}  // namespace tetracone::verify

#endif
