#ifndef TETRACONE_VERIFY_SUBJECTS_MOVING_BODIES_SUBJECT_H
#define TETRACONE_VERIFY_SUBJECTS_MOVING_BODIES_SUBJECT_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/time_bounds.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/cases/moving_bodies.h"

#include <algorithm>
#include <array>
#include <optional>

namespace tetracone::verify {

/// The package's motion between these poses. Requires quaternions between which none is 0.
inline kernel::Body_motion motion_of(const Motion_ends& ends)
{
  const auto& [from, to] = ends;
  const auto pose = [](const std::vector<kernel::Rational>& numbers) {
    std::array<kernel::Rational, 12> entries;
    std::ranges::copy(numbers, entries.begin());
    return kernel::Pose(entries);
  };
  const auto rigid = [](const std::vector<kernel::Rational>& n) {
    return kernel::Rigid_pose{{n[0], n[1], n[2], n[3]}, {n[4], n[5], n[6]}};
  };
  return from.size() == 12 ? kernel::Body_motion::linear(pose(from), pose(to))
                           : kernel::Body_motion::rigid(rigid(from), rigid(to)).value();
}

/// The package's answer.
inline std::optional<kernel::Time_bounds> first_contact(const Moving_bodies& bodies, kernel::Question question)
{
  Query query(Body(bodies.a), Body(bodies.b), question);
  const auto first = query.first_contact(Motion(motion_of(bodies.motion_a)), Motion(motion_of(bodies.motion_b)));
  if (!first) return std::nullopt;
  return kernel::Time_bounds{first->lo, first->hi};
}

}  // namespace tetracone::verify

#endif
