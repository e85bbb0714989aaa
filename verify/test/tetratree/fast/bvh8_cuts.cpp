#include "tetracone/tetratree/fast/bvh8_cuts.h"

#include <boost/test/unit_test.hpp>

#include <limits>

BOOST_AUTO_TEST_SUITE(test_bvh8_cuts)

using namespace tetracone::tetratree;
using tetracone::kernel::Vector;

namespace {

Binned_cuts::Four four(const Vector& p) { return Binned_cuts::Four{float(p[0]), float(p[1]), float(p[2]), 0}; }

}  // namespace

BOOST_AUTO_TEST_CASE(clusters_are_parted_where_one_ends)
{
  for (const double gap : {0.3, 0.6}) {
    Binned_cuts cuts({Vector(0, 0, 1), {}}, 0.5, 0.75);
    for (int k = 0; k < 100; ++k) {
      const double along = k < 30 ? 0.001 * k : gap + 0.001 * k;
      const Vector p(0.01 * (k % 7), 0.01 * (k % 5), along);
      cuts.add(p, four(p), four(p));
    }
    const Cut cut = cuts.best();
    BOOST_TEST(cut.place > 0.029);
    BOOST_TEST(cut.place < gap + 0.03);
    BOOST_TEST(cut.cost < 1);
  }
}

BOOST_AUTO_TEST_CASE(no_side_has_less_than_an_eighth)
{
  Binned_cuts cuts({Vector(1, 0, 0), {}}, 0, 1);
  const auto add = [&](double x) {
    const Vector p(x, 0.5 * (x > 0), 0.25 * (x > 0));
    cuts.add(p, four(p), four(p));
  };
  for (int k = 0; k < 7; ++k) add(-0.9);
  for (int k = 0; k < 93; ++k) add(0.5 + 1e-3 * k);
  const Cut cut = cuts.best();
  BOOST_TEST(cut.place > 0.5);
  // In one bin all are: no cut.
  Binned_cuts none({Vector(1, 0, 0), {}}, 0, 1);
  for (int k = 0; k < 20; ++k) none.add(Vector(0.01, 0, 0), four(Vector(0, 0, 0)), four(Vector(0.01, 0, 0)));
  BOOST_TEST(none.best().cost == std::numeric_limits<double>::infinity());
}

BOOST_AUTO_TEST_CASE(halves_added_cut_as_the_whole)
{
  const Binned_cuts none({Vector(0, 0, 1), {}}, 0.5, 0.75);
  Binned_cuts whole = none, first = none, second = none;
  for (int k = 0; k < 100; ++k) {
    const Vector p(0.01 * (k % 7), 0.01 * (k % 5), (k % 10 < 3 ? 0 : 0.4) + 0.001 * k), q = p + Vector(0.1, 0.01, 0);
    whole.add(p, four(p), four(q));
    (k < 40 ? first : second).add(p, four(p), four(q));
  }
  BOOST_TEST(first.best().cost < whole.best().cost);
  first.add(second);
  BOOST_TEST(first.best().cost == whole.best().cost);
  BOOST_TEST(first.best().place == whole.best().place);
}

BOOST_AUTO_TEST_CASE(a_place_that_is_no_number_is_in_some_bin)
{
  // Planes through the origin, and points there and behind it.
  Binned_cuts cuts({Vector(1, 0, 0), Vector(0, 0, 1)}, 0, 1e-30);
  for (const Vector& p : {Vector(0, 0, 0), Vector(1, 0, 0), Vector(-1, 0, 0), Vector(1, 0, -1), Vector(1, 0, 1)})
    cuts.add(p, four(p), four(p));
  const Cut cut = cuts.best();
  BOOST_TEST(cut.pencil.place(Vector(0.5, 0, 2)) == 0.25);
  BOOST_TEST(cut.cost < 100);
}

BOOST_AUTO_TEST_SUITE_END()
