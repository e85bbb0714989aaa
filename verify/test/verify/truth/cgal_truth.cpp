#include "verify/truth/cgal_truth.h"

#include "verify/integer_truth/integer_probes.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_cgal_truth)

using namespace tetracone::verify;
using tetracone::kernel::Contact;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;

namespace {

/// The possible positions of a pair: it is apart, only the solids meet (one is in the other), or the surfaces meet.
enum class Meet { apart, nested, surface };

std::ostream& operator<<(std::ostream& out, Meet meet)
{
  return out << (meet == Meet::apart ? "apart" : meet == Meet::nested ? "nested" : "surface");
}

Meet meet(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b, const Pose& pose_b)
{
  const Brute_body body_a(a), body_b(b);
  const Placed_body placed_a(body_a, pose_a), placed_b(body_b, pose_b);
  const bool solid = collide(placed_a, placed_b, Question::solid),
             surface = collide(placed_a, placed_b, Question::surface);
  BOOST_TEST((solid || !surface));
  BOOST_TEST(surface == !features(placed_a, placed_b).empty());
  return surface ? Meet::surface : solid ? Meet::nested : Meet::apart;
}
Meet meet(const Polyhedron& a, const Polyhedron& b) { return meet(a, Pose(), b, Pose()); }

std::vector<Feature_pair> features_of(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b, const Pose& pose_b)
{
  return features(Brute_body(a), pose_a, Brute_body(b), pose_b);
}

std::map<Contact, int> kinds_of(const std::vector<Feature_pair>& features, int body)
{
  std::map<Contact, int> kinds;
  for (const Feature_pair& pair : features)
    if (pair.body == body) ++kinds[pair.kind];
  return kinds;
}

/// The answer, and that it is the same with the bodies swapped, their elements in another order, their faces turned,
/// and both moved by one exact motion: rigid, reflected, sheared.
void check(Meet expected, const Polyhedron& a, const Pose& pose_a, const Polyhedron& b, const Pose& pose_b)
{
  static Random random(1);
  BOOST_TEST(meet(a, pose_a, b, pose_b) == expected);
  BOOST_TEST(meet(b, pose_b, a, pose_a) == expected, "swapped");
  BOOST_TEST(meet(shuffled(a, random), pose_a, shuffled(b, random), pose_b) == expected, "shuffled");
  BOOST_TEST(meet(turned(a), pose_a, b, pose_b) == expected, "one turned");
  const Pose reflection(std::array<double, 12>{-1, 0, 0, 3, 0, 1, 0, 0, 0, 0, 1, 0});
  const Rational third = Rational(1) / 3;
  for (const Pose& motion :
       {random_rotation(random, 5, {third, -third, 100 * third}), reflection, random_affine(random)})
    BOOST_TEST(meet(a, composed(motion, pose_a), b, composed(motion, pose_b)) == expected, "moved");

  std::vector<Feature_pair> straight = features_of(a, pose_a, b, pose_b), swapped = features_of(b, pose_b, a, pose_a);
  for (Feature_pair& pair : swapped) pair.body = 1 - pair.body;
  std::sort(swapped.begin(), swapped.end());
  BOOST_TEST((straight == swapped), "features of swapped bodies");
  const Pose motion = random_rotation(random);
  BOOST_TEST((straight == features_of(a, composed(motion, pose_a), b, composed(motion, pose_b))),
             "features of moved bodies");
  BOOST_TEST((std::adjacent_find(straight.begin(), straight.end()) == straight.end()));
}
void check(Meet expected, const Polyhedron& a, const Polyhedron& b) { check(expected, a, Pose(), b, Pose()); }

Polyhedron box_at(const Vertex& low, double size) { return box(low, {low[0] + size, low[1] + size, low[2] + size}); }

/// The cube [0, 4]^3 with the pocket [1, 3]^2 x [2, 4], open at the top: its top is a face with a hole.
Polyhedron cube_with_pocket()
{
  const Polyhedron outer = box({0, 0, 0}, {4, 4, 4}), inner = box({1, 1, 2}, {3, 3, 4});
  Polyhedron body;
  body.vertices = outer.vertices;
  body.vertices.insert(body.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  for (Index f = 0; f < 5; ++f) {
    body.add_polygon(outer.loop(f, 0));
    body.add_polygon(reversed_loop(inner, f, 8));
  }
  const auto top = outer.loop(5, 0);
  body.add_face(std::vector<std::vector<Index>>{{top.begin(), top.end()}, reversed_loop(inner, 5, 8)});
  return body;
}

const Rational tiny = Rational(1) / Rational("1000000000000000000000000000000");

Pose shift(const Rational& x, const Rational& y, const Rational& z)
{
  return Pose({1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(made_by_hand)

BOOST_AUTO_TEST_CASE(cubes_that_touch_in_a_face_an_edge_or_a_vertex_collide)
{
  for (const Polyhedron& a : {unit_cube(), triangulated(unit_cube())})
    for (const auto& [x, y, z] :
         std::vector<std::array<double, 3>>{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {-1, 0.5, 0.25}, {1, -1, 0.5}})
      check(Meet::surface, a, Pose(), unit_cube(), translation(x, y, z));
}

BOOST_AUTO_TEST_CASE(a_gap_is_a_gap_however_small)
{
  const double above = std::nextafter(1., 2.), below = std::nextafter(1., 0.);
  check(Meet::apart, unit_cube(), Pose(), unit_cube(), translation(above, 0, 0));
  check(Meet::surface, unit_cube(), Pose(), unit_cube(), translation(below, 0, 0));
  check(Meet::apart, unit_cube(), box_at({1, above, 0}, 1));
  check(Meet::apart, unit_cube(), box_at({above, above, above}, 1));
  check(Meet::surface, unit_cube(), box_at({below, 1, below}, 1));
  Random random(2);
  for (int round = 0; round < 5; ++round) {
    const Pose turn = random_rotation(random, 9);
    const auto beside = [&](const Rational& step) { return composed(turn, shift(step, step, 1)); };
    BOOST_TEST(meet(unit_cube(), turn, unit_cube(), beside(1 + tiny)) == Meet::apart);
    BOOST_TEST(meet(unit_cube(), turn, unit_cube(), beside(1)) == Meet::surface);
    BOOST_TEST(meet(unit_cube(), turn, unit_cube(), beside(1 - tiny)) == Meet::surface);
  }
}

BOOST_AUTO_TEST_CASE(coplanar_faces_collide_from_either_side)
{
  check(Meet::surface, cube(2), box({-1, -1, 0}, {1, 1, 2}));  // from inside: same side
  check(Meet::surface, cube(2), box({-1, -1, 2}, {1, 1, 3}));  // from outside: opposite sides
  check(Meet::surface, cube(2), cube(2));
  check(Meet::apart, cube(2), box({3, -1, 2}, {4, 1, 3}));  // one plane, apart in it
  check(Meet::apart, box({0, 0, 0}, {4, 1, 1}), box({0, 2, 0}, {4, 3, 1}));
}

BOOST_AUTO_TEST_CASE(one_inside_the_other_collides_as_solids_only)
{
  check(Meet::nested, cube(2), cube(1));
  check(Meet::nested, turned(cube(2)), cube(1));
  check(Meet::nested, cube(2), Pose(), unit_cube(), translation(0.25, 0.5, -0.125));
  check(Meet::nested, star_prism(), box({-0.25, -0.25, 0.5}, {0.25, 0.25, 1.5}));
  check(Meet::apart, star_prism(), box({1.25, 1.25, 0.5}, {2, 2, 1.5}));  // between two arms
}

BOOST_AUTO_TEST_CASE(a_cavity_is_outside)
{
  check(Meet::apart, cube_with_cavity(), cube(1));
  check(Meet::surface, cube_with_cavity(), cube(2));
  check(Meet::nested, cube_with_cavity(), cube(2.5));  // around the cavity, inside the wall
  check(Meet::nested, cube_with_cavity(), cube(4));
  check(Meet::nested, cube_with_cavity(), box_at({2.25, 2.25, 2.25}, 0.5));
  // A body in the cavity of a body in its own: shells of one inside, of the other outside.
  check(Meet::apart, cube_with_cavity(), moved(cube_with_cavity(), 0.5));
  check(Meet::surface, cube_with_cavity(), moved(cube_with_cavity(), 0.6666666666666666));  // 3 times it is 2
  // Shells of one orientation in one another: winding number 2 inside is solid too.
  Polyhedron twice = cube(3);
  append(twice, cube(2));
  check(Meet::nested, twice, cube(1));
}

BOOST_AUTO_TEST_CASE(only_one_of_several_shells_is_inside)
{
  Polyhedron two = box_at({10, 10, 10}, 1);
  append(two, box_at({-0.5, -0.5, -0.5}, 1));
  check(Meet::nested, two, cube(2));
  check(Meet::apart, two, box_at({4, 4, 4}, 1));
  Polyhedron around = box_at({20, 0, 0}, 1);
  append(around, cube(5));
  check(Meet::nested, two, around);
}

BOOST_AUTO_TEST_CASE(a_tunnel_through_faces_with_holes_is_outside)
{
  const Polyhedron tunnel = cube_with_tunnel();
  check(Meet::apart, tunnel, cube(0.5));
  check(Meet::apart, tunnel, box({-0.5, -0.5, -5}, {0.5, 0.5, 5}));  // its edges run through both holes
  check(Meet::apart, tunnel, box({-0.5, -0.5, 2}, {0.5, 0.5, 5}));
  check(Meet::surface, tunnel, box({-1, -0.5, -5}, {0.5, 0.5, 5}));  // along the wall
  check(Meet::surface, tunnel, box({-1, -1, -5}, {1, 1, 5}));        // along the hole's edges
  check(Meet::surface, tunnel, box({0, 0, 3}, {1, 1, 5}));           // in the hole's plane, touches its boundary
  check(Meet::apart, tunnel, box({-0.5, -0.5, 3}, {0.5, 0.5, 5}));   // in the hole's plane
  check(Meet::surface, tunnel, box({-2, -2, 3}, {2, 2, 4}));         // a lid over the hole
  check(Meet::nested, tunnel, box({1.25, -1, -1}, {2.75, 1, 1}));    // in the wall
  check(Meet::apart, tunnel, Pose(), tetrahedron({0, 0, -4}, {1, 1, 4}, {-1, 1, 4}, {0, -1, 4}),
        translation(0, 0, 0.5));
  // The edge of a tetrahedron leans on the hole's edge x = 1, z = 3, in one point.
  check(Meet::surface, tunnel, tetrahedron({0, 0, 2}, {2, 0, 4}, {0, 0, 5}, {0, 0.5, 5}));
  check(Meet::apart, tunnel, tetrahedron({0, 0, std::nextafter(2., 3.)}, {2, 0, 4}, {0, 0, 5}, {0, 0.5, 5}));
}

BOOST_AUTO_TEST_CASE(a_pocket_is_outside)
{
  check(Meet::apart, cube_with_pocket(), box({1.5, 1.5, 2.5}, {2.5, 2.5, 3.5}));
  check(Meet::apart, cube_with_pocket(), box({1.5, 1.5, 2.5}, {2.5, 2.5, 7}));
  check(Meet::surface, cube_with_pocket(), box({1.5, 1.5, 2}, {2.5, 2.5, 7}));
  check(Meet::nested, cube_with_pocket(), box({1.5, 1.5, 0.5}, {2.5, 2.5, 1.5}));
  check(Meet::surface, cube_with_pocket(), box({3, 3, 4}, {3.5, 3.5, 5}));
  check(Meet::apart, cube_with_pocket(), box({1.5, 1.5, 4}, {2.5, 2.5, 5}));
}

BOOST_AUTO_TEST_CASE(degenerate_faces_are_points_of_the_surface)
{
  Polyhedron degenerate = cube(2);
  degenerate.vertices.push_back({0, 0, 5});
  degenerate.add_polygon({8});  // a point above the cube
  degenerate.vertices.push_back({0, 0, -3});
  degenerate.vertices.push_back({0, 0, -6});
  degenerate.add_polygon({9, 10});  // a needle below it
  degenerate.add_polygon({9, 9, 10, 10, 9});
  degenerate.add_polygon({10, 10});
  for (const auto& [low, expected] : std::vector<std::pair<Vertex, Meet>>{{{0, 0, 5}, Meet::surface},
                                                                          {{-0.5, -0.5, 4.5}, Meet::nested},
                                                                          {{0, 0, std::nextafter(5., 6.)}, Meet::apart},
                                                                          {{-0.5, -0.5, -4.5}, Meet::surface},
                                                                          {{0, 0, -4.5}, Meet::surface},
                                                                          {{0.25, 0, -4.5}, Meet::apart}})
    check(expected, degenerate, box_at(low, 1));
  Polyhedron needle, point, other;
  needle.vertices = {{0, 0, 0}, {2, 2, 2}};
  needle.add_polygon({0, 1});
  point.vertices = {{1, 1, 1}};
  point.add_polygon({0});
  other.vertices = {{0, 2, 1}, {2, 0, 1}};
  other.add_polygon({0, 1});
  check(Meet::surface, needle, point);
  check(Meet::surface, needle, other);
  check(Meet::surface, point, point);
  check(Meet::apart, point, Pose(), point, shift(0, 0, tiny));
  check(Meet::apart, needle, Pose(), point, shift(0, 0, tiny));
  check(Meet::apart, needle, Pose(), other, shift(0, 0, tiny));
  check(Meet::nested, cube(3), needle);
}

BOOST_AUTO_TEST_CASE(a_spur_in_a_face_and_a_spur_out_of_it)
{
  Polyhedron flag = cube(1);  // the top's loop goes out to (5, 5, 1) and back
  flag.vertices.push_back({5, 5, 1});
  Polyhedron body;
  body.vertices = flag.vertices;
  for (Index f = 0; f < 5; ++f) body.add_polygon(flag.loop(f, 0));
  body.add_polygon({4, 5, 7, 8, 7, 6});
  check(Meet::surface, body, box_at({3, 3, 1}, 0.5));
  check(Meet::surface, body, box_at({2.75, 2.75, 0.75}, 0.5));
  check(Meet::apart, body, box_at({3, 3.75, 1}, 0.5));
}

BOOST_AUTO_TEST_CASE(a_reflection_places_a_solid_too)
{
  const Pose mirror(std::array<double, 12>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0});
  check(Meet::nested, cube(3), mirror, cube(1), Pose());
  check(Meet::apart, cube_with_cavity(), mirror, cube(1), mirror);
  check(Meet::nested, star_prism(), mirror, box({0.5, -0.25, -0.25}, {1.5, 0.25, 0.25}), Pose());
}

BOOST_AUTO_TEST_CASE(huge_and_tiny_coordinates_are_exact)
{
  const double huge = 1e300, next = std::nextafter(huge, HUGE_VAL), most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  for (const double unit : {huge, least, 1e-310, 0x1p200, 0x1p-600}) {
    BOOST_TEST_INFO_SCOPE("unit " << unit);
    check(Meet::surface, box_at({0, 0, 0}, unit), box_at({unit, unit, unit}, unit));
    check(Meet::apart, box_at({0, 0, 0}, unit), box_at({2 * unit, 0, 0}, unit));
    check(Meet::nested, cube(2 * unit), cube(unit));
    check(Meet::apart, moved(cube_with_tunnel(), unit), box({-0, -0, -4 * unit}, {0, 0, 4 * unit}));
  }
  check(Meet::apart, box_at({0, 0, 0}, huge), box({next, 0, 0}, {2 * huge, huge, huge}));
  check(Meet::apart, box_at({0, 0, 0}, least), Pose(), box_at({0, 0, 0}, least),
        shift(Rational(least) * (1 + tiny), 0, 0));
  check(Meet::nested, cube(huge), cube(least));
  check(Meet::surface, box({-most, -most, -most}, {0, most, most}), box({0, -most, -most}, {most, most, most}));
  // Images beyond the doubles: 1e600, and below them.
  const auto scaled = [](double s, double t) {
    return Pose(std::array<double, 12>{s, 0, 0, t, 0, s, 0, t, 0, 0, s, t});
  };
  check(Meet::nested, cube(2 * huge), scaled(huge, 0), cube(huge), scaled(huge, 0));
  check(Meet::surface, cube(huge), scaled(huge, 0), cube(huge), scaled(huge, huge));
  check(Meet::apart, box_at({0, 0, 0}, huge), scaled(huge, 0), box_at({next, 0, 0}, huge), scaled(huge, 0));
  check(Meet::nested, cube(2 * least), scaled(least, 0), cube(least), scaled(least, 0));
  check(Meet::apart, box_at({0, 0, 0}, least), scaled(least, 0), box_at({2 * least, 0, 0}, least), scaled(least, 0));
}

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
  // Two edges of the triangle cross a face of the cube, no edge of the cube meets the triangle.
  const auto pairs = features(triangle, translation(1.5, 0, 0), solid, Pose());
  BOOST_TEST((kinds_of(pairs, 0) == std::map<Contact, int>{{Contact::edge_face, 2}}));
  BOOST_TEST(kinds_of(pairs, 1).empty());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(features_counted_by_hand)

BOOST_AUTO_TEST_CASE(of_two_cubes_that_touch)
{
  using Kinds = std::map<Contact, int>;
  Random random(4);
  for (int round = 0; round < 5; ++round) {
    const Pose turn = round == 0 ? Pose() : random_rotation(random);
    const auto kinds = [&](const Pose& step, int body) {
      return kinds_of(features_of(unit_cube(), turn, unit_cube(), composed(turn, step)), body);
    };
    for (const int body : {0, 1}) {
      // 3 edges and 3 faces in the vertex.
      BOOST_TEST((kinds(translation(1, 1, 1), body) == Kinds{{Contact::vertex_vertex, 9}}));
      // The common edge on 2 faces, and at each end on one; 2 more edges at each end, on 3 faces each.
      BOOST_TEST(
          (kinds(translation(1, 1, 0), body) == Kinds{{Contact::vertex_vertex, 14}, {Contact::coplanar_overlap, 2}}));
      // The square's 4 edges: each on the square and a side, with an end on 2 sides. 4 edges end in it, on 3 faces
      // each.
      BOOST_TEST(
          (kinds(translation(1, 0, 0), body) == Kinds{{Contact::vertex_vertex, 20}, {Contact::coplanar_overlap, 8}}));
      // Halfway along the edge: 1 edge of each lies half on the other's; ends of 3 edges meet the other's edge, on 2
      // faces.
      BOOST_TEST(
          (kinds(translation(1, 1, 0.5), body) == Kinds{{Contact::vertex_edge, 5}, {Contact::coplanar_overlap, 2}}));
      BOOST_TEST(kinds(translation(2, 0, 0), body).empty());
      // A corner in the square: its 2 edges on the square, each over an edge of it; a third edge ends there.
      BOOST_TEST((kinds(shift(1, Rational(1) / 3, Rational(1) / 3), body) ==
                  Kinds{{Contact::vertex_face, 1}, {Contact::edge_edge, 2}, {Contact::coplanar_overlap, 2}}));
    }
  }
}

BOOST_AUTO_TEST_CASE(of_an_edge_through_a_face_and_of_one_through_a_hole)
{
  const Polyhedron lance = tetrahedron({2, 2, -1}, {2.5, 2, 9}, {2, 2.5, 9}, {2, 2, 10});
  const auto through = features_of(lance, Pose(), box({0, 0, 0}, {4, 4, 4}), Pose());
  BOOST_TEST((kinds_of(through, 0) == std::map<Contact, int>{{Contact::edge_face, 6}}));  // 3 edges in and out
  BOOST_TEST(kinds_of(through, 1).empty());
  BOOST_TEST(features_of(moved(lance, 1, {-2, -2, 0}), translation(0, 0, -4), cube_with_tunnel(), Pose()).empty());
}

/// The kind of two boxes whose sides are parallel to the axes, `edge` long in one direction and `square` in two, or
/// fewer.
Contact kind_of_boxes(const std::array<std::array<int, 3>, 2>& edge, const std::array<std::array<int, 3>, 2>& square)
{
  int edge_free = 0, square_free = 0;
  bool overlap = false;
  for (int k = 0; k < 3; ++k) {
    const int low = std::max(edge[0][k], square[0][k]), high = std::min(edge[1][k], square[1][k]);
    if (low > high) return Contact::none;
    overlap = overlap || low < high;
    edge_free += edge[0][k] < low && low < edge[1][k];
    square_free += square[0][k] < low && low < square[1][k];
  }
  if (overlap) return Contact::coplanar_overlap;
  static constexpr std::array<std::array<Contact, 3>, 2> kinds = {
      {{Contact::vertex_vertex, Contact::vertex_edge, Contact::vertex_face},
       {Contact::vertex_edge, Contact::edge_edge, Contact::edge_face}}};
  return kinds[edge_free][square_free];
}

BOOST_AUTO_TEST_CASE(of_voxel_solids_on_half_steps_are_those_of_boxes)
{
  Random random(8);
  std::map<Contact, int> seen;
  for (int round = 0; round < 12; ++round) {
    const Polyhedron a = Voxels(random, 2).solid(), b = Voxels(random, 2).solid();
    std::array<int, 3> step = {integer(random, -3, 3), integer(random, -3, 3), integer(random, -3, 3)};  // halves
    if (round < 4) step = std::array<std::array<int, 3>, 4>{{{1, 1, -1}, {1, -1, 0}, {0, 1, 0}, {0, 0, 0}}}[round];
    const auto corners = [&](const Polyhedron& body, bool moved, const auto& vertices) {
      std::array<std::array<int, 3>, 2> range{{{1000, 1000, 1000}, {-1000, -1000, -1000}}};
      for (const Index v : vertices)
        for (int k = 0; k < 3; ++k) {
          const int x = int(2 * body.vertices[v][k]) + (moved ? step[k] : 0);
          range[0][k] = std::min(range[0][k], x);
          range[1][k] = std::max(range[1][k], x);
        }
      return range;
    };
    std::vector<Feature_pair> expected;
    for (const int body : {0, 1}) {
      const Polyhedron& with_edges = body == 0 ? a : b;
      const Polyhedron& with_faces = body == 0 ? b : a;
      std::set<std::pair<Index, Index>> edges;
      for (Index f = 0; f < with_edges.face_count(); ++f)
        for (std::size_t k = 0; k < 4; ++k)
          edges.insert(std::minmax({with_edges.loop(f, 0)[k], with_edges.loop(f, 0)[(k + 1) % 4]}));
      for (const auto& [from, to] : edges)
        for (Index f = 0; f < with_faces.face_count(); ++f) {
          const Contact kind = kind_of_boxes(corners(with_edges, body == 1, std::array{from, to}),
                                             corners(with_faces, body == 0, with_faces.loop(f, 0)));
          if (kind == Contact::none) continue;
          expected.push_back({body, from, to, f, kind});
          ++seen[kind];
        }
    }
    std::sort(expected.begin(), expected.end());
    const Pose turn = random_rotation(random);
    BOOST_TEST(
        (features_of(a, turn, b, composed(turn, translation(step[0] / 2., step[1] / 2., step[2] / 2.))) == expected));
  }
  BOOST_TEST(seen.size() == 6u);
  for (const auto& [kind, count] : seen) BOOST_TEST_MESSAGE(to_string(kind) << ": " << count);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(against_other_arithmetic)

BOOST_AUTO_TEST_CASE(voxel_solids_collide_where_their_cells_touch)
{
  Random random(6);
  std::map<Meet, int> seen;
  for (int round = 0; round < 60; ++round) {
    const int n = integer(random, 1, 3);
    const Voxels a(random, n, round % 2 ? 0.8 : 0.3), b(random, round % 3 == 0 ? 4 - n : 2, 0.4);
    const double scale = round % 4 == 3 ? 0.25 : 0.5;  // of b: in quarters of a's cells, or halves
    const int unit = round % 4 == 3 ? 1 : 2;           // b's cell in quarters
    std::array<int, 3> step;                           // in quarters
    for (int& s : step) s = integer(random, -2, 2 * n) * 2 + integer(random, 0, 1);
    // Cells and squares by whole numbers, in quarters: a's cell is 4 wide, b's is `unit`.
    bool solid = false, surface = false;
    for (int i = 0; i < a.n * a.n * a.n; ++i)
      for (int j = 0; j < b.n * b.n * b.n; ++j) {
        if (!a.full[i] || !b.full[j]) continue;
        bool touch = true;
        for (int k = 0, power = 1; k < 3; ++k, power *= a.n) {
          const int p = 4 * (i / power % a.n);
          int q = j;
          for (int l = 0; l < k; ++l) q /= b.n;
          q = unit * (q % b.n) + step[2 - k];
          touch = touch && p <= q + unit && q <= p + 4;
        }
        solid = solid || touch;
      }
    // The surfaces are made of lattice squares: where they meet, they meet in a point of the lattice of quarters.
    const auto wall = [](const Voxels& body, int cell, const std::array<int, 3>& p) {
      int cells = 0, filled = 0;
      const auto around = [cell](int x) {
        const int floor = x >= 0 ? x / cell : -((-x + cell - 1) / cell);
        return x % cell == 0 ? std::vector<int>{floor - 1, floor} : std::vector<int>{floor};
      };
      for (const int x : around(p[0]))
        for (const int y : around(p[1]))
          for (const int z : around(p[2])) {
            ++cells;
            filled += body(x, y, z);
          }
      return filled > 0 && filled < cells;
    };
    for (int x = 0; x <= 4 * a.n; ++x)
      for (int y = 0; y <= 4 * a.n; ++y)
        for (int z = 0; z <= 4 * a.n; ++z)
          surface = surface || (wall(a, 4, {x, y, z}) && wall(b, unit, {x - step[0], y - step[1], z - step[2]}));
    const Meet expected = surface ? Meet::surface : solid ? Meet::nested : Meet::apart;
    ++seen[expected];
    const Pose turn = round % 5 == 0 ? Pose() : random_rotation(random);
    const Pose step_pose(
        std::array<double, 12>{scale, 0, 0, step[0] / 4., 0, scale, 0, step[1] / 4., 0, 0, scale, step[2] / 4.});
    BOOST_TEST_INFO_SCOPE("round " << round);
    BOOST_TEST(meet(a.solid(), turn, b.solid(), composed(turn, step_pose)) == expected);
  }
  for (const Meet kind : {Meet::apart, Meet::nested, Meet::surface}) BOOST_TEST(seen[kind] > 0, kind << " never came");
}

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

/// The closed images of the unit cube, by separating axes in rational numbers.
bool images_of_cubes_meet(const Pose& a, const Pose& b)
{
  using rationals::Vector;
  const auto column = [](const Pose& pose, int k) {
    return Vector{pose.exact(k), pose.exact(4 + k), pose.exact(8 + k)};
  };
  std::vector<Vector> axes;
  for (int i = 0; i < 3; ++i) {
    axes.push_back(rationals::outer(column(a, i), column(a, (i + 1) % 3)));
    axes.push_back(rationals::outer(column(b, i), column(b, (i + 1) % 3)));
    for (int j = 0; j < 3; ++j) axes.push_back(rationals::outer(column(a, i), column(b, j)));
  }
  for (const Vector& axis : axes) {
    const auto range = [&](const Pose& pose) {
      Rational low = rationals::inner(axis, column(pose, 3)), high = low;
      for (int k = 0; k < 3; ++k) {
        const Rational length = rationals::inner(axis, column(pose, k));
        (length < 0 ? low : high) += length;
      }
      return std::pair(low, high);
    };
    const auto [low_a, high_a] = range(a);
    const auto [low_b, high_b] = range(b);
    if (high_a < low_b || high_b < low_a) return false;
  }
  return true;
}

BOOST_AUTO_TEST_CASE(cubes_under_rounded_rotations_agree_with_separating_axes_in_rationals)
{
  Random random(20240601);
  const Brute_body cube(unit_cube()), triangles(triangulated(unit_cube()));
  std::array<std::array<int, 2>, 6> seen{};
  for (int round = 0; round < 60; ++round) {
    const Pose turn = rounded(random_rotation(random, 9));
    const auto beside = [&](double x, double y, double z) {  // the shift R (x, y, z), rounded
      std::array<double, 12> entries = turn.entries();
      for (int i = 0; i < 3; ++i)
        entries[4 * i + 3] = entries[4 * i] * x + entries[4 * i + 1] * y + entries[4 * i + 2] * z;
      return Pose(entries);
    };
    const std::array<Pose, 6> others = {beside(1, 0, 0),           beside(1, 1, 0),
                                        beside(1, 1, 1),           beside(1 + 0x1p-20, 0, 0),
                                        beside(1 - 0x1p-40, 0, 0), beside(1 + 0x1p-40, 0.5, 0.5)};
    for (std::size_t k = 0; k < others.size(); ++k) {
      const bool expected = images_of_cubes_meet(turn, others[k]);
      ++seen[k][expected];
      BOOST_TEST(collide(cube, turn, cube, others[k], Question::surface) == expected);
      BOOST_TEST(collide(triangles, others[k], cube, turn) == expected);
    }
  }
  for (const int k : {1, 2}) BOOST_TEST((seen[k][0] > 0 && seen[k][1] > 0));
  BOOST_TEST(seen[3][1] == 0);
  BOOST_TEST(seen[4][0] == 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(points)

BOOST_AUTO_TEST_CASE(are_inside_on_or_outside_voxels_as_their_cells_say)
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

BOOST_AUTO_TEST_CASE(are_where_the_second_truth_says)
{
  Random random(13);
  for (const auto& [name, polyhedron] : closed_bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    const Brute_body body(polyhedron);
    const integer_truth::Probed_body second(polyhedron);
    BOOST_TEST(body.is_closed());
    std::array<int, 3> seen{};
    for (int round = 0; round < 60; ++round) {
      const int d = round % 2 + 1;
      Vertex p = grid_vertex(random, 4 * d);
      for (double& x : p) x /= d;
      const int expected = second.where(p);
      ++seen[expected + 1];
      BOOST_TEST(inside(body, rationals::exactly(p)) == expected);
    }
    BOOST_TEST(seen[0] > 0);
  }
}

BOOST_AUTO_TEST_CASE(are_told_apart_by_any_distance)
{
  const Brute_body body(cube_with_tunnel());
  BOOST_TEST(inside(body, {1, 0, 0}) == 0);
  BOOST_TEST(inside(body, {1 + tiny, 0, 0}) == 1);
  BOOST_TEST(inside(body, {1 - tiny, 0, 0}) == -1);
  BOOST_TEST(inside(body, {0, 0, 3}) == -1);
  BOOST_TEST(inside(body, {1, 0, 3}) == 0);
  BOOST_TEST(inside(body, {3, 3, 3 - tiny}) == 0);
  BOOST_TEST(inside(body, {3, 3, 3 + tiny}) == -1);
  BOOST_TEST(inside(Brute_body(cube(1e300)), {Rational(1e300), 0, 0}) == 0);
  BOOST_TEST(inside(Brute_body(cube(1e300)), {Rational(1e300) - tiny, 0, 0}) == 1);
  BOOST_TEST(inside(Brute_body(cube(5e-324)), {Rational(5e-324) / 2, 0, 0}) == 1);
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

// Two errors were planted in planar_face.h to see whether tests notice:
//  1. the half-open crossing rule of `winding` made closed (from.y() >= p.y()): 14 cases here failed (tunnel, pocket,
//  small tetrahedra, CGAL's triangles, ...).
//  2. `locate` without each loop's last edge: 7 cases here failed (features of touching cubes, of voxels; a gap; the
//  tunnel; degenerate faces; ...).
//  3. `crossing` without its way out for a ray through a border: only
//  a_ray_through_an_edge_a_vertex_or_in_a_face_is_not_counted failed.

BOOST_AUTO_TEST_SUITE_END()
