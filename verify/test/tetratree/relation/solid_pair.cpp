#include "tetracone/tetratree/relation/solid_pair.h"

#include "tetracone/covering/model.h"
#include "tetracone/covering/star_faces.h"
#include "tetracone/kernel/contact/face_cells.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/query/bvh8_contacts.h"
#include "tetracone/tetratree/relation/simple_relation.h"
#include "tetracone/tetratree/relation/solid_sides.h"
#include "verify/cases/lego.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_solid_pair)

namespace scenes = tetracone::verify::scenes;
using namespace tetracone;
using namespace tetracone::kernel;
using kernel::Pose;

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

BOOST_AUTO_TEST_CASE(a_vertex_touches_where_a_cell_is_looked_at)
{
  const Polyhedron corner = scenes::tetrahedron({0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {0, 0, 2});
  // The origin, from which volumes are summed, is off the plane.
  const Rational_point a = {0, 0, 1}, b = {1, 0, 1}, c = {0, 1, 1};
  const Rational_face bottom({{a, b}, {b, c}, {c, a}});
  const Face_cells cells(bottom, {});
  BOOST_REQUIRE(cells.size() > 0u);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Rational_point at = cells.inner_point(k);
    const double x = at[0].get_d(), y = at[1].get_d();
    for (const double z : {0.0625, -0.0625}) {
      const Polyhedron needle = scenes::tetrahedron({x, y, 1}, {x - 0.0625, y - 0.03125, 1 + z},
                                                    {x + 0.0625, y - 0.03125, 1 + z}, {x, y + 0.0625, 1 + z});
      BOOST_TEST(text_of(corner, needle) == (z > 0 ? "covers 0" : "meet 0"));
      for (const bool swapped : {false, true}) {
        Query query(Body(swapped ? needle : corner), Body(swapped ? corner : needle));
        BOOST_TEST(query.overlap(Pose(), Pose()).exact_volume() == (z > 0 ? "1/8192" : "0"));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(signs_tell_the_relation_that_cells_tell)
{
  // A face that is a point, at a vertex, adds nothing; but the body is not simple then, and cells decide.
  const auto by_cells = [](Polyhedron body) {
    body.add_polygon({0, 0});
    return Body(body);
  };
  const Polyhedron corner = scenes::prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);
  const std::vector<Polyhedron> shapes = {scenes::unit_cube(),
                                          scenes::triangulated(scenes::cube(1)),
                                          scenes::cube_with_cavity(),
                                          scenes::star_prism(),
                                          scenes::cube_with_tunnel(),
                                          corner,
                                          scenes::turned(corner),
                                          scenes::tetrahedron({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}),
                                          scenes::tetrahedron({0, 0, 0}, {2, 0, 0}, {1, 1, 1}, {1, -1, 1})};
  scenes::Random random(7);
  std::map<std::string, int> met;
  for (std::size_t k = 0; k < 2 * shapes.size() * shapes.size(); ++k) {
    const Polyhedron &a = shapes[k % shapes.size()], &b = shapes[k / shapes.size() % shapes.size()];
    Query by_signs{Body(a), Body(b)};
    Query others{by_cells(a), by_cells(b)};
    for (int pose = 0; pose < 6; ++pose) {
      // Half turns about axes, mirrored or not, and swaps of axes keep many faces in common planes.
      std::array<Rational, 12> m{};
      const int first = scenes::integer(random, 0, 2), step = scenes::integer(random, 1, 2);
      for (int i = 0; i < 3; ++i) {
        m[std::size_t(4 * i + (first + i * step) % 3)] = scenes::integer(random, 0, 1) == 0 ? 1 : -1;
        m[std::size_t(4 * i + 3)] = Rational(scenes::integer(random, -4, 4)) / 2;
      }
      const Pose unmoved, moved = pose == 0 ? unmoved : Pose(m);
      const Solid_contact told = by_signs.solid_relation(moved, unmoved);
      BOOST_TEST_CONTEXT("shapes " << k % shapes.size() << " and " << k / shapes.size() % shapes.size() << ", pose "
                                   << pose)
      {
        BOOST_TEST((told.relation == others.solid_relation_alone(moved, unmoved)));
        BOOST_TEST((by_signs.solid_relation_alone(moved, unmoved) == told.relation));
      }
      ++met[text(told)];
    }
  }
  for (const char* relation : {"disjoint -1", "meet 0", "meet 1", "meet 2", "overlap 1", "overlap 2", "equal 2",
                               "inside -1", "contains -1", "covered_by 2", "covers 2"})
    BOOST_TEST(met[relation] > 0, relation << " was not met");
}

BOOST_AUTO_TEST_CASE(signs_decide_plates_in_flat_contact)
{
  namespace lego = verify::lego;
  // A body of cells, in large faces or in squares, of triangles.
  struct Signed_body {
    Signed_body(const lego::Cells& cells, double merged, verify::Random& random)
        : bricks{{cells}},
          body(scenes::triangulated(
              lego::solid(bricks, {.merged = merged, .is_one_mesh = true, .is_straight = merged == 1}, random))),
          tree(body, covering::star_faces(body)),
          sides(tree, body),
          placed(tree.model())
    {}
    Signed_body(const Signed_body&) = delete;

    lego::Bricks bricks;
    Polyhedron body;
    tetratree::Bvh8 tree;
    tetratree::Solid_sides sides;
    covering::Placed_model<Adaptive> placed;
  };
  verify::Random random(11);
  lego::Cells plate = lego::block({0, 0, 0}, {6, 6, 1}), lid = plate;
  std::erase_if(plate, [](const lego::Cell& cell) { return cell[0] % 3 == 1 && cell[1] % 3 == 1; });
  std::map<std::string, int> met;
  for (const auto& [cells_a, cells_b] : {std::pair(plate, plate), {plate, lid}, {lid, plate}})
    for (const double merged_b : {0.0, 1.0}) {
      Signed_body a(cells_a, 0, random), b(cells_b, cells_b == plate ? 0 : merged_b, random);
      BOOST_TEST_REQUIRE((a.sides.is_simple() && b.sides.is_simple()));
      tetratree::Bvh8_contacts<> finder(a.tree, a.tree.model(), a.body, b.tree, b.tree.model(), b.body);
      tetratree::Simple_relation by_signs({&a.body, &a.sides, &a.placed}, {&b.body, &b.sides, &b.placed});
      for (const lego::Cell& offset :
           {lego::Cell{0, 0, 0}, {0, 0, 2}, {1, 0, 2}, {1, 1, -2}, {6, 6, 0}, {6, 0, 0}, {12, 3, 0}})
        for (const int mirror : {1, -1}) {
          const auto at = [&](const lego::Cell& halves) {
            std::array<Rational, 12> m{};
            for (std::size_t k = 0; k < 3; ++k) {
              m[5 * k] = k == 0 ? mirror : 1;
              m[4 * k + 3] = m[5 * k] * halves[k] / 2;
            }
            return Pose(m);
          };
          const std::array<Pose, 2> pose = {at({0, 0, 0}), at(offset)};
          a.placed.place(pose[0]);
          b.placed.place(pose[1]);
          const auto is_vertex_inside = [&](int of, Index v) {
            Vertex x = (of == 0 ? a : b).body.vertices[v];
            for (std::size_t k = 0; k < 3; ++k) x[k] += (of == 0 ? -0.5 : 0.5) * offset[k];
            return Body((of == 0 ? b : a).body).inside({x[0], x[1], x[2]}) == covering::Location::inside;
          };
          const auto relation = by_signs(finder.contacts(pose[0], pose[1]), is_vertex_inside);
          BOOST_TEST_REQUIRE(relation.has_value());
          BOOST_TEST((*relation == lego::overlap(a.bricks, b.bricks, offset).contact.relation));
          ++met[std::string(to_string(*relation))];
        }
    }
  for (const char* relation : {"meet", "overlap", "equal", "covered_by", "covers"}) BOOST_TEST(met[relation] > 0);
}

BOOST_AUTO_TEST_CASE(a_membrane_is_no_border)
{
  // The winding number is 2 within the inner cube, and 1 about it.
  const Polyhedron nested = scenes::both(scenes::cube(3), scenes::cube(2));
  BOOST_TEST(text_of(nested, scenes::cube(3)) == "equal 2");
  BOOST_TEST(text_of(scenes::box({1, 1, 1}, {2.5, 2.5, 2.5}), nested) == "inside 1");
  const Polyhedron glued = scenes::both(scenes::unit_cube(), box_at({1, 0, 0}, {1, 1, 1}));
  BOOST_TEST(text_of(glued, box_at({0, 0, 0}, {2, 1, 1})) == "equal 2");
  BOOST_TEST(text_of(box_at({0.5, 0.25, 0}, {0.5, 0.5, 0.5}), glued) == "covered_by 2");
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

BOOST_AUTO_TEST_CASE(an_overlap_of_solids_that_touch_is_that_of_the_cells)
{
  // A sheet far away makes a body that is not simple, so that cells are asked.
  const auto on_grid = [](double x) { return std::round(64 * x) / 64; };
  std::vector<std::array<double, 2>> star;
  for (int k = 0; k < 10; ++k) {
    const double angle = 2 * M_PI * k / 10, radius = k % 2 == 0 ? 2 : 1.25;
    star.push_back({on_grid(radius * std::cos(angle)), on_grid(radius * std::sin(angle))});
  }
  const std::vector<Polyhedron> bodies = {
      scenes::box({-1, -1, 0}, {1, 1, 2}),
      scenes::prism(star, 2),
      scenes::tetrahedron({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}),
      scenes::tetrahedron({1, 0, 0}, {-1, 0, 0}, {0, 1, 2}, {0, -1, 2}),
      scenes::triangulated(scenes::torus(4, 3)),
      scenes::cube_with_tunnel(),
  };
  scenes::Random random(9);
  int overlapping = 0, touching = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const Body a(bodies[i]), with_sheet(scenes::both(bodies[i], sheet({50, 50, 50}, 1)));
      for (const Vertex& shift : {Vertex{0, 0, 0}, {0.5, 0, 0}, {0, 0, 2}, {-2, 0, 0}, {0.25, 0.5, 0}, {0, 1, 1}}) {
        const Body b(scenes::moved(bodies[j], 1, shift));
        const Pose frame = scenes::random_affine(random, 2);
        const Overlap by_limit = Query(a, b).overlap(frame, frame),
                      by_cells = Query(with_sheet, b).overlap(frame, frame);
        const std::string name = std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(shift[0]);
        BOOST_TEST(by_limit.exact_volume() == by_cells.exact_volume(), name);
        BOOST_TEST(by_limit.exact_centroid() == by_cells.exact_centroid(), name);
        BOOST_TEST(by_limit.exact_contact_vector() == by_cells.exact_contact_vector(), name);
        BOOST_TEST(by_limit.contact_area == by_cells.contact_area, name);
        overlapping += by_limit.volume > 0;
        touching += by_limit.contact_area[1] > 0;
      }
    }
  BOOST_TEST(overlapping > 50);
  BOOST_TEST(touching > 40);
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

namespace lego = tetracone::verify::lego;

int below(tetracone::verify::Random& random, int n) { return int(random.bits() % std::uint64_t(n)); }

/// All cells of a block, most of them or half.
lego::Cells any_cells(tetracone::verify::Random& random)
{
  lego::Cell low, high;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = below(random, 3);
    high[k] = low[k] + 1 + below(random, 3 - low[k]);
  }
  lego::Cells cells = lego::block(low, high);
  const int kept = 3 + below(random, 3);  // of 5
  std::erase_if(cells, [&](const lego::Cell& cell) { return cell != low && below(random, 5) >= kept; });
  return cells;
}

/// Cells, at times with others that share walls with them, or with walls alone.
lego::Bricks any_bricks(tetracone::verify::Random& random)
{
  lego::Bricks bricks = {{any_cells(random)}};
  if (below(random, 3) == 0) bricks.push_back({any_cells(random)});
  if (below(random, 3) == 0)
    for (const int turn : {1, -1}) bricks.push_back({lego::block({3, 0, 0}, {4, 1, 1}), turn});
  return bricks;
}

}  // namespace

BOOST_AUTO_TEST_CASE(bricks_stand_as_counting_says_in_every_frame)
{
  tetracone::verify::Random random(46);
  scenes::Random of_frames(46);
  std::map<Solid_relation, int> seen;
  for (int round = 0; round < 280; ++round) {
    lego::Bricks a = any_bricks(random), b = any_bricks(random);
    lego::Cell offset{below(random, 3), 0, below(random, 3)};
    const int kind = below(random, 8);
    if (kind < 5) offset = {0, 0, 0};
    if (kind == 0) b = a;
    if (kind == 1) b.insert(b.end(), a.begin(), a.end());
    if (kind == 2) a.insert(a.end(), b.begin(), b.end());
    if (kind == 3) b = {{lego::block({-1, -1, -1}, {4, 4, 4})}};
    if (kind == 4) a = {{lego::block({-1, -1, -1}, {4, 4, 4})}};
    const tetracone::verify::Solid_overlap expected = lego::overlap(a, b, offset);
    ++seen[expected.contact.relation];
    const Pose frame = round % 3 == 0 ? Pose()
                       : round % 3 == 1
                           ? scenes::random_affine(of_frames)
                           : scenes::random_rotation(of_frames, 5, {Rational(7, 3), Rational(1, 7), Rational(-5, 2)});
    const Pose of_b = scenes::composed(frame, scenes::translation(offset[0] / 2.0, 0, offset[2] / 2.0));
    const auto body = [&](const lego::Bricks& bricks) {
      return Body(lego::solid(bricks, {random.unit(), random.unit(), round % 2 == 0, round % 5 == 0}, random));
    };
    Query query{body(a), body(b)};
    BOOST_TEST_CONTEXT("round " << round)
    {
      BOOST_TEST(text(query.solid_relation(frame, of_b)) == text(expected.contact));
      BOOST_TEST(query.solid_relation_alone(frame, of_b) == expected.contact.relation);
      const Overlap overlap = query.overlap(frame, of_b);
      const tetracone::kernel::Rational_map map(frame);
      BOOST_TEST(overlap.exact_volume() == to_string(Rational(expected.volume * abs(map.determinant()))));
      if (expected.volume == 0) continue;
      const auto centroid = map(expected.centroid, 1);
      for (std::size_t k = 0; k < 3; ++k) BOOST_TEST(overlap.exact_centroid()[k] == to_string(centroid[k]));
    }
  }
  BOOST_TEST(seen.size() == 8);
  for (const auto& [relation, count] : seen) BOOST_TEST(count >= 5, relation << " " << count);
}

BOOST_AUTO_TEST_SUITE_END()
