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

/// The pose of twelve numbers.
kernel::Pose pose_of(const std::vector<kernel::Rational>& numbers);

/// The package's motion between these poses. Requires quaternions between which none is 0.
kernel::Body_motion motion_of(const Motion_ends& ends);

/// The package's answer.
std::optional<kernel::Time_bounds> first_contact(const Moving_bodies& bodies, kernel::Question question);

/// What a subject tells of the first contact of two moving bodies.
struct Told_contact {
  Outcome outcome = Outcome::not_asked;
  kernel::Time_bounds time{0, 0};  ///< yes: doubles about the time; twice the same of a subject that tells but one
  std::optional<Spent> spent{};    ///< nothing where the subject gave no answer
};

/// A subject that is asked when moving bodies first meet, in one thread.
class Running_motion {
 public:
  virtual ~Running_motion() = default;
  virtual Told_contact first_contact(const Moving_bodies& bodies, kernel::Question question) = 0;
};

/// Something that says when moving bodies first meet.
struct Moving_bodies_subject {
  std::string name;  ///< "adaptive tree", "static 100"
  bool is_exact = false;
  std::string note;  ///< of others: what they really answer
  std::function<std::unique_ptr<Running_motion>()> make;
};

/// The package's exact first contact, and its exact static questions at 10, 100 and 1000 times, evenly spaced from
/// start to end, in poses of doubles.
std::vector<Moving_bodies_subject> moving_bodies_subjects();

}  // namespace tetracone::verify

#endif
