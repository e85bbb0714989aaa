#include "tetracone/tetratree/query_statistics.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_query_statistics)

using namespace tetracone::tetratree;

BOOST_AUTO_TEST_CASE(counts_begin_at_zero)
{
  const Query_statistics counts;
  BOOST_TEST(counts.queries == 0u);
  BOOST_TEST(counts.bounding_tests() == 0u);
  BOOST_TEST(counts.primitive_tests() == 0u);
}

BOOST_AUTO_TEST_CASE(sums_are_of_tests_not_of_what_they_discard)
{
  Query_statistics counts;
  counts.hull_tests = 1;
  counts.sphere_tests = 20;
  counts.tetrahedron_tests = 300;
  counts.discarded_by_hull = counts.discarded_by_sphere = counts.discarded_by_tetrahedron = counts.discarded_by_box = 7;
  counts.edge_face_tests = 4000;
  counts.inclusion_tests = 50000;
  BOOST_TEST(counts.bounding_tests() == 321u);
  BOOST_TEST(counts.primitive_tests() == 54000u);
}

BOOST_AUTO_TEST_CASE(statistics_add_up_field_by_field)
{
  Query_statistics a, b;
  a.queries = 1;
  a.leaf_pairs = 20;
  b.leaf_pairs = 300;
  b.exact_fallbacks = 4000;
  a += b;
  BOOST_TEST(a.queries == 1u);
  BOOST_TEST(a.leaf_pairs == 320u);
  BOOST_TEST(a.exact_fallbacks == 4000u);
  BOOST_TEST(a.pairs_visited == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
