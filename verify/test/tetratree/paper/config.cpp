#include "tetracone/tetratree/paper/config.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_config)

using namespace tetracone::tetratree;

BOOST_AUTO_TEST_CASE(the_default_is_the_papers_method)
{
  const Config config;
  BOOST_TEST(config.depth == Config::by_size);
  BOOST_TEST((config.far_plane == Far_plane::shortened));
  BOOST_TEST((config.sphere_centre == Sphere_centre::centroid));
  BOOST_TEST((config.descent == Descent::larger_first));
  BOOST_TEST(config.regular_hull);
  BOOST_TEST(config.all_axes);
  BOOST_TEST(!config.leaf_boxes);
  BOOST_TEST(!config.on_demand);
  // The loop ends: what is shortened and lengthened again is still shorter.
  BOOST_TEST((1 - config.shorten_by) * (1 + config.lengthen_by) < 1);
}

BOOST_AUTO_TEST_CASE(the_other_choices_are_what_their_names_say)
{
  BOOST_TEST(Config::brute().depth == 0);
  BOOST_TEST(Config::fastest().all_axes);
  BOOST_TEST((Config::fastest().far_plane == Far_plane::tightest));
}

BOOST_AUTO_TEST_SUITE_END()
