#include "tetracone/tetratree/fast/cone_order.h"

#include <boost/test/unit_test.hpp>

#include <vector>

BOOST_AUTO_TEST_SUITE(test_cone_order)

using namespace tetracone::tetratree;
using tetracone::covering::Index;
using tetracone::kernel::Vector;

BOOST_AUTO_TEST_CASE(octants_part_first_then_the_children_of_the_one_that_holds_all)
{
  std::vector<Vector> points = {{1, 1, 1}, {-1, 1, 1}, {2, 1, 1}, {1, -1, -1}};
  std::vector<Index> order = {0, 1, 2, 3};
  const auto centroid = [&](Index e) { return points[e]; };
  BOOST_TEST(order_by_cones(order, centroid) == (std::vector<std::size_t>{0, 2, 3}), boost::test_tools::per_element());
  BOOST_TEST(order == (std::vector<Index>{0, 2, 1, 3}), boost::test_tools::per_element());
  // Near x, near y, near z, and in the middle.
  points = {{1, 1, 1}, {1, 1, 9}, {9, 1, 1}, {1, 9, 1}};
  order = {0, 1, 2, 3};
  BOOST_TEST(order_by_cones(order, centroid) == (std::vector<std::size_t>{0, 1, 2, 3}),
             boost::test_tools::per_element());
  BOOST_TEST(order == (std::vector<Index>{2, 3, 1, 0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(weights_of_a_child_are_those_of_its_rays)
{
  const Vector rays[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto middle = [&](int i, int j) { return Vector(0.5 * (rays[i] + rays[j])); };
  for (const Vector& p : {Vector(5, 1, 2), Vector(1, 5, 2), Vector(0.5, 1, 7), Vector(2, 3, 4)}) {
    Vector w = p;
    const int child = child_cone_of(w);
    Vector sum;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      sum += w[i] * (child == 3 ? middle(j, k) : i == child ? rays[i] : middle(i, child));
    }
    BOOST_TEST((sum - p).norm() < 1e-12);
    BOOST_TEST(tetracone::kernel::minimum(w[0], w[1], w[2]) >= 0);
  }
}

BOOST_AUTO_TEST_CASE(what_lies_on_one_ray_is_one_part)
{
  const std::vector<Vector> points = {{1, 2, 3}, {2, 4, 6}, {0.5, 1, 1.5}};
  std::vector<Index> order = {0, 1, 2};
  BOOST_TEST(order_by_cones(order, [&](Index e) { return points[e]; }).size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
