#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/brute_body.h"
#include "verify/truth/distance_truth.h"
#include "verify/truth/point_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_distances)

using namespace tetracone;
namespace scenes = tetracone::verify::scenes;

BOOST_AUTO_TEST_CASE(the_distance_is_that_of_the_nearest_of_all_pairs)
{
  scenes::Random random(5);
  for (int round = 0; round < 12; ++round) {
    const auto a = scenes::blob(random, 4, 0.5, 1), b = scenes::blob(random, 3, 0.25, 1);
    const kernel::Pose in_a = scenes::random_rotation(random),
                       in_b = scenes::random_rotation(random, 5, {kernel::Rational(7, 3), 0, kernel::Rational(1, 7)});
    const verify::Brute_body of_a(a), of_b(b);
    const kernel::Rational square =
        verify::squared_distance(verify::Placed_body(of_a, in_a), verify::Placed_body(of_b, in_b));
    const Body body_a(a), body_b(b);
    Query query(body_a, body_b, Question::surface);
    const Nearest nearest = query.nearest(in_a, in_b);
    BOOST_TEST(nearest.squared == kernel::exact_text(square));
    BOOST_TEST(query.distance(in_a, in_b) == nearest.distance);
  }
}

BOOST_AUTO_TEST_CASE(a_body_of_no_size_beside_the_other_has_leaves_still)
{
  const Body fine(scenes::triangulated(scenes::torus(24, 24)));
  Query query(fine, fine, Question::surface);
  const double speck = std::ldexp(1.0, -148);
  const Pose flat(std::array<double, 12>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0x1p-142, 0}),
      small(std::array<double, 12>{speck, 0, 0, 0, 0, speck, 0, 0, 0, 0, speck, 0}),
      away = Pose::translation(100, 0, 0);
  for (const Pose& pose : {small, flat}) {
    const Nearest nearest = query.nearest(pose, away);
    BOOST_TEST(nearest.distance > 50);
    BOOST_TEST(query.distance(pose, away) == nearest.distance);
    BOOST_TEST(query.within(pose, away, nearest.distance * (1 + 0x1p-40)));
    BOOST_TEST(!query.within(pose, away, nearest.distance * (1 - 0x1p-40)));
  }
}

BOOST_AUTO_TEST_CASE(no_limit_holds_that_only_overflow_would_grant)
{
  const double s = 0x1p-151;
  const Body body(scenes::tetrahedron({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}));
  const Pose away = Pose::translation(0x1p1000, 0, 0);
  Query query(body, body, Question::surface);
  BOOST_TEST(!query.within(Pose(), away, 0x1p900));
  BOOST_TEST(query.within(Pose(), away, 0x1p1001));
  BOOST_TEST(query.distance(Pose(), away) == 0x1p1000);
}

BOOST_AUTO_TEST_CASE(no_limit_holds_that_only_underflow_would_grant)
{
  const double s = 0x1p-100, h = 0x1p-540;
  const Body below(scenes::tetrahedron({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, -s})),
      above(scenes::tetrahedron({0, 0, h}, {s, 0, h}, {0, s, h}, {0, 0, s}));
  for (const Kernel kernel : {Kernel::adaptive, Kernel::rational}) {
    Query query(below, above, Question::surface, {.kernel = kernel});
    BOOST_TEST(!query.within(Pose(), Pose(), 0x1p-560));
    BOOST_TEST(query.within(Pose(), Pose(), h));
    BOOST_TEST(query.distance(Pose(), Pose()) == h);
  }
}

BOOST_AUTO_TEST_CASE(doubles_do_not_take_bodies_that_are_tiny_for_touching)
{
  const Body body(scenes::moved(scenes::unit_cube(), 1e-70));
  Query query(body, body, Question::surface, {.kernel = Kernel::double_});
  BOOST_TEST(std::abs(query.distance(Pose(), Pose::translation(1e-60, 0, 0)) / 1e-60 - 1) < 1e-9);
  BOOST_TEST(!query.within(Pose(), Pose::translation(1e-60, 0, 0), 1e-61));
}

BOOST_AUTO_TEST_CASE(of_two_corners_that_doubles_call_equally_near_the_nearer_one_counts)
{
  // Their distances round to 1 and to its successor.
  const double low = 0x1p-53 - 0x1p-80, high = 0x1p-53 + 0x1p-80;
  const Pose up = Pose::translation(0, 0, 1);
  const Body slab(scenes::triangulated(scenes::box({-8, -8, -1}, {8, 8, 0})));
  for (const auto& [first, second] : {std::array{low, high}, std::array{high, low}}) {
    // Both are over one triangle of the slab.
    Polyhedron spikes = scenes::tetrahedron({-2, -5, first}, {-1, -5, 1}, {-2, -4, 1}, {-3, -6, 1});
    scenes::append(spikes, scenes::tetrahedron({2, -5, second}, {3, -5, 1}, {2, -4, 1}, {1, -6, 1}));
    const Body body(spikes);
    BOOST_TEST(Query(body, slab).distance(up, Pose()) == 1.0);
    BOOST_TEST(Query(slab, body).distance(Pose(), up) == 1.0);
  }
}

BOOST_AUTO_TEST_CASE(a_zone_has_the_faces_whose_distance_is_within_the_limit)
{
  scenes::Random random(4630);
  std::size_t near = 0, far = 0, inside = 0;
  for (const auto& [name, polyhedron] : scenes::closed_bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    const Polyhedron b = scenes::with_cavity(scenes::cube(16), scenes::cube(4));
    const verify::Brute_body of_b(b);
    const verify::Placed_body at_rest(of_b, kernel::Pose());
    const verify::Point_truth in_b(b);
    for (int round = 0; round < 8; ++round) {
      std::array<kernel::Rational, 3> t;
      for (auto& x : t) x = kernel::Rational(scenes::integer(random, -75, 75), 3);
      const kernel::Pose pose({1, 0, 0, t[0], 0, 1, 0, t[1], 0, 0, 1, t[2]});
      const kernel::Rational limit(scenes::integer(random, 0, 6), 2);
      std::array<std::vector<Index>, 2> expected;
      for (Index f = 0; f < polyhedron.face_count(); ++f) {
        const Polyhedron alone = verify::face_alone(polyhedron, f);
        const verify::Brute_body of_face(alone);
        const verify::Placed_body placed(of_face, pose);
        const kernel::Rational square = verify::squared_distance(placed, at_rest);
        if (square <= limit * limit) expected[0].push_back(f);
        const auto& corner = polyhedron.vertices[polyhedron.loop(f, 0)[0]];
        const bool is_inside =
            in_b(std::array<kernel::Rational, 3>{corner[0] + t[0], corner[1] + t[1], corner[2] + t[2]}) == 1;
        if (square <= limit * limit || is_inside) expected[1].push_back(f);
        inside += square > limit * limit && is_inside;
      }
      const std::string within = kernel::to_string(limit);
      for (const char* kernel : {"adaptive", "rational"}) {
        BOOST_TEST(Query(Body(polyhedron), Body(b), Question::surface, *parse_kernel(kernel))
                       .zone(pose, kernel::Pose(), within) == expected[0]);
        BOOST_TEST(Query(Body(polyhedron), Body(b), Question::solid, *parse_kernel(kernel))
                       .zone(pose, kernel::Pose(), within) == expected[1]);
      }
      near += expected[1].size();
      far += polyhedron.face_count() - expected[1].size();
    }
  }
  BOOST_TEST(near > 100u);
  BOOST_TEST(far > 100u);
  BOOST_TEST(inside > 5u);
}

BOOST_AUTO_TEST_CASE(a_zone_on_integers_is_decided_at_equality)
{
  // Squares of two boxes, whose distance is that of boxes: along each axis the gap of intervals.
  const Polyhedron box = scenes::cube(2);
  Query query{Body(box), Body(box), Question::solid};
  scenes::Random random(4631);
  for (int round = 0; round < 60; ++round) {
    std::array<int, 3> t;
    for (int& x : t) x = scenes::integer(random, -9, 9);
    std::vector<int> squares;
    for (Index f = 0; f < 6; ++f) {
      int square = 0;
      for (int k = 0; k < 3; ++k) {
        int low = 99, high = -99;
        for (const Index v : box.loop(f, 0)) {
          low = std::min(low, int(box.vertices[v][k]) + t[k]);
          high = std::max(high, int(box.vertices[v][k]) + t[k]);
        }
        const int gap = std::max({0, low - 2, -2 - high});
        square += gap * gap;
      }
      squares.push_back(square);
    }
    for (const int limit : {0, 1, 3, 5, 7}) {
      std::vector<Index> at, below;
      for (Index f = 0; f < 6; ++f) {
        if (squares[f] <= limit * limit) at.push_back(f);
        if (squares[f] < limit * limit) below.push_back(f);
      }
      const Pose pose = Pose::translation(t[0], t[1], t[2]);
      BOOST_TEST(query.zone(pose, Pose(), std::to_string(limit)) == at);
      BOOST_TEST(query.zone(pose, Pose(), std::to_string(limit) + "00000000000000000000001/100000000000000000000000") ==
                 at);
      if (limit > 0)
        BOOST_TEST(query.zone(pose, Pose(),
                              std::to_string(limit * 1000 - 1) + "999999999999999999/1000000000000000000000") == below);
    }
  }
  BOOST_TEST(query.zone(Pose(), Pose(), "-1").empty());
  BOOST_CHECK_THROW(query.zone(Pose(), Pose(), "nan"), Error);
}

BOOST_AUTO_TEST_SUITE_END()
