#include "tetratree/wide_node.h"

#include <boost/test/unit_test.hpp>

#include <cstddef>

using namespace tetracone::tetratree;

BOOST_AUTO_TEST_CASE(a_node_is_made_of_whole_cache_lines_and_its_boxes_begin_one)
{
  BOOST_TEST(alignof(Wide_node) == 64u);
  BOOST_TEST(sizeof(Wide_node) % 64 == 0u);
  BOOST_TEST(offsetof(Wide_node, boxes) == 0u);
  BOOST_TEST(std::tuple_size_v<decltype(Wide_node::child)> == tetracone::kernel::lanes);
  BOOST_TEST(std::tuple_size_v<decltype(Wide_node::first)> == tetracone::kernel::lanes);
  BOOST_TEST(sizeof(Wide_node) == 576u);
}

BOOST_AUTO_TEST_CASE(what_is_no_node_is_negative_and_says_where_its_elements_end)
{
  for (const std::uint32_t last : {1u, 2u, 1000u, Wide_node::most_elements}) {
    BOOST_TEST(Wide_node::not_made(last) < 0);
    BOOST_TEST(!Wide_node::is_leaf(Wide_node::not_made(last)));
    BOOST_TEST(Wide_node::last_of(Wide_node::not_made(last)) == last);
  }
}

BOOST_AUTO_TEST_CASE(a_leaf_is_negative_and_says_where_its_triangle_lies)
{
  for (const int apex : {0, 1, 32768, 65535}) {
    const std::int32_t code = Wide_node::leaf(tetracone::kernel::Apex_code(apex));
    BOOST_TEST(code < 0);
    BOOST_TEST(Wide_node::is_leaf(code));
    BOOST_TEST(Wide_node::apex(code) == apex);
  }
  for (const std::int32_t node : {0, 1, 1000000, 0x7fffffff}) BOOST_TEST(!Wide_node::is_leaf(node));
}
