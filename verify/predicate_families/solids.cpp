#include "verify/predicate_families/predicate_families.h"
#include "verify/predicate_families/predicate_points.h"

#include <cmath>
#include <utility>

namespace tetracone::verify::predicate_family {

using namespace points;

Predicate_case stacked(Random& random, double ulps)
{
  // The lower body's top is v1 v2 v3, at the height h; the upper one stands on p, h and some ulps high.
  const bool lifted = one_in(random, 2);  // by B's translation, else by its points
  const double h = lifted ? 1 + random.unit() : integer(random, 1, 15) / 8.0;
  const Rational top(h), bottom = top + Rational(ulps) * power_of_two(std::ilogb(h) - 52);
  return settled([&]() -> std::optional<Predicate_case> {
    const auto base = [&](const Rational& z) { return Point{integer(random, -8, 8), integer(random, -8, 8), z}; };
    const Tetra v = {base(0), base(top), base(top), base(top)};
    if (is_zero(cross(difference(v[2], v[1]), difference(v[3], v[1])))) return std::nullopt;
    Point x = element_point(random, v, integer(random, 1, 3), 4);
    if (one_in(random, 8)) x = in_plane(v, Rational(-1) / 8, Rational(1) / 2);
    const auto above = [&](const Rational& z) {
      return Point{x[0] + integer(random, -2, 2), x[1] + integer(random, -2, 2), z};
    };
    Scene scene{v, {x[0], x[1], bottom}, above(one_in(random, 2) ? bottom : Rational(3)), above(3)};
    if (one_in(random, 4)) scene.q = above(0);  // the segment goes through
    relabel(random, scene);
    Frames f;
    if (lifted) f.b = Pose::translation(0, 0, h);
    switch (random.bits() % 4) {
      case 0: f.common = signed_permutation(integer(random, 0, 47)); break;
      case 1: f.common = frames(random, Frame_kind::rounded_rotation).common; break;
      case 2: f.common = Pose::translation(0, 0, random.symmetric()); break;
      default: break;
    }
    return placed(scene, f);
  });
}

Predicate_case nested_touching(Random& random, double dimension)
{
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron(random, 8);
    const auto on = [&](int corners) { return element_point(random, v, corners, 4); };
    Scene scene{v, {}, {}, {}};
    if (one_in(random, 2)) {
      // B is inside: a vertex, an edge or a face of it on an element of A.
      const int corners = integer(random, dimension == 0 ? 1 : dimension == 1 ? 2 : 3, 3);
      scene.p = on(corners);
      scene.q = dimension >= 1 ? on(corners) : inner_point(random, v);
      scene.r = dimension >= 2 ? on(corners) : inner_point(random, v);
    } else if (dimension == 0) {
      // A is inside: it has a vertex in B's face, an edge, or a face. Here B's face is parallel to the one opposite v1.
      const Point way = difference(v[2], v[3]), other = difference(v[3], v[0]);
      scene.p = sum(v[1], way);
      scene.q = sum(v[1], other);
      scene.r = sum(sum(v[1], Rational(-integer(random, 0, 2)), way), Rational(-1), other);
    } else if (dimension == 1) {
      scene.p = between(v[1], v[2], Rational(-1) / 2);
      scene.q = between(v[1], v[2], Rational(integer(random, 3, 6)) / 4);
      scene.r = outward(random, v, on(2));
    } else {
      scene.p = in_plane(v, Rational(-1) / 2, Rational(-1) / 2);
      scene.q = in_plane(v, 3, Rational(-1) / 2);
      scene.r = in_plane(v, Rational(-1) / 2, 3);
    }
    const int ulps = one_in(random, 2) ? any_of(random, std::array{-2, -1, 1, 2}) : 0;
    return finished(random, scene, ulps);
  });
}

Predicate_case nested(Random& random, double distance)
{
  return settled([&]() -> std::optional<Predicate_case> {
    // About the origin, on an element of A, so that what is far off rounds nothing away.
    const Tetra v = tetrahedron_at_origin(random);
    const Point inward = inner_point(random, v), x{0, 0, 0};
    Scene scene{v, {}, {}, {}};
    if (one_in(random, 2)) {
      // B is inside.
      scene.p = times(Rational(distance), inward);
      scene.q = inner_point(random, v);
      scene.r = inner_point(random, v);
    } else {
      // A is inside, p q r on B's face beyond x.
      scene.p = times(Rational(-distance), inward);
      scene.q = outward(random, v, x);
      scene.r = outward(random, v, x);
    }
    relabel(random, scene);
    return placed_somehow(scene, any_frames(random));
  });
}

Predicate_case cavity_wall(Random& random, double genus)
{
  return settled([&]() -> std::optional<Predicate_case> {
    Tetra v;
    if (genus == 0) {
      // The cavity itself, turned inside out.
      v = tetrahedron(random, 8);
      if (dot(difference(v[1], v[0]), cross(difference(v[2], v[0]), difference(v[3], v[0]))) > 0) std::swap(v[0], v[1]);
    } else {
      // Two thirds of the way up a wall between two corners of a tunnel along z, square or triangular, and a point of
      // the material.
      constexpr std::array<std::array<int, 2>, 4> square = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
      constexpr std::array<std::array<int, 2>, 3> triangle = {{{-2, -1}, {2, -1}, {0, 3}}};
      const int k = integer(random, 0, genus == 1 ? 3 : 2);
      const auto corner = [&](int i, int z) {
        const auto [x, y] = genus == 1 ? square[i % 4] : triangle[i % 3];
        return Point{x, y, z};
      };
      v = {sum(corner(k, 0), sum(corner(k, 0), corner(k + 1, integer(random, -2, 2)))), corner(k, -3),
           corner(k + 1, -3), corner(k + 1, 3)};
      if (one_in(random, 2)) v[3] = corner(k, 3);
    }
    const Point x = element_point(random, v, integer(random, 1, 3), 4);
    if (one_in(random, 2)) return contact(random, v, x, any_frames(random));
    // An edge along the wall.
    Scene scene{v, x, in_plane(v, Rational(integer(random, -1, 4)) / 4, Rational(1) / 8), outward(random, v, x)};
    const int ulps = one_in(random, 2) ? any_of(random, std::array{-2, -1, 1, 2}) : 0;
    return finished(random, scene, ulps);
  });
}

Predicate_case duplicates(Random& random, double what)
{
  return settled([&]() -> std::optional<Predicate_case> {
    Tetra v = tetrahedron(random, 8);
    Scene scene{v, v[1], {}, {}};
    complete(random, scene);
    if (what == 0) {
      // Vertices: of B, of A, of both.
      switch (random.bits() % 4) {
        case 0: scene.q = scene.p; break;
        case 1: scene.r = scene.p; break;
        case 2: scene.v[3] = scene.v[integer(random, 0, 2)]; break;
        default: break;
      }
    } else if (what == 1) {
      scene.q = v[2];
      scene.r = v[3];
    } else {
      // B's face is another one of the edge v1 v2: right beyond A's, against it, or on it.
      const std::array<Point, 6> wing = {v[3],
                                         between(v[1], v[3], -1),
                                         between(v[1], v[0], -1),
                                         v[0],
                                         between(v[0], v[3], Rational(0.5)),
                                         between(v[1], between(v[0], v[3], Rational(0.5)), -1)};
      scene.q = v[2];
      scene.r = wing[random.bits() % (what == 2 ? 4 : 6)];
    }
    if (one_in(random, 4)) std::swap(scene.p, scene.q);
    const int ulps = moved_aside(random, scene);
    if (one_in(random, 4)) {
      scene.q = outward(random, v, v[1]);
      scene.r = outward(random, v, v[1]);
    }
    return finished(random, scene, ulps);
  });
}

Predicate_case voxels(Random& random, double size)
{
  const int n = static_cast<int>(size);
  // A corner of one voxel, and corners of others.
  Tetra v;
  const auto corner = [&] { return Point{integer(random, 0, n), integer(random, 0, n), integer(random, 0, n)}; };
  v[0] = corner();
  const int first = integer(random, 0, 2);
  for (int k = 0; k < 3; ++k) {
    v[k + 1] = v[0];
    v[k + 1][(first + k) % 3] += sign(random);
  }
  Scene scene{v, corner(), corner(), corner()};
  if (one_in(random, 2)) {
    // Sides of one voxel that has v0 for a corner.
    for (Point* x : {&scene.p, &scene.q, &scene.r})
      for (int k = 0; k < 3; ++k) (*x)[k] = v[0][k] + integer(random, -1, 1);
  }
  relabel(random, scene);
  constexpr std::array kinds = {Frame_kind::identity, Frame_kind::translation, Frame_kind::permutation};
  return settled([&] { return placed(scene, frames(random, any_of(random, kinds))); });
}

Predicate_case tangent_fan(Random& random, double valence)
{
  return settled([&]() -> std::optional<Predicate_case> {
    // Two fans of triangles about the z-axis meet in their hubs; A's is v1, or v0, two neighbours of its rim v2 and v3.
    const int n = static_cast<int>(valence);
    const auto rim = [&](int k, const Rational& z) {
      const auto [x, y] = turn(double(k % n) / n);
      return on_grid(Point{Rational(x), Rational(y), z}, 20);
    };
    const Point hub{0, 0, 0};
    const int k = integer(random, 0, n - 1);
    const Rational slope = Rational(integer(random, 0, 4)) / 8;
    Scene scene{{Point{0, 0, Rational(-1)}, hub, rim(k, -slope), rim(k + 1, -slope)}, hub, {}, {}};
    const int m = one_in(random, 2) ? k : integer(random, 0, n - 1);
    const Rational other = Rational(integer(random, 0, 4)) / 8 - (one_in(random, 4) ? Rational(1) / 2 : Rational(0));
    scene.q = rim(m, other);
    scene.r = rim(m + 1, other);
    if (one_in(random, 4)) scene.r = Point{0, 0, 1};
    const int ulps = moved_aside(random, scene);
    return finished(random, scene, ulps);
  });
}

Predicate_case swept_primitives(Random& random, double kind)
{
  // A vertex or edge moves to a contact by decimal amounts: here before it, or there, in doubles. Without poses, as
  // recorded queries are.
  const Tetra grid = tetrahedron(random, 8);
  Tetra v;
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 3; ++i) v[k][i] = Rational(kernel::nearest_double(grid[k][i]) / 10);
  const auto on = [&](int corners) { return element_point(random, v, corners, 10); };
  const auto out = [&](const Point& x) { return sum(x, Rational(0.3), difference(x, inner_point(random, v))); };
  Scene scene{v, {}, {}, {}};
  const double thin = any_of(random, std::array{1e-2, 1e-6, 1e-12});
  switch (static_cast<int>(kind)) {
    case 0:  // a spike's tip on a face or another tip, its other corners close together
      scene.p = on(one_in(random, 2) ? 3 : 1);
      scene.q = out(scene.p);
      scene.r = sum(scene.q, Rational(thin), difference(v[2], v[1]));
      break;
    case 1:  // a wedge's edge across another edge
      scene.p = out(on(2));
      scene.q = between(scene.p, on(2), 2);
      scene.r = out(on(2));
      break;
    case 2: {  // a corner in a crack: between the face and one right opposite
      const Point x = on(3);
      scene.p = sum(x, Rational(thin), difference(out(x), x));
      scene.q = sum(scene.p, Rational(0.5), difference(v[2], v[1]));
      scene.r = out(x);
      break;
    }
    case 3:  // a corner at a cliff's edge, about to fall
      scene.p = on(2);
      scene.q = sum(scene.p, Rational(thin), difference(v[2], v[3]));
      scene.r = out(scene.p);
      break;
    default:  // on the edge between two triangles of one plane
      scene.v[0] = sum(v[2], difference(v[1], v[3]));
      scene.v[0][integer(random, 0, 2)] += Rational(thin);
      scene.p = on(2);
      scene.q = out(scene.p);
      scene.r = out(scene.p);
  }
  if (one_in(random, 3)) {
    // The start of the sweep.
    const Point shift = times(Rational(any_of(random, std::array{1e-3, 0.1, 1.0})), difference(out(scene.p), scene.p));
    for (Point* x : {&scene.p, &scene.q, &scene.r}) *x = sum(*x, shift);
  }
  relabel(random, scene);
  return placed_nearly(scene, {});
}

}  // namespace tetracone::verify::predicate_family
