#include "tetracone/tetratree/door/tetracone.h"

#include "tetracone/covering/io/write.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/repair.h"
#include "verify/test/support/keep_environment.h"
#include "verify/test/support/said.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tetracone)

namespace scenes = tetracone::verify::scenes;
using namespace tetracone;
using verify::said;

namespace {

Polyhedron open_box() { return scenes::without_last_face(scenes::unit_cube()); }

Polyhedron with_corner(double x)
{
  Polyhedron p = scenes::unit_cube();
  p.vertices[7][0] = x;
  return p;
}

Polyhedron naming(std::uint32_t vertex)
{
  Polyhedron p = scenes::unit_cube();
  p.add_polygon({0, 1, vertex});
  return p;
}

Pose turned(const std::array<double, 9>& m)
{
  return Pose(std::array<double, 12>{m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8], 0});
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_misuse_has_its_line)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Body box(scenes::unit_cube()), open(open_box());
  const std::vector<Pose> two(2), three(3);
  Query query(box, box), moved_from(box, box);
  const Query moved_to = std::move(moved_from);
  const auto is = [](const std::string& line, const std::string& expected) { BOOST_TEST(line == expected); };

  const std::string is_open =
      " is open at 4 edges, first at the edge from vertex 4 to 5; expected a closed surface for ";
  is(said([&] { Query(open, box); }), "query: body a" + is_open + "Question::solid");
  is(said([&] { Query(box, open); }), "query: body b" + is_open + "Question::solid");
  is(said([&] { Query(open, open, Question::surface); }), "");
  is(said([&] {
       turned({1, 0, 0, 0, 1, 0, 1, 1, 0});
     }),
     "pose: the 3x3 part has determinant 0; expected a matrix that flattens nothing");
  is(said([&] { turned({1, 0, 0, 0, nan, 0, 0, 0, 1}); }), "pose: entry 6 of 12 is nan; expected a finite number");
  is(said([&] { Pose::translation(0, 0, HUGE_VAL); }), "pose: entry 12 of 12 is inf; expected a finite number");
  is(said([&] {
       Pose::from_text({"1", "0", "0", "1/0", "0", "1", "0", "0", "0", "0", "1", "0"});
     }),
     "pose: entry 4 of 12 is '1/0'; expected a finite decimal number or a fraction n/d");
  is(said([&] { Body{Polyhedron()}; }), "body: no face; expected a body with faces");
  is(said([&] { Body{with_corner(nan)}; }), "body: vertex 7 has the coordinate nan; expected finite coordinates");
  is(said([&] { Body{naming(8)}; }),
     "body: face 6 names vertex 8 of 8 vertices; expected numbers from 0 to 8, the last excluded");
  is(said([&] { Body{with_corner(1.5)}; }).substr(0, 48), "body: face 1 has a corner 0.4472135954999579 off");
  is(said([&] { moved_from.collide(Pose(), Pose()); }), "query: moved from; expected one that still has its bodies");
  is(said([&] { query.collide(two, three); }), "query: 2 poses of a and 3 of b; expected as many, or one of either");
  is(said([&] { tetracone::read_body("no such file.off"); }),
     "no such file.off: no such file; expected a file to read");
  const verify::Temporary_file bent("bent.off",
                                    "OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n4 0 1 2 3\n3 0 2 1\n3 0 3 2\n3 0 1 3\n");
  const std::string line = said([&] { tetracone::read_body(bent.path()); });
  BOOST_TEST(line.find("bent.off: face 0 has a corner ") != std::string::npos, line);
  BOOST_TEST(verify::not_refused<Error>([&] { query.collide(Pose(), Pose()); }) == 0);
  is(said([&] { moved_from.collide(std::vector<Pose>(), std::vector<Pose>()); }),
     "query: moved from; expected one that still has its bodies");
  // Numbers would be read wrongly, too.
  const verify::Temporary_file whole("whole.off", covering::write_off(scenes::unit_cube()));
  const std::array<double, 12> rows = Pose().rows();
  std::array<std::string, 12> texts;
  for (std::size_t k = 0; k < 12; ++k) texts[k] = kernel::shortest(rows[k]);
  BOOST_TEST(verify::not_refused<Error>([&] { tetracone::read_body(whole.path()); }) == 0);
  BOOST_TEST(verify::not_refused<Error>([&] { Body(scenes::unit_cube()); }) == 0);
  BOOST_TEST(verify::not_refused<Error>([&] { Pose{rows}; }) == 0);
  BOOST_TEST(verify::not_refused<Error>([&] { Pose::from_text(texts); }) == 0);
}

BOOST_AUTO_TEST_CASE(bodies_and_poses_may_be_temporaries_copies_and_moved_from)
{
  Body kept(scenes::unit_cube());
  const Body taken = std::move(kept);
  Query query(kept, Body(scenes::cube(0.25)));  // what was moved from is a copy still, what was temporary is shared
  BOOST_TEST(bool(query.collide(Pose(), Pose::translation(0, 0, 0))));
  std::vector<Query> queries;
  for (int k = 0; k < 20; ++k) queries.emplace_back(taken, Body(scenes::cube(0.25)));
  for (Query& q : queries) BOOST_TEST(bool(q.collide(Pose(), Pose())));
  Pose pose = Pose::translation(1, 2, 3);
  const Pose copy = pose;
  pose = Pose();
  BOOST_TEST((copy.rows() == std::array<double, 12>{1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3}));
  BOOST_TEST((pose.rows() == Pose().rows()));
  static_assert(std::is_copy_constructible_v<Body> && !std::is_copy_constructible_v<Query>);
}

BOOST_AUTO_TEST_CASE(an_answer_says_how_the_bodies_stand_to_one_another)
{
  const Body large(scenes::cube(2)), small(scenes::cube(0.5));
  for (const Kernel kernel : {Kernel::adaptive, Kernel::double_, Kernel::float_, Kernel::double_eps, Kernel::epick,
                              Kernel::epeck, Kernel::rational})
    for (const Method method : {Method::tree, Method::paper, Method::brute}) {
      const tetracone::Query_options options{kernel, method, {}, false};
      Query query(large, small, Question::solid, options), other_way(small, large, Question::solid, options),
          surface(large, small, Question::surface, options);
      const auto relation = [](Query& q, double x) { return q.collide(Pose(), Pose::translation(x, 0, 0)).relation(); };
      BOOST_TEST((relation(query, 0) == Relation::b_in_a));
      BOOST_TEST((relation(other_way, 0) == Relation::a_in_b));
      BOOST_TEST((relation(surface, 0) == Relation::apart));
      BOOST_TEST((relation(query, 2) == Relation::surfaces));
      BOOST_TEST((relation(query, 2.5) == Relation::surfaces));
      BOOST_TEST((relation(query, 3) == Relation::apart));
      BOOST_TEST(bool(query.collide(Pose(), Pose())));
      BOOST_TEST(!query.collide(Pose(), Pose::translation(3, 0, 0)));
    }
  std::ostringstream out;
  out << Relation::apart << ' ' << Relation::surfaces << ' ' << Relation::a_in_b << ' ' << Relation::b_in_a;
  BOOST_TEST(out.str() == "apart surfaces a_in_b b_in_a");
}

BOOST_AUTO_TEST_CASE(triangles_that_do_not_cover_their_face_are_refused)
{
  const Polyhedron cube = scenes::unit_cube();
  const auto refusal = [&](const std::vector<tetracone::Face_triangle>& triangles) {
    return said([&] { return Body(cube, triangles); });
  };
  const auto loop = cube.loop(2, 0);
  const std::array<std::uint32_t, 3> half{loop[0], loop[1], loop[2]}, other{loop[0], loop[2], loop[3]};
  const std::string expected = "; expected triangles that cover exactly the face";
  BOOST_TEST(refusal({{2, half}, {2, other}}) == "");
  BOOST_TEST(
      refusal({{2, half}}).starts_with("body: face 2: its triangles do not end where its loops do, at the edge "));
  BOOST_TEST(refusal({{2, half}}).ends_with(expected));
  BOOST_TEST(refusal({{2, half}, {2, other}, {2, other}}).starts_with("body: face 2: "));
  BOOST_TEST(refusal({{3, half}, {3, other}}).starts_with("body: face 3: its triangle "));
  BOOST_TEST(refusal({{2, {loop[2], loop[1], loop[0]}}, {2, other}}).starts_with("body: face 2: "));
  BOOST_TEST(refusal({{2, {loop[0], loop[1], 8}}}) ==
             "body: a triangle of face 2 names vertex 8; expected a vertex's number");
  BOOST_TEST(refusal({{6, half}}) == "body: a triangle of face 6 of 6; expected a face's number");
}

BOOST_AUTO_TEST_CASE(many_poses_have_the_answers_of_each)
{
  const Body a(scenes::cube_with_tunnel()), b(scenes::cube(0.5));
  Query query(a, b), remembering(a, b, Question::solid, {.remember = true});
  std::vector<Pose> poses;
  for (int k = -20; k <= 20; ++k) poses.push_back(Pose::translation(k / 4.0, k / 8.0, 0.25));
  const std::vector<Pose> one = {Pose()};
  const std::vector<Answer> answers = query.collide(one, poses), other_way = remembering.collide(poses, one);
  BOOST_REQUIRE(answers.size() == poses.size());
  BOOST_REQUIRE(other_way.size() == poses.size());
  int yes = 0;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    BOOST_TEST((answers[k].relation() == query.collide(Pose(), poses[k]).relation()));
    BOOST_TEST((other_way[k].relation() == query.collide(poses[k], Pose()).relation()));
    yes += bool(answers[k]);
  }
  BOOST_TEST(yes > 5);
  BOOST_TEST(yes < 36);
  BOOST_TEST(query.collide(std::vector<Pose>(), {}).empty());
}

BOOST_AUTO_TEST_CASE(what_repair_does_is_said)
{
  const auto bent = tetracone::repaired(with_corner(1.5));
  BOOST_TEST(bent.replaced.size() >= 1u);
  BOOST_TEST(!bent.turned);
  BOOST_CHECK_NO_THROW(Body{bent.polyhedron});
  const auto is_third = [](std::uint32_t f) { return f == 2; };
  Polyhedron all = scenes::without(scenes::unit_cube(), is_third);
  covering::append_face(all, scenes::unit_cube(), 2, true);
  BOOST_TEST(!Body(all).is_closed());
  const auto mended = tetracone::repaired(all);
  BOOST_TEST(mended.turned);
  BOOST_TEST(Body(mended.polyhedron).is_closed());
  BOOST_TEST(said([&] {
               Query(Body(all), Body(all));
             }).find("(consistent orientation may close it: tetracone/repair.h)") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(points_of_doubles_and_of_fractions_are_located_exactly)
{
  const Body cube(scenes::unit_cube()), open(open_box());
  const double above = std::nextafter(1.0, 2.0);
  const std::vector<std::array<double, 3>> points = {{0.5, 0.5, 0.5}, {0.5, 0.5, 1}, {0.5, 0.5, above}};
  const std::vector<Location> expected = {Location::inside, Location::on_surface, Location::outside};
  BOOST_TEST((cube.inside(points) == expected));
  for (std::size_t k = 0; k < points.size(); ++k) BOOST_TEST((cube.inside(points[k]) == expected[k]));
  BOOST_TEST(cube.inside_bytes() > 0u);
  const std::string large = "100000000000000000000000000000000000000000";
  BOOST_TEST((cube.inside_text({"1/3", "0.5", large + "1/" + large + "0"}) == Location::outside));
  BOOST_TEST((cube.inside_text({"1/3", "0.5", "1"}) == Location::on_surface));
  BOOST_TEST((cube.inside_text({"1/3", "0.5", large + "0/" + large + "1"}) == Location::inside));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(said([&] { cube.inside({0, nan, 0}); }) == "point: y is nan; expected a finite number");
  std::vector<std::array<double, 3>> many(1000), second = {{0, 0, 0}, {0, 0, nan}};
  BOOST_TEST(said([&] { cube.inside(second); }) == "points[1]: z is nan; expected a finite number");
  BOOST_TEST(cube.inside(many).size() == many.size());
  many[999][1] = -std::numeric_limits<double>::infinity();
  BOOST_TEST(said([&] { cube.inside(many); }) == "points[999]: y is -inf; expected a finite number");
  const std::array<std::string, 3> by_zero = {"0", "0", "1/0"};
  BOOST_TEST(said([&] { cube.inside_text(by_zero); }) ==
             "point: z is '1/0'; expected a finite decimal number or a fraction n/d");
  for (const double far : {1e300, -1e300}) BOOST_TEST((cube.inside({far, 0.5, 0.5}) == Location::outside));
  BOOST_TEST((cube.inside({5e-324, 0.5, 0.5}) == Location::inside));
  BOOST_TEST((cube.inside({-5e-324, 0.5, 0.5}) == Location::outside));
  BOOST_TEST(
      said([&] { open.inside(points); }) ==
      "body is open at 4 edges, first at the edge from vertex 4 to 5; expected a closed surface for points inside "
      "or outside");
  BOOST_TEST(verify::not_refused<Error>([&] { cube.inside(points); }) == 0);
}

BOOST_AUTO_TEST_CASE(rays_meet_an_open_or_closed_surface)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Body box(scenes::cube(1)), open(open_box());
  const Ray through{{-4, 0.25, 0}, {3, 0, 0}}, past{{-4, 2, 0}, {3, 0, 0}};
  const auto first = box.first_hit(through);
  BOOST_REQUIRE(first.has_value());
  BOOST_TEST(first->t == 1);
  BOOST_TEST(box.hits(through).size() == 2u);
  BOOST_TEST((box.hits(through)[0] == *first));
  BOOST_TEST(box.hits(through)[1].t == 5.0 / 3);
  const auto both = box.first_hits(std::vector{past, through});
  BOOST_TEST((!both[0] && both[1] == first));
  BOOST_TEST(open.first_hit(through).has_value());
  const Ray still{{0, 0, 0}, {0, -0.0, 0}}, lost{{0, 0, 0}, {0, nan, 0}};
  BOOST_TEST(said([&] { box.first_hit(still); }) == "ray: the direction is 0; expected one of any other length");
  BOOST_TEST(said([&] { box.hits(lost); }) == "ray: number 5 of 6 is nan; expected a finite number");
  BOOST_TEST(verify::not_refused<Error>([&] { box.first_hit(through); }) == 0);
  BOOST_TEST(verify::not_refused<Error>([&] { box.normal(0); }) == 0);
  BOOST_TEST(verify::not_refused<Error>([&] { box.crossing(through, 0); }) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
