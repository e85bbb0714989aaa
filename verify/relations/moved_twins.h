#ifndef TETRACONE_VERIFY_RELATIONS_MOVED_TWINS_H
#define TETRACONE_VERIFY_RELATIONS_MOVED_TWINS_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "verify/cases/case.h"
#include "verify/cases/exact_motion.h"
#include "verify/cases/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

/// Twins of cases with poses, for relations of several levels.
namespace tetracone::verify {

/// Returns the case with A and B swapped.
inline Object_case with_bodies_swapped(Object_case c)
{
  std::swap(c.a, c.b);
  std::swap(c.pose_a, c.pose_b);
  return c;
}

/// Returns the largest absolute coordinate of a translation.
inline double largest_translation(const kernel::Pose& a, const kernel::Pose& b)
{
  double largest = 0;
  for (const kernel::Pose* pose : {&a, &b})
    for (const int k : {3, 7, 11}) largest = std::max(largest, std::abs((*pose)[k]));
  return largest;
}

/// Returns the pose translated by `length` along an axis; nothing when that is not exact.
inline std::optional<kernel::Pose> translated_along(const kernel::Pose& pose, int axis, const kernel::Rational& length)
{
  std::array<kernel::Rational, 3> d{0, 0, 0};
  d[axis] = length;
  return translated(pose, d);
}

/// Moves both poses by `p` and then by a translation of up to 2^24 ulps of `scale` along each axis on which it is exact
/// for both. False when nothing has moved.
template <class Case>
bool move_together(Case& c, const Signed_permutation& p, double scale, Random& random)
{
  c.pose_a = turned(p, c.pose_a);
  c.pose_b = turned(p, c.pose_b);
  bool changed = !p.is_identity();
  const double unit = 4096 * ulp(scale);
  for (int axis = 0; axis < 3; ++axis) {
    const kernel::Rational length(unit * double(one_of(random, 4096)));
    const auto a = translated_along(c.pose_a, axis, length), b = translated_along(c.pose_b, axis, length);
    if (!a || !b) continue;
    c.pose_a = *a;
    c.pose_b = *b;
    changed = true;
  }
  return changed;
}

/// Returns the exact ones among the poses of B at -2, ..., 2 steps along an axis; a step is 1, 4 or 2^24 ulps of
/// `scale`.
inline std::vector<kernel::Pose> poses_along_axis(const kernel::Pose& pose, double scale, Random& random)
{
  const int axis = one_of(random, 3);
  const double step = std::ldexp(ulp(scale), int(std::array{0, 0, 2, 24}[one_of(random, 4)]));
  std::vector<kernel::Pose> poses;
  for (int k = -2; k <= 2; ++k)
    if (const auto moved = translated_along(pose, axis, kernel::Rational(k) * kernel::Rational(step)))
      poses.push_back(*moved);
  return poses;
}

}  // namespace tetracone::verify

#endif
