#include "verify/cases/object_placing.h"
#include "verify/families/object_families.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tetracone::verify::object_family {
namespace {

/// A tetrahedron with a corner at A's extreme vertex along `direction`, or a few ulps off it, and the rest beyond: no
/// pose moves it.
Object_case vertex_on_vertex_in_place(Random& random)
{
  const Body& a = any_shape(random).body;
  const Exact_vector direction = integer_direction(random, 16);
  const kernel::Vertex top = a->vertices[lowest(a->vertices, times(Rational(-1), direction))[0]];
  kernel::Vertex tip = top;
  for (int steps = random.bits() % 2 == 0 ? 0 : integer(random, -3, 3), i = integer(random, 0, 2); steps != 0;
       steps += steps > 0 ? -1 : 1)
    tip[i] = std::nextafter(tip[i], steps > 0 ? HUGE_VAL : -HUGE_VAL);
  std::array<kernel::Vertex, 3> beyond;
  for (kernel::Vertex& v : beyond)
    for (Exact_vector way = {0, 0, 0}; dot(way, direction) <= 0;) {
      way = integer_direction(random, 8);
      v = rounded(sum(exact(top), Rational(1) / 8, way));
    }
  const Object_case c =
      placed(random, a, tetrahedron({tip, beyond[0], beyond[1], beyond[2]}), Pose(), Motion::identity);
  if (tip == top) return with_answer(c, true);
  return dot(difference(exact(tip), exact(top)), direction) > 0 ? with_answer(c, false) : c;
}

}  // namespace

Object_case vertex_on_vertex(Random& random, double parameter)
{
  const int pose = static_cast<int>(parameter);
  if (pose == 0) return vertex_on_vertex_in_place(random);
  const Body& a = any_shape(random).body;
  const Body& b = any_shape(random).body;
  const Pose turn = pose == 1   ? Pose()
                    : pose == 2 ? signed_permutation(integer(random, 0, 23))
                                : rational_rotation(random, 4);
  constexpr std::array motions = {Motion::identity, Motion::translation, Motion::permutation, Motion::rotation,
                                  Motion::rounded};
  const Touching contact = object_family::vertex_on_vertex(random, a, b, turn);
  return placed(random, contact, any_gap(random), motions[pose]);
}

Object_case vertex_on_edge(Random& random, double parameter)
{
  const Shape& a = with_hull_edges(random);
  const Body& b = any_shape(random).body;
  return placed(random, object_family::vertex_on_edge(random, a, b, any_turn(random), static_cast<int>(parameter)));
}

Object_case vertex_on_face(Random& random, double parameter)
{
  const Shape& a = any_shape(random);
  const int bits = static_cast<int>(parameter);
  if (a.inner.empty() || random.bits() % 3 != 0) {
    const Body& b = any_shape(random).body;
    return placed(random, object_family::vertex_on_face(random, a, b, any_turn(random), bits));
  }
  // In a hollow of A: what else the bodies touch there is for the truth.
  const Face_triangle& triangle = a.triangles[a.inner[random.bits() % a.inner.size()]];
  const Body& b = any_pebble(random).body;
  const Exact_vector& normal = a.normals[triangle.face];
  const Pose turn = any_turn(random);
  const Pose relative = resting(*b, turn, point_inside(random, a, triangle, bits), normal);
  return placed(random, Touching{a.body, b, relative, normal, false});
}

Object_case edge_across_edge(Random& random, double parameter)
{
  const Shape& a = with_hull_edges(random);
  const Shape& b = any_block(random);
  return placed(random, object_family::edge_across_edge(random, a, b, any_turn(random), static_cast<int>(parameter)));
}

/// Half of the cases: a body and itself after half a turn about a line along one of its edges. Half: tetrahedra on an
/// edge.
Object_case edge_along_edge(Random& random, double parameter)
{
  const Rational away = Rational(1) - Rational(parameter);  // in edge lengths, along the edge
  if (random.bits() % 2 == 0) {
    for (;;) {
      const Shape& a = any_block(random);
      const Hull_edge& edge = a.hull_edges[random.bits() % a.hull_edges.size()];
      const Exact_vector from = a.vertex(edge.from), along = difference(a.vertex(edge.to), from);
      Exact_vector apart = scaled_to_one(a.normals[edge.faces[0]]);
      apart = sum(apart, scaled_to_one(a.normals[edge.faces[1]]));
      if (std::ranges::count(along, Rational(0)) != 2) continue;
      const auto unless_zero = [](const Rational& x) { return x == 0 ? -1.0 : 1.0; };
      const Pose half_turn = scaling(unless_zero(along[0]), unless_zero(along[1]), unless_zero(along[2]));
      const Pose relative = moved(half_turn, difference(sum(from, away, along), image(half_turn, from)));
      const Object_case c = placed(random, a.body, a.body, relative, exact_motion(random));
      // Another edge of the body may be on the same line.
      if (parameter >= 0) return with_answer(c, true);
      return a.body->vertices.size() <= 8 ? with_answer(c, false) : c;
    }
  }
  const Exact_vector along = integer_direction(random, 4);
  Exact_vector normal = {0, 0, 0};
  while (is_zero(normal)) normal = cross(along, integer_direction(random, 3));
  const auto on_side = [&](int side) {
    for (;;) {
      const Exact_vector v = integer_direction(random, 4);
      if (dot(v, normal) * side > 0) return *exactly(v);
    }
  };
  const kernel::Vertex origin = {0, 0, 0};
  const auto from = exactly(times(away, along)), to = exactly(times(Rational(away + 1), along));
  assert(from && to);
  const Body a = tetrahedron({origin, *exactly(along), on_side(-1), on_side(-1)});
  const Body b = tetrahedron({*from, *to, on_side(1), on_side(1)});
  return with_answer(placed(random, a, b, Pose(), exact_motion(random)), parameter >= 0);
}

/// Ridges of two wedges that cross, or would cross beyond their ends, or lie a hair apart.
Object_case near_parallel_edges(Random& random, double parameter)
{
  const double slope = std::isinf(parameter) ? 0 : std::ldexp(1.0, -static_cast<int>(parameter));
  const double shift = std::array{0.0, 0.25, 1.0, 2.0, -2.0, 3.0}[random.bits() % 6];          // of B along the ridges
  const double aside = std::array{0.0, slope, 2 * slope, -slope, 0x1p-52}[random.bits() % 5];  // across them, at B's
                                                                                               // middle
  const double hair = std::ldexp(1.0, -integer(random, 30, 60));
  const double height = std::array{0.0, 0.0, hair, -hair}[random.bits() % 4];
  const auto sharp = [&] { return dyadic(random, 4); };
  const Body a = tetrahedron({kernel::Vertex{-1, 0, 0}, {1, 0, 0}, {-0.5, sharp(), -1}, {0.5, -sharp(), -1}});
  const Body b = tetrahedron({kernel::Vertex{shift - 1, aside - slope, height},
                              {shift + 1, aside + slope, height},
                              {shift, 1 + sharp(), 1},
                              {shift, -1 - sharp(), 1}});
  Object_case c = placed(random, a, b, Pose(), exact_motion(random));
  return height > 0 ? with_answer(c, false) : c;
}

}  // namespace tetracone::verify::object_family
