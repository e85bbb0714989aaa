#include "tetracone/tetratree/paper/placed_tree.h"

#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_placed_tree)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using rationals::Vector;
using scenes::Random;

namespace {

using K = Adaptive;

Config config_of(int n)
{
  Config config;
  config.depth = n % 6;
  config.leaf_size = n % 4;
  config.on_demand = n % 2 == 1;
  return config;
}

std::vector<Pose> poses(Random& random)
{
  return {Pose(),
          scenes::random_rotation(random, 5, {Rational(1) / Rational(3), -1, 7}),
          scenes::rounded(scenes::random_rotation(random)),
          scenes::random_affine(random),
          Pose(std::array<double, 12>{-1, 0, 0, 5, 0, 1, 0, 0.1, 0, 0, 1, -0.3}),
          scenes::translation(0x1p30, 0.1, -0x1p-30)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_question_about_a_point_makes_only_the_nodes_of_its_cones)
{
  Random random(3);
  Config config;
  config.depth = 5;
  config.leaf_size = 1;
  config.on_demand = true;
  Tetra_tree<K> tree(scenes::blob(random, 3, 0.8, 1), config);
  Placed_tree<K> placed(tree);
  placed.place(Pose());
  BOOST_TEST(tree.node_count() == 1u);
  BOOST_TEST(placed.contains(point<K>({0.1, 0.2, 0.3})));
  BOOST_TEST(tree.node_count() <= 1u + 8 + 4 * 4);
  const std::size_t made = tree.node_count();
  BOOST_TEST(!placed.contains(point<K>({1, 2, 3})));
  BOOST_TEST(tree.node_count() == made);
}

BOOST_AUTO_TEST_CASE(the_reference_plane_faces_the_point_and_has_the_body_behind_it)
{
  Random random(5);
  int found = 0, tried = 0;
  for (const auto& [name, body] : scenes::closed_bodies()) {
    BOOST_TEST_INFO_SCOPE(name);
    for (const Pose& pose : poses(random)) {
      Tetra_tree<K> tree(body, config_of(++tried));
      Placed_tree<K> placed(tree);
      placed.place(pose);
      const auto origin = placed.origin();
      Bound_point<double> far;
      const Vertex d = scenes::real_vertex(random, 1000);
      for (int k = 0; k < 3; ++k) far[k] = origin[k] + d[k];
      const auto plane = placed.reference(far);
      const double slack = projection_slack(placed.frame(), placed.frame());
      found += plane.is_beyond(far, slack);
      BOOST_TEST(!plane.is_beyond(origin, slack));
      for (const Vertex& v : body.vertices) BOOST_TEST(!plane.is_beyond(placed.frame()(v), slack));
    }
  }
  BOOST_TEST(found > tried * 9 / 10);
}

BOOST_AUTO_TEST_SUITE_END()
