#include "verify/cases/object_placing.h"
#include "verify/families/object_families.h"

#include "verify/cases/shape_generators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace tetracone::verify::object_family {
namespace {

using covering::Polyhedron;
using kernel::Vertex;

double nudged(double x, int ulps)
{
  for (; ulps > 0; --ulps) x = std::nextafter(x, HUGE_VAL);
  for (; ulps < 0; ++ulps) x = std::nextafter(x, -HUGE_VAL);
  return x;
}

/// The way from the middle of the vertices to a vertex: a plane normal to it through that vertex need not support the
/// body.
Exact_vector outward_at(const Polyhedron& body, const Exact_vector& point)
{
  const Exact_vector way = difference(point, exact(centroid(body)));
  return is_zero(way) ? Exact_vector{0, 0, 1} : way;
}

/// Vertex of B, or the middle of an edge of B, at a point of A's surface.
Touching at_point(Random& random, const Body& a, const Shape& b, const Exact_vector& point)
{
  const Exact_vector normal = outward_at(*a, point);
  if (random.bits() % 3 != 0) return {a, b.body, resting(*b.body, any_turn(random), point, normal), normal, false};
  const Pose turn = any_turn(random);
  const auto& edge = b.edges[random.bits() % b.edges.size()];
  const Exact_vector middle = times(Rational(1) / 2, sum(b.vertex(edge[0]), b.vertex(edge[1])));
  return {a, b.body, moved(turn, difference(point, image(turn, middle))), normal, false};
}

/// The same, often a hair off.
Object_case near_point(Random& random, const Body& a, const Shape& b, const Exact_vector& point)
{
  const Touching contact = at_point(random, a, b, point);
  return placed(random, contact, random.bits() % 2 == 0 ? Rational(abs(any_gap(random))) : any_gap(random));
}

Exact_vector middle(const Vertex& a, const Vertex& b) { return times(Rational(1) / 2, sum(exact(a), exact(b))); }

}  // namespace

/// A tetrahedron with an edge broken at its middle, h ulps off the edge, and the sliver between. B is at the break or h
/// ulps off it.
Object_case nearly_collinear(Random& random, double parameter)
{
  const int ulps = static_cast<int>(parameter);
  const auto coordinate = [&] { return 1 + random.unit(); };
  Vertex from = {coordinate(), coordinate(), coordinate()}, to = from;
  // An even distance: the middle is exact.
  for (int i = 0; i < 3; ++i) to[i] += std::ldexp(integer(random, -7, 7), -2);
  if (to == from) to[0] += 1;
  for (int i = 0; i < 3; ++i) {
    from[i] = std::floor(from[i] * 0x1p40) * 0x1p-40;
    to[i] = std::floor(to[i] * 0x1p40) * 0x1p-40;
  }
  Vertex broken = *exactly(middle(from, to));
  const int axis = integer(random, 0, 2);
  broken[axis] = nudged(broken[axis], random.bits() % 2 == 0 ? ulps : -ulps);
  Polyhedron body;
  body.vertices = {from,
                   to,
                   broken,
                   {coordinate() - 3, coordinate(), coordinate()},
                   {coordinate(), coordinate() - 3, coordinate() - 3}};
  body.add_polygon({0, 1, 3});
  body.add_polygon({1, 4, 3});
  body.add_polygon({4, 0, 3});
  body.add_polygon({0, 4, 2});
  body.add_polygon({2, 4, 1});
  body.add_polygon({0, 2, 1});
  const Body a = shared(std::move(body));
  const Shape& b = any_block(random);
  // At the broken corner, on the straight edge, or between them and beyond.
  const Exact_vector straight = middle(from, to), way = difference(exact(broken), straight);
  const Exact_vector point = sum(straight, Rational(std::array{1.0, 1.0, 0.0, 0.5, 2.0, -1.0}[random.bits() % 6]), way);
  const Touching contact = at_point(random, a, b, point);
  const Rational gap = random.bits() % 2 == 0 ? Rational(0) : Rational(abs(any_gap(random)));
  if (point == exact(broken)) return placed(random, contact, gap);
  return placed(random, a, b.body, moved(contact.relative, times(gap, scaled_to_one(contact.apart))),
                exact_motion(random));
}

/// Returns the polyhedron with one more loop of face `of`. The loop's vertices may come later.
Polyhedron with_loop(const Polyhedron& polyhedron, Index of, const std::vector<Index>& loop)
{
  Polyhedron result;
  result.vertices = polyhedron.vertices;
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    auto loops = face_loops(polyhedron, f);
    if (f == of) loops.push_back(loop);
    result.add_face(loops);
  }
  return result;
}

/// Blocks with a spur of no width, a lone point, a face with a repeated corner, or a loop of one point beside a face.
/// B is at that, or inside a block.
Object_case degenerate_face(Random& random, double parameter)
{
  const int kind = static_cast<int>(parameter);
  static const std::vector<std::pair<Body, std::array<Vertex, 2>>> spurred = [] {
    std::vector<std::pair<Body, std::array<Vertex, 2>>> all;
    for (int kind = 0; kind < 4; ++kind)
      for (const std::size_t block : {0, 2, 5, 7}) {
        Polyhedron body = *blocks()[block].body;
        const covering::Loop loop = body.loop(0, 0);
        const Index from = kind == 3 ? loop[0] : 1, to = body.vertices.size();
        const Vertex v = body.vertices[from], next = body.vertices[loop[1]];
        Vertex tip = {v[0] + 0.5, v[1] - 0.25, v[2] + 0.25};
        if (kind == 3)  // on the line of an edge, so in the face's plane
          for (int k = 0; k < 3; ++k) tip[k] = 2 * v[k] - next[k];
        if (kind == 3) body = with_loop(body, 0, {to, to, to});
        body.vertices.push_back(tip);
        if (kind == 0) body.add_polygon({from, to});
        if (kind == 1) body.add_polygon({to});
        if (kind == 2) body.add_polygon({from, from, to});
        all.push_back({shared(std::move(body)), {kind % 2 == 1 ? tip : v, tip}});
      }
    return all;
  }();
  const auto& [a, ends] = spurred[4 * kind + random.bits() % 4];
  const Exact_vector along = difference(exact(ends[1]), exact(ends[0]));
  const Shape& b = any_block(random);
  const Exact_vector point = sum(exact(ends[0]), Rational(random.bits() % 2 == 0 ? 1.0 : dyadic(random, 3)), along);
  if (random.bits() % 5 == 0) {
    // The spur's end, or the point, in the middle of B.
    const Pose turn = any_turn(random);
    const Rational far = Rational(integer(random, 0, 3)) / 4;
    return placed(
        random, a, b.body,
        moved(turn, sum(difference(point, image(turn, exact(centroid(*b.body)))), far, exact(b.body->vertices[0]))),
        exact_motion(random));
  }
  return near_point(random, a, b, point);
}

/// Zero-length edges, membranes, edges of four and six faces; B is there.
Object_case duplicates(Random& random, double parameter)
{
  const int kind = static_cast<int>(parameter);
  static const std::array<std::pair<Body, std::vector<Exact_vector>>, 4> doubled = [] {
    std::array<std::pair<Body, std::vector<Exact_vector>>, 4> all;
    Polyhedron split;  // a cube whose corner 0 is two corners, joined by an edge of no length
    for (int k = 0; k < 8; ++k) split.vertices.push_back({double(k & 1), double(k >> 1 & 1), double(k >> 2 & 1)});
    split.vertices.push_back({0, 0, 0});
    for (const auto& face :
         {std::vector<Index>{0, 8, 4, 6, 2}, {1, 3, 7, 5}, {8, 0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}})
      split.add_polygon(face);
    append(split, *blocks()[2].body);  // and a second shell on the same corners
    all[0] = {shared(split), {exact({0, 0, 0}), exact({1, 0, 0}), exact({0, 0, 1})}};
    Polyhedron membrane = *blocks()[0].body;  // a face three times, and an inner one twice
    const std::vector<Index> top(membrane.loop(0, 0).begin(), membrane.loop(0, 0).end()),
        turned(top.rbegin(), top.rend());
    membrane.add_polygon(top);
    membrane.add_polygon(turned);
    membrane.add_polygon({0, 2, 6});
    membrane.add_polygon({6, 2, 0});
    all[1] = {shared(membrane),
              {exact(membrane.vertices[top[0]]), middle(membrane.vertices[top[0]], membrane.vertices[top[2]]),
               middle(membrane.vertices[0], membrane.vertices[6])}};
    for (const int wedges : {2, 3}) {  // about the edge from (0, 0, 0) to (0, 0, 1)
      Polyhedron fan;
      fan.vertices = {{0, 0, 0}, {0, 0, 1}};
      const std::array<std::array<double, 2>, 6> rays = {
          {{1, 0}, {1, 0.5}, {-0.5, 1}, {-1, 0.5}, {-0.5, -1}, {0.5, -1}}};
      for (int w = 0; w < wedges; ++w) {
        const auto& [x, y] = rays[2 * w];
        const auto& [u, v] = rays[2 * w + 1];
        const Index p = fan.vertices.size();
        for (const double z : {0.0, 1.0}) {
          fan.vertices.push_back({x, y, z});
          fan.vertices.push_back({u, v, z});
        }
        fan.add_polygon({0, p + 1, p});
        fan.add_polygon({1, p + 2, p + 3});
        fan.add_polygon({0, p, p + 2, 1});
        fan.add_polygon({p, p + 1, p + 3, p + 2});
        fan.add_polygon({p + 1, 0, 1, p + 3});
      }
      all[wedges] = {shared(fan), {exact({0, 0, 0}), exact({0, 0, 0.25}), exact({0, 0, 1})}};
    }
    return all;
  }();
  const auto& [a, points] = doubled[kind];
  const Exact_vector& point = points[random.bits() % points.size()];
  return near_point(random, a, any_block(random), point);
}

/// A block of quadrangles whose top is h ulps off its plane, as triangles; B stands on it, or on the plane.
Object_case non_planar_quads(Random& random, double parameter)
{
  const int ulps = static_cast<int>(parameter);
  const double height = 1 + random.unit(), wide = 1 + dyadic(random, 6), deep = 1 + dyadic(random, 6);
  Polyhedron body = box({0, 0, 0}, {wide, deep, height}), triangulated;
  std::vector<Index> top;
  for (Index v = 0; v < body.vertices.size(); ++v)
    if (body.vertices[v][2] == height) top.push_back(v);
  for (const Index v : top)
    if (random.bits() % 2 == 0) body.vertices[v][2] = nudged(height, random.bits() % 2 == 0 ? ulps : -ulps);
  triangulated.vertices = body.vertices;
  for (Index f = 0; f < body.face_count(); ++f) {
    // One diagonal or the other.
    const covering::Loop loop = body.loop(f, 0);
    const Index k = random.bits() % 2;
    triangulated.add_polygon({loop[k], loop[k + 1], loop[k + 2]});
    triangulated.add_polygon({loop[k], loop[k + 2], loop[(k + 3) % 4]});
  }
  const Shape& b = any_block(random);
  const Exact_vector point = {Rational(wide * dyadic(random, 4)), Rational(deep * dyadic(random, 4)),
                              Rational(nudged(height, random.bits() % 2 == 0 ? 0 : integer(random, -ulps, ulps)))};
  const Pose turn = random.bits() % 3 == 0 ? rational_rotation(random, 4) : signed_permutation(integer(random, 0, 23));
  const Exact_vector up = {0, 0, 1};
  Pose relative = resting(*b.body, turn, point, up);
  if (random.bits() % 3 == 0) relative = moved(relative, {0, 0, power_of_two(-integer(random, 40, 52))});
  return placed(random, shared(std::move(triangulated)), b.body, relative, exact_motion(random));
}

/// A block with an edge split at j / 2^k on one side, a face of no width between; B is at the split.
Object_case t_junctions(Random& random, double parameter)
{
  const double at = dyadic(random, static_cast<int>(parameter));
  // An axis-parallel edge between 0 and 1: every dyadic share of it is exact.
  const Shape& whole = blocks()[random.bits() % 2 == 0 ? unit_cube_block : tetrahedron_block];
  const auto& vertices = whole.body->vertices;
  std::vector<std::array<Index, 2>> edges;
  for (const auto& edge : whole.edges) {
    const Exact_vector along = difference(whole.vertex(edge[1]), whole.vertex(edge[0]));
    if (std::ranges::count(along, Rational(0)) == 2) edges.push_back(edge);
  }
  const auto [from, to] = edges[random.bits() % edges.size()];
  const Vertex& u = vertices[from];
  const Vertex& v = vertices[to];
  Polyhedron body;
  body.vertices = vertices;
  const Index split = body.vertices.size();
  Vertex p;
  for (int i = 0; i < 3; ++i) p[i] = u[i] + at * (v[i] - u[i]);
  body.vertices.push_back(p);
  bool done = false;
  for (Index f = 0; f < whole.body->face_count(); ++f) {
    std::vector<Index> loop(whole.body->loop(f, 0).begin(), whole.body->loop(f, 0).end());
    for (std::size_t k = 0; k < loop.size() && !done; ++k) {
      const Index a = loop[k], b = loop[(k + 1) % loop.size()];
      if (!(a == from && b == to) && !(a == to && b == from)) continue;
      done = true;
      loop.insert(loop.begin() + k + 1, split);
      body.add_polygon({a, b, split});  // what is left of the undivided side
    }
    body.add_polygon(loop);
  }
  return near_point(random, shared(std::move(body)), any_block(random), exact(p));
}

}  // namespace tetracone::verify::object_family
