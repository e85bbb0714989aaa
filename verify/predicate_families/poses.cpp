#include "verify/cases/exact_motion.h"
#include "verify/predicate_families/predicate_families.h"
#include "verify/predicate_families/predicate_points.h"

#include <cmath>

namespace tetracone::verify::predicate_family {

using namespace points;

namespace {

/// A contact whose points are the nearest doubles in the frames, by an ulp or two beside one another.
Predicate_case near_contact(Random& random, const Frames& frames)
{
  const Tetra v = tetrahedron(random, 8);
  Scene scene{v, element_point(random, v, integer(random, 1, 3), 4), {}, {}};
  complete(random, scene);
  relabel(random, scene);
  return placed_nearly(scene, frames);
}

/// The half-turn about an axis as doubles have it: the sine of the double nearest to pi is 1.2e-16.
Pose half_turn(int axis)
{
  constexpr double sine = 1.2246467991473532e-16;
  std::array<double, 12> entries = Pose().entries();
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  entries[5 * j] = entries[5 * k] = -1;
  entries[4 * j + k] = -sine;
  entries[4 * k + j] = sine;
  return Pose(entries);
}

/// A map of determinant +-2^-d: its third row is a sum of the first two up to 2^-d. Axes are permuted before and after
/// it.
Pose nearly_flat(Random& random, int d, bool mirrored)
{
  const double u = integer(random, -1, 1), w = integer(random, -1, 1), l = integer(random, -1, 1),
               m = integer(random, -1, 1);
  const double rest = std::ldexp(mirrored ? -1.0 : 1.0, -d);
  const Pose flat(std::array<double, 12>{1, u, 0, 0, 0, 1, w, 0, l, l * u + m, m * w + rest, 0});
  const Pose before = signed_permutation(integer(random, 0, 23)), after = signed_permutation(integer(random, 0, 23));
  return composed(after, composed(flat, before));
}

}  // namespace

Predicate_case special_poses(Random& random, double which)
{
  const int k = static_cast<int>(which);
  Frames f;
  if (k > 24) {
    // Both under the half-turn: exact contact; or B turned back in doubles, beside it by what the sine moves.
    const Pose turn = half_turn(k - 25);
    if (one_in(random, 2)) {
      f.common = turn;
      return any_contact(random, f);
    }
    f.b = turn;
    return near_contact(random, f);
  }
  (one_in(random, 2) ? f.a : f.b) = k == 0 ? Pose() : signed_permutation(k - 1);
  if (one_in(random, 4)) f.common = Pose::translation(random.symmetric(), 0, 0);
  return any_contact(random, f);
}

Predicate_case true_rotation(Random& random, double largest)
{
  Frames f = true_rotations(random, static_cast<int>(largest));
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron(random, 8);
    Scene scene{v, element_point(random, v, integer(random, 1, 3), 4), {}, {}};
    complete(random, scene);
    const int ulps = moved_aside(random, scene);
    relabel(random, scene);
    auto c = placed(scene, f);
    if (c) nudge(random, *c, ulps);
    return c;
  });
}

Predicate_case shear(Random& random, double largest)
{
  const auto [there, back] = shear_and_inverse(random, static_cast<int>(largest));
  Frames f;
  switch (random.bits() % 4) {
    case 0: f.b = there; break;
    case 1:
      f.a = there;
      f.b = back;
      break;
    case 2:
      f.b = back;
      f.common = there;
      break;  // B's pose is the product, an identity
    default: f.common = there;
  }
  return any_contact(random, f);
}

Predicate_case nearly_singular(Random& random, double d)
{
  const int bits = static_cast<int>(std::abs(d));
  Frames f;
  if (one_in(random, 2)) {
    f.common = nearly_flat(random, bits, d < 0);
    if (one_in(random, 2)) f.b = signed_permutation(integer(random, 0, 23));
    return any_contact(random, f);
  }
  // B's model is long along one axis, which its pose shortens.
  f.b = Pose(std::array<double, 12>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, std::ldexp(d < 0 ? -1.0 : 1.0, -bits), 0});
  f.b = composed(shear_and_inverse(random, 3)[0], f.b);
  return any_contact(random, f);
}

Predicate_case drifted_rotation(Random& random, double n)
{
  Pose product = double_rotation(random);
  for (int k = 1; k < n; ++k) product = rounded_product(double_rotation(random), product);
  Frames f;
  if (one_in(random, 2)) {
    f.common = product;
    if (one_in(random, 2)) f.b = signed_permutation(integer(random, 0, 47));
    return any_contact(random, f);
  }
  // B alone has drifted; its points are what the map brings back, rounded.
  f.b = product;
  return near_contact(random, f);
}

Predicate_case swept_contact(Random& random, double bisections)
{
  // B moves by s d, d of powers of two, from s = 0, where p is outside of a face's plane, to s = 1, inside.
  const bool full = one_in(random, 2);
  Tetra v;
  if (full) do {
      for (Point& x : v) x = mantissa_point(random, 50);
    } while (abs(dot(difference(v[1], v[0]), cross(difference(v[2], v[0]), difference(v[3], v[0])))) < Rational(0.25));
  else
    v = tetrahedron(random, 8);
  Scene scene{v, {}, {}, {}};
  const Point x = on_grid(element_point(random, v, integer(random, 2, 3), 6), 12);
  const Point normal = cross(difference(v[2], v[1]), difference(v[3], v[1]));
  const Rational inside = dot(normal, difference(v[0], v[1]));
  const auto depth = [&](const Point& y) -> Rational { return dot(normal, difference(y, v[1])) * inside; };
  Point way;
  do {
    for (Rational& w : way) w = any_of(random, std::array{-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0});
  } while (dot(normal, way) * inside <= 0);
  scene.p = x;
  while (depth(scene.p) >= 0) scene.p = sum(scene.p, Rational(-1) / 2, way);
  complete(random, scene);
  if (one_in(random, 2)) scene.q = on_grid(sum(scene.p, Rational(-1), way), usual_grid);
  const Rational speed = dot(normal, way) * inside;
  double low = 0, high = 1;
  while (depth(scene.p) + Rational(high) * speed < 0) high *= 2;
  for (int k = 0; k < bisections; ++k) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (depth(scene.p) + Rational(middle) * speed < 0 ? low : high) = middle;
  }
  const double s = one_in(random, 2) ? low : high;
  relabel(random, scene);
  Predicate_case c = placed_nearly(scene, {});  // exactly, but for a q along the face
  std::array<double, 12> entries = Pose().entries();
  for (int k = 0; k < 3; ++k) entries[4 * k + 3] = s * kernel::nearest_double(way[k]);
  c.pose_b = Pose(entries);
  const Pose common = any_frames(random).common;
  c.pose_a = composed(common, c.pose_a);
  c.pose_b = composed(common, c.pose_b);
  return c;
}

}  // namespace tetracone::verify::predicate_family
