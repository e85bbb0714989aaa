#include "tetracone/tetratree/relation/solid_pair.h"

#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_solid_pair)

namespace scenes = tetracone::verify::scenes;
using tetracone::Body;
using tetracone::Index;
using tetracone::Overlap;
using tetracone::Polyhedron;
using tetracone::Query;
using tetracone::Solid_contact;
using tetracone::Solid_relation;
using tetracone::kernel::Pose;
using tetracone::kernel::Rational;
using tetracone::kernel::to_string;
using tetracone::kernel::Vertex;

namespace {

std::string text(const Solid_contact& contact)
{
  return std::string(to_string(contact.relation)) + ' ' + std::to_string(contact.dimension);
}

std::string text_of(const Polyhedron& a, const Polyhedron& b, const Pose& pose_a = Pose(), const Pose& pose_b = Pose())
{
  Query query{Body(a), Body(b)};
  const Solid_contact contact = query.solid_relation(pose_a, pose_b);
  BOOST_TEST(query.solid_relation_alone(pose_a, pose_b) == contact.relation);
  return text(contact);
}

Polyhedron box_at(const Vertex& low, const Vertex& size)
{
  return scenes::box(low, {low[0] + size[0], low[1] + size[1], low[2] + size[2]});
}

/// Two squares of opposite directions in the plane z = height.
Polyhedron sheet(const Vertex& low, double size)
{
  Polyhedron result;
  const auto [x, y, z] = low;
  result.vertices = {{x, y, z}, {x + size, y, z}, {x + size, y + size, z}, {x, y + size, z}};
  result.add_polygon({0, 1, 2, 3});
  result.add_polygon({3, 2, 1, 0});
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(boxes_stand_in_each_of_the_relations)
{
  const Polyhedron unit = scenes::unit_cube(), small = scenes::box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5});
  BOOST_TEST(text_of(unit, box_at({2, 0, 0}, {1, 1, 1})) == "disjoint -1");
  BOOST_TEST(text_of(unit, box_at({1, 0, 0}, {1, 1, 1})) == "meet 2");
  BOOST_TEST(text_of(unit, box_at({1, 0.5, 0.25}, {2, 2, 2})) == "meet 2");
  BOOST_TEST(text_of(unit, box_at({1, 1, 0}, {1, 1, 1})) == "meet 1");
  BOOST_TEST(text_of(unit, box_at({1, 1, 0.5}, {1, 1, 1})) == "meet 1");
  BOOST_TEST(text_of(unit, box_at({1, 1, 1}, {1, 1, 1})) == "meet 0");
  BOOST_TEST(text_of(unit, box_at({0.5, 0.5, 0.5}, {1, 1, 1})) == "overlap 1");
  BOOST_TEST(text_of(unit, box_at({0.5, 0, 0}, {1, 1, 1})) == "overlap 2");
  BOOST_TEST(text_of(unit, box_at({0.25, 0.25, -1}, {0.5, 0.5, 3})) == "overlap 1");
  BOOST_TEST(text_of(unit, unit) == "equal 2");
  BOOST_TEST(text_of(unit, scenes::triangulated(unit)) == "equal 2");
  BOOST_TEST(text_of(small, unit) == "inside -1");
  BOOST_TEST(text_of(unit, small) == "contains -1");
  BOOST_TEST(text_of(box_at({0.25, 0.25, 0}, {0.5, 0.5, 0.5}), unit) == "covered_by 2");
  BOOST_TEST(text_of(unit, box_at({0, 0, 0}, {1, 1, 0.5})) == "covers 2");
}

BOOST_AUTO_TEST_CASE(a_vertex_or_an_edge_touches_from_within)
{
  const Polyhedron unit = scenes::unit_cube();
  const Polyhedron needle = scenes::tetrahedron({0.5, 0.5, 0}, {0.75, 0.5, 0.5}, {0.5, 0.75, 0.5}, {0.5, 0.5, 0.5});
  BOOST_TEST(text_of(needle, unit) == "covered_by 0");
  BOOST_TEST(text_of(unit, needle) == "covers 0");
  const Polyhedron wedge = scenes::tetrahedron({0.25, 0.5, 0}, {0.75, 0.5, 0}, {0.5, 0.75, 0.5}, {0.5, 0.25, 0.5});
  BOOST_TEST(text_of(wedge, unit) == "covered_by 1");
  BOOST_TEST(text_of(needle, unit, Pose::translation(0, 0, -1)) == "disjoint -1");
  BOOST_TEST(text_of(needle, unit, Pose::translation(0, 0, 1)) == "meet 0");
  BOOST_TEST(text_of(needle, unit, Pose::translation(0, 0, 0x1p-1000)) == "inside -1");
  BOOST_TEST(text_of(needle, unit, Pose::translation(0, 0, -0x1p-1000)) == "overlap 1");
  BOOST_TEST(text_of(needle, unit, Pose::translation(0, 0, -0x1p-40)) == "overlap 1");
}

BOOST_AUTO_TEST_CASE(edges_that_cross_in_a_point_touch)
{
  const Polyhedron below = scenes::tetrahedron({-1, 0, 0}, {1, 0, 0}, {0, -1, -1}, {0, 1, -1}),
                   above = scenes::tetrahedron({0, -1, 0}, {0, 1, 0}, {-1, 0, 1}, {1, 0, 1});
  BOOST_TEST(text_of(below, above) == "meet 0");
  BOOST_TEST(text_of(below, above, Pose(), Pose::translation(0, 0, -0x1p-1000)) == "overlap 1");
  BOOST_TEST(text_of(below, above, Pose(), Pose::translation(0, 0, 0x1p-1000)) == "disjoint -1");
}

BOOST_AUTO_TEST_CASE(a_cavity_is_outside)
{
  const Polyhedron shell = scenes::with_cavity(scenes::cube(3), scenes::cube(2));
  BOOST_TEST(text_of(scenes::cube(1), shell) == "disjoint -1");
  BOOST_TEST(text_of(scenes::cube(2), shell) == "meet 2");
  BOOST_TEST(text_of(shell, scenes::cube(2)) == "meet 2");
  BOOST_TEST(text_of(scenes::cube(2.5), shell) == "overlap -1");
  BOOST_TEST(text_of(scenes::cube(4), shell) == "contains -1");
  BOOST_TEST(text_of(scenes::cube(3), shell) == "covers 2");
  BOOST_TEST(text_of(shell, shell) == "equal 2");
  BOOST_TEST(text_of(scenes::box({2.25, -1, -1}, {2.5, 1, 1}), shell) == "inside -1");
  BOOST_TEST(text_of(scenes::box({2, -1, -1}, {2.5, 1, 1}), shell) == "covered_by 2");
}

BOOST_AUTO_TEST_CASE(shells_need_not_agree)
{
  const Polyhedron two = scenes::both(scenes::cube(1), box_at({9, 9, 9}, {1, 1, 1}));
  BOOST_TEST(text_of(two, scenes::cube(2)) == "overlap -1");
  BOOST_TEST(text_of(scenes::cube(2), two) == "overlap -1");
  BOOST_TEST(text_of(two, scenes::both(scenes::cube(2), box_at({8, 8, 8}, {3, 3, 3}))) == "inside -1");
  BOOST_TEST(text_of(two, scenes::both(scenes::cube(2), box_at({9, 9, 9}, {1, 1, 1}))) == "covered_by 2");
  BOOST_TEST(text_of(two, box_at({10, 9, 9}, {1, 1, 1})) == "meet 2");
}

BOOST_AUTO_TEST_CASE(a_membrane_is_no_border)
{
  // The winding number is 2 within the inner cube, and 1 about it.
  const Polyhedron nested = scenes::both(scenes::cube(3), scenes::cube(2));
  BOOST_TEST(text_of(nested, scenes::cube(3)) == "equal 2");
  BOOST_TEST(text_of(scenes::cube(2), nested) == "inside 2");
  BOOST_TEST(text_of(scenes::cube(1), nested) == "inside -1");
  BOOST_TEST(text_of(scenes::box({1, 1, 1}, {2.5, 2.5, 2.5}), nested) == "inside 1");
  BOOST_TEST(text_of(scenes::box({1, 1, 1}, {3, 2.5, 2.5}), nested) == "covered_by 2");
  const Polyhedron glued = scenes::both(scenes::unit_cube(), box_at({1, 0, 0}, {1, 1, 1}));
  BOOST_TEST(text_of(glued, box_at({0, 0, 0}, {2, 1, 1})) == "equal 2");
  BOOST_TEST(text_of(box_at({0.5, 0.25, 0.25}, {0.5, 0.5, 0.5}), glued) == "inside 2");
  BOOST_TEST(text_of(box_at({0.5, 0.25, 0}, {0.5, 0.5, 0.5}), glued) == "covered_by 2");
}

BOOST_AUTO_TEST_CASE(a_sheet_is_all_border)
{
  const Polyhedron unit = scenes::unit_cube();
  BOOST_TEST(text_of(sheet({0.25, 0.25, 0.5}, 0.5), unit) == "inside -1");
  BOOST_TEST(text_of(sheet({0.25, 0.25, 0}, 0.5), unit) == "covered_by 2");
  BOOST_TEST(text_of(sheet({0.5, 0.5, 0.5}, 1), unit) == "meet 1");
  BOOST_TEST(text_of(sheet({1, 0, 1}, 1), unit) == "meet 1");
  const Polyhedron flagged = scenes::both(unit, sheet({1, 0, 1}, 1));
  BOOST_TEST(text_of(flagged, unit) == "covers 2");
  BOOST_TEST(text_of(unit, flagged) == "covered_by 2");
  BOOST_TEST(text_of(scenes::cube(4), flagged) == "contains -1");
  BOOST_TEST(text_of(scenes::both(unit, sheet({0.25, 0.25, 0.5}, 0.5)), unit) == "equal 2");
  BOOST_TEST(text_of(sheet({0, 0, 0}, 1), sheet({0.5, 0.5, 0}, 1)) == "meet 2");
  BOOST_TEST(text_of(sheet({0, 0, 0}, 1), sheet({0, 0, 0}, 1)) == "equal 2");
  BOOST_TEST(text_of(sheet({0.25, 0.25, 0}, 0.5), sheet({0, 0, 0}, 1)) == "covered_by 2");
}

BOOST_AUTO_TEST_CASE(faces_without_area_are_points_of_the_solid)
{
  // An edge there and back, from the cube's corner (1, 1, 1).
  Polyhedron spiked = scenes::unit_cube();
  spiked.vertices.push_back({2, 2, 2});
  spiked.add_polygon({7, 8});
  BOOST_TEST(text_of(scenes::unit_cube(), spiked) == "covered_by 2");
  BOOST_TEST(text_of(spiked, scenes::cube(3)) == "inside -1");
  BOOST_TEST(text_of(spiked, scenes::cube(2)) == "covered_by 0");
  BOOST_TEST(text_of(spiked, box_at({1.5, 1.5, 1.5}, {4, 4, 4})) == "meet 0");
  BOOST_TEST(text_of(spiked, box_at({2, 2, 2}, {4, 4, 4})) == "meet 0");
  // A face that is a point, and a sheet, lie inside the other solid, away from its surface.
  const Polyhedron far = box_at({9, 9, 9}, {1, 1, 1}), around = scenes::cube(2);
  Polyhedron pointed = far;
  pointed.vertices.push_back({0.5, 0.5, 0.5});
  pointed.add_polygon({8, 8});
  BOOST_TEST(text_of(pointed, around) == "meet -1");
  BOOST_TEST(text_of(around, pointed) == "meet -1");
  BOOST_TEST(text_of(scenes::both(far, sheet({0, 0, 0}, 1)), around) == "meet -1");
  Polyhedron within = scenes::unit_cube();
  within.vertices.push_back({0.5, 0.5, 0.5});
  within.add_polygon({7, 8});
  BOOST_TEST(text_of(within, scenes::unit_cube()) == "equal 2");
  BOOST_TEST(text_of(box_at({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}), within) == "inside 0");
}

BOOST_AUTO_TEST_CASE(holes_and_edges_of_four_faces_are_no_obstacle)
{
  const Polyhedron tunnel = scenes::cube_with_tunnel();
  BOOST_TEST(text_of(tunnel, tunnel) == "equal 2");
  BOOST_TEST(text_of(tunnel, scenes::moved(tunnel, 0.5)) == text_of(scenes::moved(tunnel, 0.5), tunnel));
  const Polyhedron edge = scenes::both(scenes::unit_cube(), box_at({1, 1, 0}, {1, 1, 1}));
  BOOST_TEST(text_of(edge, box_at({1, 0, 0}, {1, 1, 1})) == "meet 2");
  BOOST_TEST(text_of(edge, box_at({0, 0, 0}, {2, 2, 1})) == "covered_by 2");
  BOOST_TEST(text_of(edge, box_at({0.5, 0.5, 0.25}, {1, 1, 0.5})) == "overlap 1");
}

BOOST_AUTO_TEST_CASE(an_aligned_overlap_of_50_mm_is_one)
{
  const Polyhedron column = scenes::box({0, 0, 0}, {0.3, 0.3, 3});
  BOOST_TEST(text_of(column, column, Pose(), Pose::translation(0.25, 0, 0)) == "overlap 2");
  BOOST_TEST(text_of(column, column, Pose(), Pose::translation(0.3, 0, 0)) == "meet 2");
  BOOST_TEST(text_of(column, column, Pose(), Pose::translation(std::nextafter(0.3, 0), 0, 0)) == "overlap 2");
  BOOST_TEST(text_of(column, column, Pose(), Pose::translation(std::nextafter(0.3, 1), 0, 0)) == "disjoint -1");
}

BOOST_AUTO_TEST_CASE(volumes_are_exact)
{
  const auto overlap = [](const Polyhedron& a, const Polyhedron& b, const Pose& pose = Pose()) {
    return Query(Body(a), Body(b)).overlap(pose, Pose());
  };
  const Polyhedron unit = scenes::unit_cube();
  const Overlap half = overlap(unit, box_at({0.5, 0.25, 0}, {1, 1, 1}));
  BOOST_TEST(half.exact_volume() == "3/8");
  BOOST_TEST(half.volume == 0.375);
  BOOST_TEST(half.exact_centroid() == (std::array<std::string, 3>{"3/4", "5/8", "1/2"}));
  BOOST_TEST(half.contact_area == (std::array<double, 2>{0.75, 0.75}));
  BOOST_TEST(half.exact_contact_vector() == (std::array<std::string, 3>{"0", "0", "0"}));
  const Overlap touch = overlap(unit, box_at({1, 0.5, 0.5}, {1, 1, 1}));
  BOOST_TEST(touch.exact_volume() == "0");
  BOOST_TEST(touch.exact_contact_vector() == (std::array<std::string, 3>{"1/4", "0", "0"}));
  const Polyhedron corner = scenes::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  BOOST_TEST(overlap(corner, corner).exact_volume() == "1/6");
  BOOST_TEST(overlap(corner, unit).exact_centroid() == (std::array<std::string, 3>{"1/4", "1/4", "1/4"}));
  BOOST_TEST(overlap(corner, scenes::box({-1, -1, -1}, {0.5, 0.5, 2})).exact_volume() == "1/8");
  for (const scenes::Named& each : scenes::closed_bodies())
    BOOST_TEST(overlap(each.body, each.body).exact_volume() == overlap(each.body, scenes::cube(1000)).exact_volume(),
               each.name);
}

BOOST_AUTO_TEST_CASE(hard_bodies_equal_themselves_and_swap_with_others)
{
  const std::map<Solid_relation, Solid_relation> swapped = {{Solid_relation::inside, Solid_relation::contains},
                                                            {Solid_relation::contains, Solid_relation::inside},
                                                            {Solid_relation::covered_by, Solid_relation::covers},
                                                            {Solid_relation::covers, Solid_relation::covered_by}};
  const std::vector<scenes::Named> bodies = scenes::closed_bodies();
  scenes::Random random(3);
  for (const scenes::Named& a : bodies)
    for (const scenes::Named& b : bodies) {
      const Pose frame = scenes::random_affine(random),
                 moved = scenes::translation(scenes::integer(random, 0, 2), 0, 1);
      const Pose of_b = scenes::composed(frame, moved);
      Query query{Body(a.body), Body(b.body)}, other_way{Body(b.body), Body(a.body)};
      const Solid_contact contact = query.solid_relation(frame, of_b), other = other_way.solid_relation(of_b, frame);
      BOOST_TEST_CONTEXT(a.name << ", " << b.name)
      {
        const auto expected = swapped.find(contact.relation);
        BOOST_TEST(other.relation == (expected == swapped.end() ? contact.relation : expected->second));
        BOOST_TEST(other.dimension == contact.dimension);
        BOOST_TEST(text(query.solid_relation(Pose(), moved)) == text(contact));
        BOOST_TEST(query.overlap(frame, of_b).exact_volume() == other_way.overlap(of_b, frame).exact_volume());
        if (&a == &b) BOOST_TEST(query.solid_relation(frame, frame).relation == Solid_relation::equal);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_volume_in_general_position_is_that_of_the_cells)
{
  // A sheet far away makes a body that is not simple, so that cells are asked.
  scenes::Random random(8);
  int general = 0, told_apart = 0;
  for (int round = 0; round < 30; ++round) {
    const Polyhedron a = scenes::blob(random, 3, 0.5, 1), b = scenes::blob(random, 2, 0.5, 1);
    Pose of_a = round % 3 == 0 ? scenes::random_affine(random, 2) : scenes::random_rotation(random),
         of_b = scenes::random_rotation(random, 5, {Rational(Rational(round) / 30), Rational(1, 7), 0});
    if (round % 2 == 0) {  // then no interval is wide from the start
      of_a = scenes::rounded(of_a);
      of_b = scenes::rounded(of_b);
    }
    Query query{Body(a), Body(b)}, with_sheet{Body(scenes::both(a, sheet({5, 5, 5}, 1))), Body(b)};
    const Overlap by_crossings = query.overlap(of_a, of_b), by_cells = with_sheet.overlap(of_a, of_b);
    const tetracone::Overlap_bounds bounds = query.overlap_bounds(of_a, of_b);
    const Rational volume(by_cells.exact_volume());
    BOOST_TEST((bounds.volume[0] <= volume && volume <= bounds.volume[1]), "round " << round);
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational x(by_cells.exact_centroid()[k]);
      BOOST_TEST((bounds.centroid[k][0] <= x && x <= bounds.centroid[k][1]), "round " << round);
    }
    told_apart += bounds.volume[0] < bounds.volume[1];
    BOOST_TEST(by_crossings.exact_volume() == by_cells.exact_volume(), "round " << round);
    BOOST_TEST(by_crossings.exact_centroid() == by_cells.exact_centroid(), "round " << round);
    general += by_crossings.volume > 0;
  }
  BOOST_TEST(general > 20);
  BOOST_TEST(told_apart > 20);  // by intervals
}

BOOST_AUTO_TEST_CASE(what_has_no_solid_or_no_exact_sign_is_refused)
{
  const Body cube(scenes::unit_cube()), open(scenes::without_last_face(scenes::unit_cube()));
  const tetracone::Pose pose;
  BOOST_CHECK_THROW(Query(cube, open), tetracone::Error);
  BOOST_CHECK_THROW(Query(cube, open, tetracone::Question::surface).solid_relation(pose, pose), tetracone::Error);
  BOOST_CHECK_THROW(
      Query(cube, cube, tetracone::Question::solid, {.kernel = tetracone::Kernel::double_}).overlap(pose, pose),
      tetracone::Error);
}

namespace {

constexpr int width = 4;
using Place = std::array<int, 3>;

/// A set of unit cubes of a grid, and unit squares. Counting answers all questions about two of them.
struct Blocks {
  std::bitset<width * width * width> cubes;
  std::vector<std::pair<Place, int>> sheets;  ///< the least corner of a square, and the axis across it
  bool has_walls = false;                     ///< each cube has its own six faces, also within the solid

  static std::size_t number(const Place& p) { return std::size_t((p[0] * width + p[1]) * width + p[2]); }
  bool has(const Place& p) const
  {
    return std::ranges::all_of(p, [](int x) { return x >= 0 && x < width; }) && cubes[number(p)];
  }

  /// Calls what(least corner, axis, number of cubes) for each square of the grid that is part of the surface.
  template <class What>
  void for_faces(const What& what) const
  {
    for (int axis = 0; axis < 3; ++axis)
      for_places([&](Place p) {
        Place before = p;
        --before[axis];
        const bool is_sheet = std::ranges::find(sheets, std::pair(p, axis)) != sheets.end();
        if (has(p) != has(before) || (has_walls && has(p)) || is_sheet) what(p, axis);
      });
  }

  template <class What>
  static void for_places(const What& what)
  {
    for (int x = 0; x <= width; ++x)
      for (int y = 0; y <= width; ++y)
        for (int z = 0; z <= width; ++z) what(Place{x, y, z});
  }

  /// Returns the surface's corners, edges and squares, named by twice their middles.
  std::set<Place> surface() const
  {
    std::set<Place> all;
    for_faces([&](const Place& p, int axis) {
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          Place middle = {2 * p[0], 2 * p[1], 2 * p[2]};
          middle[(axis + 1) % 3] += i;
          middle[(axis + 2) % 3] += j;
          all.insert(middle);
        }
    });
    return all;
  }

  /// Returns the cubes at a corner, edge or square that is named by twice its middle.
  std::vector<Place> cubes_at(const Place& middle) const
  {
    std::vector<Place> all;
    for (int k = 0; k < 8; ++k) {
      Place p;
      bool is_new = true;
      for (int i = 0; i < 3; ++i) {
        const bool is_between = middle[i] % 2 == 0;
        p[i] = middle[i] / 2 - (is_between && (k >> i & 1));
        is_new = is_new && (is_between || !(k >> i & 1));
      }
      if (is_new) all.push_back(p);
    }
    return all;
  }
  bool holds(const Place& middle, const std::set<Place>& own_surface) const
  {
    return own_surface.contains(middle) ||
           std::ranges::any_of(cubes_at(middle), [&](const Place& p) { return has(p); });
  }

  Polyhedron polyhedron(scenes::Random& random) const
  {
    Polyhedron result;
    std::map<Place, Index> numbers;
    const auto corner = [&](Place p, int i, int di, int j, int dj) {
      p[i] += di;
      p[j] += dj;
      const auto [at, is_new] = numbers.emplace(p, Index(result.vertices.size()));
      if (is_new) result.vertices.push_back({double(p[0]), double(p[1]), double(p[2])});
      return at->second;
    };
    const auto add = [&](const Place& p, int axis, bool is_up) {
      const int i = (axis + 1) % 3, j = (axis + 2) % 3;
      std::vector<Index> loop = {corner(p, i, 0, j, 0), corner(p, i, 1, j, 0), corner(p, i, 1, j, 1),
                                 corner(p, i, 0, j, 1)};
      if (!is_up) std::ranges::reverse(loop);
      std::ranges::rotate(loop, loop.begin() + scenes::integer(random, 0, 3));
      if (scenes::integer(random, 0, 1) == 0) {
        result.add_polygon(loop);
      } else {
        result.add_polygon({loop[0], loop[1], loop[2]});
        result.add_polygon({loop[2], loop[3], loop[0]});
      }
    };
    for (int axis = 0; axis < 3; ++axis)
      for_places([&](Place p) {
        Place before = p;
        --before[axis];
        if (has(before) && (has_walls || !has(p))) add(p, axis, true);
        if (has(p) && (has_walls || !has(before))) add(p, axis, false);
        for (const auto& [at, across] : sheets)
          if (at == p && across == axis) {
            add(p, axis, true);
            add(p, axis, false);
          }
      });
    return result;
  }
};

struct Counted {
  Solid_contact contact;
  int volume = 0;
  std::array<int, 3> twice_moment{}, contact_vector{};
  int contact_area = 0;
};

Counted counted(const Blocks& a, const Blocks& b)
{
  const std::set<Place> surface_a = a.surface(), surface_b = b.surface();
  const auto sticks_out = [](const Blocks& one, const std::set<Place>& surface, const Blocks& other,
                             const std::set<Place>& other_surface) {
    return (one.cubes & ~other.cubes).any() ||
           std::ranges::any_of(surface, [&](const Place& middle) { return !other.holds(middle, other_surface); });
  };
  // The border of a solid has a corner where it has a point.
  const auto meets_border = [](const Blocks& one, const std::set<Place>& surface, const Blocks& other,
                               const std::set<Place>& other_surface) {
    bool meets = false;
    Blocks::for_places([&](const Place& p) {
      const Place middle = {2 * p[0], 2 * p[1], 2 * p[2]};
      meets = meets || (one.holds(middle, surface) && other.holds(middle, other_surface) &&
                        !std::ranges::all_of(other.cubes_at(middle), [&](const Place& c) { return other.has(c); }));
    });
    return meets;
  };
  Counted counted{{Solid_relation::disjoint, -1}};
  for (const Place& middle : surface_a)
    if (surface_b.contains(middle))
      counted.contact.dimension = std::max(counted.contact.dimension, middle[0] % 2 + middle[1] % 2 + middle[2] % 2);
  counted.volume = int((a.cubes & b.cubes).count());
  Blocks::for_places([&](const Place& p) {
    if (a.has(p) && b.has(p))
      for (int k = 0; k < 3; ++k) counted.twice_moment[k] += 2 * p[k] + 1;
  });
  a.for_faces([&](const Place& p, int axis) {
    Place middle = {2 * p[0] + 1, 2 * p[1] + 1, 2 * p[2] + 1}, before = p;
    --middle[axis];
    --before[axis];
    if (!surface_b.contains(middle)) return;
    ++counted.contact_area;
    counted.contact_vector[axis] += int(a.has(before)) - int(a.has(p));
  });
  const bool a_out = sticks_out(a, surface_a, b, surface_b), b_out = sticks_out(b, surface_b, a, surface_a);
  using enum Solid_relation;
  counted.contact.relation = !a_out && !b_out     ? equal
                             : !a_out             ? meets_border(a, surface_a, b, surface_b) ? covered_by : inside
                             : !b_out             ? meets_border(b, surface_b, a, surface_a) ? covers : contains
                             : counted.volume > 0 ? overlap
                             : std::ranges::any_of(surface_a, [&](const Place& m) { return b.holds(m, surface_b); })
                                 ? meet
                                 : disjoint;
  return counted;
}

/// Compares volume and centroid with the counts, and the contact where nothing is moved.
void check_overlap(Query& query, const Pose& frame, const Counted& expected)
{
  const Overlap overlap = query.overlap(frame, frame);
  const tetracone::kernel::Rational_map map(frame);
  BOOST_TEST(overlap.exact_volume() == to_string(Rational(expected.volume * abs(map.determinant()))));
  if (expected.volume > 0) {
    tetracone::kernel::Rational_point middle;
    for (int k = 0; k < 3; ++k) middle[k] = Rational(expected.twice_moment[k]) / (2 * expected.volume);
    const auto centroid = map(middle, 1);
    for (int k = 0; k < 3; ++k) BOOST_TEST(overlap.exact_centroid()[k] == to_string(centroid[k]));
  }
  if (!frame.is_identity()) return;
  for (int k = 0; k < 3; ++k) BOOST_TEST(overlap.contact_vector[k] == expected.contact_vector[k]);
  for (const double bound : overlap.contact_area) BOOST_TEST(bound == expected.contact_area);
}

Blocks random_blocks(scenes::Random& random)
{
  Blocks blocks;
  Place low, high;
  for (int k = 0; k < 3; ++k) {
    low[k] = scenes::integer(random, 0, width - 1);
    high[k] = scenes::integer(random, low[k], width - 1);
  }
  const int share = scenes::integer(random, 0, 2);  // all of a box, most of it, or half
  Blocks::for_places([&](const Place& p) {
    for (int k = 0; k < 3; ++k)
      if (p[k] < low[k] || p[k] > high[k]) return;
    blocks.cubes[Blocks::number(p)] = share == 0 || scenes::integer(random, 0, 6) < (share == 1 ? 6 : 3);
  });
  blocks.has_walls = scenes::integer(random, 0, 4) == 0;
  for (int k = scenes::integer(random, -6, 2); k > 0 || (k == 0 && blocks.cubes.none()); --k)
    blocks.sheets.push_back(
        {{scenes::integer(random, 0, 3), scenes::integer(random, 0, 3), scenes::integer(random, 0, 3)},
         scenes::integer(random, 0, 2)});
  if (blocks.cubes.none() && blocks.sheets.empty()) blocks.cubes[0] = true;
  return blocks;
}

/// Takes from `inner` all that is at the grid's border, and makes `outer` all of the grid, but for its sheets.
void lie_within(Blocks& inner, Blocks& outer)
{
  inner.sheets.clear();
  Blocks::for_places([&](const Place& p) {
    if (std::ranges::any_of(p, [](int x) { return x == 0 || x == width - 1; }) &&
        std::ranges::all_of(p, [](int x) { return x < width; }))
      inner.cubes[Blocks::number(p)] = false;
  });
  if (inner.cubes.none()) inner.cubes[Blocks::number({1, 2, 1})] = true;
  outer.cubes.set();
}

}  // namespace

BOOST_AUTO_TEST_CASE(blocks_stand_as_counting_says_in_every_frame)
{
  scenes::Random random(46);
  std::map<Solid_relation, int> seen;
  for (int round = 0; round < 280; ++round) {
    Blocks a = random_blocks(random), b = random_blocks(random);
    const int kind = scenes::integer(random, 0, 8);
    if (kind == 0) b.cubes = a.cubes;
    if (kind == 1) b.cubes |= a.cubes;
    if (kind == 2) b.cubes.set();
    if (kind == 3) b.cubes = ~a.cubes;
    if (kind == 4) lie_within(a, b);
    if (kind == 5) lie_within(b, a);
    if (b.cubes.none() && b.sheets.empty()) b.cubes[0] = true;
    const Counted expected = counted(a, b);
    ++seen[expected.contact.relation];
    const Pose frame = round % 3 == 0 ? Pose()
                       : round % 3 == 1
                           ? scenes::random_affine(random)
                           : scenes::random_rotation(random, 5, {Rational(7, 3), Rational(1, 7), Rational(-5, 2)});
    Query query{Body(a.polyhedron(random)), Body(b.polyhedron(random))};
    BOOST_TEST_CONTEXT("round " << round)
    {
      BOOST_TEST(text(query.solid_relation(frame, frame)) == text(expected.contact));
      BOOST_TEST(query.solid_relation_alone(frame, frame) == expected.contact.relation);
      check_overlap(query, frame, expected);
    }
  }
  BOOST_TEST(seen.size() == 8);
  for (const auto& [relation, count] : seen) BOOST_TEST(count >= 5, relation << " " << count);
}

BOOST_AUTO_TEST_SUITE_END()
