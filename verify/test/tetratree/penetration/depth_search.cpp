#include "tetracone/tetratree/penetration/depth_search.h"

#include "tetracone/covering/star_faces.h"
#include "tetracone/kernel/contact/direction_view.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/penetration/near_origin.h"
#include "verify/cases/lego.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/exit_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_depth_search)

namespace scenes = tetracone::verify::scenes;
using namespace tetracone;

using tetracone::kernel::Pose;
using tetracone::kernel::Rational;

namespace {

/// Checks what every bracket must hold: its vector parts the solids and has the length that is said.
Depth checked(Query& query, const Pose& pose_a, const Pose& pose_b, const tetracone::Depth_options& options = {})
{
  const Depth depth = query.depth(pose_a, pose_b, options);
  std::array<Rational, 3> v;
  Rational square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = Rational(depth.exact_vector[k]);
    square += v[k] * v[k];
  }
  BOOST_TEST(square == Rational(depth.exact_square));
  BOOST_TEST(depth.low <= depth.high);
  BOOST_TEST(Rational(depth.low) * Rational(depth.low) <= square);
  BOOST_TEST(Rational(depth.high) * Rational(depth.high) >= square);
  if (depth.is_exact) BOOST_TEST(depth.high <= std::nextafter(depth.low, HUGE_VAL));
  const auto [moved, unmoved] = tetracone::kernel::moved_along(pose_a, pose_b, v, 1);
  const auto relation = query.solid_relation_alone(moved, unmoved);
  BOOST_TEST((relation == tetracone::Solid_relation::meet || relation == tetracone::Solid_relation::disjoint));
  return depth;
}

Depth depth_of(const Polyhedron& a, const Polyhedron& b, const Pose& pose_a = Pose(), const Pose& pose_b = Pose(),
               const tetracone::Depth_options& options = {})
{
  Query query{Body(a), Body(b)};
  return checked(query, pose_a, pose_b, options);
}

/// What a search needs of a body of triangles.
struct Searched {
  explicit Searched(const Polyhedron& triangles)
      : body(triangles), tree(body, covering::star_faces(body)), sides(tree, body), locator(tree.model())
  {}
  Searched(const Searched&) = delete;

  tetratree::Seen_solid seen() const { return {tree, body, sides}; }
  tetratree::Inner_balls balls() const { return {tree, locator, sides.is_simple()}; }

  Polyhedron body;
  tetratree::Bvh8 tree;
  tetratree::Solid_sides sides;
  tetratree::Point_locator locator;
};

}  // namespace

BOOST_AUTO_TEST_CASE(boxes_part_across_their_thinnest_overlap)
{
  const Polyhedron unit = scenes::unit_cube();
  const Depth corner = depth_of(unit, unit, scenes::translation(0.5, 0.625, 0.75));
  BOOST_TEST(corner.is_exact);
  BOOST_TEST(corner.exact_square == "1/16");
  BOOST_TEST(corner.exact_vector[2] == "1/4");
  BOOST_TEST(corner.low == 0.25);
  BOOST_TEST(corner.high == 0.25);
  // The whole body goes out by the shortest way.
  const Depth deep = depth_of(scenes::box({0, 0, 0}, {1, 1, 1}), scenes::box({-1, -2, -3}, {5, 5, 1.5}));
  BOOST_TEST(deep.exact_square == "9/4");
  BOOST_TEST(depth_of(unit, unit, scenes::translation(1, 0.5, 0)).exact_square == "0");
}

BOOST_AUTO_TEST_CASE(the_depth_of_convex_bodies_is_the_least_of_all_normals)
{
  scenes::Random random(5);
  int exact = 0;
  for (int round = 0; round < 8; ++round) {
    const Polyhedron a = scenes::cube(1), b = scenes::tetrahedron({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3});
    const Pose pose_a = scenes::random_rotation(random, 4),
               pose_b = scenes::random_rotation(random, 4, {Rational(round) / 8, 0, Rational(1, 3)});
    const tetracone::verify::Object_case c{
        std::make_shared<const Polyhedron>(a), std::make_shared<const Polyhedron>(b), pose_a, pose_b, {}, {}, {}};
    const Rational truth = tetracone::verify::convex_squared_depth(c);
    const Depth depth = depth_of(a, b, pose_a, pose_b);
    BOOST_TEST(Rational(depth.low) * Rational(depth.low) <= truth);
    BOOST_TEST(Rational(depth.exact_square) >= truth);
    BOOST_TEST(depth.low >= depth.high * (1 - 1e-9));
    exact += depth.is_exact && Rational(depth.exact_square) == truth;
  }
  BOOST_TEST(exact >= 6);
}

BOOST_AUTO_TEST_CASE(bodies_that_are_not_convex_part_by_the_shortest_way)
{
  // A bolt's head is pressed into a ring by a quarter; a bar goes through a tunnel's wall.
  Polyhedron frame = scenes::cube_with_tunnel();
  const Depth through =
      depth_of(scenes::box({-0.25, -0.25, -9}, {0.25, 0.25, 9}), frame, scenes::translation(1.25, 0, 0));
  BOOST_TEST(through.low >= through.high * (1 - 1e-9));
  scenes::Random random(8);
  for (int round = 0; round < 3; ++round) {
    const Polyhedron a = scenes::blob(random, 3, 0.75, 1), b = scenes::triangulated(scenes::torus(8, 6));
    const Pose pose_a = scenes::random_rotation(random, 4, {Rational(1, 3), Rational(2, 5), 1});
    Query query{Body(a), Body(b)}, turned{Body(b), Body(a)};
    const Depth depth = checked(query, pose_a, Pose()), swapped = checked(turned, Pose(), pose_a);
    // Both brackets hold the one truth, which no exit is below.
    BOOST_TEST(depth.low <= swapped.high);
    BOOST_TEST(swapped.low <= depth.high);
    for (const auto& d : {std::array{1.0, 0.0, 0.0}, {0.5, -0.5, 0.5}, {0.0, 0.75, -0.25}})
      BOOST_TEST(query.exits(tetracone::Pose(pose_a.entries()), tetracone::Pose(), d).first >= 0);
  }
}

BOOST_AUTO_TEST_CASE(a_small_budget_gives_a_wider_bracket_that_holds_the_truth)
{
  const Polyhedron torus = scenes::triangulated(scenes::torus(8, 6));
  Query query{Body(torus), Body(torus)};
  scenes::Random random(2);
  const Pose aside = scenes::random_rotation(random, 4, {Rational(1, 2), Rational(1, 4), Rational(1, 8)});
  const Depth narrow = checked(query, aside, Pose(), {1e-6, 1000});
  for (const std::size_t budget : {0, 1, 20, 200}) {
    const Depth wide = checked(query, aside, Pose(), {1e-6, budget});
    BOOST_TEST(wide.low <= narrow.high);
    BOOST_TEST(wide.high >= narrow.low);
  }
}

BOOST_AUTO_TEST_CASE(deep_overlaps_have_narrow_brackets)
{
  scenes::Random random(4);
  const Polyhedron a = scenes::blob(random, 3, 0.75, 1), b = scenes::blob(random, 3, 0.75, 1);
  Query query{Body(a), Body(b)};
  for (const auto& [scale, shift] : {std::pair(Rational(1), Rational(1, 3)), {Rational(1, 2), Rational(1, 5)}}) {
    Pose pose = scenes::random_rotation(random, 4, {shift, shift / 2, -shift});
    std::array<Rational, 12> rows;
    for (int k = 0; k < 12; ++k) rows[std::size_t(k)] = k % 4 == 3 ? pose.exact(k) : Rational(pose.exact(k) * scale);
    const Depth depth = checked(query, Pose(rows), Pose(), {1e-3, 20000});
    BOOST_TEST(depth.low >= depth.high * 0.998);
    // The solids meet after every shorter translation.
    for (int round = 0; round < 60; ++round) {
      std::array<double, 3> d = scenes::real_vertex(random, 1);
      const double length = std::hypot(d[0], d[1], d[2]),
                   share = scenes::real(random, 0.5, 0.9999) * depth.low / length;
      const auto [moved, unmoved] =
          tetracone::kernel::moved_along(Pose(rows), Pose(), {d[0], d[1], d[2]}, Rational(share));
      const auto relation = query.solid_relation_alone(moved, unmoved);
      BOOST_TEST((relation != tetracone::Solid_relation::meet && relation != tetracone::Solid_relation::disjoint));
    }
  }
}

BOOST_AUTO_TEST_CASE(cubes_in_a_block_leave_it_or_enter_a_cavity)
{
  // The least translation brings a cube out of the block, or into its cavity: an exact fit in one of four.
  scenes::Random random(6);
  int into_cavity = 0, exact = 0;
  for (int round = 0; round < 24; ++round) {
    std::array<double, 3> at, low, high;
    Rational out = 1000, in = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = scenes::integer(random, 16, 56) / 4.0;
      low[k] = scenes::integer(random, 16, 56) / 4.0;
      high[k] = low[k] + 2 + scenes::integer(random, 0, 3) / 2.0;
      const Rational move = at[k] < low[k] ? low[k] - at[k] : std::max(at[k] + 2 - high[k], 0.0);
      in += move * move;
      out = std::min(out, Rational(std::min(at[k] + 2, 20 - at[k])));
    }
    const Polyhedron block = scenes::with_cavity(scenes::box({0, 0, 0}, {20, 20, 20}),
                                                 scenes::box({low[0], low[1], low[2]}, {high[0], high[1], high[2]})),
                     small = scenes::box({at[0], at[1], at[2]}, {at[0] + 2, at[1] + 2, at[2] + 2});
    const Rational truth = std::min(in, Rational(out * out));
    const Depth depth = depth_of(small, block, Pose(), Pose(), {1e-4, 20000});
    BOOST_TEST(Rational(depth.low) * Rational(depth.low) <= truth);
    BOOST_TEST(Rational(depth.exact_square) >= truth);
    into_cavity += in < out * out;
    exact += Rational(depth.exact_square) == truth;
  }
  BOOST_TEST(into_cavity > 8);
  BOOST_TEST(exact > 20);
}

BOOST_AUTO_TEST_CASE(a_solid_without_volume_has_no_inside)
{
  const Polyhedron flat = scenes::tetrahedron({0.5, 0.5, 0}, {1, 0.5, 0}, {0.5, 1, 0}, {0.25, 0.25, 0});
  Query query{Body(flat), Body(scenes::cube(2))};
  BOOST_TEST(query.exits(tetracone::Pose(), tetracone::Pose(), {1.0, 2.0, 0.0}).last == 0);
  const Depth depth = query.depth(Pose(), Pose());
  BOOST_TEST(depth.is_exact);
  BOOST_TEST(depth.high == 0);
}

BOOST_AUTO_TEST_CASE(poses_near_the_origin_are_one_map_of_those_given)
{
  scenes::Random random(9);
  long moved = 0, scaled = 0;
  for (int round = 0; round < 2000; ++round) {
    const kernel::Local_scale scale{{scenes::real(random, -1, 1), 0, 1},
                                    std::ldexp(1.0, scenes::integer(random, -9, 9))};
    const Rational size = kernel::times_power(1, std::array{0, 0, -30, 300, -1000}[scenes::integer(random, 0, 4)]),
                   far = kernel::times_power(scenes::integer(random, -9, 9), scenes::integer(random, -9, 70));
    std::array<Pose, 2> pose;
    for (Pose& p : pose) {
      std::array<Rational, 12> rows = kernel::rows_of(scenes::random_rotation(random, 4, {far, Rational(1, 3), -far}));
      const bool rounded = scenes::integer(random, 0, 1) == 0;
      for (Rational& x : rows) x = rounded ? Rational(kernel::nearest_double(x * size)) : Rational(x * size);
      p = Pose(rows);
    }
    const tetratree::Near_origin near = tetratree::near_origin(pose[0], scale, pose[1]);
    std::array<std::array<Rational, 12>, 2> off;
    for (std::size_t body = 0; body < 2; ++body)
      for (int k = 0; k < 12; ++k)
        off[body][k] = pose[body].exact(k) - kernel::times_power(near.pose[body].exact(k), near.exponent);
    BOOST_TEST((off[0] == off[1]));
    for (int k = 0; k < 12; ++k)
      if (k % 4 != 3) BOOST_TEST(off[0][k] == 0);
    for (std::size_t body = 0; body < 2; ++body)
      BOOST_TEST((pose[body].is_rational() || !near.pose[body].is_rational()));
    moved += off[0] != std::array<Rational, 12>{};
    scaled += near.exponent != 0;
  }
  BOOST_TEST(moved > 500);
  BOOST_TEST(scaled > 300);
}

BOOST_AUTO_TEST_CASE(a_far_place_or_an_extreme_size_widens_no_bracket)
{
  const Body body(scenes::cube_with_tunnel());
  Query query{body, body};
  const auto pose = [](double far, const std::array<double, 3>& aside, int exponent) {
    const double size = std::ldexp(1.0, exponent);
    std::array<double, 12> rows = {size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0};
    for (std::size_t k = 0; k < 3; ++k) rows[4 * k + 3] = (far + aside[k]) * size;
    return Pose(rows);
  };
  const auto asked = [&](double far, int exponent) {
    return checked(query, pose(far, {}, exponent), pose(far, {0.25, -0.125, 0.5}, exponent), {1e-9, 200});
  };
  const Depth near = asked(0, 0);
  BOOST_TEST(near.low > 0.1);
  for (const double far : {0x1p30, -0x1p49})
    for (const int exponent : {0, -220, 300, 900, -1000}) {
      const Depth depth = asked(far, exponent);
      BOOST_TEST(depth.low <= std::ldexp(near.high, exponent));
      BOOST_TEST(depth.low >= std::ldexp(near.low, exponent) * 0.99);
      BOOST_TEST(depth.high == std::ldexp(near.high, exponent));
      const std::array<std::string, 3> along = {"1", "1/3", "2/7"};
      const Exits exits = query.exits(pose(far, {}, exponent), pose(far, {0.25, -0.125, 0.5}, exponent), along),
                  of_near = query.exits(pose(0, {}, 0), pose(0, {0.25, -0.125, 0.5}, 0), along);
      BOOST_TEST(Rational(exits.exact_first) == kernel::times_power(Rational(of_near.exact_first), exponent));
      BOOST_TEST(Rational(exits.exact_last) == kernel::times_power(Rational(of_near.exact_last), exponent));
    }
}

BOOST_AUTO_TEST_CASE(a_sheet_outside_a_solid_holds_nothing)
{
  Polyhedron with_sheet = scenes::unit_cube();
  const Index first = Index(with_sheet.vertices.size());
  using covering::Vertex;
  for (const Vertex& v : {Vertex{1.0625, -1, 0.5}, Vertex{5, -1, 0.5}, Vertex{5, 2, 0.5}, Vertex{1.0625, 2, 0.5}})
    with_sheet.vertices.push_back(v);
  with_sheet.add_polygon({first, first + 1, first + 2, first + 3});
  with_sheet.add_polygon({first + 3, first + 2, first + 1, first});
  const Searched cube(scenes::triangulated(scenes::unit_cube())), other(scenes::triangulated(with_sheet));
  // The sheet goes through the cube, which leaves the solid after 1/4. The search is told of longer ways alone.
  const auto exit = [](kernel::Rational_point d) {
    for (Rational& x : d) x *= 8;
    return tetratree::Depth_search::Exit{d, {}};
  };
  const auto meet = [](const kernel::Rational_point&) { return true; };
  const std::array<std::array<Rational, 12>, 2> map = {kernel::rows_of(scenes::translation(0.75, 0, 0)),
                                                       kernel::rows_of(Pose())};
  for (const bool swapped : {false, true}) {
    const Searched &a = swapped ? other : cube, &b = swapped ? cube : other;
    tetratree::Depth_search search(a.seen(), b.seen(), a.balls(), b.balls());
    const tetratree::Depth_bracket found = search(map[swapped], map[!swapped], exit, meet, {1e-6, 1000});
    BOOST_TEST(found.least > 0.2);
    BOOST_TEST(found.least <= 0.25);
  }
}

BOOST_AUTO_TEST_CASE(aligned_faces_have_narrow_brackets)
{
  // A bend of three cubes, in triangles.
  Polyhedron triangles;
  triangles.vertices = scenes::prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1).vertices;
  for (const std::array<Index, 3>& t : {std::array<Index, 3>{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 5, 4}}) {
    triangles.add_polygon({t[0], t[1], t[2]});
    triangles.add_polygon({t[0] + 6, t[2] + 6, t[1] + 6});
  }
  for (Index k = 0; k < 6; ++k) {
    const Index next = (k + 1) % 6;
    triangles.add_polygon({k, next, next + 6});
    triangles.add_polygon({k, next + 6, k + 6});
  }
  const Depth depth = depth_of(triangles, triangles, Pose(), scenes::translation(0.25, -0.125, 0.5), {1e-9, 1000});
  BOOST_TEST(depth.exact_square == "1/4");
  BOOST_TEST(depth.low >= 0.5 * (1 - 1e-9));
}

BOOST_AUTO_TEST_CASE(what_is_no_width_is_refused)
{
  Query query{Body(scenes::unit_cube()), Body(scenes::unit_cube())};
  for (const double relative : {-1.0, 1.0, double(NAN)})
    BOOST_CHECK_THROW(query.depth(Pose(), Pose(), {relative}), tetracone::Error);
}

BOOST_AUTO_TEST_CASE(brackets_of_aligned_bodies_of_cells_get_narrow)
{
  namespace lego = tetracone::verify::lego;
  int wide = 0;
  constexpr int pairs = 6;
  for (int n = 1; n <= pairs; ++n) {
    tetracone::verify::Random random(n);
    lego::Bricks a(1), b(1);
    for (const lego::Cell& cell : lego::block({0, 0, 0}, {3, 3, 3})) {
      if (random.symmetric() > -0.2) a[0].cells.insert(cell);
      if (random.symmetric() > -0.2) b[0].cells.insert(cell);
    }
    const lego::Cell offset = {int(2 * random.symmetric()), int(2 * random.symmetric()), int(2 * random.symmetric())};
    Query query{Body(lego::solid(a, {}, random)), Body(lego::solid(b, {}, random))};
    const Pose moved = Pose::translation(offset[0] / 2.0, offset[1] / 2.0, offset[2] / 2.0);
    const Depth depth = checked(query, Pose(), moved, {1e-9, 1000});
    const Rational truth = lego::squared_depth(a, b, offset);
    BOOST_TEST(Rational(depth.low) * Rational(depth.low) <= truth);
    BOOST_TEST(Rational(depth.high) * Rational(depth.high) >= truth);
    wide += depth.high - depth.low > 0.1 * depth.high;
  }
  BOOST_TEST(wide <= pairs / 3);
}

BOOST_AUTO_TEST_SUITE_END()
