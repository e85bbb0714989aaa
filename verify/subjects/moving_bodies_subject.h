#ifndef TETRACONE_VERIFY_SUBJECTS_MOVING_BODIES_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_MOVING_BODIES_SUBJECT_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/time_bounds.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/moving_bodies.h"
#include "verify/subjects/running.h"

#include <optional>
#include <vector>

namespace tetracone::verify {

/// Returns the pose with these twelve numbers.
kernel::Pose pose_of(const std::vector<kernel::Rational>& numbers);

/// Returns the package's motion between these poses. Requires quaternions between which none is 0.
kernel::Body_motion motion_of(const Motion_ends& ends);

/// Returns the package's answer.
std::optional<kernel::Time_bounds> first_contact(const Moving_bodies& bodies, kernel::Question question);

/// A running subject of first contacts, for one thread. The time is for `yes`: doubles around the exact one. They are
/// equal for a subject with only one.
using Running_motion = Running<Moving_bodies, kernel::Time_bounds, kernel::Question>;
using Told_contact = Told<kernel::Time_bounds>;
using Moving_bodies_subject = Subject_of<Running_motion>;

/// The package's exact first contact, and its exact static questions at 10, 100 and 1000 times, evenly spaced from
/// start to end, in poses of doubles.
std::vector<Moving_bodies_subject> moving_bodies_subjects();

}  // namespace tetracone::verify

#endif
