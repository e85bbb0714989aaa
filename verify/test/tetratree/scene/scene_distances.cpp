#include "tetracone/tetratree/scene/scene.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_scene_distances)

using namespace tetracone;
namespace scenes = verify::scenes;

BOOST_AUTO_TEST_CASE(near_pairs_of_cubes_on_integers_are_those_of_their_gaps)
{
  scenes::Random random(4650);
  std::size_t near = 0, at_limit = 0;
  for (int round = 0; round < 20; ++round) {
    Scene scene({.threads = std::size_t(1 + round % 2)});
    const std::array models = {scene.add_model(Body(scenes::cube(1))), scene.add_model(Body(scenes::cube(2)))};
    constexpr int count = 14;
    std::array<std::array<int, 3>, count> place{};
    for (std::size_t k = 0; k < count; ++k) {
      scene.add_body(models[k % 2]);
      // Far from the origin, floats round boxes.
      for (int& x : place[k]) x = scenes::integer(random, -8, 8) + (round % 4 == 0 ? 1 << 25 : 0);
      scene.place(k, Pose::translation(place[k][0], place[k][1], place[k][2]));
    }
    scene.ignore(1, 4);
    for (const int limit : {0, 1, 3, 5}) {
      std::vector<std::array<double, 3>> expected, found;
      for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = a + 1; b < count; ++b) {
          int square = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            const int gap = std::max(0, std::abs(place[a][k] - place[b][k]) - int(1 + a % 2) - int(1 + b % 2));
            square += gap * gap;
          }
          if (square > limit * limit || (a == 1 && b == 4)) continue;
          expected.push_back({double(a), double(b), std::sqrt(double(square))});
          at_limit += square == limit * limit;
        }
      for (const auto& [pair, distance] : scene.pairs_within(std::to_string(limit)))
        found.push_back({double(pair.a), double(pair.b), distance});
      BOOST_TEST((found == expected));
      near += found.size();
    }
    BOOST_TEST(scene.pairs_within("-1").empty());
    std::vector<Scene_pair> colliding;
    for (const Scene_distance& each : scene.pairs_within("0")) colliding.push_back(each.pair);
    BOOST_TEST((scene.pairs() == colliding));
  }
  BOOST_TEST(near > 1000u);
  BOOST_TEST(at_limit > 100u);
  Scene empty;
  empty.add_body(empty.add_model(Body(scenes::cube(1))));
  BOOST_CHECK_THROW(empty.pairs_within("1"), Error);
  BOOST_CHECK_THROW(empty.pairs_within("one"), Error);
}

BOOST_AUTO_TEST_SUITE_END()
