#ifndef TETRACONE_VERIFY_TRUTH_MOVING_BODIES_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_MOVING_BODIES_TRUTH_H

#include "tetracone/kernel/motion/time_bounds.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case.h"
#include "verify/cases/moving_bodies.h"

#include <optional>

/// When two moving bodies first meet, judged by two formulations that share nothing with what they judge, nor with each
/// other but the exact poses.
namespace tetracone::verify {

/// By features: whether `first` is what the definitions say of bodies that collide as `question` says. Static truth at
/// t = 0; after it all vertices with all triangles of fans, and all edges with all edges, by `truly_meet_in_motion` of
/// motion_truth.h: no contact before lo, one from there to hi. Points are found by products of quaternions.
bool truly_first_by_features(const Moving_bodies& bodies, kernel::Question question,
                             const std::optional<kernel::Time_bounds>& first);

/// The first contact itself, by features: `guess` where it is proved to be it, else found by halving, in much more time.
std::optional<kernel::Time_bounds> true_first_contact(const Moving_bodies& bodies, kernel::Question question,
                                                      const std::optional<kernel::Time_bounds>& guess = std::nullopt);

/// The bodies as they stand at t = 0.
Object_case at_start(const Moving_bodies& bodies, const Origin& origin = {});

enum class Bracket { holds, violated, undecided };

/// By distances: exact ones of the placed surfaces at rational times, and a bound on how fast a point moves, show that
/// there is no contact until `first`, or until the end, and that the bodies are as near there as the doubles about it
/// allow. Undecided where more than `most` distances would be needed, and where a linear motion's image is flat at a time that is
/// looked at; within `end` of the time itself nothing is said.
Bracket truly_first_by_distances(const Moving_bodies& bodies, kernel::Question question,
                                 const std::optional<kernel::Time_bounds>& first, int most = 200, double end = 0x1p-20);

}  // namespace tetracone::verify

#endif
