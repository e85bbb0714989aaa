#include "tetracone/kernel/number/pose.h"
#include "verify/cases/exact_map.h"
#include "verify/cases/shape_generators.h"
#include "verify/relations/convex_body.h"
#include "verify/relations/moved_twins.h"
#include "verify/relations/relations.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace tetracone::verify {
namespace {

using covering::Polyhedron;
using kernel::Pose;
using kernel::Question;
using kernel::Rational;
using kernel::Solid_relation;
using namespace object_family;

/// Relation: the overlap of a twin is `expected`.
Verdict overlap_is(const Solid_overlap& expected, const Solid_level::Trial& t, const std::optional<Object_case>& twin)
{
  if (!twin) return Verdict::not_applicable;
  return verdict(t.subject.solids(*twin), [&](const Solid_answer& told) { return told.overlap == expected; });
}

Solid_relation reversed(Solid_relation relation)
{
  switch (relation) {
    case Solid_relation::inside: return Solid_relation::contains;
    case Solid_relation::contains: return Solid_relation::inside;
    case Solid_relation::covered_by: return Solid_relation::covers;
    case Solid_relation::covers: return Solid_relation::covered_by;
    default: return relation;
  }
}

/// A lies in B.
bool is_within(Solid_relation relation)
{
  return relation == Solid_relation::equal || relation == Solid_relation::inside ||
         relation == Solid_relation::covered_by;
}

Verdict shared_points(const Solid_level::Trial& t)
{
  const Outcome solid = t.subject(t.c, Question::solid), surface = t.subject(t.c, Question::surface);
  for (const Outcome outcome : {solid, surface})
    if (outcome != Outcome::yes && outcome != Outcome::no) return Verdict::not_applicable;
  const auto [relation, dimension] = t.given.overlap.contact;
  return verdict((relation != Solid_relation::disjoint) == (solid == Outcome::yes) &&
                 (dimension >= 0) == (surface == Outcome::yes));
}

Verdict swapped(const Solid_level::Trial& t)
{
  Solid_overlap expected = t.given.overlap;
  expected.contact.relation = reversed(expected.contact.relation);
  return overlap_is(expected, t, with_bodies_swapped(t.c));
}

Verdict mapped(const Solid_level::Trial& t)
{
  Solid_overlap expected = t.given.overlap;
  if (expected.volume != 0) {
    const auto column = [](int k) { return object_family::turned(affine_map(), Exact_vector{k == 0, k == 1, k == 2}); };
    expected.volume *= Rational(abs(object_family::dot(column(0), object_family::cross(column(1), column(2)))));
    expected.centroid = object_family::image(affine_map(), expected.centroid);
  }
  return overlap_is(expected, t, under_affine_map(t.c));
}

Verdict same_when_split(const Solid_level::Trial& t)
{
  return overlap_is(t.given.overlap, t, with_split_triangles(t.c));
}

Verdict same_in_any_order(const Solid_level::Trial& t)
{
  return overlap_is(t.given.overlap, t, in_another_order(t.c, t.random));
}

/// Returns a box about a body's vertices, which may touch them; nothing when the box would be flat, or beyond the
/// doubles.
std::optional<Polyhedron> box_about(const Polyhedron& what, Random& random)
{
  Corners about(what);
  kernel::Vertex &low = about.low, &high = about.high;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(low[k] < high[k])) return std::nullopt;
    if (one_of(random, 2) == 0) low[k] = std::nextafter(low[k], -HUGE_VAL);
    if (one_of(random, 2) == 0) high[k] = std::nextafter(high[k], HUGE_VAL);
    if (!std::isfinite(low[k]) || !std::isfinite(high[k])) return std::nullopt;
  }
  return box(low, high);
}

/// Relation: the third body is a box about B. What holds of A and B, and of B and the box, bounds what holds of A and
/// the box.
Verdict transitive(const Solid_level::Trial& t)
{
  const bool is_swapped = is_within(reversed(t.given.overlap.contact.relation));
  const Object_case c = is_swapped ? with_bodies_swapped(t.c) : t.c;
  const Solid_relation of_b =
      is_swapped ? reversed(t.given.overlap.contact.relation) : t.given.overlap.contact.relation;
  auto box = box_about(*c.b, t.random);
  if (!box) return Verdict::not_applicable;
  Object_case twin = c;
  twin.b = as_shared(std::move(*box));
  const auto of_box = t.subject.solids(twin);
  twin.a = c.b;
  twin.pose_a = c.pose_b;
  const auto between = t.subject.solids(twin);
  if (of_box.outcome != Outcome::yes || between.outcome != Outcome::yes) return Verdict::not_applicable;
  const Solid_relation of_c = of_box.answer.overlap.contact.relation,
                       of_b_and_c = between.answer.overlap.contact.relation;
  if (!is_within(of_b_and_c)) return Verdict::violated;
  if (is_within(of_b)) {
    const bool is_strict = of_b == Solid_relation::inside || of_b_and_c == Solid_relation::inside;
    return verdict(is_strict ? of_c == Solid_relation::inside : is_within(of_c));
  }
  if (of_c == Solid_relation::disjoint) return verdict(of_b == Solid_relation::disjoint);
  return verdict(of_b != Solid_relation::overlap || of_c != Solid_relation::meet);
}

/// Returns the middle of the corners of a placed body's faces.
Exact_vector middle_of_corners(const Polyhedron& body, const Pose& pose)
{
  Exact_vector total = {0, 0, 0};
  for (covering::Index f = 0; f < body.face_count(); ++f)
    for (std::size_t l = 0; l < body.loop_count(f); ++l)
      for (const covering::Index v : body.loop(f, l))
        total = object_family::sum(total, object_family::exact(body.vertices[v]));
  return object_family::image(pose, object_family::times(Rational(1) / Rational(long(body.corner_count())), total));
}

/// Relation: convex solids that meet in p overlap when B moves by a share of the way between inner points, from b to a.
/// The point at that share of the way from p to a is then inside both.
Verdict nudged(const Solid_level::Trial& t)
{
  if (t.given.overlap.contact.relation != Solid_relation::meet || !is_convex(*t.c.a) || !is_convex(*t.c.b))
    return Verdict::not_applicable;
  const Exact_vector way =
      object_family::difference(middle_of_corners(*t.c.a, t.c.pose_a), middle_of_corners(*t.c.b, t.c.pose_b));
  const Rational share(1, 1L << (10 + one_of(t.random, 40)));
  const auto twin = with_moved(t.c, &Object_case::pose_b, object_family::times(share, way));
  if (!twin) return Verdict::not_applicable;
  return verdict(t.subject.solids(*twin), [](const Solid_answer& told) {
    const Solid_relation relation = told.overlap.contact.relation;
    return relation != Solid_relation::disjoint && relation != Solid_relation::meet && told.overlap.volume > 0;
  });
}

constexpr std::array of_solids = std::to_array<Solid_level::Relation>({
    {"R1 collide", "solids are disjoint, and contacts have no dimension, exactly where they do not collide",
     shared_points},
    {"R5 swap", "A and B may be swapped, which exchanges inside and contains", swapped},
    {"R6 affine", "a common affine map keeps the relation and maps the overlap", mapped},
    {"R7 face", "triangles split at inner points give the same answer", same_when_split},
    {"R8 order", "vertices and faces may stand in any order, and loops run either way", same_in_any_order},
    {"R9 transitive", "what lies in B lies in a box about B, and what overlaps B overlaps the box", transitive},
    {"R13 nudge", "the interiors of convex solids that meet share a volume after a nudge inward", nudged},
});

}  // namespace

std::span<const Solid_level::Relation> solid_relations() { return of_solids; }

}  // namespace tetracone::verify
