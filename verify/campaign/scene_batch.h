#ifndef TETRACONE_VERIFY_CAMPAIGN_SCENE_BATCH_H
#define TETRACONE_VERIFY_CAMPAIGN_SCENE_BATCH_H

#include "verify/campaign/batches.h"
#include "verify/campaign/findings.h"
#include "verify/subjects/scene_subject.h"

#include <memory>
#include <vector>

namespace tetracone::verify {

/// Running subjects of scenes of one thread.
using Running_scenes = std::vector<std::unique_ptr<Running_scene>>;

/// Judges a batch of scenes by the colliding pairs of each frame; both truths decide every pair of bodies. An answer is
/// a frame's list. Throws Truths_disagree, with the two bodies.
Findings judge_scenes(const Campaign& campaign, const Batch& batch, const Done& done, Running_scenes& running);

}  // namespace tetracone::verify

#endif
