#include "verify/cases/object_placing.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace tetracone::verify::object_family {

int integer(Random& random, int low, int high)
{
  return low + static_cast<int>(random.bits() % std::uint64_t(high - low + 1));
}

Rational power_of_two(int k)
{
  // The power is built from doubles, since 2^k may be beyond their range.
  Rational result = 1;
  for (; std::abs(k) > 1000; k -= k > 0 ? 1000 : -1000) result *= Rational(std::ldexp(1.0, k > 0 ? 1000 : -1000));
  return Rational(result * Rational(std::ldexp(1.0, k)));
}

double dyadic(Random& random, int bits)
{
  const std::uint64_t odd = (random.bits() & ((std::uint64_t(1) << bits) - 1)) | 1;
  return std::ldexp(static_cast<double>(odd), -bits);
}

Exact_vector integer_direction(Random& random, int size)
{
  for (;;) {
    const Exact_vector d = {integer(random, -size, size), integer(random, -size, size), integer(random, -size, size)};
    if (!is_zero(d)) return d;
  }
}

Pose signed_permutation(int k)
{
  // The six permutations by parity, four sign patterns of each determinant.
  constexpr std::array<std::array<int, 3>, 6> axes = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  const int permutation = k / 4 % 6, signs = k % 4;
  const bool flip = (permutation >= 3) != (k >= 24);
  std::array<double, 12> entries{};
  for (int i = 0; i < 3; ++i) {
    const bool negative = i == 0   ? (signs & 1) != 0
                          : i == 1 ? (signs & 2) != 0
                                   : ((signs & 1) != 0) != ((signs & 2) != 0);
    entries[4 * i + axes[permutation][i]] = negative != flip ? -1 : 1;
  }
  return Pose(entries);
}

Pose rational_rotation(Random& random, int size)
{
  for (;;) {
    std::array<int, 4> q;
    for (int& x : q) x = integer(random, -size, size);
    if (q != std::array<int, 4>{0, 0, 0, 0}) return Pose::from_quaternion(q[0], q[1], q[2], q[3]);
  }
}

Pose rotated(const Rotation& m, const Vector& at)
{
  const auto& [x, y, z] = m;
  return Pose(std::array<double, 12>{x[0], x[1], x[2], at[0], y[0], y[1], y[2], at[1], z[0], z[1], z[2], at[2]});
}

Pose double_rotation(Random& random)
{
  const auto [w, x, y, z] = random.quaternion();
  return rotated(rotation(w, x, y, z), {});
}

Pose rounded_product(const Pose& second, const Pose& first)
{
  std::array<double, 12> entries{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      entries[4 * i + j] =
          second[4 * i] * first[j] + second[4 * i + 1] * first[4 + j] + second[4 * i + 2] * first[8 + j];
  return Pose(entries);
}

std::array<Pose, 2> shear_and_inverse(Random& random, int size)
{
  std::array<Pose, 2> result;
  for (int step = 0; step < 2; ++step) {
    const int row = integer(random, 0, 2), column = (row + integer(random, 1, 2)) % 3;
    std::array<double, 12> there = Pose().entries(), back = there;
    there[4 * row + column] = integer(random, 0, 1) == 0 ? size : integer(random, -size, size);
    back[4 * row + column] = -there[4 * row + column];
    result = {composed(Pose(there), result[0]), composed(result[1], Pose(back))};
  }
  return result;
}

Pose stretch(const std::array<int, 3>& exponents)
{
  std::array<Rational, 12> entries;
  for (int k = 0; k < 3; ++k) entries[5 * k] = power_of_two(exponents[k]);
  return Pose(entries);
}

Pose fraction_map(Random& random, int exponent)
{
  const int numerator = integer(random, 3, 9), denominator = integer(random, 3, 9);
  const Rational size = power_of_two(exponent) * numerator / denominator;
  const Pose turn = rational_rotation(random, 3);
  std::array<Rational, 12> entries;
  for (int k = 0; k < 12; ++k) entries[k] = size * (k % 4 == 3 ? Rational(integer(random, -4, 4)) / 3 : turn.exact(k));
  return Pose(entries);
}

Pose wild_map(Random& random, int size)
{
  const auto any_stretch = [&] {
    const int all = integer(random, -size, size);
    if (random.bits() % 3 == 0) return stretch({all, all, all});
    const int second = integer(random, -size, size);
    return stretch({all, second, random.bits() % 2 == 0 ? second : integer(random, -size, size)});
  };
  const auto any_turn = [&] {
    switch (random.bits() % 5) {
      case 0: return signed_permutation(integer(random, 0, 47));
      case 1: return rational_rotation(random, 3);
      case 2: return double_rotation(random);
      case 3: return shear_and_inverse(random, 3)[0];
      default: return motion(random, Motion::similarity);
    }
  };
  const Pose before = any_stretch(), turn = any_turn(), after = random.bits() % 2 == 0 ? any_stretch() : Pose();
  const Pose map = composed(after, composed(turn, before));
  if (random.bits() % 2 == 0) return map;
  Exact_vector shift;
  for (Rational& x : shift) {
    const double mantissa = random.symmetric();
    x = Rational(std::ldexp(mantissa, integer(random, -size, size)));
  }
  return moved(map, shift);
}

Motion exact_motion(Random& random)
{
  constexpr std::array<Motion, 10> kinds = {
      Motion::identity,    Motion::identity,    Motion::identity, Motion::translation, Motion::translation,
      Motion::permutation, Motion::permutation, Motion::rotation, Motion::rotation,    Motion::similarity};
  return random.bits() % 16 == 0 ? Motion::shear : kinds[random.bits() % kinds.size()];
}

Pose motion(Random& random, Motion kind)
{
  const auto sixty_fourths = [&random]() -> Rational { return Rational(integer(random, -256, 256)) / 64; };
  const Exact_vector shift = {sixty_fourths(), sixty_fourths(), sixty_fourths()};
  switch (kind) {
    case Motion::identity: return {};
    case Motion::translation: return moved({}, shift);
    case Motion::permutation: return moved(signed_permutation(integer(random, 0, 23)), shift);
    case Motion::rotation:
    case Motion::rounded: return moved(rational_rotation(random, 5), shift);
    case Motion::shear: return moved(shear_and_inverse(random, 3)[0], shift);
    case Motion::similarity: break;
  }
  // The quaternion's matrix of integers: a rotation times its norm, exact in doubles.
  const Pose rotation = rational_rotation(random, 3);
  for (int norm = 1;; ++norm) {
    const Pose scaled = composed(scaling(norm), rotation);
    if (!scaled.is_rational()) return moved(composed(scaling(0.125), scaled), shift);
  }
}

Pose any_turn(Random& random)
{
  const std::uint64_t draw = random.bits() % 20;
  if (draw < 4) return {};
  if (draw < 13) return signed_permutation(integer(random, 0, draw == 4 ? 47 : 23));
  return rational_rotation(random, 4);
}

Pose resting(const covering::Polyhedron& b, const Pose& turn, const Exact_vector& point, const Exact_vector& normal)
{
  const Index v = lowest(b.vertices, pulled_back(turn, normal))[0];
  return moved(turn, difference(point, image(turn, exact(b.vertices[v]))));
}

Exact_vector point_on(const Shape& shape, const Face_triangle& triangle, double s, double t)
{
  const Exact_vector p = shape.vertex(triangle.corners[0]);
  return sum(sum(p, Rational(s), difference(shape.vertex(triangle.corners[1]), p)), Rational(t),
             difference(shape.vertex(triangle.corners[2]), p));
}

Exact_vector point_inside(Random& random, const Shape& shape, const Face_triangle& triangle, int bits)
{
  assert(bits >= 2);
  for (;;) {
    const double s = dyadic(random, bits), t = dyadic(random, bits);
    if (s + t < 1) return point_on(shape, triangle, s, t);
  }
}

Touching vertex_on_face(Random& random, const Shape& a, const Body& b, const Pose& turn, int bits)
{
  const Face_triangle& triangle = a.triangles[a.hull[random.bits() % a.hull.size()]];
  const Exact_vector& normal = a.normals[triangle.face];
  return {a.body, b, resting(*b, turn, point_inside(random, a, triangle, bits), normal), normal, true};
}

Touching vertex_on_edge(Random& random, const Shape& a, const Body& b, const Pose& turn, int bits)
{
  const Hull_edge& edge = a.hull_edges[random.bits() % a.hull_edges.size()];
  const Exact_vector from = a.vertex(edge.from);
  const Exact_vector point = sum(from, Rational(dyadic(random, bits)), difference(a.vertex(edge.to), from));
  const Rational share = integer(random, 1, 7);
  const Exact_vector normal =
      sum(times(share, a.normals[edge.faces[0]]), Rational(integer(random, 1, 7)), a.normals[edge.faces[1]]);
  return {a.body, b, resting(*b, turn, point, normal), normal, true};
}

Touching vertex_on_vertex(Random& random, const Body& a, const Body& b, const Pose& turn)
{
  const Exact_vector direction = integer_direction(random, 64);
  const Index top = lowest(a->vertices, times(Rational(-1), direction))[0];
  return {a, b, resting(*b, turn, exact(a->vertices[top]), direction), direction, true};
}

Touching edge_across_edge(Random& random, const Shape& a, const Shape& b, const Pose& turn, int bits)
{
  const auto between = [](const Exact_vector& d, const Exact_vector& m, const Exact_vector& n,
                          const Exact_vector& edge) {
    // d, m and n are normal to the edge. d is a positive combination of m and n if it lies between them.
    const Rational side = dot(cross(m, n), edge);
    return dot(cross(m, d), edge) * side > 0 && dot(cross(d, n), edge) * side > 0;
  };
  const bool on_hulls = !a.hull_edges.empty() && !b.hull_edges.empty();
  for (int tries = 0;; ++tries) {
    const bool free = !on_hulls || tries == 40;
    const Hull_edge& hull_a = on_hulls ? a.hull_edges[random.bits() % a.hull_edges.size()] : Hull_edge();
    const Hull_edge& hull_b = on_hulls ? b.hull_edges[random.bits() % b.hull_edges.size()] : Hull_edge();
    const auto ends_a = free ? a.edges[random.bits() % a.edges.size()] : std::array{hull_a.from, hull_a.to};
    const auto ends_b = free ? b.edges[random.bits() % b.edges.size()] : std::array{hull_b.from, hull_b.to};
    const Exact_vector p = a.vertex(ends_a[0]), q = image(turn, b.vertex(ends_b[0]));
    const Exact_vector along_a = difference(a.vertex(ends_a[1]), p),
                       along_b = difference(image(turn, b.vertex(ends_b[1])), q);
    Exact_vector apart = cross(along_a, along_b);
    if (is_zero(apart)) {
      if (!free) continue;
      apart = integer_direction(random, 4);
    }
    if (!free) {
      const auto fits = [&](const Exact_vector& d) {
        return between(d, a.normals[hull_a.faces[0]], a.normals[hull_a.faces[1]], along_a) &&
               between(times(Rational(-1), d), turned(turn, b.normals[hull_b.faces[0]]),
                       turned(turn, b.normals[hull_b.faces[1]]), along_b);
      };
      if (!fits(apart)) apart = times(Rational(-1), apart);
      if (!fits(apart)) continue;
    }
    const Exact_vector at = sum(p, Rational(dyadic(random, bits)), along_a),
                       to = sum(q, Rational(dyadic(random, bits)), along_b);
    return {a.body, b.body, moved(turn, difference(at, to)), apart, !free};
  }
}

Touching any_contact(Random& random, const Shape& a, const Shape& b, const Pose& turn)
{
  const std::uint64_t draw = random.bits() % 8;
  if (draw < 2) return vertex_on_vertex(random, a.body, b.body, turn);
  if (draw == 2 && !a.hull_edges.empty()) return vertex_on_edge(random, a, b.body, turn, 3);
  if (draw < 5) return edge_across_edge(random, a, b, turn, 3);
  return vertex_on_face(random, a, b.body, turn, 3);
}

Touching any_contact(Random& random, const Pose& turn)
{
  const Shape& a = any_shape(random);
  const Shape& b = any_shape(random);
  return any_contact(random, a, b, turn);
}

Rational any_gap(Random& random)
{
  const std::uint64_t draw = random.bits() % 20;
  if (draw < 10) return 0;
  const Rational hair = power_of_two(-integer(random, 10, 60));
  return draw < 17 ? hair : Rational(-hair);
}

Object_case placed(Random& random, const Body& a, const Body& b, const Pose& relative, const Pose& common)
{
  Object_case c{a, b, common, composed(common, relative), {}, {}, {}};
  if (random.bits() % 2 == 0) {
    std::swap(c.a, c.b);
    std::swap(c.pose_a, c.pose_b);
  }
  return c;
}

Object_case placed(Random& random, const Body& a, const Body& b, const Pose& relative, Motion kind)
{
  Object_case c = placed(random, a, b, relative, motion(random, kind));
  return kind == Motion::rounded ? rounded_poses(c) : c;
}

Object_case placed(Random& random, const Touching& contact, const Rational& gap, const Pose& common)
{
  const Pose relative = moved(contact.relative, times(gap, scaled_to_one(contact.apart)));
  Object_case c = placed(random, contact.a, contact.b, relative, common);
  if (gap == 0) return with_answer(c, true);
  return gap > 0 && contact.separated ? with_answer(c, false) : c;
}

Object_case placed(Random& random, const Touching& contact, const Rational& gap, Motion kind)
{
  Object_case c = placed(random, contact, gap, motion(random, kind));
  return kind == Motion::rounded ? rounded_poses(c) : c;
}

Object_case placed(Random& random, const Touching& contact, const Rational& gap)
{
  return placed(random, contact, gap, exact_motion(random));
}

Object_case placed(Random& random, const Touching& contact) { return placed(random, contact, any_gap(random)); }

Object_case with_answer(Object_case c, std::optional<bool> surface, std::optional<bool> solid)
{
  c.surface = surface;
  c.solid = solid;
  return c;
}

Object_case with_answer(Object_case c, bool both) { return with_answer(std::move(c), both, both); }

Object_case rounded_poses(Object_case c)
{
  if (c.pose_a.is_rational() || c.pose_b.is_rational()) c.surface = c.solid = std::nullopt;
  c.pose_a = Pose(c.pose_a.entries());
  c.pose_b = Pose(c.pose_b.entries());
  return c;
}

}  // namespace tetracone::verify::object_family
