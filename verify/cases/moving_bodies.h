#ifndef TETRACONE_VERIFY_CASES_MOVING_BODIES_H
#define TETRACONE_VERIFY_CASES_MOVING_BODIES_H

#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/number/number.h"
#include "verify/cases/case.h"

#include <array>
#include <vector>

namespace tetracone::verify {

/// The poses of a body at t = 0 and t = 1. Linear ones have 12 numbers each, row-major 3x4; rigid ones have 7 each, a
/// quaternion (w, x, y, z) and a translation. See `kernel::Body_motion`.
using Motion_ends = std::array<std::vector<kernel::Rational>, 2>;

/// Two bodies in motion, both linear or both rigid. Every face is convex.
struct Moving_bodies {
  covering::Polyhedron a, b;
  Motion_ends motion_a, motion_b;
  Origin origin{};

  bool is_rigid() const { return motion_a[0].size() == 7; }
};

}  // namespace tetracone::verify

#endif
