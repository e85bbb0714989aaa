#include "tetracone/tetratree/memory/pair_memory.h"

#include "tetracone/tetratree/query/bvh8_collision.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

BOOST_AUTO_TEST_SUITE(test_pair_memory)

using namespace tetracone::tetratree;
using namespace tetracone::verify::scenes;
using tetracone::kernel::Question;
using tetracone::kernel::Relation;

namespace {

/// Two rings through one another, nearer and farther, in contact now and then.
Pose linked(double t, double side)
{
  const double a = M_PI / 2 + 0.2 * t, c = std::cos(a), s = std::sin(a);
  return Pose(std::array<double, 12>{1, 0, 0, side * (3.85 + 0.15 * std::sin(t)), 0, c, -s, 0.05, 0, s, c, 0});
}

}  // namespace

BOOST_AUTO_TEST_CASE(many_pairs_share_a_query_and_keep_a_front_each)
{
  const Polyhedron ring = triangulated(torus(32, 20));
  const Bvh8 tree(ring, {});
  Bvh8_collision none(tree, tree), with(tree, tree);
  std::array<Pair_memory, 2> of_pairs;
  int differ = 0, collide = 0;
  std::uint64_t without_front = 0, with_front = 0;
  for (int k = 0; k < 200; ++k)
    for (int pair = 0; pair < 2; ++pair) {
      const Pose pose = linked(0.01 * k + pair, pair == 0 ? 1 : -1);
      const Question question = pair == 0 ? Question::surface : Question::solid;
      none.clear_counts();
      with.clear_counts();
      Pair_memory& memory = of_pairs[std::size_t(pair)];
      memory.allow_front(k > 0);
      const Relation expected = none.relation(Pose(), pose, question),
                     found = with.relation(Pose(), pose, question, &memory);
      differ += found != expected;
      collide += expected != Relation::apart;
      BOOST_TEST(with.certified_gap() <= none.certified_gap());
      if (expected != Relation::apart) continue;
      without_front += none.counts().box_tests;
      with_front += with.counts().box_tests;
    }
  BOOST_TEST(differ == 0);
  BOOST_TEST(collide > 20);
  BOOST_TEST(collide < 380);
  BOOST_TEST(3 * with_front < without_front);
  for (Pair_memory& memory : of_pairs) {
    BOOST_TEST(memory.bytes() > sizeof(Bvh8_front));
    memory.allow_front(false);
    BOOST_TEST(memory.bytes() == 0u);
  }
}

BOOST_AUTO_TEST_CASE(what_costs_little_gets_no_front)
{
  const Bvh8 tree(triangulated(cube(1)), {});
  Bvh8_collision query(tree, tree);
  Pair_memory memory;
  for (int k = 0; k < 20; ++k) {
    memory.allow_front(true);
    query.relation(Pose(), linked(0.01 * k, 0.4), Question::surface, &memory);
  }
  BOOST_TEST(memory.bytes() == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
