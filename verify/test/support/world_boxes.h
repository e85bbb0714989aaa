#ifndef TETRACONE_VERIFY_TEST_SUPPORT_WORLD_BOXES_H
#define TETRACONE_VERIFY_TEST_SUPPORT_WORLD_BOXES_H

#include "tetracone/tetratree/scene/world_box.h"
#include "verify/test/support/rationals.h"

#include <cmath>

namespace tetracone::verify {

/// True when the point is in the box; a side that is not finite bounds nothing.
inline bool holds(const tetratree::World_box& box, const rationals::Vector& p)
{
  using kernel::Rational;
  for (int k = 0; k < 3; ++k)
    if ((std::isfinite(box.low[k]) && Rational(double(box.low[k])) > p[k]) ||
        (std::isfinite(box.high[k]) && Rational(double(box.high[k])) < p[k]))
      return false;
  return true;
}

}  // namespace tetracone::verify

#endif
