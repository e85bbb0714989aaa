#include "verify/cases/object_placing.h"
#include "verify/cases/shape_generators.h"
#include "verify/families/object_families.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <mutex>
#include <utility>

namespace tetracone::verify::object_family {
namespace {

constexpr int star_shaped = 3, kinds = 4;  // kinds 0 to 2: star-shaped about 0; 3: a knot
constexpr std::size_t most_in_both = 5000;

/// The mesh of about that many triangles, about 2 large, made once.
const Body& mesh(std::size_t triangles, int kind)
{
  static std::mutex mutex;
  static std::map<std::pair<std::size_t, int>, Body> made;
  const std::lock_guard lock(mutex);
  Body& body = made[{triangles, kind}];
  if (!body) body = shared(kind < star_shaped ? blob(triangles, 40 + kind) : round_torus_knot(triangles));
  return body;
}

/// The second body: as large as the first one, or of 1000 triangles, which all beside the largest are.
const Body& other_mesh(Random& random, std::size_t triangles)
{
  const int kind = integer(random, 0, kinds - 1);
  return mesh(random.bits() % 2 == 0 && triangles <= most_in_both ? triangles : 1000, kind);
}

/// A body of the size of one triangle of A, its lowest vertex on the inside of that triangle. The truth finds what else
/// they share there. Only a few elements of either decide.
Object_case on_one_triangle(Random& random, const Body& a, const Body& b)
{
  const Index f = Index(random.bits() % a->face_count());
  const covering::Loop corners = a->loop(f, 0);
  const auto corner = [&](int k) { return exact(a->vertices[corners[k]]); };
  const Exact_vector u = difference(corner(1), corner(0)), v = difference(corner(2), corner(0));
  const double s = dyadic(random, 4) / 2, t = dyadic(random, 4) / 2;
  const Exact_vector at = sum(sum(corner(0), Rational(s), u), Rational(t), v);
  const int exponent = std::ilogb(dot(u, u).get_d()) / 2 - integer(random, 2, 4);
  const Pose turn = any_turn(random);
  const Exact_vector normal = cross(u, v);
  const Pose small = composed(turn, scaling(std::ldexp(1.0, exponent)));
  const Touching contact{a, b, resting(*b, small, at, normal), normal, false};
  // Touching, well into that triangle, or a hair off it; a gap counts in parts of the small body.
  const std::uint64_t way = random.bits() % 4;
  const int part = way == 2 ? integer(random, 3, 6) : integer(random, 10, 50);
  const Rational gap = way < 2 ? Rational(0) : Rational((way == 2 ? -1 : 1) * power_of_two(exponent - part));
  return placed(random, contact, gap);
}

/// A star-shaped body shrunk about 0: strictly inside itself.
Object_case in_itself(Random& random, const Body& a, const Body& b, double scale)
{
  const Object_case c = placed(random, a, b, scaling(scale), exact_motion(random));
  return with_answer(c, false, true);
}

}  // namespace

/// Mostly the bodies meet on the inside of one triangle, where an answer hangs on one leaf. Else they meet in extreme
/// vertices, or one is inside the other, far or so near that a descent ends in most leaves.
Object_case many_faces(Random& random, double parameter)
{
  const auto triangles = static_cast<std::size_t>(parameter);
  const std::uint64_t draw = random.bits() % 8;
  if (draw == 0) {
    const Body& a = mesh(triangles, integer(random, 0, kinds - 1));
    const Body& b = other_mesh(random, triangles);
    const Pose turn = any_turn(random);
    return placed(random, object_family::vertex_on_vertex(random, a, b, turn));
  }
  if (draw < 7) {
    const Body& a = mesh(triangles, integer(random, 0, kinds - 1));
    return on_one_triangle(random, a, random.bits() % 2 == 0 ? mesh(1000, 0) : blocks()[tetrahedron_block].body);
  }
  const Body& a = mesh(triangles, integer(random, 0, star_shaped - 1));
  if (random.bits() % 2 == 0 || triangles > 2000) {
    // Radii are from 1/2 to 3/2.
    const Body& b = other_mesh(random, triangles);
    return in_itself(random, a, b, 0.25);
  }
  return in_itself(random, a, a, 1 - 0x1p-5);
}

}  // namespace tetracone::verify::object_family
