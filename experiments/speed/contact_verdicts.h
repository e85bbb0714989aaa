#ifndef TETRACONE_EXPERIMENTS_SPEED_CONTACT_VERDICTS_H
#define TETRACONE_EXPERIMENTS_SPEED_CONTACT_VERDICTS_H

#include "tetracone/kernel/motion/time_bounds.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/predicate/question.h"
#include "verify/cases/moving_bodies.h"
#include "verify/subjects/running.h"
#include "verify/truth/distance_truth.h"
#include "verify/truth/moving_bodies_truth.h"

#include <optional>

/// Verdicts on answers: 0 for a right one, 1 for one that tells of too much contact, -1 for too little.
namespace tetracone::experiments {

/// Returns the verdict on a list: -1 if an element is missing, else 1 if one is invented. Requires sorted lists.
template <class List>
int verdict(const List& told, const List& truth)
{
  const int value = verify::as_number(told, truth), right = int(truth.size());
  return value == right ? 0 : value < right ? -1 : 1;
}

/// Returns the verdict on a distance. Only the double nearest to the root of `square` is right. If the method rounds,
/// every distance above 0 is right for bodies apart. A distance that is too small tells of too much contact.
inline int verdict(double distance, const kernel::Rational& square, bool is_rounded)
{
  const bool is_right = is_rounded ? (distance > 0) == (sgn(square) > 0) : verify::is_nearest_root(distance, square);
  if (is_right) return 0;
  return kernel::Rational(distance) * kernel::Rational(distance) < square ? 1 : -1;
}

/// Returns the verdict on the first contact of two surfaces. A wrong time counts as more contact.
inline int verdict(const std::optional<kernel::Time_bounds>& first, const verify::Moving_bodies& bodies)
{
  if (verify::truly_first_by_features(bodies, kernel::Question::surface, first)) return 0;
  return first ? 1 : -1;
}

}  // namespace tetracone::experiments

#endif
