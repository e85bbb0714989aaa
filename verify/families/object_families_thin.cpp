#include "verify/cases/object_placing.h"
#include "verify/families/object_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace tetracone::verify::object_family {

using covering::Polyhedron;
using kernel::Vertex;

/// A tetrahedron whose face in the plane z = 0 has the height 2^-h over its longest side, and one below with a corner
/// about there.
Object_case sliver(Random& random, double parameter)
{
  const double height = std::ldexp(1.0, -static_cast<int>(parameter)), at = dyadic(random, 3);
  const auto aside = [&] { return random.symmetric(); };
  const Body a = tetrahedron({Vertex{0, 0, 0}, {1, 0, 0}, {at, height, 0}, {aside(), aside(), 1}});
  const double along = integer(random, -1, 9) / 8.0, across = height * integer(random, -2, 5) / 4.0;
  const double up = random.bits() % 3 != 0 ? 0 : height * integer(random, -4, 4) / 8.0;
  const Body b = tetrahedron(
      {Vertex{along, across, up}, {aside(), aside(), -1}, {aside(), aside(), -1.25}, {aside(), aside(), -1.5}});
  const Object_case c = placed(random, a, b, Pose(), exact_motion(random));
  if (up < 0) return with_answer(c, false);
  if (up > 0) return c;
  // Over the long side, and under the two others.
  const Rational x(along), y(across), h(height), top(at);
  return with_answer(c, y >= 0 && y * top <= h * x && y * (1 - top) <= h * (1 - x));
}

/// Its tip, its sides or its tiny base at a block.
Object_case needle(Random& random, double parameter)
{
  static const std::vector<Shape> needles = [] {
    std::vector<Shape> all;
    double width = 1;
    for (int a = 0; a <= 15; ++a, width /= 10)
      all.emplace_back(tetrahedron({Vertex{0, 0, 0}, {1, width, 0}, {1, 0, width}, {1, -width, -width}}));
    return all;
  }();
  const Shape& b = needles[static_cast<int>(parameter)];
  const Shape& a = random.bits() % 4 == 0 ? b : any_block(random);
  const Touching contact = any_contact(random, a, b, any_turn(random));
  const Rational width(b.body->vertices[1][1]);
  const Rational gap = random.bits() % 2 == 0 ? any_gap(random) : Rational(width * integer(random, -2, 4) / 2);
  return placed(random, contact, gap);
}

/// Pyramids of many sides, and crowns that are pits between ridges: on their apex.
Object_case tangent_fan(Random& random, double parameter)
{
  const int valence = static_cast<int>(parameter);
  static const std::array<int, 5> valences = {3, 6, 12, 24, 48};
  static const std::vector<Shape> fans = [] {
    std::vector<Shape> all;
    for (const bool crown : {false, true})
      for (const int n : valences) {
        // Corners on a circle, rounded to 2^-20; every other one of a crown is nearer and as high as its apex or
        // higher.
        Polyhedron fan;
        fan.vertices = {{0, 0, 0}, {0, 0, -1}};
        for (int k = 0; k < n; ++k) {
          const auto [c, s] = turn(double(k) / n);
          const double r = crown && k % 2 == 1 ? 0.5 : 1, z = crown && k % 2 == 1 ? (k % 4 == 1 ? 0 : 0.125) : -0.25;
          fan.vertices.push_back({std::floor(r * c * 0x1p20) * 0x1p-20, std::floor(r * s * 0x1p20) * 0x1p-20, z});
        }
        for (Index k = 0; k < Index(n); ++k) {
          const Index here = 2 + k, next = 2 + (k + 1) % n;
          fan.add_polygon({0, here, next});
          fan.add_polygon({1, next, here});
        }
        all.emplace_back(shared(std::move(fan)));
      }
    return all;
  }();
  const int size = static_cast<int>(std::ranges::find(valences, valence) - valences.begin());
  const Shape& a = fans[random.bits() % 2 * valences.size() + size];
  const Shape& b = random.bits() % 4 == 0   ? fans[random.bits() % 2 * valences.size() + size]
                   : random.bits() % 2 == 0 ? any_convex(random)
                                            : any_pebble(random);
  const Exact_vector apex = a.vertex(0),
                     up = {Rational(integer(random, -1, 1)) / 16, Rational(integer(random, -1, 1)) / 16, 1};
  const bool on_apex = random.bits() % 8 != 0;
  const Pose turn = &b == &a ? scaling(1, -1, -1) : any_turn(random);
  const Touching contact{a.body, b.body,
                         resting(*b.body, turn, on_apex ? apex : a.vertex(2 + random.bits() % valence), up), up, false};
  return placed(random, contact, random.bits() % 2 == 0 ? Rational(0) : Rational(abs(any_gap(random))));
}

}  // namespace tetracone::verify::object_family
