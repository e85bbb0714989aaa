#include "verify/cases/object_placing.h"
#include "verify/families/ladder.h"
#include "verify/families/object_families.h"

#include <cmath>
#include <utility>

namespace tetracone::verify::object_family {
namespace {

Rational sixty_fourths(Random& random, int most) { return Rational(integer(random, -most, most)) / 64; }

}  // namespace

/// Two bodies of 0.1 to 10 m within 100 m of the origin, apart or overlapping by 2^-bits of their size. Both poses are
/// rounded rotations, as engines are given them.
Object_case metres(Random& random, double bits)
{
  const Shape& a = any_shape(random);
  const Shape& b = any_shape(random);
  const int exponent = integer(random, -3, 3);
  const double size = std::ldexp(1.0, exponent);
  const Pose turn_b = rational_rotation(random, 5);
  Touching contact = any_contact(random, a, b, turn_b);
  contact.a = moved_copy(a, exponent);
  contact.b = moved_copy(b, exponent);
  contact.relative = composed(scaling(size), composed(contact.relative, scaling(1 / size)));
  const Rational gap = std::isinf(bits) ? Rational(0) : Rational(power_of_two(exponent - int(bits)));
  const bool is_overlap = random.bits() % 2 == 0;
  const Exact_vector where = {sixty_fourths(random, 5000), sixty_fourths(random, 5000), sixty_fourths(random, 5000)};
  const Pose turn = double_rotation(random);
  return rounded_poses(placed(random, contact, is_overlap ? Rational(-gap) : gap, moved(turn, where)));
}

/// Two equal cubes side by side. A quarter of them are turned together by a rounded rotation; the others are placed
/// exactly, and their answer is known.
Object_case ladder(Random& random, double number)
{
  const Rung rung(static_cast<int>(number));
  const Rational size = power_of_two(rung.exponent);
  const Body cube = moved_copy(blocks()[unit_cube_block], rung.exponent);
  const Rational y = sixty_fourths(random, 48), z = sixty_fourths(random, 48);
  const bool is_flush = random.bits() % 2 == 0, is_turned = random.bits() % 4 == 0;
  const Exact_vector beside = {1 + rung.gap(), is_flush ? Rational(0) : y, is_flush ? Rational(0) : z};
  const Pose turn = is_turned ? double_rotation(random) : signed_permutation(integer(random, 0, 23));
  const Exact_vector where = {sixty_fourths(random, 99), sixty_fourths(random, 99), sixty_fourths(random, 99)};
  const Pose common = moved(turn, times(size, where));
  Object_case c = placed(random, cube, cube, moved({}, times(size, beside)), common);
  return rounded_poses(with_answer(std::move(c), rung.gap() <= 0));
}

}  // namespace tetracone::verify::object_family
