#ifndef TETRACONE_VERIFY_TRUTH_MOTION_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_MOTION_TRUTH_H

#include "tetracone/kernel/motion/moving_pair.h"
#include "tetracone/kernel/motion/time_bounds.h"
#include "tetracone/kernel/number/number.h"

#include <array>
#include <optional>
#include <vector>

namespace tetracone::verify {

/// A span of time from `from` to `to`; `with_end` tells whether `to` belongs to it. Requires 0 <= from < to <= 1.
struct Time_span {
  kernel::Rational from = 0, to = 1;
  bool with_end = true;
};

/// True when the closed primitives share a point at a time of the span. Exact, and formulated otherwise than
/// `kernel::meet_in_motion`: without projections, isolated roots or refinement. Contact is a formula in barycentric
/// coordinates, by dot products in space. Sturm and Tarski sequences in integers count the roots of a polynomial at
/// which others have given signs. See Basu, Pollack, Roy, Algorithms in Real Algebraic Geometry, section 2.2.
bool truly_meet_in_motion(const kernel::Moving_pair& pair, const Time_span& span = {});

/// A polynomial in time, from the constant coefficient up; empty: 0.
using Time_polynomial = std::vector<kernel::Rational>;
using Moving_coordinates = std::array<Time_polynomial, 3>;

/// Does the same for four points whose coordinates are such polynomials over a common one without a root in [0, 1].
bool truly_meet_in_motion(kernel::Moving_kind kind, const std::array<Moving_coordinates, 4>& points,
                          const Time_span& span = {});

/// True when the closed primitives share a point if they rest where they are at `time`.
bool truly_meet_at(const kernel::Moving_pair& pair, const kernel::Rational& time);

/// True when `bounds` bound the first time of contact. They are neighbouring doubles, or one, with no contact before
/// them and one within; nothing where there is no contact. `meets` is truly_meet_in_motion(pair).
bool truly_first(const kernel::Moving_pair& pair, const std::optional<kernel::Time_bounds>& bounds, bool meets);

}  // namespace tetracone::verify

#endif
