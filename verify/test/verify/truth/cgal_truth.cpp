#include "verify/truth/cgal_truth.h"

#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <map>

BOOST_AUTO_TEST_SUITE(test_cgal_truth)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;

namespace {

/// The possible positions of a pair: it is apart, only the solids meet (one is in the other), or the surfaces meet.
enum class Meet { apart, nested, surface };

std::ostream& operator<<(std::ostream& out, Meet meet)
{
  return out << (meet == Meet::apart ? "apart" : meet == Meet::nested ? "nested" : "surface");
}

Meet meet(const Polyhedron& a, const Polyhedron& b)
{
  const Brute_body body_a(a), body_b(b);
  const Placed_body placed_a(body_a, Pose()), placed_b(body_b, Pose());
  const bool solid = collide(placed_a, placed_b, Question::solid),
             surface = collide(placed_a, placed_b, Question::surface);
  BOOST_TEST((solid || !surface));
  BOOST_TEST(surface == !features(placed_a, placed_b).empty());
  return surface ? Meet::surface : solid ? Meet::nested : Meet::apart;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_open_surface_has_no_solid)
{
  Polyhedron open;
  open.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  open.add_polygon({0, 1, 2});
  const Brute_body triangle(open), solid(cube(2));
  BOOST_CHECK_THROW(collide(triangle, Pose(), solid, Pose()), std::invalid_argument);
  BOOST_CHECK_THROW(collide(solid, Pose(), triangle, Pose()), std::invalid_argument);
  BOOST_CHECK_THROW(inside(triangle, {0, 0, 1}), std::invalid_argument);
  BOOST_TEST(!collide(triangle, Pose(), solid, Pose(), Question::surface));
  BOOST_TEST(collide(triangle, translation(1.5, 0, 0), solid, Pose(), Question::surface));
}

namespace {

using Corner = std::array<long, 3>;
using Tetrahedron = std::array<Corner, 4>;

Corner minus(const Corner& a, const Corner& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Corner outer(const Corner& a, const Corner& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
long inner(const Corner& a, const Corner& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
long determinant(const Tetrahedron& t) { return inner(minus(t[1], t[0]), outer(minus(t[2], t[0]), minus(t[3], t[0]))); }

/// Closed, by separating axes: normals of faces, products of edges.
bool tetrahedra_meet(const Tetrahedron& a, const Tetrahedron& b)
{
  const auto separates = [&](const Corner& axis) {
    long low_a = inner(axis, a[0]), high_a = low_a, low_b = inner(axis, b[0]), high_b = low_b;
    for (int i = 1; i < 4; ++i) {
      low_a = std::min(low_a, inner(axis, a[i]));
      high_a = std::max(high_a, inner(axis, a[i]));
      low_b = std::min(low_b, inner(axis, b[i]));
      high_b = std::max(high_b, inner(axis, b[i]));
    }
    return high_a < low_b || high_b < low_a;
  };
  for (const Tetrahedron& t : {a, b})
    for (int i = 0; i < 4; ++i)
      if (separates(outer(minus(t[(i + 1) % 4], t[i]), minus(t[(i + 2) % 4], t[i])))) return false;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      for (int k = 0; k < 4; ++k)
        for (int l = 0; l < k; ++l)
          if (separates(outer(minus(a[i], a[j]), minus(b[k], b[l])))) return false;
  return true;
}

/// Strictly inside, all of it.
bool is_inside(const Tetrahedron& inner, const Tetrahedron& outer)
{
  for (const Corner& p : inner)
    for (int i = 0; i < 4; ++i) {
      Tetrahedron part = outer;
      part[i] = p;
      if ((determinant(part) > 0) != (determinant(outer) > 0) || determinant(part) == 0) return false;
    }
  return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(small_tetrahedra_agree_with_separating_axes_in_whole_numbers)
{
  Random random(9);
  std::map<Meet, int> seen;
  for (int round = 0; round < 4000; ++round) {
    Tetrahedron a, b;
    for (auto [t, radius] : {std::pair{&a, round % 2 ? 6 : 2}, {&b, round % 2 ? 1 : 2}}) do
        for (Corner& p : *t)
          p = {integer(random, -radius, radius), integer(random, -radius, radius), integer(random, -radius, radius)};
      while (determinant(*t) == 0);
    const Meet expected = !tetrahedra_meet(a, b)               ? Meet::apart
                          : is_inside(a, b) || is_inside(b, a) ? Meet::nested
                                                               : Meet::surface;
    ++seen[expected];
    const auto body = [](const Tetrahedron& t) {
      const auto vertex = [&](int i) { return Vertex{double(t[i][0]), double(t[i][1]), double(t[i][2])}; };
      return tetrahedron(vertex(0), vertex(1), vertex(2), vertex(3));
    };
    BOOST_TEST_INFO_SCOPE("round " << round);
    BOOST_TEST(meet(body(a), body(b)) == expected);
  }
  for (const Meet kind : {Meet::apart, Meet::nested, Meet::surface})
    BOOST_TEST(seen[kind] > 20, kind << " came too seldom");
}

BOOST_AUTO_TEST_CASE(points_are_inside_on_or_outside_voxels_as_their_cells_say)
{
  Random random(12);
  for (int round = 0; round < 6; ++round) {
    const int n = 2 + round % 2;
    const Voxels voxels(random, n);
    const Brute_body body(round % 3 == 2 ? turned(voxels.solid()) : voxels.solid());
    for (int x = 0; x <= 2 * n; ++x)
      for (int y = 0; y <= 2 * n; ++y)
        for (int z = 0; z <= 2 * n; ++z)
          BOOST_TEST(inside(body, {Rational(x) / 2, Rational(y) / 2, Rational(z) / 2}) == voxels.where(x, y, z));
    BOOST_TEST(inside(body, {-1, 0, 0}) == -1);
    BOOST_TEST(inside(body, {n + 1, n, n}) == -1);
  }
}

// The first ray from the origin is along (1, 7/16, 49/256): it is made to run through an edge, through a vertex and in
// a face's plane.
BOOST_AUTO_TEST_CASE(a_ray_through_an_edge_a_vertex_or_in_a_face_is_not_counted)
{
  const double x = 1, y = 0.4375, z = 0.4375 * 0.4375;
  const tetracone::kernel::Vertex on = {x, y, z}, above = {x, y, z + 1}, below = {x, y, z - 1};
  for (const double far : {1.0, -1.0}) {  // the body's bulk behind the edge, or about the origin
    const tetracone::kernel::Vertex left = {x + 4 * far, y + 3, z}, right = {x + 4 * far, y - 3, z};
    const Brute_body edge(tetrahedron(above, below, left, right));
    BOOST_TEST(inside(edge, {0, 0, 0}) == -int(far));
    const Brute_body turned(tetrahedron(below, above, left, right));
    BOOST_TEST(inside(turned, {0, 0, 0}) == -int(far));
    const tetracone::kernel::Vertex back = {x + 4 * far, y, z + 3}, low = {x + 4 * far, y + 3, z - 3},
                                    high = {x + 4 * far, y - 3, z - 3};
    const Brute_body vertex(tetrahedron(on, back, low, high));
    BOOST_TEST(inside(vertex, {0, 0, 0}) == -int(far));
  }
  // The ray in the plane of a face: a, b, c on the plane of the ray.
  const Brute_body plane(tetrahedron({2, 0.875, 1}, {2, 0.875, -1}, {4, 1.75, 0}, {3, 0, 5}));
  BOOST_TEST(inside(plane, {0, 0, 0}) == -1);
}

BOOST_AUTO_TEST_SUITE_END()
