#include "tetracone/tetratree/paper/placed_tree.h"

#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_placed_tree)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
namespace scenes = tetracone::verify::scenes;
using K = Adaptive;

BOOST_AUTO_TEST_CASE(a_question_about_a_point_makes_only_the_nodes_of_its_cones)
{
  scenes::Random random(3);
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

BOOST_AUTO_TEST_CASE(a_point_on_the_border_of_cones_is_in_one_of_them)
{
  Config config;
  config.depth = 3;
  config.leaf_size = 1;
  Tetra_tree<K> tree(scenes::cube(1), config);
  Placed_tree<K> placed(tree);
  placed.place(Pose());
  for (const Vertex& p : {Vertex{0.5, 0, 0}, {0.25, 0.5, 0}, {0.25, 0.25, 0.25}, {0, 0, -0.5}})
    BOOST_TEST(placed.contains(point<K>(p)));
}

BOOST_AUTO_TEST_SUITE_END()
