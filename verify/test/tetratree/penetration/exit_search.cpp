#include "tetracone/tetratree/penetration/exit_search.h"

#include "tetracone/kernel/contact/direction_view.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <string>

BOOST_AUTO_TEST_SUITE(test_exit_search)

namespace scenes = tetracone::verify::scenes;
using namespace tetracone;
using namespace tetracone::kernel;
using kernel::Pose;

namespace {

using Direction = std::array<std::string, 3>;

const Direction along_x = {"1", "0", "0"}, along_y = {"0", "1", "0"}, along_z = {"0", "0", "1"},
                down = {"0", "0", "-1"};

/// Returns "first last".
std::string text_of(const Polyhedron& a, const Polyhedron& b, const Direction& direction, const Pose& pose_a = Pose(),
                    const Pose& pose_b = Pose())
{
  const Exits exits = Query(Body(a), Body(b)).exits(pose_a, pose_b, direction);
  return exits.exact_first + ' ' + exits.exact_last;
}

/// A block with a square hole through it, from z = 0 to 4.
Polyhedron block_with_hole()
{
  Polyhedron block = scenes::both(scenes::box({-2, -2, 0}, {2, -1, 4}), scenes::box({-2, 1, 0}, {2, 2, 4}));
  append(block, scenes::box({-2, -1, 0}, {-1, 1, 4}));
  append(block, scenes::box({1, -1, 0}, {2, 1, 4}));
  return block;
}

}  // namespace

BOOST_AUTO_TEST_CASE(boxes_leave_each_other_after_what_they_overlap)
{
  const Polyhedron unit = scenes::unit_cube();
  BOOST_TEST(text_of(unit, unit, along_x) == "1 1");
  BOOST_TEST(text_of(unit, unit, {"-2", "0", "0"}) == "1/2 1/2");
  BOOST_TEST(text_of(unit, unit, {"1", "1", "0"}) == "1 1");
  BOOST_TEST(text_of(unit, unit, {"1/3", "1/7", "0"}) == "3 3");
  BOOST_TEST(text_of(unit, scenes::box({0.25, 0.25, 0.25}, {5, 0.5, 0.5}), along_x) == "5 5");
  BOOST_TEST(text_of(unit, scenes::box({0.25, 0.25, 0.25}, {5, 0.5, 0.5}), along_y) == "1/2 1/2");
}

BOOST_AUTO_TEST_CASE(solids_whose_interiors_share_no_point_have_left)
{
  const Polyhedron unit = scenes::unit_cube();
  for (const Direction& direction : {along_x, Direction{"-1", "0", "0"}, along_z}) {
    BOOST_TEST(text_of(unit, unit, direction, Pose(), scenes::translation(1, 0, 0)) == "0 0");
    BOOST_TEST(text_of(unit, unit, direction, Pose(), scenes::translation(3, 0.5, 0)) == "0 0");
  }
  BOOST_TEST(text_of(scenes::cube(1), scenes::cube_with_cavity(), along_x) == "0 0");
}

BOOST_AUTO_TEST_CASE(a_peg_of_exact_fit_leaves_its_hole)
{
  const Polyhedron block = block_with_hole(), peg = scenes::box({-1, -1, -0.5}, {1, 1, 8});
  BOOST_TEST(text_of(peg, block, along_z) == "0 0");
  // A head on the peg is pressed into the block by a quarter.
  const Polyhedron bolt = scenes::both(peg, scenes::box({-1.5, -1.5, 3.75}, {1.5, 1.5, 6}));
  BOOST_TEST(text_of(bolt, block, along_z) == "1/4 1/4");
  BOOST_TEST(text_of(block, bolt, down) == "1/4 1/4");
  BOOST_TEST(text_of(bolt, block, down) == "6 6");
  BOOST_TEST(text_of(bolt, block, along_x) == "7/2 7/2");
  // Wider by an ulp, it must go all the way.
  const double wide = std::nextafter(1.0, 2.0);
  BOOST_TEST(text_of(scenes::box({-1, -1, -0.5}, {wide, 1, 8}), block, along_z) == "9/2 9/2");
}

BOOST_AUTO_TEST_CASE(a_comb_is_met_again_at_each_tooth)
{
  Polyhedron comb;
  for (int k = 0; k < 5; ++k) append(comb, scenes::box({3.0 * k, 0, 0}, {3.0 * k + 1, 1, 1}));
  const Polyhedron tooth = scenes::box({0.25, 0.25, 0.25}, {1.25, 0.5, 0.5}), thick = scenes::box({0, 0, 0}, {2, 1, 1});
  BOOST_TEST(text_of(tooth, comb, along_x) == "3/4 51/4");
  BOOST_TEST(text_of(tooth, comb, {"-1", "0", "0"}) == "5/4 5/4");
  // A tooth as wide as the gaps touches both sides of one: for an instant the interiors share no point.
  BOOST_TEST(text_of(thick, comb, along_x) == "1 13");
  BOOST_TEST(text_of(scenes::box({0, 0, 0}, {std::nextafter(2.0, 3.0), 1, 1}), comb, along_x) == "13 13");
}

BOOST_AUTO_TEST_CASE(gaps_between_turned_teeth_are_not_skipped)
{
  // Pointed teeth, so that faces go through each other, and rounded numbers tell where. The closest are met at once,
  // the next after a gap that boxes do not see.
  const auto tooth_at = [](double x) {
    return scenes::tetrahedron({x, 0, 0}, {x + 1, 0.25, 0.125}, {x + 0.25, 1, 0}, {x + 0.5, 0.25, 1});
  };
  const Body tooth(scenes::tetrahedron({0, 0.125, 0}, {1, 0.25, 0.25}, {0.125, 0.75, 0.125}, {0.25, 0.25, 1}));
  const Direction along = {"1", "1/100", "1/50"};
  const Exits alone = Query(tooth, Body(tooth_at(0))).exits(Pose(), Pose(), along);
  const Rational left(alone.exact_first);
  const auto [moved, unmoved] =
      tetracone::kernel::moved_along(Pose(), Pose(), {Rational(1), Rational(1) / 100, Rational(1) / 50}, left);
  int gaps = 0;
  for (int k = 0; k <= 64; ++k) {
    const double step = 0.75 + k / 32.0;
    Polyhedron comb = tooth_at(0);
    for (int t = 1; t < 4; ++t) append(comb, tooth_at(step * t));
    Query query(tooth, Body(comb));
    const Exits all = query.exits(Pose(), Pose(), along);
    // Where no other tooth is met when the first is left, it is left as if it were alone.
    const auto relation = query.solid_relation_alone(moved, unmoved);
    const bool is_gap = relation == tetracone::Solid_relation::disjoint || relation == tetracone::Solid_relation::meet;
    gaps += is_gap;
    BOOST_TEST((all.exact_first == alone.exact_first) == is_gap, step);
    BOOST_TEST(all.last > 3 * step);
  }
  BOOST_TEST(gaps > 20);
  BOOST_TEST(gaps < 60);
}

BOOST_AUTO_TEST_CASE(a_body_inside_goes_through_cavities_and_walls)
{
  const Polyhedron hollow = scenes::cube_with_cavity(), small = scenes::cube(0.5);
  // From within the wall to the cavity; the other wall is met again.
  BOOST_TEST(text_of(small, hollow, along_x, scenes::translation(-2.25, 0, 0)) == "3/4 23/4");
  BOOST_TEST(text_of(scenes::cube(0.5), scenes::cube(3), along_x) == "7/2 7/2");
  BOOST_TEST(text_of(scenes::cube(3), scenes::cube(0.5), along_x) == "7/2 7/2");
}

BOOST_AUTO_TEST_CASE(sheets_are_no_solid_and_membranes_no_border)
{
  // Two squares of opposite directions beyond the cube: no point of them is inside.
  Polyhedron with_sheet = scenes::unit_cube();
  const Index first = Index(with_sheet.vertices.size());
  for (const Vertex& v : {Vertex{5, 0, 0}, Vertex{5, 1, 0}, Vertex{5, 1, 1}, Vertex{5, 0, 1}})
    with_sheet.vertices.push_back(v);
  with_sheet.add_polygon({first, first + 1, first + 2, first + 3});
  with_sheet.add_polygon({first + 3, first + 2, first + 1, first});
  BOOST_TEST(text_of(scenes::unit_cube(), with_sheet, along_x) == "1 1");
  BOOST_TEST(text_of(with_sheet, scenes::unit_cube(), along_x) == "1 1");
  // Two boxes share a wall, which lies in the inside of both together; and two overlap.
  const Polyhedron two = scenes::both(scenes::unit_cube(), scenes::box({1, 0, 0}, {2, 1, 1})),
                   crossed = scenes::both(scenes::box({0, 0, 0}, {3, 1, 1}), scenes::box({1, -1, 0}, {2, 2, 1}));
  BOOST_TEST(text_of(scenes::unit_cube(), two, along_x) == "2 2");
  BOOST_TEST(text_of(two, two, along_x) == "2 2");
  BOOST_TEST(text_of(crossed, crossed, along_x) == "3 3");
  BOOST_TEST(text_of(crossed, crossed, along_y) == "3 3");
}

BOOST_AUTO_TEST_CASE(faces_with_holes_and_shuffled_triangles_give_the_same_exits)
{
  const Polyhedron frame = scenes::cube_with_tunnel(), bar = scenes::box({-0.25, -0.25, -9}, {0.25, 0.25, 9});
  scenes::Random random(3);
  for (int round = 0; round < 6; ++round) {
    const Pose pose = scenes::random_rotation(random, 3);
    const Direction d = {std::to_string(scenes::integer(random, -3, 3)), std::to_string(scenes::integer(random, -3, 3)),
                         "5/3"};
    const std::string exits = text_of(bar, frame, d, pose);
    BOOST_TEST(text_of(scenes::triangulated(bar), frame, d, pose) == exits);
    BOOST_TEST(text_of(scenes::shuffled(bar, random), scenes::shuffled(frame, random), d, pose) == exits);
    BOOST_TEST(
        text_of(frame, bar,
                {d[0][0] == '-' ? d[0].substr(1) : "-" + d[0], d[1][0] == '-' ? d[1].substr(1) : "-" + d[1], "-5/3"},
                Pose(), pose) == exits);
  }
}

BOOST_AUTO_TEST_CASE(round_bodies_leave_where_their_relation_says)
{
  scenes::Random random(11);
  for (int round = 0; round < 8; ++round) {
    const Body a(scenes::blob(random, 5, 0.5, 1)), b(scenes::triangulated(scenes::torus(9, 7)));
    const Pose pose_a = scenes::random_rotation(random, 4, {Rational(1, 3), Rational(round) / 9, 0}),
               pose_b = scenes::random_rotation(random);
    const std::array<Rational, 3> d = {Rational(1, 2), Rational(round - 4) / 3, 1};
    Query query(a, b);
    const Exits exits = query.exits(pose_a, pose_b, {d[0].get_str(), d[1].get_str(), d[2].get_str()});
    const auto meet = [&](const Rational& s) {
      const auto [moved, unmoved] = tetracone::kernel::moved_along(pose_a, pose_b, d, s);
      const auto relation = query.solid_relation_alone(moved, unmoved);
      return relation != tetracone::Solid_relation::disjoint && relation != tetracone::Solid_relation::meet;
    };
    const Rational first(exits.exact_first), last(exits.exact_last), almost(999999, 1000000);
    BOOST_TEST((first > 0) == meet(0));
    if (first == 0) continue;
    BOOST_TEST(!meet(first));
    BOOST_TEST(!meet(last));
    for (int k = 0; k < 8; ++k) BOOST_TEST(meet(first * k / 8));
    BOOST_TEST(meet(first * almost));
    BOOST_TEST(meet(last * almost));
    for (int k = 1; k < 4; ++k) BOOST_TEST(!meet(last * (1 + Rational(k) / 4)));
  }
}

BOOST_AUTO_TEST_CASE(numbers_of_any_size_are_exact)
{
  const double tiny = 0x1p-1070, large = 0x1p1000;
  BOOST_TEST(text_of(scenes::cube(tiny), scenes::cube(tiny), along_x) ==
             Rational(Rational(tiny) * 2).get_str() + ' ' + Rational(Rational(tiny) * 2).get_str());
  const std::string most = Rational(Rational(large) * 2).get_str();
  BOOST_TEST(text_of(scenes::cube(large), scenes::cube(large), along_z) == most + ' ' + most);
  // A speck in a large cube, and a step beyond the doubles.
  const Polyhedron largest = scenes::cube(0x1.fp1022);
  const Exits exits = Query(Body(largest), Body(largest)).exits(Pose(), Pose(), {"1e-308", "0", "0"});
  BOOST_TEST(Rational(exits.exact_first) == Rational(Rational(0x1.fp1023) / Rational(1e-308)));
  BOOST_TEST(std::isinf(exits.first));
  BOOST_TEST(text_of(scenes::cube(tiny), scenes::cube(1), along_x) ==
             Rational(1 + Rational(tiny)).get_str() + ' ' + Rational(1 + Rational(tiny)).get_str());
}

BOOST_AUTO_TEST_CASE(a_query_forgets_the_view_of_the_last_pose)
{
  Polyhedron tetrahedron;
  tetrahedron.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}};
  for (const auto& face : {std::array<Index, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
    tetrahedron.add_polygon(face);
  Query query{Body(tetrahedron), Body(tetrahedron)};
  for (const Direction& direction : {along_x, Direction{"1/3", "1", "-1/7"}, along_z})
    for (const Pose& pose : {Pose(), Pose::from_quaternion(3, 1, 2, 5, {0, 0, 0}), scenes::translation(0.5, 0.25, 0)}) {
      const Exits exits = query.exits(pose, Pose(), direction);
      BOOST_TEST(exits.exact_first + ' ' + exits.exact_last == text_of(tetrahedron, tetrahedron, direction, pose));
    }
}

BOOST_AUTO_TEST_CASE(what_is_no_direction_is_refused)
{
  Query query{Body(scenes::unit_cube()), Body(scenes::unit_cube())};
  const Pose pose;
  for (const Direction& none : {Direction{"0", "0", "-0.0"}, Direction{"1", "nan", "0"}, Direction{"1", "0", "1/0"},
                                Direction{"inf", "0", "0"}, Direction{"", "0", "1"}})
    BOOST_CHECK_THROW(query.exits(pose, pose, none), Error);
  Query surface(Body(scenes::unit_cube()), Body(scenes::unit_cube()), tetracone::Question::surface);
  BOOST_CHECK_THROW(surface.exits(pose, pose, along_x), Error);
}

BOOST_AUTO_TEST_SUITE_END()
