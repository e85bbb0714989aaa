#ifndef TETRACONE_VERIFY_CAMPAIGN_BATCH_JUDGE_H
#define TETRACONE_VERIFY_CAMPAIGN_BATCH_JUDGE_H

#include "verify/campaign/batches.h"
#include "verify/campaign/distance_batch.h"
#include "verify/campaign/findings.h"
#include "verify/campaign/motion_batch.h"
#include "verify/campaign/probe_batch.h"
#include "verify/campaign/scene_batch.h"

#include <tbb/enumerable_thread_specific.h>

namespace tetracone::verify {

/// Asks a campaign's subjects, and judges their answers by the truths.
class Batch_judge {
 public:
  /// `done` lists the cases that need not be asked again. Both are kept by reference.
  Batch_judge(const Campaign& campaign, const Done& done);

  /// Judges one batch. Thread-safe. Throws Truths_disagree.
  Findings operator()(const Batch& batch);

 private:
  const Campaign& campaign_;
  const Done& done_;
  tbb::enumerable_thread_specific<Running_subjects> colliding_, listing_, locating_, measuring_;  // of the
      // levels object, features,
      // contacts and distances
  tbb::enumerable_thread_specific<Running_probes> placing_, casting_;  // of points and rays
  tbb::enumerable_thread_specific<Running_scenes> playing_;
  tbb::enumerable_thread_specific<Running_motions> following_;
};

}  // namespace tetracone::verify

#endif
