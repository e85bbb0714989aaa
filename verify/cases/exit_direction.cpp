#include "verify/cases/exit_direction.h"

#include "verify/cases/exact_map.h"
#include "verify/cases/exact_motion.h"
#include "verify/cases/random.h"

namespace tetracone::verify {
namespace {

using covering::Index;
using object_family::Exact_vector;

Exact_vector any_direction(const Object_case& c, Random& random)
{
  const bool of_a = one_of(random, 2) == 0;
  const covering::Polyhedron& body = of_a ? *c.a : *c.b;
  const kernel::Pose& pose = of_a ? c.pose_a : c.pose_b;
  const auto vertex = [&](const covering::Polyhedron& in, Index v) { return object_family::exact(in.vertices[v]); };
  const auto any_loop = [&] { return body.loop(Index(one_of(random, body.face_count())), 0); };
  switch (c.origin.index % 5) {
    case 0: {
      Exact_vector axis = {0, 0, 0};
      axis[one_of(random, 3)] = of_a ? 1 : -1;
      return axis;
    }
    case 1: {
      Exact_vector steps;
      for (kernel::Rational& x : steps) x = int(one_of(random, 7)) - 3;
      return steps;
    }
    case 2: {
      const covering::Loop loop = any_loop();
      const auto edge = [&](std::size_t k) {
        const Exact_vector from = vertex(body, loop[0]);
        return object_family::turned(pose, object_family::difference(vertex(body, loop[k % loop.size()]), from));
      };
      return object_family::cross(edge(1), edge(2));
    }
    case 3: {
      const covering::Loop loop = any_loop();
      const Exact_vector along = object_family::difference(vertex(body, loop[1 % loop.size()]), vertex(body, loop[0]));
      return object_family::turned(pose, along);
    }
    default: {
      const auto any_of = [&](const covering::Polyhedron& in) {
        return vertex(in, Index(one_of(random, in.vertices.size())));
      };
      return object_family::difference(object_family::image(c.pose_a, any_of(*c.a)),
                                       object_family::image(c.pose_b, any_of(*c.b)));
    }
  }
}

}  // namespace

std::array<kernel::Rational, 3> exit_direction(const Object_case& c)
{
  if (c.exits) return c.exits->direction;
  Random random = random_of_case(c.origin.seed, c.origin.family, c.origin.index);
  const Exact_vector direction = any_direction(c, random);
  if (object_family::is_zero(direction)) return {0, 0, 1};
  return object_family::scaled_to_one(direction);
}

std::array<std::string, 3> as_texts(const std::array<kernel::Rational, 3>& direction)
{
  return {kernel::exact_text(direction[0]), kernel::exact_text(direction[1]), kernel::exact_text(direction[2])};
}

}  // namespace tetracone::verify
