#include "verify/cases/exact_map.h"
#include "verify/cases/exit_direction.h"
#include "verify/relations/moved_twins.h"
#include "verify/relations/relations.h"

#include <array>
#include <optional>

namespace tetracone::verify {
namespace {

using kernel::Rational;
using object_family::Exact_vector;
using object_family::times;
using object_family::turned;

/// Relation: a twin has these exits along a direction.
Verdict exits_are(const Solid_exits& expected, const Exit_level::Trial& t, const std::optional<Object_case>& twin,
                  const Exact_vector& direction)
{
  if (!twin) return Verdict::not_applicable;
  return verdict(t.subject.exits(*twin, direction), [&](const Exit_answer& told) { return told.exits == expected; });
}

/// Returns the case with A moved along the direction; nothing where that goes beyond the doubles.
std::optional<Object_case> moved_along(const Object_case& c, const Rational& share)
{
  return with_moved(c, &Object_case::pose_a, times(share, exit_direction(c)));
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
  return exits_are({t.given.exits.first - share, t.given.exits.last - share}, t, moved_along(t.c, share),
                   exit_direction(t.c));
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
  return exits_are(t.given.exits, t, under_affine_map(t.c), turned(affine_map(), exit_direction(t.c)));
}

Verdict same_when_split(const Exit_level::Trial& t)
{
  return exits_are(t.given.exits, t, with_split_triangles(t.c), exit_direction(t.c));
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
