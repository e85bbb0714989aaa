#include "verify/cases/object_placing.h"
#include "verify/families/object_families.h"

#include "verify/cases/shape_generators.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetracone::verify::object_family {
namespace {

using kernel::Vertex;

/// `x` with `bits` bits of mantissa.
double of_bits(double x, int bits)
{
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::floor(std::ldexp(mantissa, bits) + 0.5), exponent - bits);
}

/// The pose with its translation rounded to `bits` bits, and its linear part to doubles.
Pose with_translation_of_bits(const Pose& pose, int bits)
{
  std::array<double, 12> entries = pose.entries();
  for (const int k : {3, 7, 11}) entries[k] = of_bits(entries[k], bits);
  return Pose(entries);
}

double ulp(double x) { return std::nextafter(std::abs(x), HUGE_VAL) - std::abs(x); }

/// A motion that keeps doubles exact.
Motion motion_of_doubles(Random& random)
{
  return std::array{Motion::identity, Motion::identity, Motion::permutation}[random.bits() % 3];
}

Pose exact_turn_of_doubles(Random& random)
{
  return random.bits() % 3 == 0 ? Pose() : signed_permutation(integer(random, 0, 23));
}

}  // namespace

Object_case random(Random& random, double parameter)
{
  const double scale = std::ldexp(1.0, static_cast<int>(parameter));
  const auto somewhere = [&](double reach) {
    const Vector v = random.in_ball();
    return Vertex{reach * v[0], reach * v[1], reach * v[2]};
  };
  const bool of_tetrahedra = random.bits() % 2 == 0;
  const auto body = [&]() -> Body {
    if (!of_tetrahedra) return any_shape(random).body;
    return tetrahedron({somewhere(scale), somewhere(scale), somewhere(scale), somewhere(scale)});
  };
  const auto pose = [&] {
    std::array<double, 12> entries = double_rotation(random).entries();
    const Vertex t = somewhere(of_tetrahedra ? 0.8 * scale : 1.2 * scale);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3 && !of_tetrahedra; ++j) entries[4 * i + j] *= scale;
      entries[4 * i + 3] = t[i];
    }
    return Pose(entries);
  };
  const Body a = body(), b = body();
  const Pose pose_a = pose(), pose_b = pose();
  return {a, b, pose_a, pose_b, {}, {}, {}};
}

Object_case rounded_on_plane(Random& random, double parameter)
{
  for (;;) {
    const Shape& a = any_shape(random);
    const Body& b = any_shape(random).body;
    const Touching contact = vertex_on_face(random, a, b, exact_turn_of_doubles(random), 52);
    // On an axis-parallel plane rounding keeps the contact: only now and then.
    if (std::ranges::count(contact.apart, Rational(0)) == 2 && random.bits() % 8 != 0) continue;
    return placed(random, contact.a, contact.b, with_translation_of_bits(contact.relative, static_cast<int>(parameter)),
                  motion_of_doubles(random));
  }
}

Object_case ulps_off_plane(Random& random, double parameter)
{
  const Shape& a = any_shape(random);
  const Body& b = any_shape(random).body;
  const Touching contact = vertex_on_face(random, a, b, any_turn(random), 4);
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (abs(contact.apart[i]) > abs(contact.apart[axis])) axis = i;
  const bool away = random.bits() % 2 == 0;
  const double size = std::max(std::abs(contact.relative[4 * axis + 3]), 0.5);
  Exact_vector step = {0, 0, 0};
  step[axis] = Rational((contact.apart[axis] > 0) == away ? 1 : -1) * Rational(parameter) * Rational(ulp(size));
  const Object_case c = placed(random, contact.a, contact.b, moved(contact.relative, step), exact_motion(random));
  if (parameter == 0) return with_answer(c, true);
  return away ? with_answer(c, false) : c;
}

/// Changes a coordinate of B's translation by a fraction of it.
Object_case perturbed_zero(Random& random, double parameter)
{
  const Touching contact = any_contact(random, any_turn(random));
  Exact_vector change = {0, 0, 0};
  if (!std::isinf(parameter)) {
    const int axis = integer(random, 0, 2);
    change[axis] = Rational(random.bits() % 2 == 0 ? 1 : -1) * power_of_two(-static_cast<int>(parameter)) *
                   contact.relative.exact(4 * axis + 3);
  }
  const Object_case c = placed(random, contact.a, contact.b, moved(contact.relative, change), exact_motion(random));
  if (is_zero(change)) return with_answer(c, true);
  return contact.separated && dot(change, contact.apart) > 0 ? with_answer(c, false) : c;
}

Object_case ulp_walk(Random& random, double parameter)
{
  const Shape& a = any_shape(random);
  const Shape& b = any_shape(random);
  const Touching contact = any_contact(random, a, b, exact_turn_of_doubles(random));
  std::array<double, 12> entries = contact.relative.entries();
  const int first = static_cast<int>(parameter);
  bool walked = false;
  for (const int axis : {first, (first + 1) % 3}) {
    double& t = entries[4 * axis + 3];
    const int steps = integer(random, -8, 8);
    t += steps * ulp(std::max(std::abs(t), 0x1p-6));
    walked = walked || steps != 0;
  }
  const Object_case c = placed(random, contact.a, contact.b, Pose(entries), motion_of_doubles(random));
  return walked || contact.relative.is_rational() ? c : with_answer(c, true);
}

/// Boxes and corners whose decimals touch: their doubles may not.
Object_case decimal_grid(Random& random, double parameter)
{
  double unit = 1;
  for (int d = 0; d < parameter; ++d) unit *= 10;
  const int range = static_cast<int>(std::min(10 * unit, 2e9));
  const auto decimal = [&](std::int64_t k) { return double(k) / unit; };
  std::array<std::int64_t, 3> corner, own;  // where they touch, in A and in B
  for (int i = 0; i < 3; ++i) {
    corner[i] = integer(random, 1, range);
    own[i] = integer(random, 1, range);
  }
  const Vertex p = {decimal(corner[0]), decimal(corner[1]), decimal(corner[2])},
               q = {decimal(own[0]), decimal(own[1]), decimal(own[2])};
  const Pose relative =
      Pose::translation(decimal(corner[0] - own[0]), decimal(corner[1] - own[1]), decimal(corner[2] - own[2]));
  const auto beside = [&](const Vertex& v, int side) {
    return Vertex{v[0] + side * decimal(integer(random, 1, range)), v[1] + side * decimal(integer(random, 1, range)),
                  v[2] + side * decimal(integer(random, 1, range))};
  };
  if (random.bits() % 2 == 0) {
    // Corner on corner of tetrahedra in opposite octants.
    const Body a = tetrahedron({p, beside(p, -1), beside(p, -1), beside(p, -1)}),
               b = tetrahedron({q, beside(q, 1), beside(q, 1), beside(q, 1)});
    return placed(random, a, b, relative, motion_of_doubles(random));
  }
  // Face on face along one axis, edge on edge along two, or corner on corner.
  Vertex low_a = beside(p, -1), high_a = p, low_b = q, high_b = beside(q, 1);
  const int touching = integer(random, 1, 3), first = integer(random, 0, 2);
  for (int i = touching; i < 3; ++i) {
    const int axis = (first + i) % 3;
    high_a[axis] += 1 / unit;
    low_b[axis] -= 1 / unit;
  }
  const Object_case c =
      placed(random, shared(box(low_a, high_a)), shared(box(low_b, high_b)), relative, motion_of_doubles(random));
  bool meet = true;
  for (int i = 0; i < 3; ++i) meet = meet && Rational(low_b[i]) + relative.exact(4 * i + 3) <= Rational(high_a[i]);
  return with_answer(c, meet);
}

/// Exact contacts, or B moved by one unit of the last of 24 + `parameter` bits, which floats do not have.
Object_case float_widened(Random& random, double parameter)
{
  const int bits = 24 + static_cast<int>(parameter);
  if (random.bits() % 2 == 0) {
    const Shape& a = any_block(random);
    const Shape& b = any_block(random);
    const Touching contact = any_contact(random, a, b, exact_turn_of_doubles(random));
    const int way = integer(random, 0, 2);
    return placed(random, contact, way == 0 ? Rational(0) : Rational(way == 1 ? 1 : -1) * power_of_two(1 - bits),
                  motion_of_doubles(random));
  }
  // Corners of that many bits, one on one or a unit off, in opposite octants.
  const auto corner = [&](int side) {
    return Vertex{of_bits(side * (1 + random.unit()), bits), of_bits(side * (1 + random.unit()), bits),
                  of_bits(side * (1 + random.unit()), bits)};
  };
  const auto coordinate = [&] { return of_bits(random.symmetric() / 2, bits); };
  const Vertex p = {coordinate(), coordinate(), coordinate()};
  Vertex q = p;
  const int axis = integer(random, 0, 2);
  q[axis] += integer(random, -1, 1) * std::ldexp(1.0, -bits);
  const Body a = tetrahedron({p, corner(-1), corner(-1), corner(-1)}),
             b = tetrahedron({q, corner(1), corner(1), corner(1)});
  return placed(random, a, b, Pose(), motion_of_doubles(random));
}

}  // namespace tetracone::verify::object_family
