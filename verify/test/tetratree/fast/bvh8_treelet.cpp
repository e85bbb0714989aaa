#include "tetracone/tetratree/fast/bvh8_treelet.h"

#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <vector>

BOOST_AUTO_TEST_SUITE(test_bvh8_treelet)

using namespace tetracone::tetratree;
using namespace tetracone::verify::scenes;

namespace {

struct Nodes {
  std::vector<Bvh8_node> all;

  Index push_back(const Bvh8_node& node)
  {
    all.push_back(node);
    return Index(all.size() - 1);
  }
  Bvh8_node* data() { return all.data(); }

  /// The elements in leaves below node n, by where they are in the order.
  std::vector<Index> below(Index n)
  {
    std::vector<Index> found;
    for (int lane = 0; lane < all[n].boxes.lane_count; ++lane) {
      BOOST_TEST(all[n].is_made(lane));
      if (all[n].is_leaf(lane))
        found.push_back(all[n].first[lane]);
      else
        for (const Index e : below(Index(all[n].child[lane]))) found.push_back(e);
      BOOST_TEST(all[n].first[lane] <= found.back());
    }
    return found;
  }
};

/// A body of `count` triangles, all in one place.
Polyhedron stacked(int count)
{
  Polyhedron body;
  body.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (int k = 0; k < count; ++k) body.add_polygon({0, 1, 2});
  return body;
}

}  // namespace

BOOST_AUTO_TEST_CASE(nodes_of_any_count_of_elements_are_well_filled)
{
  Random random(1);
  const Polyhedron surface = blob(random, 4, 0.5, 1.5), heap = stacked(100);
  for (const Polyhedron* body : {&surface, &heap})
    for (Index count = 2; count <= Bvh8_treelet::most; ++count) {
      Bvh8_elements elements(*body, {});
      std::vector<Index> no_ends;
      Bvh8_treelet treelet(elements, {}, no_ends);
      Nodes nodes;
      BOOST_TEST(treelet.make(7, 7 + count, nodes) == 0u);
      const std::vector<Index> found = nodes.below(0);
      BOOST_REQUIRE(found.size() == count);
      for (Index k = 0; k < count; ++k) BOOST_TEST(found[k] == 7 + k);
      BOOST_TEST(nodes.all.size() >= (count + 5) / 7);  // each has seven lanes more than the one that it is
      BOOST_TEST(nodes.all.size() <= 1 + count / 3);
      std::vector<bool> faces(body->face_count(), false);
      for (Index e = 0; e < elements.count(); ++e) faces[elements[e].face] = true;
      BOOST_TEST(std::ranges::count(faces, true) == std::ptrdiff_t(body->face_count()));
    }
}

BOOST_AUTO_TEST_SUITE_END()
