#ifndef TETRACONE_VERIFY_RELATIONS_MOVED_TWINS_H
#define TETRACONE_VERIFY_RELATIONS_MOVED_TWINS_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "verify/cases/case.h"
#include "verify/cases/exact_map.h"
#include "verify/cases/exact_motion.h"
#include "verify/cases/random.h"
#include "verify/relations/changed_bodies.h"

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

/// Returns the case with vertices and faces of A in any order, and all loops of B reversed.
inline Object_case in_another_order(Object_case c, Random& random)
{
  c.a = as_shared(reordered(*c.a, random).body);
  c.b = as_shared(wound_backwards(*c.b).body);
  return c;
}

/// Returns the case with triangles split at inner points; nothing when no triangle has such a point.
inline std::optional<Object_case> with_split_triangles(Object_case c)
{
  const auto a = split_inside(*c.a), b = split_inside(*c.b);
  if (!a && !b) return std::nullopt;
  if (a) c.a = as_shared(a->body);
  if (b) c.b = as_shared(b->body);
  return c;
}

/// Returns the case with the poses of both bodies changed; nothing where an entry would be beyond the doubles.
template <class Change>
std::optional<Object_case> with_poses(Object_case c, const Change& change)
{
  for (kernel::Pose* const pose : {&c.pose_a, &c.pose_b}) {
    const auto changed = exact_pose(entries_of(change(*pose)), true);
    if (!changed) return std::nullopt;
    *pose = *changed;
  }
  return c;
}

/// Returns the case with one body moved; nothing where an entry would be beyond the doubles.
inline std::optional<Object_case> with_moved(Object_case c, kernel::Pose Object_case::*of_body,
                                             const object_family::Exact_vector& way)
{
  const auto moved = exact_pose(entries_of(object_family::moved(c.*of_body, way)), true);
  if (!moved) return std::nullopt;
  c.*of_body = *moved;
  return c;
}

/// A map that is not rigid, has fractions, and turns bodies over.
inline const kernel::Pose& affine_map()
{
  static const kernel::Pose map({kernel::Rational(1, 3), 2, 0, 3, 0, -1, 1, 0, 1, 0, 3, kernel::Rational(-5, 7)});
  return map;
}

/// Returns the case under `affine_map`; nothing where an entry would be beyond the doubles.
inline std::optional<Object_case> under_affine_map(const Object_case& c)
{
  return with_poses(c, [](const kernel::Pose& pose) { return object_family::composed(affine_map(), pose); });
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

/// Moves both poses by `p` and then by a translation. It is up to 2^24 ulps of `scale` along each axis on which it is
/// exact for both. False when nothing has moved.
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
