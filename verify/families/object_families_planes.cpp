#include "verify/cases/object_placing.h"
#include "verify/families/object_families.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

namespace tetracone::verify::object_family {
namespace {

using Box = std::array<Exact_vector, 2>;  // low and high corner

Box extent(const covering::Polyhedron& body, const Pose& pose)
{
  Box box;
  for (int i = 0; i < 3; ++i) {
    Exact_vector axis = {0, 0, 0};
    axis[i] = 1;
    for (const int side : {1, -1}) {
      const Exact_vector way = times(Rational(side), axis);
      box[side == 1 ? 0 : 1][i] =
          dot(axis, image(pose, exact(body.vertices[lowest(body.vertices, pulled_back(pose, way))[0]])));
    }
  }
  return box;
}

/// Two boxes with axis-parallel faces: a point in common, and surfaces that meet.
Object_case boxes_answered(Object_case c, const Box& a, const Box& b)
{
  bool overlap = true, a_in_b = true, b_in_a = true;
  for (int i = 0; i < 3; ++i) {
    overlap = overlap && a[0][i] <= b[1][i] && b[0][i] <= a[1][i];
    a_in_b = a_in_b && b[0][i] < a[0][i] && a[1][i] < b[1][i];
    b_in_a = b_in_a && a[0][i] < b[0][i] && b[1][i] < a[1][i];
  }
  return with_answer(std::move(c), overlap && !a_in_b && !b_in_a, overlap);
}

/// A plane of integers: an origin-free basis, and the side above it.
struct Lattice_plane {
  Exact_vector u, v, normal;

  explicit Lattice_plane(Random& random, int size)
  {
    do {
      u = integer_direction(random, size);
      v = integer_direction(random, size);
      normal = cross(u, v);
    } while (is_zero(normal));
  }
  Exact_vector at(const Rational& s, const Rational& t) const { return sum(times(s, u), t, v); }
};

/// A point of integers on the side of the plane through 0.
kernel::Vertex apex(Random& random, const Lattice_plane& plane, int side, int size)
{
  for (;;) {
    const Exact_vector p = integer_direction(random, size);
    if (dot(p, plane.normal) * side > 0) return *exactly(p);
  }
}

}  // namespace

/// Tetrahedra that stand on one plane, mostly on its two sides, on triangles of its integer points.
Object_case coplanar_grid(Random& random, double parameter)
{
  const int bits = static_cast<int>(parameter);
  const Lattice_plane plane(random, 1 << (bits - 5));
  const auto triangle = [&](int away) {
    const int s = integer(random, -away, away), t = integer(random, -away, away);
    std::array<kernel::Vertex, 3> corners;
    for (kernel::Vertex& c : corners) {
      const int i = integer(random, -4, 4), j = integer(random, -4, 4);
      c = *exactly(plane.at(s + i, t + j));
    }
    return corners;
  };
  const auto [a, b, c] = triangle(0);
  const auto [d, e, f] = triangle(7);
  const Body first = tetrahedron({a, b, c, apex(random, plane, -1, 1 << bits)});
  const Body second = tetrahedron({d, e, f, apex(random, plane, random.bits() % 4 == 0 ? -1 : 1, 1 << bits)});
  return placed(random, first, second, Pose(), exact_motion(random));
}

/// Pyramids on the two sides of a plane, on parallelograms of one basis: where these lie decides.
Object_case coplanar_parallelogram(Random& random, double parameter)
{
  // Corners are p + s u + t v with |s|, |t| <= 3: sums of 7 numbers below 2^(bits - 3).
  const int bits = static_cast<int>(parameter) - 3;
  const auto mantissa = [&]() -> Rational {
    return Rational(std::ldexp(double(random.bits() >> (64 - bits)), 2 - bits)) - 2;
  };
  Exact_vector p = {mantissa(), mantissa(), mantissa()}, u, v, normal;
  do {
    u = {mantissa(), mantissa(), mantissa()};
    v = {mantissa(), mantissa(), mantissa()};
    normal = cross(u, v);
  } while (is_zero(normal));
  const auto pyramid_at = [&](int s, int t, int side) {
    std::vector<kernel::Vertex> base;
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      base.push_back(*exactly(sum(sum(p, Rational(s + i), u), Rational(t + j), v)));
    if (side > 0) std::ranges::reverse(base);
    for (;;) {
      const Exact_vector top = sum(exact(base[0]), integer_direction(random, 3));
      const kernel::Vertex apex = rounded(top);
      if (dot(difference(exact(apex), exact(base[0])), normal) * side > 0) return pyramid(base, apex);
    }
  };
  const int s = integer(random, -2, 2), t = integer(random, -2, 2);
  const Body a = pyramid_at(0, 0, -1), b = pyramid_at(s, t, 1);
  const Object_case c = placed(random, a, b, Pose(), exact_motion(random));
  return with_answer(c, std::abs(s) <= 1 && std::abs(t) <= 1);
}

/// A tetrahedron with an edge in the plane of a block's face, over the face.
Object_case edge_in_face_plane(Random& random, double parameter)
{
  const int kind = static_cast<int>(parameter);
  const Shape& a = any_block(random);
  const auto& of = a.inner.empty() || random.bits() % 4 != 0 ? a.hull : a.inner;
  const Face_triangle& triangle = a.triangles[of[random.bits() % of.size()]];
  // From the middle of the side t = 0 of the triangle inward, or outward.
  const Exact_vector middle = point_on(a, triangle, 0.5, 0), inward = difference(a.vertex(triangle.corners[2]), middle);
  const double near = std::ldexp(1.0, -integer(random, 2, 40));
  Exact_vector from = middle, to = sum(middle, Rational(-0.5), inward);
  if (kind == 0) from = sum(middle, Rational(-near), inward);
  if (kind == 1) from = sum(middle, Rational(near), inward);
  if (kind == 2) {
    from = point_inside(random, a, triangle, 4);
    to = point_inside(random, a, triangle, 4);
  }
  const auto p = exactly(from), q = exactly(to);
  assert(p && q);
  const Exact_vector up = scaled_to_one(a.normals[triangle.face]);
  const auto above = [&] {
    for (;;) {
      const kernel::Vertex v = rounded(sum(sum(from, up), Rational(1) / 8, integer_direction(random, 4)));
      if (dot(difference(exact(v), from), up) > 0) return v;
    }
  };
  const Body b = tetrahedron({*p, *q, above(), above()});
  const bool on_hull = &of == &a.hull;
  if (random.bits() % 4 == 0) {
    const Pose lifted = moved(Pose(), times(power_of_two(-integer(random, 10, 60)), up));
    const Object_case c = placed(random, a.body, b, lifted, exact_motion(random));
    return on_hull ? with_answer(c, false) : c;
  }
  const Object_case c = placed(random, a.body, b, Pose(), exact_motion(random));
  return kind == 0 ? c : with_answer(c, true);
}

/// Axis-parallel faces of blocks in one plane, their extents in the given relation.
Object_case face_on_face(Random& random, double parameter)
{
  const int kind = static_cast<int>(parameter) % 6;
  const bool alike = parameter >= 6;
  const auto flat = [&](const Shape& shape) -> std::optional<std::pair<int, int>> {  // axis and side of a hull face
    const Exact_vector& n = shape.normals[shape.triangles[shape.hull[random.bits() % shape.hull.size()]].face];
    if (std::ranges::count(n, Rational(0)) != 2) return std::nullopt;
    const int axis = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
    return std::pair{axis, n[axis] > 0 ? 1 : -1};
  };
  for (;;) {
    const bool same = kind == 0 && random.bits() % 2 == 0;
    const Shape& a = kind == 0 && !same ? blocks()[random.bits() % 2] : any_block(random);
    const Shape& b = kind == 0 ? a : kind == 2 ? pebbles()[random.bits() % 2 * 3] : any_block(random);
    const auto face_a = flat(a), face_b = same ? face_a : flat(b);
    if (!face_a || !face_b) continue;
    const auto [axis, side] = *face_a;
    // The turn brings B's face to the plane, on the wanted side. The face itself, mirrored or as it is, covers itself.
    std::array<double, 3> mirror = {1, 1, 1};
    mirror[axis] = -1;
    Pose turn = signed_permutation(integer(random, 0, 23));
    if (same) turn = alike ? Pose() : scaling(mirror[0], mirror[1], mirror[2]);
    Exact_vector normal = {0, 0, 0};
    normal[face_b->first] = face_b->second;
    if (turned(turn, normal)[axis] != (alike ? side : -side)) continue;

    const Box box_a = extent(*a.body, Pose()), box_b = extent(*b.body, turn);
    const auto widths = [](const Box& box) { return difference(box[1], box[0]); };
    if (kind == 0 && widths(box_a) != widths(box_b)) continue;
    Exact_vector shift;
    for (int i = 0; i < 3; ++i) {
      const Rational width_a = box_a[1][i] - box_a[0][i], width_b = box_b[1][i] - box_b[0][i];
      const bool first = i == (axis + 1) % 3;
      const int away = kind == 3 || kind == 5 ? first : kind == 4;  // beside A, not over it
      if (i == axis)
        shift[i] = box_a[side > 0][i] - box_b[alike == (side > 0)][i];
      else if (kind == 0)
        shift[i] = (box_a[0][i] + box_a[1][i] - box_b[0][i] - box_b[1][i]) / 2;
      else if (away)
        shift[i] = box_a[1][i] - box_b[0][i] + (kind == 5 ? power_of_two(-integer(random, 1, 50)) : Rational(0));
      else  // kind 2: B's extent in A's; else from a quarter to three quarters of both
        shift[i] = box_a[0][i] - box_b[0][i] +
                   (kind == 2 ? Rational((width_a - width_b) * Rational(dyadic(random, 5)))
                              : Rational((width_a + width_b) * integer(random, 1, 7) / 8 - width_b));
    }
    if (kind != 5 && random.bits() % 5 == 0) {
      const Rational hair = power_of_two(-integer(random, 10, 60));
      shift[axis] += random.bits() % 3 == 0 ? Rational(-side * hair) : Rational(side * hair);
    }
    const Pose relative = moved(turn, shift);
    const Object_case c = placed(random, a.body, b.body, relative, exact_motion(random));
    if (a.is_box && b.is_box) return boxes_answered(c, box_a, {sum(box_b[0], shift), sum(box_b[1], shift)});
    return c;
  }
}

/// Triangles of one plane that share a vertex or an edge only, or come that near.
Object_case coplanar_sharing(Random& random, double parameter)
{
  const bool edge = parameter == 1;
  const Lattice_plane plane(random, 16);
  const Rational hair = random.bits() % 3 == 0 ? power_of_two(-integer(random, 10, 60)) : Rational(0);
  const kernel::Vertex corner = {0, 0, 0}, u = *exactly(plane.at(1, 0)), v = *exactly(plane.at(0, 1));
  const bool opposite = random.bits() % 4 != 0;
  const Body a = tetrahedron({corner, u, v, apex(random, plane, -1, 32)});
  const kernel::Vertex top = apex(random, plane, opposite ? 1 : -1, 32);
  // The vertex in common is 0, the edge is that from u to v.
  const int s = integer(random, 1, 3), t = integer(random, 1, 3), i = integer(random, 0, 1), j = integer(random, 0, 1);
  const Body b = edge ? tetrahedron({u, v, *exactly(plane.at(s, t)), top})
                      : tetrahedron({corner, *exactly(plane.at(-s, -i)), *exactly(plane.at(-j, -t)), top});
  const Exact_vector away = plane.at(edge ? hair : Rational(-hair), edge ? hair : Rational(-hair));
  const Object_case c = placed(random, a, b, moved(Pose(), away), exact_motion(random));
  if (hair == 0) return with_answer(c, true);
  return opposite ? with_answer(c, false) : c;
}

/// B's bounding box on A's along an axis, with a gap in ulps of where they touch.
Object_case stacked(Random& random, double parameter)
{
  const bool of_boxes = random.bits() % 2 == 0;
  const Shape& a = of_boxes ? blocks()[random.bits() % 2] : any_shape(random);
  const Shape& b = of_boxes ? pebbles()[random.bits() % 2 * 3] : any_shape(random);
  const Pose turn = signed_permutation(integer(random, 0, 23));
  const Box box_a = extent(*a.body, Pose()), box_b = extent(*b.body, turn);
  const int axis = integer(random, 0, 2);
  const double height = std::max(std::abs(kernel::nearest_double(box_a[1][axis])), 0x1p-10);
  const Rational gap = Rational(parameter) * Rational(std::nextafter(height, HUGE_VAL) - height);
  Exact_vector shift;
  for (int i = 0; i < 3; ++i) {
    if (i == axis)
      shift[i] = box_a[1][i] - box_b[0][i] + gap;
    else
      shift[i] = (box_a[0][i] + box_a[1][i] - box_b[0][i] - box_b[1][i]) / 2 + Rational(integer(random, -16, 16)) / 128;
  }
  const Motion kind = random.bits() % 2 == 0 ? Motion::identity : exact_motion(random);
  const Object_case c = placed(random, a.body, b.body, moved(turn, shift), kind);
  if (of_boxes) return boxes_answered(c, box_a, {sum(box_b[0], shift), sum(box_b[1], shift)});
  return parameter > 0 ? with_answer(c, false) : c;
}

}  // namespace tetracone::verify::object_family
