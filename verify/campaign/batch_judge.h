#ifndef TETRACONE_VERIFY_CAMPAIGN_BATCH_JUDGE_H
#define TETRACONE_VERIFY_CAMPAIGN_BATCH_JUDGE_H

#include "verify/campaign/batches.h"
#include "verify/campaign/findings.h"

#include <tbb/enumerable_thread_specific.h>

#include <memory>
#include <vector>

namespace tetracone::verify {

/// Asks a campaign's subjects, and judges their answers by the truths.
class Batch_judge {
 public:
  /// `done` lists the cases that need not be asked again. Both are kept by reference.
  Batch_judge(const Campaign& campaign, const Done& done) : campaign_(campaign), done_(done) {}

  /// Judges one batch. Thread-safe. Throws Truths_disagree.
  Findings operator()(const Batch& batch);

 private:
  /// The running subjects of a level, made when it is first asked.
  template <class Level>
  struct Running_subjects {
    std::vector<std::unique_ptr<typename Level::Running>> subjects;
  };

  const Campaign& campaign_;
  const Done& done_;
  tbb::enumerable_thread_specific<For_levels<Running_subjects>> running_;
};

}  // namespace tetracone::verify

#endif
