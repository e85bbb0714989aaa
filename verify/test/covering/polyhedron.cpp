#include "tetracone/covering/polyhedron.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_polyhedron)

using namespace tetracone::covering;
using namespace tetracone::verify::scenes;

std::vector<Index> indices(Loop loop) { return {loop.begin(), loop.end()}; }

BOOST_AUTO_TEST_CASE(append_turned_runs_every_loop_the_other_way_round_and_twice_gives_it_back)
{
  const Polyhedron tunnel = cube_with_tunnel();
  Polyhedron once, twice;
  append(once, tunnel, true);
  append(twice, once, true);
  BOOST_TEST((once.vertices == tunnel.vertices));
  BOOST_REQUIRE(once.face_count() == tunnel.face_count());
  for (Index f = 0; f < tunnel.face_count(); ++f) {
    BOOST_REQUIRE(once.loop_count(f) == tunnel.loop_count(f));
    for (std::size_t l = 0; l < tunnel.loop_count(f); ++l) {
      const Loop loop = tunnel.loop(f, l);
      BOOST_TEST(indices(once.loop(f, l)) == (std::vector<Index>{loop.rbegin(), loop.rend()}));
      BOOST_TEST(indices(twice.loop(f, l)) == indices(loop));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
