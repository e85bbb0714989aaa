#include "tetracone/kernel/number/pose.h"
#include "verify/relations/changed_bodies.h"
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
  auto back = t.subject.contacts(with_bodies_swapped(t.c));
  if (back.outcome != Outcome::yes) return Verdict::not_applicable;
  for (Contact_piece_form& form : back.answer) {
    std::swap(form.face_a, form.face_b);
    std::swap(form.in_a, form.in_b);
  }
  std::sort(back.answer.begin(), back.answer.end());
  return verdict(t.given == back.answer);
}

/// The common map: not rigid, and it turns bodies over.
constexpr std::array<int, 12> common_map = {1, 2, 0, 3, 0, -1, 1, 0, 1, 0, 3, -5};

Exact_point mapped(const Exact_point& x)
{
  Exact_point image;
  for (std::size_t i = 0; i < 3; ++i)
    image[i] =
        common_map[4 * i] * x[0] + common_map[4 * i + 1] * x[1] + common_map[4 * i + 2] * x[2] + common_map[4 * i + 3];
  return image;
}

/// Returns the mapped pose; nothing when an entry would be beyond the doubles.
std::optional<kernel::Pose> mapped(const kernel::Pose& pose)
{
  std::array<Rational, 12> entries;
  for (std::size_t column = 0; column < 4; ++column) {
    Exact_point x;
    for (std::size_t row = 0; row < 3; ++row) x[row] = pose.exact(int(4 * row + column));
    const Exact_point image = mapped(x);
    for (std::size_t row = 0; row < 3; ++row)
      entries[4 * row + column] = image[row] - (column < 3 ? common_map[4 * row + 3] : 0);
  }
  for (const Rational& entry : entries)
    if (!std::isfinite(kernel::nearest_double(entry))) return std::nullopt;
  return kernel::Pose(entries);
}

Verdict mapped_contacts(const Contact_level::Trial& t)
{
  const auto pose_a = mapped(t.c.pose_a), pose_b = mapped(t.c.pose_b);
  if (!pose_a || !pose_b) return Verdict::not_applicable;
  Object_case twin = t.c;
  twin.pose_a = *pose_a;
  twin.pose_b = *pose_b;
  const auto found = t.subject.contacts(twin);
  if (found.outcome != Outcome::yes) return Verdict::not_applicable;
  Contact_forms expected = t.given;
  for (Contact_piece_form& form : expected) {
    for (auto& [from, to] : form.border) {
      from = mapped(from);
      to = mapped(to);
      if (to < from) std::swap(from, to);
    }
    std::sort(form.border.begin(), form.border.end());
  }
  std::sort(expected.begin(), expected.end());
  return verdict(expected == found.answer);
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
  const auto found = t.subject.contacts(twin);
  if (found.outcome != Outcome::yes) return Verdict::not_applicable;
  return verdict(point_set(t.given) == point_set(found.answer));
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
