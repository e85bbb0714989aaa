#include "tetracone/tetratree/scene/box_tree.h"

#include "verify/cases/random.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>
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

std::vector<Box_tree::Item> found(const Box_tree& tree, const World_box& box)
{
  std::vector<Box_tree::Item> items;
  tree.for_meeting(box, [&](Box_tree::Item item) { items.push_back(item); });
  std::sort(items.begin(), items.end());
  return items;
}

std::vector<Box_tree::Item> expected(const Box_tree& tree, const std::vector<World_box>& boxes, const World_box& box)
{
  std::vector<Box_tree::Item> items;
  for (Box_tree::Item item = 0; item < boxes.size(); ++item)
    if (tree.holds(item) && boxes[item].meets(box)) items.push_back(item);
  return items;
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_finds_what_meets_after_boxes_have_changed_and_gone)
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
    for (int round = 0; round < 3; ++round) {
      for (int k = 0; k < 50; ++k) {
        const World_box box = k == 0 ? World_box() : random_box(random, 0.2f);
        BOOST_TEST(found(tree, box) == expected(tree, boxes, box));
      }
      for (std::size_t i = 0; i < n; i += 3)
        if (tree.holds(Box_tree::Item(i))) tree.set(Box_tree::Item(i), boxes[i] = random_box(random, 0.1f));
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
