#ifndef TETRACONE_VERIFY_SUBJECTS_MOVING_BODIES_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_MOVING_BODIES_SUBJECT_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/time_bounds.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/moving_bodies.h"
#include "verify/subjects/object_subject.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetracone::verify {

/// Returns the pose with these twelve numbers.
kernel::Pose pose_of(const std::vector<kernel::Rational>& numbers);

/// Returns the package's motion between these poses. Requires quaternions between which none is 0.
kernel::Body_motion motion_of(const Motion_ends& ends);

/// Returns the package's answer.
std::optional<kernel::Time_bounds> first_contact(const Moving_bodies& bodies, kernel::Question question);

/// A subject's answer to when two moving bodies first meet.
struct Told_contact {
  Outcome outcome = Outcome::not_asked;
  kernel::Time_bounds time{0, 0};  ///< for yes: doubles around the time, equal for a subject with only one
  std::optional<Spent> spent{};    ///< nothing if the subject gave no answer
};

/// A running subject of first contacts, for one thread.
class Running_motion {
 public:
  virtual ~Running_motion() = default;
  virtual Told_contact first_contact(const Moving_bodies& bodies, kernel::Question question) = 0;
};

/// A method that answers when moving bodies first meet.
struct Moving_bodies_subject {
  std::string name;  ///< "adaptive tree", "static 100"
  bool is_exact = false;
  std::string note;  ///< for inexact ones: the question that they really answer
  std::function<std::unique_ptr<Running_motion>()> make;
};

/// The package's exact first contact, and its exact static questions at 10, 100 and 1000 times, evenly spaced from
/// start to end, in poses of doubles.
std::vector<Moving_bodies_subject> moving_bodies_subjects();

}  // namespace tetracone::verify

#endif
