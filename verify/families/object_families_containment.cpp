#include "verify/cases/object_placing.h"
#include "verify/cases/shape_generators.h"
#include "verify/families/object_families.h"

#include "tetracone/kernel/bound/cone_lattice.h"

#include <array>
#include <utility>
#include <vector>

namespace tetracone::verify::object_family {
namespace {

/// A turn that leaves a vertex, an edge or a face of a box lowest along any axis.
Pose turn_of_dimension(Random& random, int dimension)
{
  if (dimension == 0) return composed(Pose::from_quaternion(3, 1, -1, 1), signed_permutation(integer(random, 0, 23)));
  const Pose axes = signed_permutation(integer(random, 0, 23));
  // About an axis by the angle of cosine 3/5: an edge is lowest along the other two.
  return dimension == 2 ? axes : composed(Pose::from_quaternion(2, 1, 0, 0), axes);
}

/// An inner point of a triangle, away from its border.
Exact_vector point_within(Random& random, const Shape& shape, const Face_triangle& triangle)
{
  const double s = 0.29 + 0.06 * random.unit(), t = 0.29 + 0.06 * random.unit();
  return point_on(shape, triangle, s, t);
}

std::vector<const Shape*> wholes()
{
  std::vector<const Shape*> result;
  for (const std::size_t k : {0, 1, 2, 3, 5, 6, 8, 9}) result.push_back(&blocks()[k]);
  return result;
}

/// B is on the inner side of a hull face of A, a pebble at the face's inside.
Touching from_inside(Random& random, int dimension)
{
  static const std::vector<const Shape*> outer = wholes();
  const Shape& a = *outer[random.bits() % outer.size()];
  const Shape& b = pebbles()[dimension == 0 ? random.bits() % pebbles().size() : random.bits() % 2 * 3];
  const Face_triangle& triangle = a.triangles[a.hull[random.bits() % a.hull.size()]];
  const Exact_vector inward = times(Rational(-1), a.normals[triangle.face]);
  const Pose turn = turn_of_dimension(random, dimension);
  return {a.body, b.body, resting(*b.body, turn, point_within(random, a, triangle), inward), inward, false};
}

/// A pebble in a cube, under the middle of a face, far from the other faces.
Touching box_in_box(Random& random)
{
  const Shape& a = blocks()[unit_cube_block];
  const Shape& b = any_pebble(random);
  const Face_triangle& triangle = a.triangles[random.bits() % a.triangles.size()];
  const Exact_vector inward = times(Rational(-1), a.normals[triangle.face]);
  const Pose turn = any_turn(random);
  return {a.body, b.body, resting(*b.body, turn, point_within(random, a, triangle), inward), inward, false};
}

Exact_vector halfway(const Exact_vector& a, const Exact_vector& b, const Rational& share)
{
  return sum(a, share, difference(b, a));
}

/// A pebble's tiny copy with its first vertex at a point of A's frame.
Object_case speck_at(Random& random, const Body& a, const Exact_vector& point)
{
  const Shape& pebble = any_pebble(random);
  const Body b = moved_copy(pebble, -integer(random, 0, 1) * 4 - 2);
  const Pose turn = random.bits() % 2 == 0 ? Pose() : signed_permutation(integer(random, 0, 23));
  return placed(random, a, b, moved(turn, difference(point, image(turn, exact(b->vertices[0])))), exact_motion(random));
}

}  // namespace

Object_case nested_touching(Random& random, double parameter)
{
  const Touching contact = from_inside(random, static_cast<int>(parameter));
  return placed(random, contact, random.bits() % 4 == 0 ? Rational(abs(any_gap(random))) : any_gap(random));
}

/// Inside a box, or a cavity's wall between them: a solid, and one that is no part of it.
Object_case nested(Random& random, double parameter)
{
  if (random.bits() % 3 != 0) {
    const Touching contact = box_in_box(random);
    // A unit of the gap is half of the axis-parallel normal's.
    const Object_case c = placed(random, contact, Rational(2 * parameter));
    return with_answer(c, false, true);
  }
  // A cube in the cavity of half width 1/2, nearest to the walls of one corner.
  const double half = 0.5 - 1.5 * parameter, offset = parameter / 2;
  const Body inner = shared(box({-half, -half, -half}, {half, half, half}));
  const Pose relative = Pose::translation(offset, offset, 0);
  return with_answer(placed(random, blocks()[cavity_block].body, inner, relative, exact_motion(random)), false);
}

/// A pebble at an inner wall of A.
Object_case cavity_wall(Random& random, double parameter)
{
  const int genus = static_cast<int>(parameter);
  const Shape& a = blocks()[genus == 0 ? cavity_block : genus == 1 ? tunnel_block : complex_block];
  const Shape& b = any_pebble(random);
  const Face_triangle& triangle = a.triangles[a.inner[random.bits() % a.inner.size()]];
  const Exact_vector& normal = a.normals[triangle.face];
  const Pose turn = turn_of_dimension(random, integer(random, 0, 2));
  const Touching contact{a.body, b.body, resting(*b.body, turn, point_within(random, a, triangle), normal), normal,
                         false};
  return placed(random, contact);
}

/// A vertex of a speck at a facet O-edge, an edge O-vertex or the apex O of A's covering; some of those are outside A.
Object_case covering_elements(Random& random, double parameter)
{
  const Shape& a = any_shape(random);
  const Exact_vector apex = exact(kernel::cone_lattice(a.body->vertices).origin);
  const auto& edge = a.edges[random.bits() % a.edges.size()];
  // To the surface itself now and then, and beyond it.
  const Rational share = random.bits() % 4 == 0 ? Rational(1) : Rational(integer(random, 1, 19)) / 16;
  const Exact_vector from = a.vertex(edge[0]), to = a.vertex(edge[1]);
  if (parameter == 0)
    return speck_at(random, a.body, halfway(apex, halfway(from, to, Rational(dyadic(random, 4))), share));
  if (parameter == 1) return speck_at(random, a.body, halfway(apex, from, share));
  // At the apex itself: with bodies that have it inside, outside and, on small ones, near the surface.
  return random.bits() % 4 == 0 ? speck_at(random, a.body, from) : speck_at(random, a.body, apex);
}

/// A symmetric body whose centroid, the apex of its covering, is on a face's plane, an edge's line or a vertex. Specks
/// lie all about.
Object_case covering_apex(Random& random, double parameter)
{
  const int kind = static_cast<int>(parameter);
  // Two tetrahedra, opposite about 0: 0 is the centroid of their vertices, and where they meet; or of four of them, two
  // on an edge.
  const auto spike = [&](const std::array<Exact_vector, 4>& corners, covering::Polyhedron& body) {
    std::array<kernel::Vertex, 4> v;
    for (int i = 0; i < 4; ++i) v[i] = *exactly(corners[i]);
    append(body, *tetrahedron(v));
  };
  covering::Polyhedron body;
  Exact_vector p = integer_direction(random, 4), q = integer_direction(random, 4), r = integer_direction(random, 4);
  while (dot(p, cross(q, r)) == 0) {
    p = integer_direction(random, 4);
    q = integer_direction(random, 4);
    r = integer_direction(random, 4);
  }
  const Exact_vector zero = {0, 0, 0};
  for (const int side : {1, -1}) {
    const auto at = [side](const Exact_vector& v) { return times(Rational(side), v); };
    // A vertex at 0; an edge through 0; a face's plane through 0, the face beside it.
    if (kind == 2) spike({zero, at(p), at(q), at(r)}, body);
    if (kind == 1) spike({at(p), at(times(Rational(2), p)), at(sum(p, q)), at(sum(p, r))}, body);
    if (kind == 0) spike({at(p), at(q), at(sum(times(Rational(2), p), q)), at(sum(p, r))}, body);
  }
  const Body a = shared(std::move(body));
  // Around a tetrahedron's inside, on the flat element itself, and elsewhere.
  const Exact_vector inside = times(Rational(1) / 4, sum(sum(exact(a->vertices[0]), exact(a->vertices[1])),
                                                         sum(exact(a->vertices[2]), exact(a->vertices[3]))));
  const Exact_vector one = exact(a->vertices[random.bits() % 4]), other = exact(a->vertices[random.bits() % 4]);
  switch (random.bits() % 4) {
    case 0: return speck_at(random, a, inside);
    case 1: return speck_at(random, a, halfway(one, other, Rational(integer(random, 0, 8)) / 8));
    case 2: return speck_at(random, a, halfway(inside, one, Rational(integer(random, 0, 12)) / 8));
    default: return speck_at(random, a, halfway(zero, one, Rational(integer(random, -8, 12)) / 8));
  }
}

/// A speck at a point from which a line along an axis runs through vertices of A, along or through edges, or in faces'
/// planes.
Object_case winding_axis(Random& random, double parameter)
{
  const Shape& a = any_block(random);
  const auto vertex = [&] { return a.vertex(random.bits() % a.body->vertices.size()); };
  Exact_vector point = vertex();
  const int axis = integer(random, 0, 2), next = (axis + 1) % 3;
  const Exact_vector other = vertex();
  if (parameter == 1) {
    const auto& edge = a.edges[random.bits() % a.edges.size()];
    point = halfway(a.vertex(edge[0]), a.vertex(edge[1]), Rational(dyadic(random, 3)));
  }
  if (parameter == 2) point[next] = halfway(point, other, Rational(dyadic(random, 3)))[next];
  // Along the axis: anywhere from a vertex to another one.
  const Exact_vector third = vertex();
  point[axis] = halfway(third, other, Rational(integer(random, -2, 10)) / 8)[axis];
  return speck_at(random, a.body, point);
}

namespace {

/// Unit cells of a grid, doubled: cell x covers [2 x, 2 x + 2] in each coordinate.
struct Cells {
  int n;
  std::vector<bool> full;

  bool operator()(int x, int y, int z) const
  {
    const auto in = [this](int c) { return 0 <= c && c < n; };
    return in(x) && in(y) && in(z) && full[x + n * (y + n * z)];
  }

  /// How many of the cells about a point of the doubled grid there are, and how many of them are full.
  std::pair<int, int> about(const std::array<int, 3>& p) const
  {
    std::pair<int, int> count{0, 0};
    for (int x = (p[0] - 1) >> 1; x <= p[0] >> 1; ++x)
      for (int y = (p[1] - 1) >> 1; y <= p[1] >> 1; ++y)
        for (int z = (p[2] - 1) >> 1; z <= p[2] >> 1; ++z) {
          ++count.first;
          count.second += (*this)(x, y, z);
        }
    return count;
  }
};

Cells random_cells(Random& random, int n)
{
  Cells cells{n, std::vector<bool>(n * n * n)};
  const double share = n <= 2 ? 0.6 : 0.25;
  for (std::size_t k = 0; k < cells.full.size(); ++k) cells.full[k] = random.unit() < share;
  cells.full[random.bits() % cells.full.size()] = true;
  return cells;
}

/// A full cube of cells, or its outermost layer.
Cells massive_cells(int n, bool hollow)
{
  Cells cells{n, std::vector<bool>(n * n * n, true)};
  for (int x = 1; x + 1 < n; ++x)
    for (int y = 1; y + 1 < n; ++y)
      for (int z = 1; z + 1 < n; ++z) cells.full[x + n * (y + n * z)] = !hollow;
  return cells;
}

}  // namespace

/// B's grid is off A's by half units. Two boxes of such grids that meet do so in a corner of one of them or of their
/// common part. That is a point of the doubled grid. So its points decide: in both solids, on both surfaces.
Object_case voxels(Random& random, double parameter)
{
  const int n = static_cast<int>(parameter);
  Cells a = random_cells(random, n), b = random_cells(random, n);
  std::array<int, 3> offset;
  for (int& x : offset) x = integer(random, -2 * n, 2 * n);
  if (n > 2 && random.bits() % 3 == 0) {
    // A single cell about the middle of a solid or hollow cube.
    a = massive_cells(n, random.bits() % 2 == 0);
    b = {1, {true}};
    for (int& x : offset) x = integer(random, 1, 2 * n - 3);
  }
  if (random.bits() % 2 == 0)
    for (int& x : offset) x &= ~1;
  bool surface = false, solid = false;
  for (int x = 0; x <= 2 * n; ++x)
    for (int y = 0; y <= 2 * n; ++y)
      for (int z = 0; z <= 2 * n; ++z) {
        const auto [all_a, in_a] = a.about({x, y, z});
        const auto [all_b, in_b] = b.about({x - offset[0], y - offset[1], z - offset[2]});
        solid = solid || (in_a > 0 && in_b > 0);
        surface = surface || (in_a > 0 && in_a < all_a && in_b > 0 && in_b < all_b);
      }
  const Pose relative = Pose::translation(offset[0] / 2.0, offset[1] / 2.0, offset[2] / 2.0);
  const Body body_a = shared(voxel_solid(a.full, a.n, a.n, a.n)), body_b = shared(voxel_solid(b.full, b.n, b.n, b.n));
  return with_answer(placed(random, body_a, body_b, relative, exact_motion(random)), surface, solid);
}

}  // namespace tetracone::verify::object_family
