#include "tetracone/covering/covering.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "verify/cases/exact_motion.h"
#include "verify/cases/tetrahedron.h"
#include "verify/relations/changed_bodies.h"
#include "verify/relations/convex_body.h"
#include "verify/relations/moved_twins.h"
#include "verify/relations/relations.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using covering::Index;
using covering::Polyhedron;
using kernel::Adaptive;
using kernel::Pose;
using kernel::Question;
using kernel::Rational;
using kernel::Vertex;
using Answer = std::optional<bool>;
using Loops = std::vector<std::vector<Index>>;

Answer ask(const Object_level::Trial& t, const Object_case& c)
{
  const Outcome outcome = t.subject(c, t.question);
  return outcome == Outcome::yes ? Answer(true) : outcome == Outcome::no ? Answer(false) : std::nullopt;
}

Verdict same(const Object_level::Trial& t, const Object_case& twin)
{
  const Answer answer = ask(t, t.c);
  if (!answer) return Verdict::not_applicable;
  const Answer of_twin = ask(t, twin);
  return of_twin ? verdict(*answer == *of_twin) : Verdict::not_applicable;
}

/// One of the two bodies of a case, with its pose.
struct Posed_body {
  std::shared_ptr<const Polyhedron>& polyhedron;
  Pose& pose;

  void become(Polyhedron changed) { polyhedron = std::make_shared<const Polyhedron>(std::move(changed)); }
};
Posed_body body(Object_case& c, std::size_t which)
{
  return which == 0 ? Posed_body{c.a, c.pose_a} : Posed_body{c.b, c.pose_b};
}

/// Returns the polyhedron with the vertices of `what` and the faces that change(loops of face, add) adds for each of
/// its faces.
template <class Change>
Polyhedron with_faces(std::vector<Vertex> vertices, const Polyhedron& what, const Change& change)
{
  Polyhedron result;
  result.vertices = std::move(vertices);
  for (Index f = 0; f < what.face_count(); ++f) change(f, loops_of(what, f), result);
  return result;
}

/// The largest coordinate of a vertex or of a translation.
double scale_of(const Object_case& c)
{
  double largest = largest_translation(c.pose_a, c.pose_b);
  for (const auto& polyhedron : {c.a, c.b})
    for (const Vertex& v : polyhedron->vertices) largest = std::max(largest, magnitude(v));
  return largest;
}

// --- motions ---------------------------------------------------------------------------------------------------------

Verdict absorbed(const Object_level::Trial& t)
{
  Object_case twin = t.c;
  bool changed = false;
  for (const std::size_t which : {0, 1}) {
    Posed_body it = body(twin, which);
    if (it.pose.is_identity()) continue;
    if (auto placed = with_vertices(*it.polyhedron, [&](const Vertex& v) { return exact_image(it.pose, v); })) {
      it.become(std::move(*placed));
      it.pose = Pose();
      changed = true;
    }
  }
  if (!changed) {  // the part of a motion that any double can take: a permutation of the axes
    Posed_body it = body(twin, one_of(t.random, 2));
    const auto p = Signed_permutation::any(t.random);
    it.become(*with_vertices(*it.polyhedron, [&](const Vertex& v) -> std::optional<Vertex> { return p(v); }));
    it.pose = turned_back(it.pose, p);
  }
  return same(t, twin);
}

Verdict swap(const Object_level::Trial& t) { return same(t, with_bodies_swapped(t.c)); }

Verdict relative(const Object_level::Trial& t)
{
  Object_case twin = t.c;
  const std::size_t which = one_of(t.random, 2);
  Posed_body still = body(twin, which), other = body(twin, 1 - which);
  if (still.pose.is_identity()) return Verdict::not_applicable;
  const auto pose = seen_from(still.pose, other.pose);
  if (!pose) return Verdict::not_applicable;
  other.pose = *pose;
  still.pose = Pose();
  return same(t, twin);
}

Verdict common_motion(const Object_level::Trial& t)
{
  Object_case twin = t.c;
  const auto p = Signed_permutation::any(t.random);
  if (!move_together(twin, p, scale_of(t.c), t.random)) return Verdict::not_applicable;
  return same(t, twin);
}

Verdict scaling(const Object_level::Trial& t)
{
  const int exponent = (one_of(t.random, 2) == 0 ? 1 : -1) * int(1 + one_of(t.random, 40));
  Object_case twin = t.c;
  for (const std::size_t which : {0, 1}) {
    Posed_body it = body(twin, which);
    auto bodies = with_vertices(*it.polyhedron, [&](const Vertex& v) { return exact_scaled(v, exponent); });
    const auto pose = scaled(it.pose, exponent);
    if (!bodies || !pose) return Verdict::not_applicable;
    it.become(std::move(*bodies));
    it.pose = *pose;
  }
  return same(t, twin);
}

// --- the same surface from other elements ----------------------------------------------------------------------------

/// The body with an edge split in its middle: a triangle at it becomes two, any other face gets a corner more.
std::optional<Polyhedron> with_split_edge(const Polyhedron& what, Random& random)
{
  const covering::Covering covering(what);
  const auto& edges = covering.edges();
  for (int attempt = 0; attempt < 16; ++attempt) {
    const auto [u, v] = edges[one_of(random, edges.size())];
    const auto middle = exact_middle(what.vertices[u], what.vertices[v]);
    if (u == v || !middle) continue;
    std::vector<Vertex> vertices = what.vertices;
    const Index m = vertices.size();
    vertices.push_back(*middle);
    return with_faces(vertices, what, [&, u = u, v = v](Index f, Loops loops, Polyhedron& result) {
      std::size_t uses = 0;
      for (auto& loop : loops) {
        std::vector<Index> longer;
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const Index from = loop[k], to = loop[(k + 1) % loop.size()];
          longer.push_back(from);
          if ((from == u && to == v) || (from == v && to == u)) {
            longer.push_back(m);
            ++uses;
          }
        }
        loop = longer;
      }
      if (!what.is_triangle(f) || uses != 1) return result.add_face(loops);
      std::vector<Index>& loop = loops[0];  // from m on: m, to, opposite, from
      std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), m), loop.end());
      result.add_polygon({loop[0], loop[1], loop[2]});
      result.add_polygon({loop[0], loop[2], loop[3]});
    });
  }
  return std::nullopt;
}

/// True when b and d are on different sides of the line through a and c, all in one plane. Then abcd is the union of
/// the triangles abc and acd.
bool is_diagonal(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d)
{
  for (int axis = 0; axis < 3; ++axis) {
    const auto turn = [&](const Vertex& x) {
      return Adaptive::normal_sign(Adaptive::unmoved(a), Adaptive::unmoved(c), Adaptive::unmoved(x), axis);
    };
    if (turn(b) * turn(d) == CGAL::NEGATIVE) return true;
  }
  return false;
}

/// The body with a triangle split in three at an inner point, or a quadrangle in two along a diagonal.
std::optional<Polyhedron> with_split_face(const Polyhedron& what, Random& random)
{
  for (int attempt = 0; attempt < 16; ++attempt) {
    const Index split = one_of(random, what.face_count());
    if (what.loop_count(split) != 1) continue;
    const auto loop = what.loop(split, 0);
    const std::size_t n = loop.size(), start = one_of(random, n);
    const auto corner = [&](std::size_t k) { return loop[(start + k) % n]; };
    const auto vertex = [&](std::size_t k) -> const Vertex& { return what.vertices[corner(k)]; };
    std::vector<Vertex> vertices = what.vertices;
    std::vector<std::vector<Index>> parts;
    if (n == 3) {
      const auto side = exact_middle(vertex(0), vertex(1));
      const auto inner = side ? exact_middle(*side, vertex(2)) : std::nullopt;
      if (!inner) continue;
      const Index m = vertices.size();
      vertices.push_back(*inner);
      for (std::size_t k = 0; k < 3; ++k) parts.push_back({corner(k), corner(k + 1), m});
    } else if (n == 4 && is_diagonal(vertex(0), vertex(1), vertex(2), vertex(3))) {
      parts = {{corner(0), corner(1), corner(2)}, {corner(0), corner(2), corner(3)}};
    } else {
      continue;
    }
    return with_faces(vertices, what, [&](Index f, const Loops& loops, Polyhedron& result) {
      if (f != split) return result.add_face(loops);
      for (const auto& part : parts) result.add_polygon(part);
    });
  }
  return std::nullopt;
}

/// The relation that a change of one body, chosen at random, changes no answer.
template <std::optional<Polyhedron> (*change)(const Polyhedron&, Random&)>
Verdict unchanged_by(const Object_level::Trial& t)
{
  Object_case twin = t.c;
  Posed_body it = body(twin, one_of(t.random, 2));
  auto changed = change(*it.polyhedron, t.random);
  if (!changed) return Verdict::not_applicable;
  it.become(std::move(*changed));
  return same(t, twin);
}

std::optional<Polyhedron> in_any_order(const Polyhedron& what, Random& random) { return reordered(what, random).body; }

std::optional<Polyhedron> backwards(const Polyhedron& what, Random&) { return wound_backwards(what).body; }

// --- more and less of a body -----------------------------------------------------------------------------------------

/// Returns the body with one more tetrahedron: anywhere about it or, because winding numbers of nested shells add up
/// and may cancel, beside its box.
std::optional<Polyhedron> with_tetrahedron(const Polyhedron& what, bool beside, Random& random)
{
  const Corners box(what);
  Vertex corner;
  for (int k = 0; k < 3; ++k) corner[k] = box.low[k] + random.unit() * box.extent;
  const std::size_t axis = one_of(random, 3);
  if (beside) corner[axis] = box.high[axis] + box.extent * (0.125 + random.unit());
  std::array<Vertex, 4> corners;
  corners.fill(corner);
  for (int k = 0; k < 3; ++k) corners[k + 1][k] += box.extent * (0.25 + random.unit());
  for (const Vertex& v : corners)
    if (!std::isfinite(magnitude(v)) || (beside && !(v[axis] > box.high[axis]))) return std::nullopt;
  Polyhedron result = what;
  add_tetrahedron(result, corners);
  return result;
}

Verdict adding(const Object_level::Trial& t)
{
  Object_case twin = t.c;
  Posed_body it = body(twin, one_of(t.random, 2));
  auto more = with_tetrahedron(*it.polyhedron, t.question == Question::solid, t.random);
  if (!more) return Verdict::not_applicable;
  it.become(std::move(*more));
  if (ask(t, t.c) != true) return Verdict::not_applicable;
  const Answer with_more = ask(t, twin);
  return !with_more ? Verdict::not_applicable : *with_more ? Verdict::holds : Verdict::violated;
}

Verdict removing(const Object_level::Trial& t)
{
  // Without a face a surface is less of it, but no solid's.
  if (t.question != Question::surface) return Verdict::not_applicable;
  Object_case twin = t.c;
  Posed_body it = body(twin, one_of(t.random, 2));
  auto rest = without_a_face(*it.polyhedron, t.random);
  if (!rest) return Verdict::not_applicable;
  it.become(std::move(*rest));
  if (ask(t, t.c) != false) return Verdict::not_applicable;
  const Answer with_less = ask(t, twin);
  return !with_less ? Verdict::not_applicable : *with_less ? Verdict::violated : Verdict::holds;
}

// --- another origin of the covering ----------------------------------------------------------------------------------

/// The origin is the mean of all vertices, of those that no face has too: a vertex repeated draws it there, a far one
/// elsewhere.
std::optional<Polyhedron> with_unused_vertices(const Polyhedron& what, Random& random)
{
  Polyhedron result = what;
  const Corners box(what);
  Vertex unused = what.vertices[one_of(random, what.vertices.size())];
  if (one_of(random, 2) == 0)
    for (double& coordinate : unused) coordinate += 8 * box.extent * random.symmetric();
  if (!std::isfinite(magnitude(unused))) return std::nullopt;
  result.vertices.insert(result.vertices.end(), 1 + one_of(random, 4 * what.vertices.size()), unused);
  return result;
}

Verdict opposite_moves(const Object_level::Trial& t)
{
  Object_case twin = t.c;
  Posed_body it = body(twin, one_of(t.random, 2));
  double largest = 0;
  for (const Vertex& v : it.polyhedron->vertices) largest = std::max(largest, magnitude(v));
  const double unit = ulp(largest) * std::ldexp(1.0, int(one_of(t.random, 53)));
  for (int attempt = 0; attempt < 8; ++attempt) {
    Vertex d;
    for (double& coordinate : d) coordinate = unit * double(int(one_of(t.random, 17)) - 8);
    auto moved = with_vertices(*it.polyhedron, [&](const Vertex& v) { return exact_sum(v, d); });
    const auto pose = translated_back(it.pose, d);
    if (!moved || !pose || d == Vertex{0, 0, 0}) continue;
    it.become(std::move(*moved));
    it.pose = *pose;
    return same(t, twin);
  }
  return Verdict::not_applicable;
}

// --- along a translation ---------------------------------------------------------------------------------------------

Verdict monotone(const Object_level::Trial& t)
{
  // A surface inside another convex one does not meet it, on either side of that it does.
  if (t.question != Question::solid || !is_convex(*t.c.a) || !is_convex(*t.c.b)) return Verdict::not_applicable;
  std::vector<bool> answers;
  for (const Pose& pose : poses_along_axis(t.c.pose_b, scale_of(t.c), t.random)) {
    Object_case twin = t.c;
    twin.pose_b = pose;
    if (const Answer answer = ask(t, twin)) answers.push_back(*answer);
  }
  if (answers.size() < 3) return Verdict::not_applicable;
  const auto first = std::find(answers.begin(), answers.end(), true);
  const auto end = std::find(first, answers.end(), false);
  return std::find(end, answers.end(), true) == answers.end() ? Verdict::holds : Verdict::violated;
}

constexpr std::array of_objects = std::to_array<Object_level::Relation>({
    {"R3 absorbed", "a motion done to the vertices beforehand, exactly, gives the same answer", absorbed},
    {"R5 swap", "A and B may be swapped", swap},
    {"R5 relative",
     "one body may stand still and the other be moved as seen from it, where the inverse motion is exact", relative},
    {"R6 motion", "a common permutation of the axes and translation gives the same answer", common_motion},
    {"R6 scale", "everything times a power of two gives the same answer", scaling},
    {"R7 edge", "an edge split in its middle, for all faces at it, gives the same answer",
     unchanged_by<with_split_edge>},
    {"R7 face", "a face split at an inner point or along a diagonal gives the same answer",
     unchanged_by<with_split_face>},
    {"R8 order", "vertices, faces and the first corners of loops may stand in any order", unchanged_by<in_any_order>},
    {"R8 winding", "all loops may run the other way round", unchanged_by<backwards>},
    {"R9 adding", "a shell more keeps a collision", adding},
    {"R9 removing", "a face less keeps surfaces apart", removing},
    {"R10 unused", "vertices of no face, which move the covering's origin, give the same answer",
     unchanged_by<with_unused_vertices>},
    {"R10 opposite", "vertices moved and the pose moved back, exactly, give the same answer", opposite_moves},
    {"R13 monotone", "along a translation, convex solids meet in one stretch", monotone},
});

}  // namespace

std::span<const Object_level::Relation> object_relations() { return of_objects; }

}  // namespace tetracone::verify
