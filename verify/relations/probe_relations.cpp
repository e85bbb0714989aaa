#include "verify/cases/exact_motion.h"
#include "verify/relations/changed_bodies.h"
#include "verify/relations/relations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace tetracone::verify {
namespace {

using covering::Index;
using covering::Polyhedron;
using kernel::Vertex;

Probe_case about(const Probe_case& c, Polyhedron body)
{
  Probe_case twin = c;
  twin.body = std::make_shared<const Polyhedron>(std::move(body));
  return twin;
}

/// One and the other under a signed permutation of the axes, times a power of two and a shift that all take exactly.
/// There is at least the permutation.
Probe_case mapped(const Probe_case& c, Random& random)
{
  const auto p = Signed_permutation::any(random);
  const int exponent = int(one_of(random, 61)) - 30;
  double scale = magnitude(c.from);
  for (const Vertex& v : c.body->vertices) scale = std::max(scale, magnitude(v));
  Vertex shift;
  for (double& x : shift) x = ulp(scale) * double(one_of(random, 4096));
  const auto turn = [&](const Vertex& v) { return std::optional(p(v)); };
  const auto scaled = [&](const Vertex& v) { return exact_scaled(p(v), exponent); };
  const auto moved = [&](const Vertex& v) {
    const auto sum = exact_sum(p(v), shift);
    return sum ? exact_scaled(*sum, exponent) : std::nullopt;
  };
  const auto twin = [&](const auto& change, const auto& turned) -> std::optional<Probe_case> {
    auto body = with_vertices(*c.body, change);
    const auto from = change(c.from), direction = turned(c.direction);
    if (!body || !from || !direction) return std::nullopt;
    Probe_case result = about(c, std::move(*body));
    result.from = *from;
    result.direction = *direction;
    return result;
  };
  if (const auto all = twin(moved, scaled)) return *all;
  if (const auto larger = twin(scaled, scaled)) return *larger;
  return *twin(turn, turn);
}

// --- points ----------------------------------------------------------------------------------------------------------

Verdict same_place(const Point_level::Trial& t, const Probe_case& twin)
{
  const auto place = t.subject(t.c), of_twin = t.subject(twin);
  if (place.outcome != Outcome::yes || of_twin.outcome != Outcome::yes) return Verdict::not_applicable;
  return verdict(place.answer == of_twin.answer);
}

Verdict point_in_any_order(const Point_level::Trial& t)
{
  return same_place(t, about(t.c, reordered(*t.c.body, t.random).body));
}

Verdict point_wound_backwards(const Point_level::Trial& t)
{
  return same_place(t, about(t.c, wound_backwards(*t.c.body).body));
}

Verdict point_mapped(const Point_level::Trial& t) { return same_place(t, mapped(t.c, t.random)); }

Verdict point_split(const Point_level::Trial& t)
{
  const auto split = split_inside(*t.c.body);
  return split ? same_place(t, about(t.c, split->body)) : Verdict::not_applicable;
}

Verdict point_twice(const Point_level::Trial& t)
{
  Polyhedron twice = *t.c.body;
  for (Index f = 0; f < t.c.body->face_count(); ++f) twice.add_face(loops_of(*t.c.body, f));
  return same_place(t, about(t.c, std::move(twice)));
}

/// An unused vertex moves the origin of the covering.
Verdict point_from_another_origin(const Point_level::Trial& t)
{
  Polyhedron more = *t.c.body;
  const Vertex extra = more.vertices[one_of(t.random, more.vertices.size())];
  for (int k = 0; k < 3; ++k) more.vertices.push_back(extra);
  return same_place(t, about(t.c, std::move(more)));
}

// --- rays ------------------------------------------------------------------------------------------------------------

/// The least t of each face.
using Met = std::map<Index, double>;

std::optional<Met> met(const Ray_level::Trial& t, const Probe_case& c)
{
  const auto told = t.subject(c);
  if (told.outcome != Outcome::yes) return std::nullopt;
  Met met;
  for (const Ray_hit& hit : told.answer.all) met[hit.face] = hit.t;
  return met;
}

/// Relation: the twin's ray meets the case's faces at equal t. The twin's faces are parts of the case's.
Verdict same_hits(const Ray_level::Trial& t, const Changed_body& changed)
{
  const auto here = met(t, t.c), there = met(t, about(t.c, changed.body));
  if (!here || !there) return Verdict::not_applicable;
  Met whole;
  for (const auto& [part, at] : *there) {
    const auto [least, is_new] = whole.try_emplace(changed.of_face[part], at);
    if (!is_new) least->second = std::min(least->second, at);
  }
  return verdict(whole == *here);
}

Verdict ray_in_any_order(const Ray_level::Trial& t) { return same_hits(t, reordered(*t.c.body, t.random)); }

Verdict ray_wound_backwards(const Ray_level::Trial& t) { return same_hits(t, wound_backwards(*t.c.body)); }

Verdict ray_split(const Ray_level::Trial& t)
{
  const auto split = split_inside(*t.c.body);
  return split ? same_hits(t, *split) : Verdict::not_applicable;
}

Verdict ray_mapped(const Ray_level::Trial& t)
{
  const auto here = met(t, t.c), there = met(t, mapped(t.c, t.random));
  return here && there ? verdict(*here == *there) : Verdict::not_applicable;
}

/// Relation: for a direction 2^k times as long, t is 2^-k times as large, unless that is denormal or infinite.
Verdict ray_of_other_length(const Ray_level::Trial& t)
{
  const int exponent = int(one_of(t.random, 121)) - 60;
  const auto direction = exact_scaled(t.c.direction, exponent);
  if (!direction) return Verdict::not_applicable;
  Probe_case twin = t.c;
  twin.direction = *direction;
  const auto here = met(t, t.c), there = met(t, twin);
  if (!here || !there) return Verdict::not_applicable;
  if (here->size() != there->size()) return Verdict::violated;
  const auto is_plain = [](double x) { return x == 0 || std::isnormal(x); };
  for (const auto& [face, at] : *here) {
    const auto found = there->find(face);
    if (found == there->end()) return Verdict::violated;
    const double expected = std::ldexp(at, -exponent);
    if (is_plain(at) && is_plain(expected) && is_plain(found->second) && found->second != expected)
      return Verdict::violated;
  }
  return Verdict::holds;
}

/// Relation: a ray back from the position at t = k meets the faces in between, too.
Verdict ray_reversed(const Ray_level::Trial& t)
{
  const int exponent = int(one_of(t.random, 5));
  const double end = std::ldexp(1.0, exponent);
  const auto way = exact_scaled(t.c.direction, exponent);
  const auto from = way ? exact_sum(t.c.from, *way) : std::nullopt;
  if (!from) return Verdict::not_applicable;
  Probe_case twin = t.c;
  twin.from = *from;
  for (double& x : twin.direction) x = -x;
  const auto here = met(t, t.c), back = met(t, twin);
  if (!here || !back) return Verdict::not_applicable;
  for (const auto& [face, at] : *here) {
    const auto found = back->find(face);
    if (at < end && found == back->end()) return Verdict::violated;
    if (at > end && found != back->end() && found->second < end) return Verdict::violated;
    // One point of the face at most is met twice.
    if (at < end && found != back->end() && found->second > end) return Verdict::violated;
  }
  for (const auto& [face, at] : *back)
    if (at < end && !here->contains(face)) return Verdict::violated;
  return Verdict::holds;
}

/// Relation: a ray that starts later meets the faces after its start as before.
Verdict ray_started_later(const Ray_level::Trial& t)
{
  const int exponent = int(one_of(t.random, 5)) - 2;
  const double start = std::ldexp(1.0, exponent);
  const auto way = exact_scaled(t.c.direction, exponent);
  const auto from = way ? exact_sum(t.c.from, *way) : std::nullopt;
  if (!from) return Verdict::not_applicable;
  Probe_case twin = t.c;
  twin.from = *from;
  const auto here = met(t, t.c), later = met(t, twin);
  if (!here || !later) return Verdict::not_applicable;
  for (const auto& [face, at] : *here)
    if (at > start && !later->contains(face)) return Verdict::violated;
  for (const auto& [face, at] : *later)
    if (!here->contains(face)) return Verdict::violated;
  return Verdict::holds;
}

/// Relation: the first hit is the first of all hits, which are in order.
Verdict ray_first(const Ray_level::Trial& t)
{
  const auto told = t.subject(t.c);
  if (told.outcome != Outcome::yes) return Verdict::not_applicable;
  const auto& first = told.answer.first;
  const auto& all = told.answer.all;
  const bool is_ordered = std::ranges::is_sorted(all, [](const Ray_hit& x, const Ray_hit& y) { return x.t < y.t; });
  const bool is_first = all.empty() ? !first : first && *first == all.front();
  return verdict(is_ordered && is_first);
}

constexpr std::array of_points = std::to_array<Point_level::Relation>({
    {"R6 motion", "a common permutation of the axes, power of two and shift gives the same answer", point_mapped},
    {"R7 face", "triangles split at inner points give the same answer", point_split},
    {"R8 order", "vertices, faces and the first corners of loops may stand in any order", point_in_any_order},
    {"R8 winding", "all loops may run the other way round", point_wound_backwards},
    {"R9 twice", "the same surface a second time gives the same answer", point_twice},
    {"R10 unused", "vertices of no face, which move the covering's origin, give the same answer",
     point_from_another_origin},
});

constexpr std::array of_rays = std::to_array<Ray_level::Relation>({
    {"R1 first", "the first face met is the first of all, which are in order", ray_first},
    {"R5 reversed", "a ray back meets the same faces between its ends", ray_reversed},
    {"R5 later", "a later start on the ray meets what comes after it", ray_started_later},
    {"R6 motion", "a common permutation of the axes, power of two and shift keeps every t", ray_mapped},
    {"R6 length", "a direction 2^k as long makes every t 2^-k as large", ray_of_other_length},
    {"R7 face", "triangles split at inner points are met as the whole", ray_split},
    {"R8 order", "vertices, faces and the first corners of loops may stand in any order", ray_in_any_order},
    {"R8 winding", "all loops may run the other way round", ray_wound_backwards},
});

}  // namespace

std::span<const Point_level::Relation> point_relations() { return of_points; }

std::span<const Ray_level::Relation> ray_relations() { return of_rays; }

}  // namespace tetracone::verify
