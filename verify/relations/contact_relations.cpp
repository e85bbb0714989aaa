#include "verify/relations/moved_twins.h"
#include "verify/relations/relations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using covering::Index;
using kernel::Piece;
using kernel::Rational;

Verdict swapped_features(const Feature_level::Trial& t)
{
  const auto forth = t.subject.features(t.c);
  auto back = t.subject.features(with_bodies_swapped(t.c));
  if (forth.outcome != Outcome::yes || back.outcome != Outcome::yes) return Verdict::not_applicable;
  for (kernel::Feature_pair& pair : back.answer) pair.body = 1 - pair.body;
  std::sort(back.answer.begin(), back.answer.end());
  return verdict(forth.answer == back.answer);
}

Verdict swapped_contacts(const Contact_level::Trial& t)
{
  return verdict(t.subject.contacts(with_bodies_swapped(t.c)), [&](Contact_forms back) {
    for (Contact_piece_form& form : back) {
      std::swap(form.face_a, form.face_b);
      std::swap(form.in_a, form.in_b);
    }
    std::sort(back.begin(), back.end());
    return t.given == back;
  });
}

Verdict mapped_contacts(const Contact_level::Trial& t)
{
  const auto twin = under_affine_map(t.c);
  if (!twin) return Verdict::not_applicable;
  Contact_forms expected = t.given;
  for (Contact_piece_form& form : expected) {
    for (auto& [from, to] : form.border) {
      from = object_family::image(affine_map(), from);
      to = object_family::image(affine_map(), to);
      if (to < from) std::swap(from, to);
    }
    std::sort(form.border.begin(), form.border.end());
  }
  std::sort(expected.begin(), expected.end());
  return verdict(t.subject.contacts(*twin), [&](const Contact_forms& found) { return expected == found; });
}

Verdict contacts_where_surfaces_meet(const Contact_level::Trial& t)
{
  const Outcome outcome = t.subject(t.c, t.question);
  if (outcome != Outcome::yes && outcome != Outcome::no) return Verdict::not_applicable;
  return verdict(t.given.empty() == (outcome == Outcome::no));
}

/// Segments and points as one set, whatever the faces.
std::vector<Exact_segment> point_set(const Contact_forms& forms)
{
  std::vector<Exact_segment> all;
  for (const Contact_piece_form& form : forms) all.insert(all.end(), form.border.begin(), form.border.end());
  return maximal_segments(all);
}

/// A with each triangle halved whose first edge has a middle in doubles.
std::optional<covering::Polyhedron> halved(const covering::Polyhedron& polyhedron)
{
  covering::Polyhedron halves;
  halves.vertices = polyhedron.vertices;
  bool changed = false;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const covering::Loop loop = polyhedron.loop(f, 0);
    kernel::Vertex middle{};
    bool exact = polyhedron.is_triangle(f);
    for (std::size_t k = 0; exact && k < 3; ++k) {
      const double x = polyhedron.vertices[loop[0]][k], y = polyhedron.vertices[loop[1]][k];
      middle[k] = x / 2 + y / 2;
      exact = std::isfinite(middle[k]) && 2 * Rational(middle[k]) == Rational(x) + Rational(y);
    }
    if (exact) {
      const Index m = Index(halves.vertices.size());
      halves.vertices.push_back(middle);
      halves.add_polygon({loop[0], m, loop[2]});
      halves.add_polygon({m, loop[1], loop[2]});
      changed = true;
      continue;
    }
    halves.add_face(loops_of(polyhedron, f));
  }
  return changed ? std::optional(halves) : std::nullopt;
}

Verdict contacts_of_halves(const Contact_level::Trial& t)
{
  const auto is_polygon = [](const Contact_piece_form& form) { return form.kind == Piece::polygon; };
  if (std::ranges::any_of(t.given, is_polygon)) return Verdict::not_applicable;
  const auto halves = halved(*t.c.a);
  if (!halves) return Verdict::not_applicable;
  Object_case twin = t.c;
  twin.a = std::make_shared<const covering::Polyhedron>(*halves);
  return verdict(t.subject.contacts(twin),
                 [&](const Contact_forms& found) { return point_set(t.given) == point_set(found); });
}

constexpr std::array of_features = std::to_array<Feature_level::Relation>({
    {"R5 swap", "the pairs of A and B are those of B and A, with the bodies exchanged", swapped_features},
});

constexpr std::array of_contacts = std::to_array<Contact_level::Relation>({
    {"R5 swap", "A and B may be swapped, which swaps faces and features", swapped_contacts},
    {"R6 affine", "a common affine map maps the pieces", mapped_contacts},
    {"R1 surface", "there are contacts exactly where the surfaces share a point", contacts_where_surfaces_meet},
    {"R7 halves", "triangles cut in half share the same points", contacts_of_halves},
});

}  // namespace

std::span<const Feature_level::Relation> feature_relations() { return of_features; }

std::span<const Contact_level::Relation> contact_relations() { return of_contacts; }

}  // namespace tetracone::verify
