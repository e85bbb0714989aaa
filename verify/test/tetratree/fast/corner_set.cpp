#include "tetracone/tetratree/fast/corner_set.h"

#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <set>

BOOST_AUTO_TEST_SUITE(test_corner_set)

using namespace tetracone::tetratree;
using namespace tetracone::verify::scenes;

BOOST_AUTO_TEST_CASE(corners_are_there_once_and_elements_know_theirs)
{
  Random random(1);
  // Triangles, and faces of any number of corners as a whole.
  for (const Polyhedron& body : {blob(random, 4, 0.5, 1.5), cube_with_tunnel()}) {
    const Bvh8_elements elements(body, {});
    Corner_set set;
    for (const Index first : {Index(0), Index(3)}) {
      const Index last = std::min(first + 60, elements.count());
      set.gather(elements, first, last);
      std::set<Index> all;
      int wrong = 0;
      for (Index e = first; e < last; ++e) {
        std::size_t k = 0;
        elements.for_vertices(elements[e], [&](Index v) {
          all.insert(v);
          wrong += set.points()[set.of(e - first)[k++]] != elements.local(v);
        });
        wrong += set.of(e - first).size() != k;
      }
      BOOST_TEST(wrong == 0);
      BOOST_TEST(set.points().size() == all.size());
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
