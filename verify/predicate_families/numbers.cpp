#include "verify/cases/exact_motion.h"
#include "verify/predicate_families/predicate_families.h"
#include "verify/predicate_families/predicate_points.h"

#include <algorithm>
#include <cmath>

namespace tetracone::verify::predicate_family {

using namespace points;

namespace {

/// A pose that changes no exponent: x -> P x, P a signed permutation.
Frames permuted(Random& random)
{
  Frames f;
  if (one_in(random, 2)) f.a = signed_permutation(integer(random, 0, 47));
  if (one_in(random, 2)) f.b = signed_permutation(integer(random, 0, 47));
  return f;
}

/// Every point of the case.
std::array<Vertex*, 7> points_of(Predicate_case& c) { return {&c.v[0], &c.v[1], &c.v[2], &c.v[3], &c.p, &c.q, &c.r}; }

double largest(Predicate_case& c)
{
  double most = 0;
  for (const Vertex* x : points_of(c)) most = std::max(most, magnitude(*x));
  return most;
}

}  // namespace

Predicate_case far_from_origin(Random& random, double f)
{
  const double far = std::ldexp(1.0, static_cast<int>(f));
  const auto offset = [&] { return integer(random, -1, 1) * far; };
  const std::array t = {offset(), offset(), far};
  return settled([&] {
    // Points in quarters: doubles even at 2^50. They are far off themselves, or their poses put them there.
    const Tetra v = tetrahedron(random, 8);
    const Point x = element_point(random, v, integer(random, 1, 3), 2);
    Frames frames;
    if (one_in(random, 2))
      frames.b = frames.a = Pose::translation(-t[0], -t[1], -t[2]);
    else if (one_in(random, 2))
      frames.common = Pose::translation(t[0], t[1], t[2]);
    else
      frames.a = Pose::translation(-t[0], -t[1], -t[2]);
    if (!frames.a.is_identity()) {
      // The models are far off; half of these stay there.
      if (one_in(random, 2)) frames.common = Pose::translation(t[0], t[1], t[2]);
      if (one_in(random, 4)) frames.common = signed_permutation(integer(random, 0, 47));
    }
    return contact(random, v, x, frames, 2);
  });
}

Predicate_case mixed_scales(Random& random, double s)
{
  const Rational factor = power_of_two(static_cast<int>(s));
  return settled([&]() -> std::optional<Predicate_case> {
    // The contact is the origin, where both sizes are at home; what is common moves it anywhere.
    const Tetra v = tetrahedron_at_origin(random);
    Scene scene{v, Point{0, 0, 0}, {}, {}};
    complete(random, scene);
    const int ulps = moved_aside(random, scene);
    // The big one is A, or B; B keeps its p beside A.
    if (one_in(random, 2)) {
      for (Point& x : scene.v) x = times(factor, x);
    } else {
      scene.q = times(factor, scene.q);
      scene.r = times(factor, scene.r);
    }
    return finished(random, scene, ulps);
  });
}

Predicate_case cancelled_translation(Random& random, double f)
{
  const double far = std::ldexp(1.0, static_cast<int>(f));
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron(random, 8);
    const Point x = element_point(random, v, integer(random, 1, 3), 2);
    const std::array t = {sign(random) * far, integer(random, -1, 1) * far, integer(random, -1, 1) * far};
    const Pose away = Pose::translation(t[0], t[1], t[2]);
    Frames frames;
    if (one_in(random, 2)) {
      frames.b = composed(away, signed_permutation(integer(random, 0, 47)));
      if (one_in(random, 2)) frames.a = away;
      return contact(random, v, x, frames, 2);
    }
    // Under a rounded rotation: what is left of the sum is the rounding of the model, no less than an ulp of 2^f.
    Scene scene{v, x, {}, {}};
    complete(random, scene, 2);
    relabel(random, scene);
    frames.b = composed(away, double_rotation(random));
    return placed_nearly(scene, frames);
  });
}

Predicate_case exponent_gate(Random& random, double kind)
{
  Predicate_case c = any_contact(random, permuted(random));
  const int top = std::ilogb(largest(c)) + 1;
  // The least that the points are multiples of.
  int last = 0;
  for (const Vertex* x : points_of(c))
    for (const double coordinate : *x)
      while (std::ldexp(coordinate, last) != std::floor(std::ldexp(coordinate, last)) && last < 60) ++last;
  switch (static_cast<int>(kind)) {
    case 0: return rescaled(c, -110 + last);  // multiples of 2^-110
    case 1: return rescaled(c, 110 - top);    // at most 2^110
    case 2: return rescaled(c, -111 + last - integer(random, 0, 3));
    case 3: return rescaled(c, 111 - top + integer(random, 0, 3));
    default: break;
  }
  // Both ends: A at 2^110, B about the contact at 2^-110, or the other way round.
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron_at_origin(random);
    Scene scene{v, Point{0, 0, 0}, {}, {}};
    complete(random, scene);
    moved_aside(random, scene);
    if (one_in(random, 4)) scene.p = grid_point(random, 1);
    const Rational big = power_of_two(105), small = power_of_two(-100);
    const bool a_is_big = one_in(random, 2);
    for (Point& x : scene.v) x = times(a_is_big ? big : small, x);
    for (Point* x : {&scene.p, &scene.q, &scene.r}) *x = times(a_is_big ? small : big, *x);
    if (!a_is_big) scene.p = times(small / big, scene.p);  // p stays about A
    relabel(random, scene);
    return placed(scene, permuted(random));
  });
}

Predicate_case extreme_exponents(Random& random, double kind)
{
  if (kind < 2) {
    Predicate_case c = settled([&]() -> std::optional<Predicate_case> {
      const Tetra v = tetrahedron(random, 64);
      const Point x = element_point(random, v, integer(random, 1, 3), 4);
      Scene scene{v, x, {}, {}};
      complete(random, scene, 4);
      moved_aside(random, scene, 4);
      relabel(random, scene);
      return placed(scene, permuted(random));
    });
    int last = 0;
    for (const Vertex* x : points_of(c))
      for (const double coordinate : *x)
        while (std::ldexp(coordinate, last) != std::floor(std::ldexp(coordinate, last))) ++last;
    // Multiples of the least denormal; or up to the largest double's binade.
    const int exponent = kind == 0 ? last - 1074 : 1023 - std::ilogb(largest(c));
    c = rescaled(c, exponent);
    if (one_in(random, 4)) nudge(random, c, sign(random));
    return c;
  }
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron_at_origin(random);
    Scene scene{v, Point{0, 0, 0}, {}, {}};
    complete(random, scene, 4);
    const bool a_is_big = one_in(random, 2), at_contact = one_in(random, 2);
    if (!at_contact) scene.p = one_in(random, 2) ? outward(random, v, scene.p, 4) : on_grid(inner_point(random, v), 4);
    const double small = 1e-200, big = 1e200;
    const auto times_double = [](const Point& x, double s) { return points::exact(rounded(times(Rational(s), x))); };
    for (Point& x : scene.v) x = times(Rational(std::ldexp(1.0, a_is_big ? 664 : -664)), x);
    // B's numbers are no powers of two; its p is about A, of A's size or far less.
    scene.p = times_double(scene.p, a_is_big && one_in(random, 2) ? big : small);
    scene.q = times_double(scene.q, a_is_big ? small : big);
    scene.r = times_double(scene.r, one_in(random, 2) ? small : big);
    relabel(random, scene);
    return placed(scene, permuted(random));
  });
}

Predicate_case float_widened(Random& random, double bits)
{
  const int below = static_cast<int>(bits);
  return settled([&]() -> std::optional<Predicate_case> {
    // Mantissas of 22 bits, for a sum of three of them to be a float, and `bits` more.
    Tetra v;
    for (Point& x : v) x = on_grid(mantissa_point(random, 22 + below), 22 + below);
    for (int k = 2; k < 4; ++k)
      if (one_in(random, 2)) v[k] = between(v[1], v[k], 2);
    // Opposite v1, in the middle of v2 v3, or on a side.
    const Rational half(0.5);
    const std::array<Point, 3> places = {in_plane(v, 1, 1), in_plane(v, half, half), between(v[1], v[2], half)};
    Scene scene{v, any_of(random, places), {}, {}};
    complete(random, scene);
    const int aside = static_cast<int>(random.bits() % 8);  // by the last bit, sometimes
    if (aside < 3) scene.p[aside] += power_of_two(-22 - below) * sign(random);
    relabel(random, scene);
    return placed(scene, permuted(random));
  });
}

/// Each body stretched along its axes by powers of two and back by its pose, and both under a map of any kind.
Predicate_case wild(Random& random, double exponents)
{
  const int size = static_cast<int>(exponents) / 3;
  const auto frame = [&] {
    std::array<int, 3> by;
    for (int& e : by) e = integer(random, -size, size);
    return object_family::stretch(by);
  };
  Frames f;
  if (one_in(random, 2)) f.a = frame();
  if (one_in(random, 2)) f.b = frame();
  f.common = object_family::wild_map(random, size);
  return any_contact(random, f);
}

/// Bodies up to 2^exponent large by one power of two, or along each axis by one of its own. Their poses undo that. Then
/// both are under a similarity of fractions that may be smaller than all doubles but 0.
Predicate_case tiny_fractions(Random& random, double exponent)
{
  const int size = static_cast<int>(exponent);
  const auto frame = [&] {
    std::array<int, 3> by{-size, -size, -size};
    if (one_in(random, 3))
      for (int& e : by) e = -size * integer(random, 0, 1);
    return object_family::stretch(by);
  };
  Frames f;
  f.a = frame();
  f.b = frame();
  const std::array smaller = {0, integer(random, 25, 125), integer(random, 900, 1080)};
  f.common = object_family::fraction_map(random, -smaller[random.bits() % 3]);
  return any_contact(random, f);
}

}  // namespace tetracone::verify::predicate_family
