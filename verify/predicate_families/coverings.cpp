#include "verify/cases/exact_motion.h"
#include "verify/predicate_families/predicate_corpus.h"
#include "verify/predicate_families/predicate_families.h"
#include "verify/predicate_families/predicate_points.h"

namespace tetracone::verify::predicate_family {

using namespace points;

Predicate_case covering_elements(Random& random, double element)
{
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron(random, 8);
    Scene scene{v, v[integer(random, 1, 3)], {}, {}};
    complete(random, scene);
    // The origin of the covering is q, anywhere; the tree's cone is of a covering with the origin v0.
    const bool of_cone = one_in(random, 2);
    if (!of_cone) scene.q = one_in(random, 2) ? inner_point(random, v) : on_grid(scene.q, 4);
    const Point origin = of_cone ? v[0] : scene.q;
    const int first = integer(random, 0, 2);
    const Point &one = v[1 + first], &two = v[1 + (first + 1) % 3];
    const Rational a = Rational(integer(random, 1, 12)) / 8, b = Rational(integer(random, 1, 8)) / 8;
    switch (static_cast<int>(element)) {
      case 0: scene.p = between(between(origin, one, a), two, b); break;
      case 1: scene.p = between(origin, one, a); break;
      default: scene.p = origin;
    }
    const int ulps = one_in(random, 3) ? any_of(random, std::array{-2, -1, 1, 2}) : 0;
    if (!of_cone)
      relabel(random, scene);  // the covering has the tetrahedron's edges and facets, whatever they are called
    return finished(random, scene, any_frames(random), ulps);
  });
}

Predicate_case covering_apex(Random& random, double position)
{
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron(random, 8);
    const auto on_plane = [&] {
      const int a = integer(random, -2, 6), b = integer(random, -2, 6);
      return in_plane(v, Rational(a) / 4, Rational(b) / 4);
    };
    Scene scene{v, element_point(random, v, integer(random, 1, 3), 4), {}, {}};
    complete(random, scene);
    scene.q = position == 0 ? on_plane()
                            : between(v[1], v[2], position == 1 ? Rational(integer(random, -4, 8)) / 4 : Rational(0));
    int ulps = 0;
    switch (random.bits() % 8) {
      case 0: scene.p = inner_point(random, v); break;
      case 1: scene.p = outward(random, v, scene.p); break;
      case 2: scene.p = on_plane(); break;
      case 3: scene.p = between(scene.q, inner_point(random, v), Rational(0.5)); break;
      case 4: scene.p = between(scene.q, v[integer(random, 0, 3)], Rational(0.25)); break;
      case 5: ulps = sign(random); break;
      default: break;
    }
    return finished(random, scene, ulps);
  });
}

Predicate_case winding_axis(Random& random, double element)
{
  return settled([&]() -> std::optional<Predicate_case> {
    const Tetra v = tetrahedron(random, 8);
    const Point x = element_point(random, v, 1 + static_cast<int>(element), 4);
    const int axis = integer(random, 0, 2);
    const auto along = [&](const Rational& s) {
      Point y = x;
      y[axis] += s;
      return y;
    };
    const Rational side = sign(random), near = side * integer(random, 1, 32) / 8,
                   far = side * integer(random, 0, 64) / 8;
    // p on one side of the element, q on it or on the other side, or nearer than it; now and then p on it.
    Scene scene{v, along(near), along(one_in(random, 4) ? Rational(near / 2) : Rational(-far)), outward(random, v, x)};
    if (one_in(random, 8)) scene.p = x;
    const int ulps = one_in(random, 4) ? sign(random) : 0;
    relabel(random, scene);
    const Frame_kind kind =
        any_of(random, std::array{Frame_kind::identity, Frame_kind::translation, Frame_kind::permutation});
    return finished(random, scene, frames(random, kind), ulps);
  });
}

Predicate_case corpus(Random& random, double ulps)
{
  const auto& numbers = any_of(random, predicate_corpus);
  Predicate_case c;
  const std::array<Vertex*, 7> x = {&c.v[0], &c.v[1], &c.v[2], &c.v[3], &c.p, &c.q, &c.r};
  for (int k = 0; k < 21; ++k) (*x[k / 3])[k % 3] = numbers[k];
  const int k = integer(random, 0, 20);
  double& coordinate = (*x[k / 3])[k % 3];
  coordinate += (sign(random) * ulps) * ulp(coordinate != 0 ? coordinate : 1.0);
  return c;
}

}  // namespace tetracone::verify::predicate_family
