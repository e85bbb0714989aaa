#include "tetracone/tetratree/scene/box_tree.h"

#include "verify/cases/random.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_box_tree)

using namespace tetracone::tetratree;
using tetracone::verify::Random;

namespace {

World_box random_box(Random& random, float size)
{
  World_box box;
  for (int k = 0; k < 3; ++k) {
    box.low[k] = float(random.unit());
    box.high[k] = box.low[k] + size * float(random.unit());
  }
  return box;
}

using Pairs = std::vector<std::pair<Box_tree::Item, Box_tree::Item>>;

/// Returns the found pairs with at least one marked item, of the tree searched in `parts` parts.
Pairs found(const Box_tree& tree, std::size_t parts)
{
  Pairs pairs;
  for (const Box_tree::Part& part : tree.parts(parts))
    tree.for_meeting(part, [&](Box_tree::Item a, Box_tree::Item b) { pairs.push_back(std::minmax(a, b)); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs expected(const Box_tree& tree, const std::vector<World_box>& boxes, const std::vector<bool>& is_marked)
{
  Pairs pairs;
  for (Box_tree::Item a = 0; a < boxes.size(); ++a)
    for (Box_tree::Item b = a + 1; b < boxes.size(); ++b)
      if (tree.holds(a) && tree.holds(b) && (is_marked[a] || is_marked[b]) && boxes[a].meets(boxes[b]))
        pairs.push_back({a, b});
  return pairs;
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_finds_each_pair_of_a_marked_item_once_after_boxes_have_changed_and_gone)
{
  Random random(5);
  for (const std::size_t n : {0, 1, 2, 7, 8, 9, 65, 700}) {
    std::vector<World_box> boxes;
    for (std::size_t i = 0; i < n; ++i) boxes.push_back(random_box(random, i % 10 == 0 ? 0.5f : 0.05f));
    if (n > 2) boxes[2] = World_box();
    std::vector<Box_tree::Item> items(n);
    std::iota(items.begin(), items.end(), 0);
    Box_tree tree;
    tree.build(boxes, items);
    for (int round = 0; round < 6; ++round) {
      for (const std::size_t one_in : {1, 2, 30, 1000}) {
        std::vector<bool> is_marked(n);
        for (Box_tree::Item i = 0; i < n; ++i)
          if (tree.holds(i) && random.unit() * double(one_in) < 1) {
            is_marked[i] = true;
            tree.mark(i);
          }
        for (const std::size_t parts : {1, 64}) BOOST_TEST((found(tree, parts) == expected(tree, boxes, is_marked)));
        for (Box_tree::Item i = 0; i < n; ++i)
          if (is_marked[i]) tree.unmark(i);
        BOOST_TEST(found(tree, 1).empty());
      }
      for (Box_tree::Item i = 0; i < n; i += 3) {
        boxes[i] = random_box(random, 0.1f);
        if (round % 2 == 0 && tree.holds(i)) tree.set(i, boxes[i]);
      }
      if (round % 2 == 1) tree.set_all(boxes);
      for (std::size_t i = std::size_t(round); i < n; i += 5)
        if (tree.holds(Box_tree::Item(i))) tree.remove(Box_tree::Item(i));
    }
  }
}

BOOST_AUTO_TEST_CASE(it_is_worn_when_searches_open_much_more_than_when_it_was_new)
{
  Box_tree tree;
  const std::vector<World_box> boxes(100);
  std::vector<Box_tree::Item> items(100);
  std::iota(items.begin(), items.end(), 0);
  tree.build(boxes, items);
  tree.count_searches(100, 300);
  tree.count_searches(1000, 3000);
  BOOST_TEST(!tree.is_worn());
  tree.count_searches(100, 3000);
  BOOST_TEST(tree.is_worn());
  tree.build(boxes, items);
  BOOST_TEST(!tree.is_worn());
}

BOOST_AUTO_TEST_SUITE_END()
