#include "verify/predicate_families/predicate_points.h"

#include "verify/cases/exact_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetracone::verify::points {

Point grid_point(Random& random, int size)
{
  return {integer(random, -size, size), integer(random, -size, size), integer(random, -size, size)};
}

Point mantissa_point(Random& random, int bits)
{
  const auto coordinate = [&] {
    return Rational(std::floor(std::ldexp(random.symmetric(), bits)) * std::ldexp(1.0, -bits));
  };
  return {coordinate(), coordinate(), coordinate()};
}

Tetra tetrahedron(Random& random, int size, bool anchored)
{
  const Rational cube = Rational(size) * size * size;
  for (;;) {
    Tetra v = {grid_point(random, size), grid_point(random, size), grid_point(random, size), grid_point(random, size)};
    if (anchored) v[1] = {0, 0, 0};
    const Rational volume = dot(difference(v[0], v[1]), cross(difference(v[2], v[1]), difference(v[3], v[1])));
    if (volume != 0 && 4 * abs(volume) >= cube) return v;
  }
}

Tetra tetrahedron_at_origin(Random& random, int size)
{
  Tetra v = tetrahedron(random, size);
  const Point contact = element_point(random, v, integer(random, 1, 3), 4);
  for (Point& corner : v) corner = difference(corner, contact);
  return v;
}

Tetra tetrahedron_for(Random& random, int bits) { return tetrahedron(random, bits > 40 ? 1 : 8, true); }

Point inner_point(Random& random, const Tetra& v)
{
  std::array<int, 4> weight = {2, 2, 2, 2};
  for (int k = 0; k < 8; ++k) ++weight[random.bits() % 4];
  Point m = {0, 0, 0};
  for (int k = 0; k < 4; ++k) m = sum(m, Rational(weight[k] / 16.0), v[k]);
  return m;
}

Point element_point(Random& random, const Tetra& v, int n, int bits)
{
  if (n == 1) return v[1];
  const double a = dyadic(random, bits);
  if (n == 2) return between(v[1], v[2], Rational(a));
  for (;;) {
    const double b = dyadic(random, bits), c = dyadic(random, bits);
    if (b + c < 1) return in_plane(v, Rational(b), Rational(c));
  }
}

Point on_grid(const Point& x, int bits)
{
  Point result;
  for (int k = 0; k < 3; ++k)
    result[k] = Rational(std::floor(std::ldexp(kernel::nearest_double(x[k]), bits))) * power_of_two(-bits);
  return result;
}

Point outward(Random& random, const Tetra& v, const Point& x, int grid)
{
  const Point from = on_grid(x, grid);
  const double far = any_of(random, std::array{0.5, 1.0, 2.0});
  return on_grid(sum(from, Rational(far), difference(from, inner_point(random, v))), grid);
}

void complete(Random& random, Scene& scene, int grid)
{
  const Tetra& v = scene.v;
  const Point x = on_grid(scene.p, grid), inner = inner_point(random, v);
  scene.q = outward(random, v, x, grid);
  scene.r = outward(random, v, x, grid);
  switch (random.bits() % 8) {
    case 0: scene.r = inner; break;
    case 1: scene.q = inner; break;
    case 2: scene.q = between(x, inner, Rational(integer(random, 2, 4))); break;
    case 3: {
      // Along the face or edge, as exactly as p is on it.
      const Point& corner = v[integer(random, 1, 3)];
      scene.q = between(scene.p, corner, Rational(sign(random)) / 2);
      return;
    }
    default: break;
  }
  scene.q = on_grid(scene.q, grid);
  scene.r = on_grid(scene.r, grid);
}

int moved_aside(Random& random, Scene& scene, int grid)
{
  const Point x = on_grid(scene.p, grid), inner = inner_point(random, scene.v);
  const auto move = [&](const Rational& s) {
    scene.p = on_grid(between(x, inner, s), grid);
    return 0;
  };
  switch (random.bits() % 8) {
    case 0:
    case 1: return move(Rational(-1) / 4);
    case 2: return move(Rational(1) / 4);
    case 3:
    case 4: return any_of(random, std::array{-2, -1, 1, 2});
    default: return 0;
  }
}

void relabel(Random& random, Scene& scene)
{
  if (one_in(random, 2)) return;
  for (int k = 0; k < 3; ++k) std::swap(scene.v[k], scene.v[k + random.bits() % (4 - k)]);
}

void nudge(Random& random, Predicate_case& c, int ulps)
{
  const int axis = static_cast<int>(random.bits() % 3);
  double& x = c.p[axis];
  const double step = x != 0 ? ulp(x) : ulp(std::max({magnitude(c.p), magnitude(c.q), magnitude(c.r)}));
  x += ulps * step;
}

// --- placing ---------------------------------------------------------------------------------------------------------

namespace {

Pose translation(Random& random, int size)
{
  const std::array t = {integer(random, -size, size) / 4.0, integer(random, -size, size) / 4.0,
                        integer(random, -size, size) / 4.0};
  return Pose::translation(t[0], t[1], t[2]);
}

Pose full_translation(Random& random)
{
  const std::array t = {random.symmetric(), random.symmetric(), random.symmetric()};
  return Pose::translation(t[0], t[1], t[2]);
}

/// A rounded rotation and a translation of full mantissas.
Pose rounded_motion(Random& random)
{
  std::array<double, 12> entries = double_rotation(random).entries();
  for (const int k : {3, 7, 11}) entries[k] = random.symmetric();
  return Pose(entries);
}

/// Nothing of the model's points when some are no doubles.
std::optional<Predicate_case> with_points(const Scene& scene, const Frames& frames, bool exactly_so)
{
  Predicate_case c;
  bool all_exact = true;
  const auto model = [&](const Pose& frame, const Point& x) {
    const Point y = preimage(frame, times(frames.scale, x));
    const Vertex nearest = rounded(y);
    all_exact = all_exact && exact(nearest) == y;
    return nearest;
  };
  for (int k = 0; k < 4; ++k) c.v[k] = model(frames.a, scene.v[k]);
  c.p = model(frames.b, scene.p);
  c.q = model(frames.b, scene.q);
  c.r = model(frames.b, scene.r);
  if (exactly_so && !all_exact) return std::nullopt;
  const auto put = [&](const Pose& frame) {
    return frame.is_identity() ? frames.common : composed(frames.common, frame);
  };
  c.pose_a = put(frames.a);
  c.pose_b = put(frames.b);
  return c;
}

}  // namespace

Frames frames(Random& random, Frame_kind kind)
{
  const auto permutation = [&] {
    const Pose turn = signed_permutation(integer(random, 0, 47));
    return composed(translation(random, 16), turn);
  };
  Frames f;
  switch (kind) {
    case Frame_kind::identity: break;
    case Frame_kind::translation:
      f.a = translation(random, 32);
      f.b = translation(random, 32);
      if (one_in(random, 2)) f.common = full_translation(random);
      break;
    case Frame_kind::permutation:
      f.a = permutation();
      f.b = permutation();
      break;
    case Frame_kind::true_rotation: return true_rotations(random, 3);
    case Frame_kind::rounded_rotation:
      f.common = rounded_motion(random);
      if (one_in(random, 2)) f.b = one_in(random, 2) ? permutation() : signed_permutation(integer(random, 0, 47));
      if (one_in(random, 4)) f.a = translation(random, 32);
      break;
    case Frame_kind::shear: {
      const auto [there, back] = shear_and_inverse(random, 3);
      f.a = one_in(random, 2) ? back : Pose();
      f.b = there;
      break;
    }
  }
  return f;
}

Frames any_frames(Random& random)
{
  using enum Frame_kind;
  constexpr std::array kinds = {identity,      identity,         translation,      permutation,
                                true_rotation, rounded_rotation, rounded_rotation, shear};
  return frames(random, any_of(random, kinds));
}

Frames true_rotations(Random& random, int size)
{
  Frames f;
  for (Pose* frame : {&f.a, &f.b}) {
    std::array<int, 4> q;
    do {
      for (int& x : q) x = integer(random, -size, size);
    } while (q == std::array{0, 0, 0, 0});
    *frame = Pose::from_quaternion(q[0], q[1], q[2], q[3]);
    f.scale *= q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  }
  return f;
}

std::optional<Predicate_case> placed(const Scene& scene, const Frames& frames)
{
  return with_points(scene, frames, true);
}

std::optional<Predicate_case> placed_somehow(const Scene& scene, const Frames& frames)
{
  const auto c = placed(scene, frames);
  return c ? c : placed(scene, Frames{{}, {}, frames.common, 1});
}

std::optional<Predicate_case> finished(Random& random, const Scene& scene, const Frames& frames, int ulps)
{
  auto c = placed_somehow(scene, frames);
  if (c) nudge(random, *c, ulps);
  return c;
}

std::optional<Predicate_case> finished(Random& random, Scene scene, int ulps)
{
  relabel(random, scene);
  return finished(random, scene, any_frames(random), ulps);
}

Predicate_case placed_nearly(const Scene& scene, const Frames& frames) { return *with_points(scene, frames, false); }

Predicate_case rescaled(Predicate_case c, int exponent)
{
  for (Vertex* x : {&c.v[0], &c.v[1], &c.v[2], &c.v[3], &c.p, &c.q, &c.r})
    for (double& coordinate : *x) coordinate = std::ldexp(coordinate, exponent);
  for (Pose* pose : {&c.pose_a, &c.pose_b}) *pose = scaled(*pose, exponent).value();
  return c;
}

std::optional<Predicate_case> contact(Random& random, const Tetra& v, const Point& x, const Frames& frames, int grid)
{
  Scene scene{v, x, {}, {}};
  complete(random, scene, grid);
  const int ulps = moved_aside(random, scene, grid);
  relabel(random, scene);
  return finished(random, scene, frames, ulps);
}

Predicate_case any_contact(Random& random, const Frames& frames)
{
  return settled([&] {
    const Tetra v = tetrahedron(random, 8);
    return contact(random, v, element_point(random, v, integer(random, 1, 3), 4), frames);
  });
}

}  // namespace tetracone::verify::points
