#include "verify/cases/object_placing.h"
#include "verify/families/object_families.h"

#include <array>
#include <cmath>
#include <utility>

namespace tetracone::verify::object_family {
namespace {

/// Half a turn about an axis, its sines the double nearest to pi's.
Pose half_turn_in_doubles(int axis)
{
  constexpr double sine = 1.2246467991473532e-16;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::array<double, 12> entries = Pose().entries();
  entries[4 * u + u] = entries[4 * v + v] = -1;
  entries[4 * u + v] = -sine;
  entries[4 * v + u] = sine;
  return Pose(entries);
}

/// B's vertices moved by the translation of its pose, where they are doubles: the pose is then the identity.
Object_case in_place(Random& random, const Touching& contact, const Rational& gap)
{
  const Pose pose = moved(contact.relative, times(gap, scaled_to_one(contact.apart)));
  covering::Polyhedron body = *contact.b;
  bool all = true;
  for (kernel::Vertex& v : body.vertices) {
    const auto placed = exactly(image(pose, exact(v)));
    all = all && placed.has_value();
    if (placed) v = *placed;
  }
  if (!all) return placed(random, contact, gap, Pose());
  const Object_case c = placed(random, contact.a, shared(std::move(body)), Pose(), Pose());
  if (gap == 0) return with_answer(c, true);
  return gap > 0 && contact.separated ? with_answer(c, false) : c;
}

}  // namespace

Object_case special_poses(Random& random, double parameter)
{
  const int which = static_cast<int>(parameter);
  const Shape& a = any_shape(random);
  const Shape& b = any_block(random);
  if (which == 0) {
    const Touching contact = any_contact(random, a, b, Pose());
    return in_place(random, contact, any_gap(random));
  }
  if (which <= 24) {
    const Pose turn = signed_permutation(which - 1);
    const Touching contact = any_contact(random, a, b, turn);
    const Pose common = random.bits() % 2 == 0 ? Pose() : turn;
    return placed(random, contact, any_gap(random), common);
  }
  // The contact is that of the half-turn in doubles, exactly, or that of the half-turn itself, which it is not.
  const int axis = which - 25;
  const Pose in_doubles = half_turn_in_doubles(axis);
  std::array<double, 3> signs = {-1, -1, -1};
  signs[axis] = 1;
  if (random.bits() % 2 == 0) {
    const Touching contact = random.bits() % 2 == 0 ? vertex_on_vertex(random, a.body, b.body, in_doubles)
                                                    : vertex_on_face(random, a, b.body, in_doubles, 3);
    return placed(random, contact, any_gap(random), Pose());
  }
  const Touching contact = any_contact(random, a, b, scaling(signs[0], signs[1], signs[2]));
  const Exact_vector shift = {contact.relative.exact(3), contact.relative.exact(7), contact.relative.exact(11)};
  return placed(random, a.body, b.body, moved(in_doubles, shift), Pose());
}

Object_case true_rotation(Random& random, double parameter)
{
  const int size = static_cast<int>(parameter);
  const Touching contact = any_contact(random, random.bits() % 2 == 0 ? Pose() : rational_rotation(random, size));
  const auto third = [&]() -> Rational { return Rational(integer(random, -9, 9)) / 3; };
  const Exact_vector shift = {third(), third(), third()};
  const Pose common = moved(rational_rotation(random, size), shift);
  return placed(random, contact, any_gap(random), common);
}

/// Both bodies under one shear; or B's vertices sheared and its pose the inverse.
Object_case shear(Random& random, double parameter)
{
  const auto [there, back] = shear_and_inverse(random, static_cast<int>(parameter));
  if (random.bits() % 2 == 0) {
    const Touching contact = any_contact(random, any_turn(random));
    return placed(random, contact, any_gap(random), there);
  }
  const Shape& a = any_shape(random);
  const Shape& b = any_block(random);
  Touching contact = any_contact(random, a, b, any_turn(random));
  covering::Polyhedron sheared = *b.body;
  for (kernel::Vertex& v : sheared.vertices) v = *exactly(image(there, exact(v)));
  contact.b = shared(std::move(sheared));
  contact.relative = composed(contact.relative, back);
  return placed(random, contact);
}

/// Both bodies, or B alone, flattened along one axis by 2^-d between shears.
Object_case nearly_singular(Random& random, double parameter)
{
  const double least = std::copysign(std::ldexp(1.0, -static_cast<int>(std::abs(parameter))), parameter);
  const Pose before = shear_and_inverse(random, 2)[0], after = shear_and_inverse(random, 2)[0];
  const Pose flat = composed(composed(after, scaling(1, 1, least)), before);
  if (random.bits() % 2 == 0) {
    const Touching contact = any_contact(random, signed_permutation(integer(random, 0, 23)));
    return placed(random, contact, any_gap(random), flat);
  }
  const Shape& a = any_shape(random);
  const Body& b = any_shape(random).body;
  const Touching contact =
      random.bits() % 2 == 0 ? vertex_on_vertex(random, a.body, b, flat) : vertex_on_face(random, a, b, flat, 3);
  const Motion kind = random.bits() % 2 == 0 ? Motion::identity : Motion::permutation;
  return placed(random, contact, any_gap(random), kind);
}

/// Both bodies under the product of n rounded rotations, B's translation in the product's frame, rounded.
Object_case drifted_rotation(Random& random, double parameter)
{
  Pose drifted;
  for (int k = 0; k < parameter; ++k) drifted = rounded_product(double_rotation(random), drifted);
  const Touching contact = any_contact(random, signed_permutation(integer(random, 0, 23)));
  Object_case c = placed(random, contact, any_gap(random), drifted);
  if (random.bits() % 4 != 0) c = rounded_poses(c);
  return c;
}

}  // namespace tetracone::verify::object_family
