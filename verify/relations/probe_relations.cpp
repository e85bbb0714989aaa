#include "verify/relations/probe_relations.h"

#include "verify/cases/exact_motion.h"
#include "verify/relations/changed_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

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

/// One and the other under a signed permutation of the axes, times a power of two and a shift that all take exactly;
/// at least the permutation.
Probe_case mapped(const Probe_case& c, Random& random, int& exponent)
{
  const auto p = Signed_permutation::any(random);
  exponent = int(one_of(random, 61)) - 30;
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
  exponent = 0;
  return *twin(turn, turn);
}

// --- points ----------------------------------------------------------------------------------------------------------

Verdict same_place(const Probe_case& c, const Probe_case& twin, Running_probe& subject)
{
  const auto place = subject.where(c), of_twin = subject.where(twin);
  if (!place || !of_twin) return Verdict::not_applicable;
  return *place == *of_twin ? Verdict::holds : Verdict::violated;
}

Verdict point_in_any_order(const Probe_case& c, Running_probe& subject, Random& random)
{
  return same_place(c, about(c, reordered(*c.body, random).body), subject);
}

Verdict point_wound_backwards(const Probe_case& c, Running_probe& subject, Random&)
{
  return same_place(c, about(c, wound_backwards(*c.body).body), subject);
}

Verdict point_mapped(const Probe_case& c, Running_probe& subject, Random& random)
{
  int exponent = 0;
  return same_place(c, mapped(c, random, exponent), subject);
}

Verdict point_split(const Probe_case& c, Running_probe& subject, Random&)
{
  const auto split = split_inside(*c.body);
  return split ? same_place(c, about(c, split->body), subject) : Verdict::not_applicable;
}

Verdict point_twice(const Probe_case& c, Running_probe& subject, Random&)
{
  Polyhedron twice = *c.body;
  for (Index f = 0; f < c.body->face_count(); ++f) twice.add_face(loops_of(*c.body, f));
  return same_place(c, about(c, std::move(twice)), subject);
}

/// An unused vertex moves the origin of the covering.
Verdict point_from_another_origin(const Probe_case& c, Running_probe& subject, Random& random)
{
  Polyhedron more = *c.body;
  const Vertex extra = more.vertices[one_of(random, more.vertices.size())];
  for (int k = 0; k < 3; ++k) more.vertices.push_back(extra);
  return same_place(c, about(c, std::move(more)), subject);
}

// --- rays ------------------------------------------------------------------------------------------------------------

/// The least t of each face.
using Met = std::map<Index, double>;

std::optional<Met> met(const Probe_case& c, Running_probe& subject)
{
  const auto told = subject.hits(c);
  if (!told) return std::nullopt;
  Met met;
  for (const Ray_hit& hit : told->all) met[hit.face] = hit.t;
  return met;
}

/// Relation: the twin's ray meets the case's faces at equal t. The twin's faces are parts of the case's.
Verdict same_hits(const Probe_case& c, const Changed_body& changed, Running_probe& subject)
{
  const auto here = met(c, subject), there = met(about(c, changed.body), subject);
  if (!here || !there) return Verdict::not_applicable;
  Met whole;
  for (const auto& [part, t] : *there) {
    const auto [at, is_new] = whole.try_emplace(changed.of_face[part], t);
    if (!is_new) at->second = std::min(at->second, t);
  }
  return whole == *here ? Verdict::holds : Verdict::violated;
}

Verdict ray_in_any_order(const Probe_case& c, Running_probe& subject, Random& random)
{
  return same_hits(c, reordered(*c.body, random), subject);
}

Verdict ray_wound_backwards(const Probe_case& c, Running_probe& subject, Random&)
{
  return same_hits(c, wound_backwards(*c.body), subject);
}

Verdict ray_split(const Probe_case& c, Running_probe& subject, Random&)
{
  const auto split = split_inside(*c.body);
  return split ? same_hits(c, *split, subject) : Verdict::not_applicable;
}

Verdict ray_mapped(const Probe_case& c, Running_probe& subject, Random& random)
{
  int exponent = 0;
  const auto here = met(c, subject), there = met(mapped(c, random, exponent), subject);
  if (!here || !there) return Verdict::not_applicable;
  return *here == *there ? Verdict::holds : Verdict::violated;
}

/// Relation: for a direction 2^k times as long, t is 2^-k times as large, unless that is denormal or infinite.
Verdict ray_of_other_length(const Probe_case& c, Running_probe& subject, Random& random)
{
  const int exponent = int(one_of(random, 121)) - 60;
  const auto direction = exact_scaled(c.direction, exponent);
  if (!direction) return Verdict::not_applicable;
  Probe_case twin = c;
  twin.direction = *direction;
  const auto here = met(c, subject), there = met(twin, subject);
  if (!here || !there) return Verdict::not_applicable;
  if (here->size() != there->size()) return Verdict::violated;
  const auto is_plain = [](double t) { return t == 0 || std::isnormal(t); };
  for (const auto& [face, t] : *here) {
    const auto found = there->find(face);
    if (found == there->end()) return Verdict::violated;
    const double expected = std::ldexp(t, -exponent);
    if (is_plain(t) && is_plain(expected) && is_plain(found->second) && found->second != expected)
      return Verdict::violated;
  }
  return Verdict::holds;
}

/// Relation: a ray back from the position at t = k meets the faces in between, too.
Verdict ray_reversed(const Probe_case& c, Running_probe& subject, Random& random)
{
  const int exponent = int(one_of(random, 5));
  const double end = std::ldexp(1.0, exponent);
  const auto way = exact_scaled(c.direction, exponent);
  const auto from = way ? exact_sum(c.from, *way) : std::nullopt;
  if (!from) return Verdict::not_applicable;
  Probe_case twin = c;
  twin.from = *from;
  for (double& x : twin.direction) x = -x;
  const auto here = met(c, subject), back = met(twin, subject);
  if (!here || !back) return Verdict::not_applicable;
  for (const auto& [face, t] : *here) {
    const auto found = back->find(face);
    if (t < end && found == back->end()) return Verdict::violated;
    if (t > end && found != back->end() && found->second < end) return Verdict::violated;
    // One point of the face at most is met twice.
    if (t < end && found != back->end() && found->second > end) return Verdict::violated;
  }
  for (const auto& [face, t] : *back)
    if (t < end && !here->contains(face)) return Verdict::violated;
  return Verdict::holds;
}

/// Relation: a ray that starts later meets the faces after its start as before.
Verdict ray_started_later(const Probe_case& c, Running_probe& subject, Random& random)
{
  const int exponent = int(one_of(random, 5)) - 2;
  const double start = std::ldexp(1.0, exponent);
  const auto way = exact_scaled(c.direction, exponent);
  const auto from = way ? exact_sum(c.from, *way) : std::nullopt;
  if (!from) return Verdict::not_applicable;
  Probe_case twin = c;
  twin.from = *from;
  const auto here = met(c, subject), later = met(twin, subject);
  if (!here || !later) return Verdict::not_applicable;
  for (const auto& [face, t] : *here)
    if (t > start && !later->contains(face)) return Verdict::violated;
  for (const auto& [face, t] : *later)
    if (!here->contains(face)) return Verdict::violated;
  return Verdict::holds;
}

/// Relation: the first hit is the first of all hits, which are in order.
Verdict ray_first(const Probe_case& c, Running_probe& subject, Random&)
{
  const auto told = subject.hits(c);
  if (!told) return Verdict::not_applicable;
  const bool is_ordered =
      std::ranges::is_sorted(told->all, [](const Ray_hit& x, const Ray_hit& y) { return x.t < y.t; });
  const bool is_first = told->all.empty() ? !told->first : told->first && *told->first == told->all.front();
  return is_ordered && is_first ? Verdict::holds : Verdict::violated;
}

constexpr std::array<Probe_relation, 6> of_points = {{
    {"R6 motion", "a common permutation of the axes, power of two and shift gives the same answer", point_mapped},
    {"R7 face", "triangles split at inner points give the same answer", point_split},
    {"R8 order", "vertices, faces and the first corners of loops may stand in any order", point_in_any_order},
    {"R8 winding", "all loops may run the other way round", point_wound_backwards},
    {"R9 twice", "the same surface a second time gives the same answer", point_twice},
    {"R10 unused", "vertices of no face, which move the covering's origin, give the same answer",
     point_from_another_origin},
}};

constexpr std::array<Probe_relation, 8> of_rays = {{
    {"R1 first", "the first face met is the first of all, which are in order", ray_first},
    {"R5 reversed", "a ray back meets the same faces between its ends", ray_reversed},
    {"R5 later", "a later start on the ray meets what comes after it", ray_started_later},
    {"R6 motion", "a common permutation of the axes, power of two and shift keeps every t", ray_mapped},
    {"R6 length", "a direction 2^k as long makes every t 2^-k as large", ray_of_other_length},
    {"R7 face", "triangles split at inner points are met as the whole", ray_split},
    {"R8 order", "vertices, faces and the first corners of loops may stand in any order", ray_in_any_order},
    {"R8 winding", "all loops may run the other way round", ray_wound_backwards},
}};

}  // namespace

std::span<const Probe_relation> point_relations() { return of_points; }

std::span<const Probe_relation> ray_relations() { return of_rays; }

}  // namespace tetracone::verify
