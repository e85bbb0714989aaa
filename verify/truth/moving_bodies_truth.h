#ifndef TETRACONE_VERIFY_TRUTH_MOVING_BODIES_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_MOVING_BODIES_TRUTH_H

#include "tetracone/kernel/motion/time_bounds.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/case.h"
#include "verify/cases/moving_bodies.h"

#include <optional>

/// The first contact of two moving bodies, judged by two formulations. Neither shares anything with the code that it
/// judges, nor with the other except the exact poses.
namespace tetracone::verify {

/// True when `first` is the first contact by the definitions of `question`: judged by features. At t = 0 the static
/// truth is asked, and lo = hi = 0 is right if the bodies collide then. After that `truly_meet_in_motion` of
/// motion_truth.h is asked of all vertices with all triangles of fans, and of all edges with all edges. If lo = hi,
/// there is contact at lo and none before. If lo < hi, which are neighbouring doubles, there is none up to lo, and one
/// between them. Without `first` there is none in [0, 1]. Points are placed by products of quaternions. Requires faces
/// of one convex loop.
bool truly_first_by_features(const Moving_bodies& bodies, kernel::Question question,
                             const std::optional<kernel::Time_bounds>& first);

/// Returns the first contact, by features. It is `guess` if that is proved right, else it is found by halving, which
/// takes much longer.
std::optional<kernel::Time_bounds> true_first_contact(const Moving_bodies& bodies, kernel::Question question,
                                                      const std::optional<kernel::Time_bounds>& guess = std::nullopt);

/// Returns the bodies at t = 0.
Object_case at_start(const Moving_bodies& bodies, const Origin& origin = {});

/// True when they collide at t = 0.
bool truly_collide_at_start(const Moving_bodies& bodies, kernel::Question question);

/// The verdict on a first contact.
enum class Bracket { holds, violated, undecided };

/// Judges `first` by distances. Exact distances of the placed surfaces at rational times, and an upper bound of the
/// points' speed, prove two things. There is no contact until `first`, or until the end. The bodies are as near there
/// as the neighbouring doubles allow. Undecided where more than `most` distances would be needed, and where a linear
/// motion's image is flat at a time in question. Within `end` of the first contact itself nothing is proved.
Bracket truly_first_by_distances(const Moving_bodies& bodies, kernel::Question question,
                                 const std::optional<kernel::Time_bounds>& first, int most = 200, double end = 0x1p-20);

}  // namespace tetracone::verify

#endif
