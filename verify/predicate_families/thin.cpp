#include "verify/predicate_families/predicate_families.h"
#include "verify/predicate_families/predicate_points.h"

#include <cmath>

namespace tetracone::verify::predicate_family {

using namespace points;

Predicate_case sliver(Random& random, double h)
{
  return settled([&]() -> std::optional<Predicate_case> {
    const Rational height = power_of_two(-static_cast<int>(h));
    Tetra v = tetrahedron(random, 1, true);
    const Point up = v[3];
    v[3] = sum(between(v[1], v[2], Rational(0.5)), height, up);
    // On the middle of the triangle, on both of its sides there, and as far beyond them.
    const Rational t = Rational(integer(random, -1, 3)) / 2;
    const Point x = sum(between(v[1], v[2], Rational(0.5)), t * height, up);
    Scene scene{v, x, {}, {}};
    complete(random, scene);
    if (one_in(random, 2)) {
      const Point through = grid_point(random, 1);
      const Rational before = one_in(random, 2) ? 0 : 1;
      scene.p = sum(x, Rational(-before), through);
      scene.q = sum(x, 1, through);
    }
    relabel(random, scene);
    return placed_somehow(scene, any_frames(random));
  });
}

Predicate_case needle(Random& random, double a)
{
  double aspect = 1;
  for (int k = 0; k < a; ++k) aspect /= 10;
  return settled([&]() -> std::optional<Predicate_case> {
    // A base about the origin, where small differences are doubles, and the tip far off.
    Tetra v = tetrahedron(random, 8);
    const Point tip = mantissa_point(random, 52);
    for (Point& x : v) x = points::exact(rounded(times(Rational(aspect / 8), x)));
    v[0] = tip;
    if (dot(v[0], cross(difference(v[2], v[1]), difference(v[3], v[1]))) == 0) return std::nullopt;
    // Across the needle at some height, through it or past it by as much.
    const Rational height = Rational(integer(random, 0, 7)) / 8;
    const auto at = [&](const Point& base) { return between(base, tip, height); };
    const Point middle = times(Rational(1) / 3, sum(v[1], sum(v[2], v[3])));
    const Point& corner = v[integer(random, 1, 3)];
    const Point x = at(between(middle, corner, Rational(integer(random, 0, 3)) / 2));
    const Point way = mantissa_point(random, 20);
    Scene scene{v, x, sum(x, 1, way), {}};
    if (one_in(random, 3)) scene.p = sum(x, Rational(-1), way);
    scene.r = sum(x, 1, mantissa_point(random, 20));
    relabel(random, scene);
    Frames f = any_frames(random);
    if (!one_in(random, 4)) {
      f.a = f.b = Pose();
      f.scale = 1;
    }
    return placed_nearly(scene, f);
  });
}

Predicate_case nearly_collinear(Random& random, double ulps)
{
  return settled([&]() -> std::optional<Predicate_case> {
    Tetra v = tetrahedron(random, 8);
    Point& third = v[3];
    third = between(v[1], v[2], Rational(any_of(random, std::array{-1.0, 0.25, 0.5, 2.0})));
    const double size = std::abs(kernel::nearest_double(third[0])) + 1;
    third[integer(random, 0, 2)] += Rational(sign(random) * ulps) * power_of_two(std::ilogb(size) - 52);
    Scene scene{v, between(v[1], third, Rational(integer(random, -1, 5)) / 4), {}, {}};
    const Point apex = v[0];
    const Point way = difference(grid_point(random, 8), on_grid(scene.p, 4));
    scene.q = sum(scene.p, Rational(integer(random, -1, 2)) / 2, way);
    scene.r = grid_point(random, 8);
    if (one_in(random, 4)) scene.q = between(v[1], v[2], Rational(integer(random, -2, 4)) / 2);
    if (one_in(random, 4)) scene.p = between(apex, scene.p, Rational(integer(random, 1, 3)) / 2);
    const int off = any_of(random, std::array{0, 0, 0, 0, -4, -1, 1, 4});
    return finished(random, scene, off);
  });
}

Predicate_case degenerate_face(Random& random, double kind)
{
  return settled([&]() -> std::optional<Predicate_case> {
    Tetra v = tetrahedron(random, 8);
    const Point x = element_point(random, v, 2, 4);
    switch (static_cast<int>(kind)) {
      case 0: v[3] = between(v[1], v[2], Rational(any_of(random, std::array{-0.5, 0.25, 0.5, 1.5}))); break;
      case 1: v[2] = v[3] = v[1]; break;
      default: v[3] = v[integer(random, 1, 2)];
    }
    Scene scene{v, kind == 1 ? v[1] : x, grid_point(random, 8), grid_point(random, 8)};
    switch (random.bits() % 8) {
      case 0: scene.q = between(v[1], v[2], Rational(integer(random, -2, 4)) / 2); break;  // along it
      case 1:
      case 2: scene.p = between(scene.p, scene.q, -1); break;  // through it
      case 3: scene.p = grid_point(random, 8); break;
      case 4:
        scene.p = between(v[1], v[2], Rational(1.25));
        scene.q = between(v[1], v[2], Rational(1.5));
        break;                           // along it, beyond it
      case 5: scene.q = scene.p; break;  // B's is degenerate too
      default: break;
    }
    const int ulps = one_in(random, 4) ? sign(random) : 0;
    // Elsewhere the face is one of the three through v0.
    return finished(random, scene, ulps);
  });
}

Predicate_case near_parallel_edges(Random& random, double a)
{
  return settled([&]() -> std::optional<Predicate_case> {
    // Both edges pass through the origin, or pq beside it by as much as it turns off.
    const Rational angle = std::isinf(a) ? Rational(0) : power_of_two(-static_cast<int>(a));
    Tetra v = tetrahedron(random, 1, true);
    const Point along = v[2], aside = grid_point(random, 1);
    v[1] = times(Rational(-1), along);
    const Point turned = sum(along, angle, aside);
    const auto end = [&](int s) { return times(Rational(s * any_of(random, std::array{0.5, 1.0, 2.0})), turned); };
    Scene scene{v, end(-1), end(1), outward(random, v, Point{0, 0, 0})};
    int ulps = 0;
    switch (random.bits() % 8) {
      case 0:
      case 1: ulps = sign(random); break;
      case 2:
      case 3: {
        const Point shift = times(angle == 0 ? power_of_two(-40) : angle, grid_point(random, 1));
        scene.p = sum(scene.p, shift);
        scene.q = sum(scene.q, shift);
        break;
      }
      case 4: scene.p = Point{0, 0, 0}; break;
      case 5: scene.p = end(1); break;
      default: break;
    }
    return finished(random, scene, ulps);
  });
}

/// A tetrahedron from 0 to a triangle about 1 away that is one of that many about 0.
Predicate_case many_faces(Random& random, double triangles)
{
  constexpr int bits = 30;
  const Rational edge = on_grid({Rational(std::sqrt(29 / triangles)), 0, 0}, bits)[0];
  return settled([&]() -> std::optional<Predicate_case> {
    const auto corner = [&] { return on_grid(mantissa_point(random, bits), bits); };
    Tetra v = {Point{0, 0, 0}, corner(), corner(), corner()};
    for (int k = 2; k <= 3; ++k) v[k] = on_grid(sum(v[1], edge, v[k]), bits);
    if (dot(v[1], cross(v[2], v[3])) == 0) return std::nullopt;
    const Point x = element_point(random, v, integer(random, 1, 3), 4);
    const Frames frames = any_frames(random);
    return contact(random, v, x, frames, bits + 4);
  });
}

}  // namespace tetracone::verify::predicate_family
