#include "tetracone/tetratree/query/bvh8_motion.h"

#include "tetracone/tetratree/query/bvh8_collision.h"
#include "verify/cases/shape_generators.h"
#include "verify/test/support/object_cases.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_bvh8_motion)

namespace scenes = tetracone::verify::scenes;
using namespace tetracone::tetratree;
using tetracone::covering::Polyhedron;
using namespace tetracone::kernel;

namespace {

/// With coordinates of 12 bits: what is moved by few bits is a double.
Polyhedron coarse(Polyhedron body)
{
  for (Vertex& v : body.vertices)
    for (double& x : v) x = std::round(x * 0x1p8) * 0x1p-8;
  return body;
}

/// Requires coordinates and entries of few bits.
Vertex image(const Pose& pose, const Vertex& v)
{
  Vertex p;
  for (int i = 0; i < 3; ++i)
    p[i] = pose[4 * i] * v[0] + pose[4 * i + 1] * v[1] + pose[4 * i + 2] * v[2] + pose[4 * i + 3];
  return p;
}

/// All vertices, faces and edges of two bodies of triangles of which B moves from one pose to another, linearly.
std::optional<Time_bounds> of_all_pairs(const Polyhedron& a, const Polyhedron& b, const Pose& from, const Pose& to)
{
  std::optional<Time_bounds> first;
  const auto rests = [&](Index v) { return Moving_point{a.vertices[v], a.vertices[v]}; };
  const auto moves = [&](Index v) { return Moving_point{image(from, b.vertices[v]), image(to, b.vertices[v])}; };
  const auto take = [&](Moving_kind kind, const std::array<Moving_point, 4>& points) {
    const auto time = tetracone::kernel::first_contact_time({kind, points});
    if (time && (!first || time->hi < first->hi || (time->hi == first->hi && time->lo < first->lo))) first = time;
  };
  for (Index f = 0; f < a.face_count(); ++f)
    for (Index g = 0; g < b.face_count(); ++g) {
      const auto p = a.loop(f, 0), q = b.loop(g, 0);
      for (int i = 0; i < 3; ++i) {
        take(Moving_kind::vertex_face, {rests(p[i]), moves(q[0]), moves(q[1]), moves(q[2])});
        take(Moving_kind::vertex_face, {moves(q[i]), rests(p[0]), rests(p[1]), rests(p[2])});
        for (int j = 0; j < 3; ++j)
          take(Moving_kind::edge_edge, {rests(p[i]), rests(p[(i + 1) % 3]), moves(q[j]), moves(q[(j + 1) % 3])});
      }
    }
  return first;
}

Body_motion shift(const Vertex& from, const Vertex& to)
{
  return Body_motion::linear(Pose::translation(from[0], from[1], from[2]), Pose::translation(to[0], to[1], to[2]));
}

const Body_motion rests = shift({0, 0, 0}, {0, 0, 0});

}  // namespace

BOOST_AUTO_TEST_CASE(the_tree_finds_the_first_contact_of_all_pairs)
{
  const Polyhedron ring = coarse(scenes::triangulated(scenes::torus(8, 5))),
                   small = scenes::tetrahedron({0, 0, -1}, {1, 0.25, 0}, {-0.5, 1, 0.25}, {-0.5, -1, 0.5});
  const Bvh8 a(ring), b(small);
  Bvh8_motion motion(a, b);
  scenes::Random random(1);
  for (const bool turns : {false, true}) {
    int contacts = 0;
    for (int k = 0; k < 12; ++k) {
      std::array<double, 12> from = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 6}, to = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -6};
      for (const int i : {3, 7}) {
        from[i] = scenes::integer(random, -256, 256) / 64.0;
        to[i] = scenes::integer(random, -64, 64) / 64.0;
      }
      if (turns)
        for (const int i : {0, 1, 2, 4, 5, 6, 8, 9, 10}) {
          from[i] += scenes::integer(random, -16, 16) / 32.0;
          to[i] += scenes::integer(random, -16, 16) / 32.0;
        }
      const auto found = motion(rests, Body_motion::linear(Pose(from), Pose(to)));
      const auto expected = of_all_pairs(ring, small, Pose(from), Pose(to));
      BOOST_REQUIRE(found.has_value() == expected.has_value());
      if (!found) continue;
      ++contacts;
      const Time_bounds bounds = bounds_about(found->time);
      BOOST_TEST(bounds.lo == expected->lo);
      BOOST_TEST(bounds.hi == expected->hi);
    }
    BOOST_TEST(contacts > 2);
    BOOST_TEST(contacts < 12);
  }
}

BOOST_AUTO_TEST_CASE(doubles_alone_decide_motions_that_stay_apart)
{
  const Bvh8 tree(scenes::triangulated(scenes::torus(24, 24)));
  Bvh8_motion motion(tree, tree);
  BOOST_TEST(!motion(rests, shift({6, 1, 2.5}, {-6, 0, 2.25})));
  BOOST_TEST(motion.counts().box_tests > 0u);
  BOOST_TEST(motion.counts().exact_fallbacks == 0u);
  // A ring that turns about its axis far off.
  const auto turning = Body_motion::rigid({{1, 0, 0, 0}, {9, 0, 0}}, {{0, 0, 0, 1}, {9, 0, 1}}).value();
  motion.clear_counts();
  BOOST_TEST(!motion(rests, turning));
  BOOST_TEST(motion.counts().exact_fallbacks == 0u);
  BOOST_TEST(motion.counts().box_tests < 600u);
}

BOOST_AUTO_TEST_CASE(what_meets_is_named)
{
  const Polyhedron cube = scenes::triangulated(scenes::unit_cube()),
                   spike = scenes::tetrahedron({0, 0, 0}, {1, 0.25, 2}, {-1, 0.25, 2}, {0, -1, 2});
  const Bvh8 of_cube(cube), of_spike(spike);
  Bvh8_motion motion(of_cube, of_spike);
  auto found = motion(rests, shift({0.25, 0.5, 3}, {0.25, 0.5, -1}));
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST(bounds_about(found->time).lo == 0.5);
  BOOST_TEST((found->features.kind == Moving_kind::vertex_face));
  BOOST_TEST(found->features.body == 1);
  BOOST_TEST(found->features.corner[0] == 0u);
  for (int k = 1; k < 4; ++k) BOOST_TEST(cube.vertices[found->features.corner[k]][2] == 1);
  // An edge across an edge: the cube's turned by an eighth stands on an edge.
  const Body_motion falls = Body_motion::rigid({{1, 0, 0, 0}, {0, 0, 0}}, {{1, 0, 0, 0}, {0, 0, 0}}).value();
  const Bvh8 wedge(scenes::tetrahedron({0.5, -1, 0}, {0.5, 2, 0}, {0, 0.5, 1}, {1, 0.5, 1}));
  Bvh8_motion onto_edge(of_cube, wedge);
  found = onto_edge(falls, shift({-0.5, 0.0, 2}, {0.5, 0.0, 0.5}));
  BOOST_REQUIRE(found.has_value());
  const Time_bounds bounds = bounds_about(found->time);
  BOOST_TEST(std::abs(bounds.lo - 2.0 / 3) < 1e-9);
}

BOOST_AUTO_TEST_CASE(the_start_is_asked_about_where_elements_may_meet_then)
{
  const Bvh8 cube(scenes::triangulated(scenes::unit_cube()));
  Bvh8_motion motion(cube, cube);
  int asked = 0;
  bool is_at_start = false;
  const std::function<bool()> meet_at_start = [&] {
    ++asked;
    return is_at_start;
  };
  const auto ask = [&](const Vertex& from, const Vertex& to) {
    asked = 0;
    return motion(rests, shift(from, to), meet_at_start);
  };
  // Apart all the time; apart at the start; a hair apart there; touching, and one within the other's faces.
  auto found = ask({3, 0.25, 0.25}, {3, 9, 0.25});
  BOOST_TEST((!found.is_at_start && !found.first && asked == 0));
  found = ask({3, 0.25, 0.25}, {-3, 0.25, 0.25});
  BOOST_REQUIRE(found.first.has_value());
  BOOST_TEST(asked == 0);
  BOOST_TEST(bounds_about(found.first->time).lo == 1.0 / 3);
  found = ask({1 + 0x1p-52, 0.25, 0.25}, {3, 0.25, 0.25});
  BOOST_TEST((!found.is_at_start && !found.first && asked == 1));
  is_at_start = true;
  for (const Vertex& from : {Vertex{1, 0.25, 0.25}, Vertex{0.5, 0.25, 0.25}, Vertex{0, 0, 0}}) {
    found = ask(from, {3, 0.25, 0.25});
    BOOST_TEST((found.is_at_start && !found.first && asked == 1));
  }
}

BOOST_AUTO_TEST_CASE(where_the_start_is_not_asked_about_surfaces_are_apart_then)
{
  const Bvh8 a(scenes::triangulated(scenes::torus(12, 8))),
      b(scenes::tetrahedron({0, 0, -1}, {1, 0.25, 0}, {-0.5, 1, 0.25}, {-0.5, -1, 0.5}));
  Bvh8_motion motion(a, b);
  Bvh8_collision<> collision(a, b);
  scenes::Random random(7);
  int begun = 0, apart = 0, wrong = 0;
  for (int k = 0; k < 400; ++k) {
    // Shifted, turned a little, or turned far; some end where they began.
    std::array<double, 12> from = Pose().entries(), to = from;
    for (const int i : {3, 7, 11}) {
      from[i] = scenes::real(random, -2, 2);
      to[i] = k % 7 == 0 ? from[i] : scenes::real(random, -4, 4);
    }
    const double turn = k % 3 == 0 ? 0 : k % 3 == 1 ? 0.05 : 0.5;
    for (const int i : {0, 1, 2, 4, 5, 6, 8, 9, 10}) {
      from[i] += turn * scenes::real(random, -1, 1);
      to[i] += turn * scenes::real(random, -1, 1);
    }
    const Pose start(from);
    const bool meets = collision(Pose(), start, tetracone::kernel::Question::surface);
    int asked = 0;
    const auto found = motion(rests, Body_motion::linear(start, Pose(to)), [&] {
      ++asked;
      return meets;
    });
    wrong += found.is_at_start != meets || asked > 1;
    (meets ? begun : apart) += asked == (meets ? 1 : 0);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST_MESSAGE("begun in contact " << begun << ", not asked about " << apart);
  BOOST_TEST(begun > 40);
  BOOST_TEST(apart > 100);
}

BOOST_AUTO_TEST_CASE(faces_of_no_area_and_bodies_of_any_size_meet_too)
{
  const Bvh8 of_needle(scenes::polygon({{0, 0, 0}, {0, 0, 1}, {0, 0, 0.5}})),
      of_cube(scenes::triangulated(scenes::unit_cube()));
  Bvh8_motion motion(of_cube, of_needle);
  const auto found = motion(rests, shift({0.25, 0.25, 2}, {0.25, 0.25, -2}));
  BOOST_REQUIRE(found.has_value());
  BOOST_TEST(bounds_about(found->time).lo == 0.25);
  BOOST_TEST(!motion(rests, shift({1.25, 0.25, 2}, {1.25, 0.25, -2})));

  const double speck = 0x1p-200;
  const Bvh8 of_speck(scenes::moved(scenes::triangulated(scenes::unit_cube()), speck));
  Bvh8_motion onto(of_cube, of_speck);
  const auto time = onto(rests, shift({0.25, 0.25, 2}, {0.25, 0.25, 0}));
  BOOST_REQUIRE(time.has_value());
  BOOST_TEST(bounds_about(time->time).lo == 0.5);
}

BOOST_AUTO_TEST_CASE(a_part_far_from_the_rest_of_its_body_lets_the_search_end)
{
  const Polyhedron cube = scenes::triangulated(scenes::unit_cube());
  Polyhedron with_far = cube;
  for (const Vertex& v : cube.vertices) with_far.vertices.push_back({0x1p30 + v[0] * 0x1p-10, v[1], v[2]});
  for (Index f = 0; f < cube.face_count(); ++f) {
    std::array<Index, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = cube.loop(f, 0)[k] + Index(cube.vertices.size());
    with_far.add_polygon(corners);
  }
  // Between a turned pose and one that is not, maps are no similarities.
  const std::array<double, 12> turned = {-0.53, 0.85, 0.05, -0.94, -0.28, -0.12, -0.95, 0.06, -0.8, -0.52, 0.3, -2.06};
  const auto moves = Body_motion::linear(Pose(turned), Pose());
  const Bvh8 of_cube(cube), of_both(with_far);
  Bvh8_motion alone(of_cube, of_cube), both(of_cube, of_both);
  const auto expected = alone(rests, moves), found = both(rests, moves);
  BOOST_REQUIRE((expected.has_value() && found.has_value()));
  BOOST_TEST(bounds_about(found->time).lo == bounds_about(expected->time).lo);
  BOOST_TEST(bounds_about(found->time).hi == bounds_about(expected->time).hi);
  BOOST_TEST(both.counts().box_tests < 100000u);
}

BOOST_AUTO_TEST_CASE(features_that_land_together_need_no_number_each)
{
  const Polyhedron table = scenes::triangulated(scenes::box({-4, -4, -1}, {4, 4, 0}));
  const auto rigid = [](double turn, double x, const Rational& z) {
    return tetracone::kernel::Rigid_pose{{1, 0, 0, turn}, {x, 0.125, z}};
  };
  const Body_motion still = Body_motion::rigid({}, {}).value();
  for (const int n : {4, 16}) {
    const Bvh8 of_table(table), of_plate(tetracone::verify::plate(n, 0, 0.25)),
        of_like(tetracone::verify::plate(n, -0.25, 0));
    Bvh8_motion onto_table(of_table, of_plate), onto_like(of_like, of_plate);
    // At a dyadic time, at a third, while it slides, while it turns, and at the end.
    const std::array<std::pair<Body_motion, double>, 6> motions = {
        {{shift({0.25, 0.125, 1}, {0.25, 0.125, -1}), 0.5},
         {shift({0.25, 0.125, 1}, {0.25, 0.125, -2}), 1.0 / 3},
         {shift({0, 0.125, 1}, {1, -0.25, -2}), 1.0 / 3},
         {Body_motion::rigid(rigid(0, 0.25, 1), rigid(0, 0.25, -2)).value(), 1.0 / 3},
         {Body_motion::rigid(rigid(0, 0.25, 1), rigid(1, 0.25, -2)).value(), 1.0 / 3},
         {shift({0.25, 0.125, 1}, {0.25, 0.125, 0}), 1}}};
    for (const auto& [moves, time] : motions)
      for (Bvh8_motion* motion : {&onto_table, &onto_like}) {
        motion->clear_counts();
        const auto found = (*motion)(moves.ends() ? rests : still, moves);
        BOOST_REQUIRE(found.has_value());
        const Time_bounds bounds = bounds_about(found->time);
        BOOST_TEST((bounds.lo <= time && time <= bounds.hi));
        BOOST_TEST(motion->stages().by_roots < 12u);
        BOOST_TEST(motion->stages().by_signs < 24u);
        BOOST_TEST((n < 16 || motion->stages().by_planes > 16u));
      }
  }
}

BOOST_AUTO_TEST_CASE(what_reaches_beyond_the_plane_of_a_landing_is_met_first)
{
  // A post on the table, and a peg under the plate, each by a hair beyond the planes that land on one another.
  for (const double beyond : {0.0, 0x1p-50, 0x1p-30, 0.125, -0x1p-30})
    for (const bool is_below : {false, true}) {
      const auto post = [](double low, double high) {
        return scenes::triangulated(scenes::box({0.25, 0.25, low}, {0.375, 0.5, high}));
      };
      Polyhedron below = tetracone::verify::plate(6, -0.25, 0), above = tetracone::verify::plate(6, 0, 0.25);
      if (is_below)
        below = scenes::both(below, post(-0.125, beyond));
      else
        above = scenes::both(above, post(-beyond, 0.125));
      const Bvh8 a(below), b(above);
      const auto found = Bvh8_motion(a, b)(rests, shift({0, 0, 1}, {0, 0, -2}));
      BOOST_REQUIRE(found.has_value());
      const Time_bounds bounds = bounds_about(found->time);
      const Rational time = (Rational(1) - (beyond > 0 ? Rational(beyond) : Rational(0))) / 3;
      BOOST_TEST((Rational(bounds.lo) <= time && time <= Rational(bounds.hi)));
    }
}

BOOST_AUTO_TEST_SUITE_END()
