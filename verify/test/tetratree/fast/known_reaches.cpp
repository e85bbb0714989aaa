#include "tetracone/tetratree/fast/known_reaches.h"

#include "tetracone/tetratree/fast/support_table.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cstddef>
#include <thread>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_known_reaches)

using namespace tetracone::tetratree;
using namespace tetracone::verify::scenes;
namespace kernel = tetracone::kernel;

namespace {

/// The bounds of a table of the tree in all directions of the lattice, octant by octant.
std::vector<float> bounds_of(const Bvh8& tree)
{
  Support_table table(tree);
  std::vector<float> bounds;
  for (int octant = 0; octant < 8; ++octant)
    for (int i = 0; i <= 16; ++i)
      for (int j = 0; i + j <= 16; ++j) {
        const auto with_sign = [&](int axis, int x) { return octant >> axis & 1 ? -float(x) : float(x); };
        const kernel::Four_floats d = {with_sign(0, 16 - i - j), with_sign(1, i), with_sign(2, j), 0};
        const auto at = Support_table::place(d, kernel::sum_of_lanes(kernel::magnitudes(d)));
        table.find(at);
        bounds.push_back(kernel::sum_of_lanes(table.reach(at))[0]);
      }
  return bounds;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_known_is_not_found_again)
{
  const Known_reaches known;
  BOOST_TEST(known.bytes() == 0u);
  int found = 0;
  for (int round = 0; round < 2; ++round)
    for (std::size_t corner = 0; corner < Known_reaches::corners; corner += 7)
      BOOST_TEST(known.at(corner, [&] {
        ++found;
        return float(corner) - 100;
      }) == float(corner) - 100);
  BOOST_TEST(found == int((Known_reaches::corners + 6) / 7));
  BOOST_TEST(known.bytes() > 0u);
}

BOOST_AUTO_TEST_CASE(threads_that_ask_at_once_find_the_same)
{
  Random random(2);
  const Polyhedron body = blob(random, 4, 0.5, 1.5);
  const Bvh8 alone(body), shared(body);
  const std::vector<float> expected = bounds_of(alone);
  std::array<std::vector<float>, 4> bounds;
  std::vector<std::thread> threads;
  for (auto& own : bounds) threads.emplace_back([&] { own = bounds_of(shared); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& own : bounds) BOOST_TEST((own == expected));
}

BOOST_AUTO_TEST_SUITE_END()
