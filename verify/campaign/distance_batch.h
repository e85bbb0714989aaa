#ifndef TETRACONE_VERIFY_CAMPAIGN_DISTANCE_BATCH_H
#define TETRACONE_VERIFY_CAMPAIGN_DISTANCE_BATCH_H

#include "verify/campaign/batches.h"
#include "verify/campaign/findings.h"
#include "verify/subjects/object_subject.h"

#include <memory>
#include <vector>

namespace tetracone::verify {

/// Running subjects of one thread.
using Running_subjects = std::vector<std::unique_ptr<Running_subject>>;

/// Judges a batch of distances, of surfaces and of solids. A subject's answer makes `distance_statements` statements:
/// the exact square; that the nearest points are that far apart, and lie on the named features; the rounded root, asked
/// together with them and alone; limits at the distance, beside it and far from it. The answer's value is the number of
/// right statements. Subjects are not asked about bodies of more than `most_faces` faces. Throws Truths_disagree.
Findings judge_distances(const Campaign& campaign, const Batch& batch, const Done& done, Running_subjects& running);

inline constexpr int distance_statements = 12;

}  // namespace tetracone::verify

#endif
