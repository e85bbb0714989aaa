#ifndef TETRACONE_VERIFY_TRUTH_MOTION_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_MOTION_TRUTH_H

#include "tetracone/kernel/motion/moving_pair.h"
#include "tetracone/kernel/motion/time_bounds.h"
#include "tetracone/kernel/number/number.h"

#include <array>
#include <optional>
#include <vector>

namespace tetracone::verify {

/// Times from 0 or later to `to`, which belongs to them or not. Requires 0 <= from < to <= 1.
struct Time_span {
  kernel::Rational from = 0, to = 1;
  bool with_end = true;
};

/// Whether the closed primitives share a point at a time of the span. Exact, and of another formulation than
/// `kernel::meet_in_motion`: no projections, no isolated roots and no refinement. Contact is a formula in barycentric
/// coordinates, by dot products in space; how many roots of a polynomial have which signs of others is counted by
/// sequences of Sturm and Tarski in integers (Basu, Pollack, Roy, Algorithms in Real Algebraic Geometry, section 2.2).
bool truly_meet_in_motion(const kernel::Moving_pair& pair, const Time_span& span = {});

/// A polynomial in time, from the constant coefficient up; empty: 0.
using Time_polynomial = std::vector<kernel::Rational>;
using Moving_coordinates = std::array<Time_polynomial, 3>;

/// The same of four points whose coordinates are such polynomials, all over one that has no root in [0, 1].
bool truly_meet_in_motion(kernel::Moving_kind kind, const std::array<Moving_coordinates, 4>& points,
                          const Time_span& span = {});

/// Whether the closed primitives, standing still as they are at `time`, share a point.
bool truly_meet_at(const kernel::Moving_pair& pair, const kernel::Rational& time);

/// Whether `bounds` are those of the first time of contact: neighbouring doubles, or one, with no contact before them and
/// one within; or nothing where there is none. `meets`: what truly_meet_in_motion(pair) says.
bool truly_first(const kernel::Moving_pair& pair, const std::optional<kernel::Time_bounds>& bounds, bool meets);

}  // namespace tetracone::verify

#endif
