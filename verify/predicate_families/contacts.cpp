#include "verify/predicate_families/predicate_families.h"
#include "verify/predicate_families/predicate_points.h"

#include <utility>

namespace tetracone::verify::predicate_family {

using namespace points;

Predicate_case vertex_on_vertex(Random& random, double pose)
{
  constexpr std::array kinds = {Frame_kind::identity, Frame_kind::translation, Frame_kind::permutation,
                                Frame_kind::true_rotation, Frame_kind::rounded_rotation};
  const Frame_kind kind = kinds[static_cast<int>(pose)];
  if (kind == Frame_kind::rounded_rotation && one_in(random, 2)) {
    // B was turned back in doubles: the vertices are an ulp or so apart.
    const Tetra v = tetrahedron(random, 8);
    Scene scene{v, v[1], {}, {}};
    complete(random, scene);
    relabel(random, scene);
    Frames f = frames(random, kind);
    f.b = frames(random, kind).common;
    return placed_nearly(scene, f);
  }
  return settled([&] {
    const Tetra v = tetrahedron(random, 8);
    return contact(random, v, v[1], frames(random, kind));
  });
}

namespace {

/// A vertex in the simplex of the first `corners` of v1 v2 v3, at coordinates of `bits` bits.
Predicate_case vertex_on_element(Random& random, int corners, int bits)
{
  return settled([&] {
    const Tetra v = tetrahedron_for(random, bits);
    const Point x = element_point(random, v, corners, bits);
    return contact(random, v, x, any_frames(random));
  });
}

}  // namespace

Predicate_case vertex_on_edge(Random& random, double k) { return vertex_on_element(random, 2, static_cast<int>(k)); }
Predicate_case vertex_on_face(Random& random, double k) { return vertex_on_element(random, 3, static_cast<int>(k)); }

Predicate_case edge_across_edge(Random& random, double k)
{
  return settled([&]() -> std::optional<Predicate_case> {
    const int bits = static_cast<int>(k), size = bits > 40 ? 1 : 4;
    const Tetra v = tetrahedron_for(random, bits);
    const Point x = element_point(random, v, 2, bits);
    // Across the edge anyhow, or in one of the planes that meet there.
    const int way = integer(random, 0, 3);
    Point along = way == 0 ? v[3] : way == 1 ? v[0] : grid_point(random, size);
    if (is_zero(cross(along, v[2]))) return std::nullopt;
    const Rational before = Rational(dyadic(random, bits));
    Rational after = 1 - before;
    switch (random.bits() % 8) {
      case 0: after = 0; break;
      case 1:
      case 2: after = -power_of_two(-bits); break;  // they don't reach one another
      default: break;
    }
    Scene scene{v, sum(x, Rational(-before), along), sum(x, after, along), outward(random, v, x)};
    if (one_in(random, 2)) std::swap(scene.p, scene.q);
    int ulps = 0;
    switch (random.bits() % 8) {
      case 0:
      case 1: ulps = sign(random); break;
      case 2:
        scene.p = outward(random, v, x);
        scene.q = outward(random, v, x);
        break;
      default: break;
    }
    return finished(random, scene, ulps);
  });
}

Predicate_case edge_along_edge(Random& random, double overlap)
{
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron(random, 1, true);
    const Rational start = 1 - Rational(overlap), length = Rational(integer(random, 1, 4)) / 2;
    Scene scene{v, between(v[1], v[2], start), between(v[1], v[2], start + length), outward(random, v, v[2])};
    if (one_in(random, 4)) std::swap(scene.p, scene.q);
    relabel(random, scene);
    const int ulps = one_in(random, 4) ? sign(random) : 0;
    return finished(random, scene, any_frames(random), ulps);
  });
}

Predicate_case edge_in_face_plane(Random& random, double kind)
{
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron(random, 8);
    Tetra corner = v;
    std::swap(corner[1], corner[integer(random, 1, 3)]);
    const auto in_face = [&] { return element_point(random, corner, 3, 4); };
    const Point inner = in_face(), on_edge = one_in(random, 2) ? corner[1] : element_point(random, corner, 2, 4);
    const auto beyond = [&](const Point& x, const Rational& s) { return between(in_face(), x, 1 + s); };
    Scene scene{v, {}, {}, {}};
    switch (static_cast<int>(kind)) {
      case 0:
        scene.p = beyond(on_edge, power_of_two(-integer(random, 0, 20)));
        scene.q = beyond(on_edge, 1);
        break;
      case 1:
        scene.p = beyond(on_edge, 1);
        scene.q = between(scene.p, inner, Rational(integer(random, 1, 4)));
        break;
      case 2:
        scene.p = inner;
        scene.q = in_face();
        break;
      default:
        scene.p = on_edge;
        scene.q = beyond(on_edge, 1);
        // Past a vertex on both sides, or the end on an edge or a vertex.
        if (is_zero(difference(on_edge, corner[1])) && one_in(random, 2)) {
          const Point way = difference(corner[3], corner[2]);
          scene.p = sum(on_edge, Rational(-1) / 2, way);
          scene.q = sum(on_edge, Rational(integer(random, 1, 3)) / 2, way);
        }
    }
    if (one_in(random, 2)) std::swap(scene.p, scene.q);
    scene.r = outward(random, v, on_edge);
    const int ulps = one_in(random, 4) ? sign(random) : 0;
    if (one_in(random, 2)) relabel(random, scene);
    return finished(random, scene, any_frames(random), ulps);
  });
}

// --- face and face ---------------------------------------------------------------------------------------------------

namespace {

/// Common part of two coplanar triangles; the numbers are those of the parameter of face-on-face.
enum class Sharing { all, part, inside, edge, vertex, nothing };

/// A place in the plane v1 v2 v3, in sixteenths of the sides v1 v2 and v1 v3.
using Place = std::array<int, 2>;

/// Three corners p q r in the face's plane, counterclockwise as v1 v2 v3 when `alike`. `apart`: by how much the shared
/// edge or vertex is missed.
Scene coplanar(Random& random, const Tetra& v, Sharing sharing, bool alike, const Rational& apart = 0)
{
  const auto in_face = [&] { return Place{integer(random, 1, 7), integer(random, 1, 7)}; };
  const auto below = [&] { return Place{integer(random, -8, 24), -integer(random, 1, 16)}; };
  const auto opposite = [&] { return Place{-integer(random, 1, 12), -integer(random, 1, 12)}; };
  std::array<Place, 3> corner;
  const auto area = [&] {
    const auto& [a, b, c] = corner;
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  do {
    switch (sharing) {
      case Sharing::all: corner = {{{0, 0}, {16, 0}, {0, 16}}}; break;
      case Sharing::part: corner = {in_face(), below(), opposite()}; break;
      case Sharing::inside: corner = {in_face(), in_face(), in_face()}; break;
      case Sharing::edge: corner = {Place{integer(random, -4, 8), 0}, Place{integer(random, 9, 20), 0}, below()}; break;
      case Sharing::vertex: corner = {Place{0, 0}, opposite(), opposite()}; break;
      case Sharing::nothing: corner = {opposite(), opposite(), opposite()}; break;
    }
  } while (area() == 0);
  if ((area() > 0) != alike) std::swap(corner[1], corner[2]);
  Tetra turned = v;  // which corner and edge
  const int turns = integer(random, 0, 2);
  for (int k = 0; k < 3; ++k) turned[1 + k] = v[1 + (k + turns) % 3];
  std::array<Point, 3> x;
  const int first = integer(random, 0, 2);
  for (int k = 0; k < 3; ++k) {
    const auto [a, b] = corner[(k + first) % 3];
    x[k] = in_plane(turned, Rational(a) / 16 - apart, Rational(b) / 16 - apart);
  }
  return {v, x[0], x[1], x[2]};
}

}  // namespace

Predicate_case face_on_face(Random& random, double overlap)
{
  return settled([&]() -> std::optional<Predicate_case> {
    const int kind = static_cast<int>(overlap);
    const Tetra v = tetrahedron(random, 8);
    Scene scene = coplanar(random, v, static_cast<Sharing>(kind % 6), kind >= 6);
    const int ulps = one_in(random, 4) ? sign(random) : 0;
    if (one_in(random, 4)) relabel(random, scene);
    return finished(random, scene, any_frames(random), ulps);
  });
}

Predicate_case coplanar_sharing(Random& random, double what)
{
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron(random, 8);
    const Rational apart = one_in(random, 3) ? power_of_two(-integer(random, 4, 30)) : Rational(0);
    const Sharing sharing = what == 0 ? Sharing::vertex : Sharing::edge;
    const bool alike = one_in(random, 2);
    Scene scene = coplanar(random, v, sharing, alike, apart);
    const int ulps = one_in(random, 3) ? sign(random) : 0;
    if (one_in(random, 4)) relabel(random, scene);
    return finished(random, scene, any_frames(random), ulps);
  });
}

Predicate_case t_junctions(Random& random, double k)
{
  return settled([&]() -> std::optional<Predicate_case> {
    // B's neighbour of the edge v1 v2 has it in two. It is divided at p, q is its end or on the other side of p, and r
    // is a corner.
    const int bits = static_cast<int>(k);
    const Tetra v = tetrahedron_for(random, bits);
    Scene scene{v, element_point(random, v, 2, bits), v[1], {}};
    if (one_in(random, 4)) scene.q = between(v[1], scene.p, 2);
    scene.r = outward(random, v, scene.p);
    if (one_in(random, 2)) {
      scene.q = outward(random, v, scene.p);
    }
    const int ulps = moved_aside(random, scene);
    return finished(random, scene, ulps);
  });
}

}  // namespace tetracone::verify::predicate_family
