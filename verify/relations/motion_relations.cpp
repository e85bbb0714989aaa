#include "verify/relations/motion_relations.h"

#include "tetracone/kernel/motion/first_contact.h"
#include "tetracone/kernel/number/number.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace tetracone::verify {
namespace {

using kernel::first_contact_time;
using kernel::meet_in_motion;
using kernel::Moving_kind;
using kernel::Moving_pair;
using kernel::Moving_point;
using kernel::Rational;
using kernel::Time_bounds;
using kernel::Vertex;

using First = std::optional<Time_bounds>;

bool equal(const First& a, const First& b)
{
  return a.has_value() == b.has_value() && (!a || (a->lo == b->lo && a->hi == b->hi));
}

/// The first contact of the reversed motion is the last of the motion, so not before its first.
Verdict reversed_time(const Moving_pair& pair, Random&)
{
  Moving_pair reversed = pair;
  for (Moving_point& p : reversed.points) std::swap(p.start, p.end);
  const First first = first_contact_time(pair), last = first_contact_time(reversed);
  if (first.has_value() != last.has_value()) return Verdict::violated;
  return verdict(!first || Rational(first->lo) + Rational(last->lo) <= 1);
}

Verdict permuted(const Moving_pair& pair, Random& random)
{
  Moving_pair twin = pair;
  auto& p = twin.points;
  const auto swap_in_some = [&](std::size_t i, std::size_t j) {
    if (random.bits() % 2 == 0) std::swap(p[i], p[j]);
  };
  if (pair.kind == Moving_kind::vertex_face) {
    swap_in_some(1, 2);
    swap_in_some(2, 3);
    swap_in_some(1, 3);
  } else {
    swap_in_some(0, 1);
    swap_in_some(2, 3);
    if (random.bits() % 2 == 0) {
      std::swap(p[0], p[2]);
      std::swap(p[1], p[3]);
    }
  }
  // Axes too.
  const std::size_t i = random.bits() % 3, j = random.bits() % 3;
  for (Moving_point& q : p)
    for (Vertex* const v : {&q.start, &q.end}) {
      std::swap((*v)[i], (*v)[j]);
      (*v)[i] = -(*v)[i];
    }
  return verdict(equal(first_contact_time(pair), first_contact_time(twin)) &&
                 meet_in_motion(pair) == meet_in_motion(twin));
}

Verdict translated(const Moving_pair& pair, Random& random)
{
  Moving_pair twin = pair;
  const Vertex from = {std::round(8 * random.symmetric()), std::round(8 * random.symmetric()) / 4, 0.5};
  const Vertex to = {-2, std::round(8 * random.symmetric()), std::round(8 * random.symmetric()) / 2};
  for (Moving_point& p : twin.points)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const auto& [x, by] : {std::pair(&p.start[axis], from[axis]), std::pair(&p.end[axis], to[axis])}) {
        const Rational exact = Rational(*x) + Rational(by);
        *x += by;
        if (Rational(*x) != exact) return Verdict::not_applicable;
      }
  return verdict(equal(first_contact_time(pair), first_contact_time(twin)) &&
                 meet_in_motion(pair) == meet_in_motion(twin));
}

/// Relation: the first contact of a motion is that of its first half or, without one, that of its second half.
Verdict split(const Moving_pair& pair, Random&)
{
  Moving_pair before = pair, after = pair;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double start = pair.points[k].start[axis], end = pair.points[k].end[axis], middle = start / 2 + end / 2;
      if (Rational(middle) * 2 != Rational(start) + Rational(end)) return Verdict::not_applicable;
      before.points[k].end[axis] = after.points[k].start[axis] = middle;
    }
  const First whole = first_contact_time(pair), first = first_contact_time(before), second = first_contact_time(after);
  if (whole.has_value() != (first || second) ||
      meet_in_motion(pair) != (meet_in_motion(before) || meet_in_motion(after)))
    return Verdict::violated;
  if (!whole) return Verdict::holds;
  const Time_bounds& piece = first ? *first : *second;
  const Rational shift = first ? 0 : 1, lo = (shift + Rational(piece.lo)) / 2, hi = (shift + Rational(piece.hi)) / 2;
  return verdict(lo <= Rational(whole->hi) && Rational(whole->lo) <= hi);
}

constexpr std::array of_motion = {
    Motion_relation{"reversed-time", "existence, and the first time before the last", reversed_time},
    Motion_relation{"permuted", "the same time for permuted corners, ends, edges and axes, and for mirror images",
                    permuted},
    Motion_relation{"translated", "the same time when all points are moved alike, differently at both ends",
                    translated},
    Motion_relation{"split", "the first contact of the first half that has one", split},
};

}  // namespace

std::span<const Motion_relation> motion_relations() { return of_motion; }

}  // namespace tetracone::verify
