#include "tetracone/kernel/number/pose.h"
#include "verify/cases/exact_map.h"
#include "verify/cases/exact_motion.h"
#include "verify/cases/exit_direction.h"
#include "verify/relations/changed_bodies.h"
#include "verify/relations/moved_twins.h"
#include "verify/relations/relations.h"

#include <array>
#include <optional>

namespace tetracone::verify {
namespace {

using kernel::Pose;
using kernel::Rational;
using kernel::Solid_relation;
using object_family::composed;
using object_family::Exact_vector;
using object_family::times;
using object_family::turned;

/// Relation: a twin has these exits along a direction.
Verdict exits_are(const Solid_exits& expected, const Exit_level::Trial& t, const Object_case& twin,
                  const Exact_vector& direction)
{
  const auto told = t.subject.exits(twin, direction);
  return told.outcome == Outcome::yes ? verdict(told.answer.exits == expected) : Verdict::not_applicable;
}

/// Returns the case with A moved along the direction; nothing where that goes beyond the doubles.
std::optional<Object_case> moved_along(const Object_case& c, const Rational& share)
{
  Object_case twin = c;
  Entries entries = entries_of(c.pose_a);
  const Exact_vector direction = exit_direction(c);
  for (int row = 0; row < 3; ++row) entries[4 * row + 3] += share * direction[row];
  const auto pose = exact_pose(entries, true);
  if (!pose) return std::nullopt;
  twin.pose_a = *pose;
  return twin;
}

/// Returns whether the interiors share a point; nothing where nobody tells, and for no case.
std::optional<bool> interiors_meet(const Exit_level::Trial& t, const std::optional<Object_case>& c)
{
  if (!c) return std::nullopt;
  const auto told = t.subject.solids(*c);
  if (told.outcome != Outcome::yes) return std::nullopt;
  return told.answer.overlap.volume != 0;
}

Verdict zero(const Exit_level::Trial& t)
{
  const auto meet = interiors_meet(t, t.c);
  if (!meet) return Verdict::not_applicable;
  const auto& [first, last] = t.given.exits;
  return verdict(*meet ? first > 0 && last >= first : first == 0 && last == 0);
}

Verdict parted(const Exit_level::Trial& t)
{
  const auto& [first, last] = t.given.exits;
  if (first == 0) return Verdict::not_applicable;
  const Rational before = first * Rational((1L << 40) - 1, 1L << 40);
  const auto at_before = interiors_meet(t, moved_along(t.c, before)),
             at_first = interiors_meet(t, moved_along(t.c, first)), at_last = interiors_meet(t, moved_along(t.c, last));
  if (!at_before || !at_first || !at_last) return Verdict::not_applicable;
  return verdict(*at_before && !*at_first && !*at_last);
}

Verdict on_the_way(const Exit_level::Trial& t)
{
  const Rational share = t.given.exits.first * long(1 + one_of(t.random, 7)) / 8;
  if (share == 0) return Verdict::not_applicable;
  const auto twin = moved_along(t.c, share);
  if (!twin) return Verdict::not_applicable;
  return exits_are({t.given.exits.first - share, t.given.exits.last - share}, t, *twin, exit_direction(t.c));
}

Verdict swapped(const Exit_level::Trial& t)
{
  return exits_are(t.given.exits, t, with_bodies_swapped(t.c), times(-1, exit_direction(t.c)));
}

Verdict longer(const Exit_level::Trial& t)
{
  const Rational factor = Rational(long(1 + one_of(t.random, 9))) / 10;
  return exits_are({t.given.exits.first / factor, t.given.exits.last / factor}, t, t.c,
                   times(factor, exit_direction(t.c)));
}

Verdict mapped(const Exit_level::Trial& t)
{
  // Not rigid, with fractions, and it turns bodies over.
  const Pose map({Rational(1, 3), 2, 0, 3, 0, -1, 1, 0, 1, 0, 3, Rational(-5, 7)});
  Object_case twin = t.c;
  twin.pose_a = composed(map, t.c.pose_a);
  twin.pose_b = composed(map, t.c.pose_b);
  for (const Pose* pose : {&twin.pose_a, &twin.pose_b})
    if (!exact_pose(entries_of(*pose), true)) return Verdict::not_applicable;
  return exits_are(t.given.exits, t, twin, turned(map, exit_direction(t.c)));
}

Verdict same_when_split(const Exit_level::Trial& t)
{
  const auto a = split_inside(*t.c.a), b = split_inside(*t.c.b);
  if (!a && !b) return Verdict::not_applicable;
  Object_case twin = t.c;
  if (a) twin.a = as_shared(a->body);
  if (b) twin.b = as_shared(b->body);
  return exits_are(t.given.exits, t, twin, exit_direction(t.c));
}

constexpr std::array of_exits = std::to_array<Exit_level::Relation>({
    {"R1 zero", "exits are 0 exactly where the interiors share no point", zero},
    {"R1 parted", "interiors share a point just before the first exit, and none at it or at the last", parted},
    {"R2 on the way", "a body that has moved a part of the way has the rest to go", on_the_way},
    {"R5 swap", "B leaves A in the other direction", swapped},
    {"R6 length", "exits are in lengths of the direction", longer},
    {"R6 affine", "a common affine map of bodies and direction keeps the exits", mapped},
    {"R7 face", "triangles split at inner points give the same answer", same_when_split},
});

}  // namespace

std::span<const Exit_level::Relation> exit_relations() { return of_exits; }

}  // namespace tetracone::verify
