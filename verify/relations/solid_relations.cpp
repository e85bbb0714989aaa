#include "tetracone/kernel/number/pose.h"
#include "verify/cases/exact_map.h"
#include "verify/cases/exact_motion.h"
#include "verify/relations/changed_bodies.h"
#include "verify/relations/convex_body.h"
#include "verify/relations/moved_twins.h"
#include "verify/relations/relations.h"

#include <array>
#include <cmath>
#include <memory>
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
Verdict overlap_is(const Solid_overlap& expected, const Solid_level::Trial& t, const Object_case& twin)
{
  const auto told = t.subject.solids(twin);
  return told.outcome == Outcome::yes ? verdict(told.answer.overlap == expected) : Verdict::not_applicable;
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

/// The common map: not rigid, with fractions, and it turns bodies over.
const Pose& affine_map()
{
  static const Pose map({Rational(1, 3), 2, 0, 3, 0, -1, 1, 0, 1, 0, 3, Rational(-5, 7)});
  return map;
}

Verdict mapped(const Solid_level::Trial& t)
{
  const auto moved = [](const Pose& pose) {
    Entries entries;
    for (int column = 0; column < 4; ++column) {
      const Exact_vector x = {pose.exact(column), pose.exact(4 + column), pose.exact(8 + column)};
      const Exact_vector y =
          column < 3 ? object_family::turned(affine_map(), x) : object_family::image(affine_map(), x);
      for (int row = 0; row < 3; ++row) entries[4 * row + column] = y[row];
    }
    return exact_pose(entries, true);
  };
  const auto pose_a = moved(t.c.pose_a), pose_b = moved(t.c.pose_b);
  if (!pose_a || !pose_b) return Verdict::not_applicable;
  Object_case twin = t.c;
  twin.pose_a = *pose_a;
  twin.pose_b = *pose_b;
  Solid_overlap expected = t.given.overlap;
  if (expected.volume != 0) {
    const auto column = [](int k) { return object_family::turned(affine_map(), Exact_vector{k == 0, k == 1, k == 2}); };
    expected.volume *= Rational(abs(object_family::dot(column(0), object_family::cross(column(1), column(2)))));
    expected.centroid = object_family::image(affine_map(), expected.centroid);
  }
  return overlap_is(expected, t, twin);
}

Verdict same_when_split(const Solid_level::Trial& t)
{
  const auto a = split_inside(*t.c.a), b = split_inside(*t.c.b);
  if (!a && !b) return Verdict::not_applicable;
  Object_case twin = t.c;
  if (a) twin.a = as_shared(a->body);
  if (b && one_of(t.random, 2) == 0) twin.b = as_shared(b->body);
  return overlap_is(t.given.overlap, t, twin);
}

Verdict same_in_any_order(const Solid_level::Trial& t)
{
  Object_case twin = t.c;
  twin.a = as_shared(reordered(*t.c.a, t.random).body);
  twin.b = as_shared(wound_backwards(*t.c.b).body);
  return overlap_is(t.given.overlap, t, twin);
}

/// Returns a box about a body's vertices, which may touch them; nothing when the box would be flat, or beyond the
/// doubles.
std::optional<Polyhedron> box_about(const Polyhedron& what, Random& random)
{
  kernel::Vertex low = what.vertices[0], high = low;
  for (const kernel::Vertex& v : what.vertices)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], v[k]);
      high[k] = std::max(high[k], v[k]);
    }
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(low[k] < high[k])) return std::nullopt;
    if (one_of(random, 2) == 0) low[k] = std::nextafter(low[k], -HUGE_VAL);
    if (one_of(random, 2) == 0) high[k] = std::nextafter(high[k], HUGE_VAL);
    if (!std::isfinite(low[k]) || !std::isfinite(high[k])) return std::nullopt;
  }
  Polyhedron box;
  for (const double z : {low[2], high[2]})
    for (const double y : {low[1], high[1]})
      for (const double x : {low[0], high[0]}) box.vertices.push_back({x, y, z});
  for (const auto& loop : std::to_array<std::array<covering::Index, 4>>(
           {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}))
    box.add_polygon(loop);
  return box;
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
  Entries entries = entries_of(t.c.pose_b);
  for (int row = 0; row < 3; ++row) entries[4 * row + 3] += share * way[row];
  const auto pose_b = exact_pose(entries, true);
  if (!pose_b) return Verdict::not_applicable;
  Object_case twin = t.c;
  twin.pose_b = *pose_b;
  const auto told = t.subject.solids(twin);
  if (told.outcome != Outcome::yes) return Verdict::not_applicable;
  const Solid_relation relation = told.answer.overlap.contact.relation;
  return verdict(relation != Solid_relation::disjoint && relation != Solid_relation::meet &&
                 told.answer.overlap.volume > 0);
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
