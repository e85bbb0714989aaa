#include "verify/families/distance_families.h"

#include "verify/cases/object_placing.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tetracone::verify {
namespace object_family {
namespace {

Object_case apart_from_face(Random& random, double exponent)
{
  const Shape& a = any_shape(random);
  const Body& b = any_shape(random).body;
  const Pose turn = any_turn(random);
  const int bits = integer(random, 1, 20);
  const Touching contact = vertex_on_face(random, a, b, turn, bits);
  return placed(random, contact, power_of_two(int(exponent)));
}

Object_case apart_from_edge(Random& random, double exponent)
{
  const Shape& a = with_hull_edges(random);
  const Body& b = any_shape(random).body;
  const Pose turn = any_turn(random);
  const Touching contact = vertex_on_edge(random, a, b, turn, 3);
  return placed(random, contact, power_of_two(int(exponent)));
}

Object_case apart_from_vertex(Random& random, double exponent)
{
  const Body& a = any_shape(random).body;
  const Body& b = any_shape(random).body;
  const Pose turn = any_turn(random);
  const Touching contact = vertex_on_vertex(random, a, b, turn);
  return placed(random, contact, power_of_two(int(exponent)));
}

Object_case apart_across_edges(Random& random, double exponent)
{
  const Shape& a = with_hull_edges(random);
  const Shape& b = any_block(random);
  const Pose turn = any_turn(random);
  const Touching contact = edge_across_edge(random, a, b, turn, 4);
  return placed(random, contact, power_of_two(int(exponent)));
}

/// Cubes with parallel faces and edges. The nearest points are all points of two faces, of two edges, or two vertices.
Object_case parallel(Random& random, double which)
{
  const Shape& cube = blocks()[unit_cube_block];
  const Rational gap = power_of_two(-integer(random, 0, 12)), beside = Rational(integer(random, -4, 4)) / 4;
  Exact_vector shift = {1 + gap, beside, beside};
  if (which >= 1) shift[1] = 1 + gap * (which == 3 ? 2 : 1);
  if (which == 2) shift[2] = 1 + gap;
  return placed(random, cube.body, cube.body, moved(Pose(), shift), exact_motion(random));
}

/// A body and its mirror image beyond a plane: every point of the body nearest to the plane has the least distance.
Object_case mirrored(Random& random, double exponent)
{
  const Shape& a = any_shape(random);
  double high = a.body->vertices[0][0];
  for (const kernel::Vertex& v : a.body->vertices) high = std::max(high, v[0]);
  const Exact_vector shift = {2 * Rational(high) + power_of_two(int(exponent)), 0, 0};
  return placed(random, a.body, a.body, moved(scaling(-1, 1, 1), shift), exact_motion(random));
}

/// Two spikes over a face, one higher than the other by 2^-k.
Object_case two_spikes(Random& random, double k)
{
  const auto spike = [&](covering::Polyhedron& to, double x, double y, double height) {
    const Index first = Index(to.vertices.size());
    to.vertices.insert(to.vertices.end(),
                       {{x, y, height}, {x - 0.125, y, 2}, {x + 0.125, y - 0.125, 2}, {x, y + 0.125, 2}});
    for (const auto& f : {std::array<Index, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
      to.add_polygon({first + f[0], first + f[1], first + f[2]});
  };
  covering::Polyhedron spikes;
  const double low = 1 + std::ldexp(1.0, -integer(random, 1, 10));
  spike(spikes, 0.25, 0.25, low);
  spike(spikes, 0.75, dyadic(random, 4), k == 0 ? low : low + std::ldexp(1.0, -int(k)));
  return placed(random, blocks()[unit_cube_block].body, shared(std::move(spikes)), Pose(), exact_motion(random));
}

Object_case of_any_size(Random& random, double exponent)
{
  const Pose turn = any_turn(random);
  const Touching contact = any_contact(random, turn);
  const Rational gap = power_of_two(-integer(random, 0, 30));
  return placed(random, contact, gap, scaling(std::ldexp(1.0, int(exponent))));
}

Object_case far(Random& random, double exponent)
{
  const Pose turn = any_turn(random);
  const Touching contact = any_contact(random, turn);
  return placed(random, contact, power_of_two(int(exponent)));
}

/// A body in a cavity, off its middle by 2^-k of its size: opposite walls are nearly equally near.
Object_case between_walls(Random& random, double k)
{
  const Shape& outer = blocks()[cavity_block];
  const Body& inner = any_pebble(random).body;
  const Pose turn = any_turn(random);
  const auto middle = [](const covering::Polyhedron& body, const Pose& pose) {
    Exact_vector low = image(pose, exact(body.vertices[0])), high = low;
    for (const kernel::Vertex& v : body.vertices) {
      const Exact_vector p = image(pose, exact(v));
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    }
    return times(Rational(1) / 2, sum(low, high));
  };
  Exact_vector shift = difference(middle(*outer.body, Pose()), middle(*inner, turn));
  if (k > 0) shift[std::size_t(integer(random, 0, 2))] += power_of_two(-int(k) - 4);
  return placed(random, outer.body, inner, moved(turn, shift), exact_motion(random));
}

}  // namespace
}  // namespace object_family

const std::vector<Family>& distance_families()
{
  using namespace object_family;
  // Numbers start where these families were first numbered, so that families of pairs may still be added.
  static const std::vector<Family> all = numbered(
      std::vector<Family>{
          {{"apart-from-face", "a vertex over a face", "distance 2^e: e", {0, -4, -20, -50, 4}},
           nullptr,
           apart_from_face},
          {{"apart-from-edge", "a vertex over an edge", "distance 2^e: e", {0, -4, -20, -50, 4}},
           nullptr,
           apart_from_edge},
          {{"apart-from-vertex", "vertices against each other", "distance 2^e: e", {0, -4, -20, -50, 4}},
           nullptr,
           apart_from_vertex},
          {{"apart-across-edges", "edges that cross", "distance 2^e: e", {0, -4, -20, -50, 4}},
           nullptr,
           apart_across_edges},
          {{"parallel",
            "cubes with parallel faces and edges",
            "nearest: 0 faces, 1 edges, 2 vertices, 3 edges aslant",
            {0, 1, 2, 3}},
           nullptr,
           parallel},
          {{"mirrored", "a body and its mirror image", "distance 2^e: e", {1, 0, -10, -40}}, nullptr, mirrored},
          {{"two-spikes",
            "two spikes over a face, nearly as near",
            "nearer by 2^-k: k; 0: as near",
            {1, 10, 30, 50, 52, 0}},
           nullptr,
           two_spikes},
          {{"of-any-size", "all times a power of two", "its exponent", {-1000, -540, -300, 300, 500, 900}},
           nullptr,
           of_any_size},
          {{"far-apart", "bodies far apart", "distance 2^e: e", {10, 40, 100, 400, 900}}, nullptr, far},
          {{"between-walls", "in a cavity, nearly in its middle", "off by 2^-k of its size: k; 0: not", {0, 3, 20, 45}},
           nullptr,
           between_walls},
      },
      50);
  return all;
}

}  // namespace tetracone::verify
