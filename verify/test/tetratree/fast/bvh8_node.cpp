#include "tetracone/tetratree/fast/bvh8_node.h"

#include <boost/test/unit_test.hpp>

#include <cstddef>

BOOST_AUTO_TEST_SUITE(test_bvh8_node)

using namespace tetracone::tetratree;

BOOST_AUTO_TEST_CASE(a_node_is_made_of_whole_cache_lines_and_its_boxes_begin_one)
{
  BOOST_TEST(alignof(Bvh8_node) == 64u);
  BOOST_TEST(sizeof(Bvh8_node) % 64 == 0u);
  BOOST_TEST(offsetof(Bvh8_node, boxes) == 0u);
  BOOST_TEST(std::tuple_size_v<decltype(Bvh8_node::child)> == tetracone::kernel::lanes);
  BOOST_TEST(std::tuple_size_v<decltype(Bvh8_node::first)> == tetracone::kernel::lanes);
  BOOST_TEST(sizeof(Bvh8_node) == 576u);
}

BOOST_AUTO_TEST_CASE(what_is_no_node_is_negative_and_says_where_its_elements_end)
{
  for (const std::uint32_t last : {1u, 2u, 1000u, Bvh8_node::most_elements}) {
    BOOST_TEST(Bvh8_node::not_made(last) < 0);
    BOOST_TEST(!(Bvh8_node::not_made(last) <= Bvh8_node::last_leaf));
    BOOST_TEST(Bvh8_node::last_of(Bvh8_node::not_made(last)) == last);
  }
}

BOOST_AUTO_TEST_CASE(a_leaf_is_negative_and_says_where_its_triangle_lies)
{
  for (const int apex : {0, 1, 32768, 65535}) {
    const std::int32_t code = Bvh8_node::leaf(tetracone::kernel::Apex_code(apex));
    BOOST_TEST(code < 0);
    BOOST_TEST((code <= Bvh8_node::last_leaf));
    BOOST_TEST(Bvh8_node::apex(code) == apex);
  }
  for (const std::int32_t node : {0, 1, 1000000, 0x7fffffff}) BOOST_TEST(!(node <= Bvh8_node::last_leaf));
}

BOOST_AUTO_TEST_SUITE_END()
