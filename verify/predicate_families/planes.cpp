#include "verify/predicate_families/predicate_families.h"
#include "verify/predicate_families/predicate_points.h"

#include <cmath>

namespace tetracone::verify::predicate_family {

using namespace points;

namespace {

/// A point of the plane v1 v2 v3 at barycentric coordinates in quarters: in the triangle, on its sides, beyond them.
Point quarters(Random& random, const Tetra& v)
{
  const int a = integer(random, -1, 4), b = integer(random, -1, 4);
  return in_plane(v, Rational(a) / 4, Rational(b) / 4);
}

/// p is done; q and r as if it were on the boundary.
std::optional<Predicate_case> completed(Random& random, const Tetra& v, const Point& p, const Frames& frames,
                                        int ulps = 0)
{
  Scene scene{v, p, {}, {}};
  complete(random, scene);
  relabel(random, scene);
  return finished(random, scene, frames, ulps);
}

}  // namespace

Predicate_case random_points(Random& random, double scale)
{
  const Tetra v = {mantissa_point(random, 52), mantissa_point(random, 52), mantissa_point(random, 52),
                   mantissa_point(random, 52)};
  const Point centre = inner_point(random, v);
  // Half of the cases are about the tetrahedron: few points of a cube are in a tetrahedron of its points.
  const bool near = one_in(random, 2);
  const auto point = [&] {
    return near ? sum(centre, Rational(0.25), mantissa_point(random, 52)) : mantissa_point(random, 52);
  };
  Scene scene{v, {}, {}, {}};
  scene.p = point();
  scene.q = point();
  scene.r = point();
  return rescaled(placed_nearly(scene, any_frames(random)), static_cast<int>(scale));
}

Predicate_case rounded_on_plane(Random& random, double bits)
{
  Tetra v;
  for (Point& x : v) x = mantissa_point(random, 52);
  const double a = 1.25 * random.unit() - 0.125, b = 1.25 * random.unit() - 0.125;
  Scene scene{v, in_plane(v, Rational(a), Rational(b)), {}, {}};
  complete(random, scene);
  for (Rational& x : scene.p) {
    const double coordinate = kernel::nearest_double(x);
    const int exponent = static_cast<int>(bits) - (coordinate == 0 ? 0 : std::ilogb(coordinate) + 1);
    x = Rational(std::ldexp(std::floor(std::ldexp(coordinate, exponent) + 0.5), -exponent));
  }
  relabel(random, scene);
  Frames f = any_frames(random);
  if (one_in(random, 2)) {
    f.a = f.b = Pose();
    f.scale = 1;
  }
  return placed_nearly(scene, f);
}

Predicate_case ulps_off_plane(Random& random, double ulps)
{
  return settled([&] {
    const Tetra v = tetrahedron(random, 8);
    const Point x = element_point(random, v, integer(random, 2, 3), 4);
    const Frames f = any_frames(random);
    return completed(random, v, x, f, sign(random) * static_cast<int>(ulps));
  });
}

Predicate_case perturbed_zero(Random& random, double q)
{
  const Frames f = any_frames(random);
  Predicate_case c = settled([&] {
    const Tetra v = tetrahedron(random, 8);
    const Point x = element_point(random, v, integer(random, 1, 3), 4);
    return completed(random, v, x, f);
  });
  if (std::isinf(q)) return c;
  const double share = sign(random) * std::ldexp(1.0, -static_cast<int>(q));
  const int axis = integer(random, 0, 2);
  double& x = c.p[axis];
  if (const double changed = x + share * x; changed != x) {
    x = changed;
    return c;
  }
  // Below the coordinate's last bit (or of a coordinate 0): B's translation has room for it.
  Point shift = {0, 0, 0};
  shift[axis] = Rational(share) * Rational(x == 0 ? 1.0 : x);
  c.pose_b = moved(c.pose_b, shift);
  return c;
}

Predicate_case coplanar_grid(Random& random, double bits)
{
  const int size = 1 << (static_cast<int>(bits) / 2 - 2), large = 1 << static_cast<int>(bits);
  return settled([&]() -> std::optional<Predicate_case> {
    const Point base = grid_point(random, large / 4), e1 = grid_point(random, size), e2 = grid_point(random, size);
    Tetra v;
    v[0] = grid_point(random, large);
    for (int k = 1; k < 4; ++k) {
      // Multiples of 4, for points in quarters.
      const int a = 4 * integer(random, -size / 2, size / 2), b = 4 * integer(random, -size / 2, size / 2);
      v[k] = sum(sum(base, Rational(a), e1), Rational(b), e2);
    }
    if (dot(difference(v[0], v[1]), cross(difference(v[2], v[1]), difference(v[3], v[1]))) == 0) return std::nullopt;
    Scene scene{v, quarters(random, v), {}, {}};
    complete(random, scene, 0);
    if (one_in(random, 4)) scene.q = quarters(random, v);
    relabel(random, scene);
    const int aside = static_cast<int>(random.bits() % 8);  // to the next point of the grid, sometimes
    if (aside < 3) scene.p[aside] += sign(random);
    return placed_somehow(scene, any_frames(random));
  });
}

Predicate_case coplanar_parallelogram(Random& random, double bits)
{
  return settled([&]() -> std::optional<Predicate_case> {
    Tetra v;
    for (Point& x : v) x = mantissa_point(random, static_cast<int>(bits));
    Scene scene{v, {}, {}, {}};
    if (one_in(random, 2)) {
      scene.p = in_plane(v, 1, 1);  // opposite v1
    } else {
      // v1 and the middles of the triangle's sides: p is in the middle of v2 v3.
      for (int k = 2; k < 4; ++k) scene.v[k] = between(v[1], v[k], 2);
      scene.p = in_plane(v, 1, 1);
    }
    complete(random, scene);
    if (one_in(random, 4))
      scene.q = any_of(random, std::array{scene.v[1], between(scene.v[2], scene.v[3], Rational(0.5))});
    const int ulps = one_in(random, 3) ? sign(random) : 0;
    relabel(random, scene);
    const Frames f = any_frames(random);
    return finished(random, scene, Frames{{}, {}, f.common, 1}, ulps);
  });
}

Predicate_case ulp_walk(Random& random, double axes)
{
  const Frames f = frames(
      random, any_of(random, std::array{Frame_kind::identity, Frame_kind::permutation, Frame_kind::rounded_rotation}));
  Predicate_case c = settled([&] {
    Tetra v = tetrahedron_at_origin(random, 24);
    const Point x = {Rational(0.5), Rational(0.5), Rational(0.5)};
    for (Point& corner : v) corner = sum(x, corner);
    return completed(random, v, x, f);
  });
  // Kettner's patch: 256 x 256 doubles, the contact in its middle. At 1/2 they are finer than the differences from A's
  // corners.
  for (int k = 0; k < 2; ++k) {
    double& x = c.p[(static_cast<int>(axes) + k) % 3];
    const double ulp = std::ldexp(1.0, (x == 0 ? 0 : std::ilogb(x)) - 52);
    x += integer(random, -128, 127) * ulp;
  }
  return c;
}

Predicate_case decimal_grid(Random& random, double d)
{
  double unit = 1;
  for (int k = 0; k < d; ++k) unit *= 10;
  return settled([&]() -> std::optional<Predicate_case> {
    Tetra v = tetrahedron(random, static_cast<int>(unit / 4) + 2);
    for (Point& x : v) x = times(4, x);
    Scene scene{v, quarters(random, v), {}, {}};
    complete(random, scene, 0);
    if (one_in(random, 8)) scene.p[0] += sign(random);
    relabel(random, scene);
    const auto decimal = [&](Point& x) {
      for (Rational& coordinate : x) coordinate = Rational(kernel::nearest_double(coordinate) / unit);
    };
    for (Point& x : scene.v) decimal(x);
    decimal(scene.p);
    decimal(scene.q);
    decimal(scene.r);
    return placed_somehow(scene, any_frames(random));
  });
}

Predicate_case non_planar_quads(Random& random, double ulps)
{
  return settled([&]() -> std::optional<Predicate_case> {
    // The quadrangle v1 v2 p v3 and its diagonal v2 v3: p is the fourth corner, or on the triangle's side of it.
    Tetra v;
    for (Point& x : v) x = mantissa_point(random, 40);
    const Rational along = Rational(integer(random, 1, 6)) / 4;
    Scene scene{v, between(v[1], between(v[2], v[3], Rational(0.5)), along), {}, {}};
    complete(random, scene);
    if (one_in(random, 3)) scene.q = v[1];  // the other diagonal
    const int off = sign(random) * static_cast<int>(ulps);
    return finished(random, scene, off);
  });
}

}  // namespace tetracone::verify::predicate_family
