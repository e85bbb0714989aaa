#include "tetracone/tetratree/fast/bvh8_subtrees.h"

#include "tetracone/tetratree/fast/bvh8.h"
#include "verify/test/support/at_once.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <cstring>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bvh8_subtrees)

using namespace tetracone::tetratree;
using namespace tetracone::verify::scenes;

namespace {

/// Returns a function that calls work() by `count` threads at once.
auto by_threads(int count)
{
  return [count](const auto& work) {
    std::vector<std::thread> threads;
    for (int k = 0; k < count; ++k) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
  };
}

int differing_nodes(const Bvh8& a, const Bvh8& b)
{
  if (a.node_count() != b.node_count()) return -1;
  int differing = 0;
  for (Index n = 0; n < a.node_count(); ++n) {
    differing += std::memcmp(&a.node(n), &b.node(n), sizeof(Bvh8_node)) != 0;
    for (int lane = 0; lane < a.node(n).boxes.lane_count; ++lane)
      if (a.is_leaf({n, lane})) differing += a.element({n, lane}).face != b.element({n, lane}).face;
  }
  return differing;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_tree_is_the_same_whatever_the_threads)
{
  Random random(1);
  const Polyhedron body = blob(random, 6, 0.5, 1.5);
  BOOST_TEST(body.face_count() > 2 * tetracone::covering::most_in_part);  // several rounds
  const Bvh8 by_one(body), by_three(body, {}, {}, tetracone::verify::At_once()), by_none_but_the_last(body);
  by_one.make_all();
  by_three.make_all(by_threads(3), tetracone::verify::At_once());
  by_none_but_the_last.make_all([](const auto& work) {
    work();
    work();  // finds nothing left
  });
  BOOST_TEST(differing_nodes(by_one, by_three) == 0);
  BOOST_TEST(differing_nodes(by_one, by_none_but_the_last) == 0);
  BOOST_TEST(by_one.cuts().all == by_three.cuts().all);
  BOOST_TEST(by_one.cuts().tried_cones == by_three.cuts().tried_cones);
  BOOST_TEST(by_one.cuts().through_origin == by_three.cuts().through_origin);
}

BOOST_AUTO_TEST_CASE(a_tree_by_other_choices_is_the_same_whatever_the_threads)
{
  Random random(3);
  // Two apart, so that the origin lies before all of each: planes through it are tried on what several threads share.
  Polyhedron body = blob(random, 6, 0.5, 1.5), other = blob(random, 4, 0.5, 1.5);
  for (auto& v : body.vertices) v[0] += 5;
  for (auto& v : other.vertices) v[0] -= 5;
  append(body, other);
  for (const Bvh8_options& options :
       {Bvh8_options{}, Bvh8_options{.parts = 3, .leaf_size = 4}, Bvh8_options{.cuts = Cuts::through_origin},
        Bvh8_options{.cuts = Cuts::tetra_cones}}) {
    const Bvh8 by_one(body, {}, options), by_two(body, {}, options, tetracone::verify::At_once());
    by_one.make_all();
    by_two.make_all(by_threads(2), tetracone::verify::At_once());
    BOOST_TEST(differing_nodes(by_one, by_two) == 0);
    BOOST_TEST(by_one.cuts().all == by_two.cuts().all);
    BOOST_TEST(by_one.cuts().tried_cones == by_two.cuts().tried_cones);
    BOOST_TEST(by_one.cuts().through_origin == by_two.cuts().through_origin);
  }
}

BOOST_AUTO_TEST_CASE(what_queries_have_made_stays)
{
  Random random(2);
  const Polyhedron body = blob(random, 5, 0.5, 1.5);
  const Bvh8 whole(body), partly(body);
  whole.make_all();
  const Index top = partly.child({}), below = partly.child({top, 3});
  const Bvh8_node kept = partly.node(below);
  partly.make_all(by_threads(2));
  BOOST_TEST(partly.child({top, 3}) == below);
  BOOST_TEST(std::memcmp(&partly.node(below).boxes, &kept.boxes, sizeof(kept.boxes)) == 0);
  BOOST_TEST(partly.node_count() == whole.node_count());
  BOOST_TEST(partly.cuts().all == whole.cuts().all);
}

BOOST_AUTO_TEST_SUITE_END()
