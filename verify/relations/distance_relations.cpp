#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "verify/cases/exact_map.h"
#include "verify/cases/exact_motion.h"
#include "verify/relations/moved_twins.h"
#include "verify/relations/relations.h"

#include <array>
#include <optional>
#include <utility>

namespace tetracone::verify {
namespace {

using kernel::Question;
using kernel::Rational;

/// Relation: the squared distance of a twin is `factor` times the case's.
Verdict times_as_far(const Distance_level::Trial& t, const Rational& factor, const std::optional<Object_case>& twin)
{
  if (!twin) return Verdict::not_applicable;
  return verdict(t.subject.distance(*twin, t.question), [&](const Distance_answer& told) {
    return Rational(told.nearest.squared) == factor * Rational(t.given.nearest.squared);
  });
}

Verdict as_far_swapped(const Distance_level::Trial& t) { return times_as_far(t, 1, with_bodies_swapped(t.c)); }

/// Relation: both poses are followed by a permutation of the axes and a scaling by `factor`.
Verdict moved_together(const Distance_level::Trial& t, const Signed_permutation& p, const Rational& factor,
                       const object_family::Exact_vector& shift)
{
  const auto twin = with_poses(t.c, [&](const kernel::Pose& pose) {
    Entries entries = entries_of(turned(p, pose));
    for (std::size_t k = 0; k < 12; ++k) entries[k] = factor * entries[k] + (k % 4 == 3 ? shift[k / 4] : Rational(0));
    return kernel::Pose(entries);
  });
  return times_as_far(t, Rational(factor * factor), twin);
}

Verdict as_far_moved(const Distance_level::Trial& t)
{
  const auto p = Signed_permutation::any(t.random);
  object_family::Exact_vector shift;
  for (Rational& x : shift) x = Rational(int(one_of(t.random, 41)) - 20) / 7;
  return moved_together(t, p, 1, shift);
}

Verdict twice_as_far(const Distance_level::Trial& t) { return moved_together(t, {}, 2, {0, 0, 0}); }

Verdict as_large_as_far(const Distance_level::Trial& t)
{
  const Rational factor = Rational(1 + int(one_of(t.random, 9))) / 3;
  return moved_together(t, {}, factor, {0, 0, 0});
}

/// Relation: B moves a fraction of the way to A's nearest point. By the triangle inequality no pair of points comes
/// nearer than the rest of the way, and the nearest points are that near.
Verdict approached(const Distance_level::Trial& t)
{
  if (t.given.nearest.squared == "0") return Verdict::not_applicable;
  const Rational share = Rational(1 + int(one_of(t.random, 4))) / 4, rest = 1 - share;
  object_family::Exact_vector way;
  for (std::size_t k = 0; k < 3; ++k)
    way[k] = share * (Rational(t.given.nearest.point[0][k]) - Rational(t.given.nearest.point[1][k]));
  return times_as_far(t, Rational(rest * rest), with_moved(t.c, &Object_case::pose_b, way));
}

Verdict as_far_in_any_order(const Distance_level::Trial& t)
{
  return times_as_far(t, 1, in_another_order(t.c, t.random));
}

Verdict as_far_split(const Distance_level::Trial& t) { return times_as_far(t, 1, with_split_triangles(t.c)); }

/// Relation of the surfaces: a body that loses a face does not get nearer.
Verdict a_face_less(const Distance_level::Trial& t)
{
  if (t.question != Question::surface) return Verdict::not_applicable;
  auto rest = without_a_face(*t.c.a, t.random);
  if (!rest) return Verdict::not_applicable;
  Object_case twin = t.c;
  twin.a = as_shared(std::move(*rest));
  return verdict(t.subject.distance(twin, t.question), [&](const Distance_answer& told) {
    return Rational(told.nearest.squared) >= Rational(t.given.nearest.squared);
  });
}

Verdict zero_where_they_collide(const Distance_level::Trial& t)
{
  const Outcome outcome = t.subject(t.c, t.question);
  if (outcome != Outcome::yes && outcome != Outcome::no) return Verdict::not_applicable;
  return verdict((t.given.nearest.squared == "0") == (outcome == Outcome::yes));
}

constexpr std::array of_distances = std::to_array<Distance_level::Relation>({
    {"R1 zero", "the distance is 0 exactly where the bodies collide", zero_where_they_collide},
    {"R5 swap", "A and B may be swapped", as_far_swapped},
    {"R6 motion", "a common permutation of the axes and translation keeps the distance", as_far_moved},
    {"R6 twice", "all twice as large is twice as far", twice_as_far},
    {"R6 scale", "all n/3 times as large is n/3 times as far", as_large_as_far},
    {"R7 face", "triangles split at inner points are as far", as_far_split},
    {"R8 order", "vertices and faces may stand in any order, and loops run either way", as_far_in_any_order},
    {"R9 removing", "a face less brings surfaces no nearer", a_face_less},
    {"R13 approach", "a share of the way to the nearest point leaves the rest of the distance", approached},
});

}  // namespace

std::span<const Distance_level::Relation> distance_relations() { return of_distances; }

}  // namespace tetracone::verify
