#include "tetracone/kernel/bound/bound_box.h"

#include "verify/test/support/scenes.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_bound_box)

using namespace tetracone::kernel;
using namespace tetracone::verify::scenes;
using Points = std::vector<Bound_point<double>>;

Points random_points(Random& random, const Bound_point<double>& flat)
{
  Points points;
  for (int k = 0; k < 20; ++k) {
    Bound_point<double> p;
    for (int i = 0; i < 3; ++i) p[i] = flat[i] * real(random, -1, 1) + 7;
    points.push_back(p);
  }
  return points;
}

BOOST_AUTO_TEST_CASE(a_box_is_apart_from_no_point_that_it_holds)
{
  Random random(1);
  for (const Bound_point<double>& flat :
       {Bound_point<double>{1, 1, 1}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}, {1, 1e-9, 1e9}})
    for (int k = 0; k < 50; ++k) {
      const Points points = random_points(random, flat);
      const auto box = bound_box<double>(points);
      for (const auto& p : points) {
        Bound_box<double> dot;
        dot.fill(p);
        BOOST_TEST(!separated(box, dot, 0.0));
        BOOST_TEST(!separated(dot, box, 0.0));
      }
    }
}

BOOST_AUTO_TEST_CASE(boxes_with_a_gap_between_faces_or_edges_are_told_apart)
{
  const auto box = [](double x, double y, double z) {
    Points points;
    for (int k = 0; k < 8; ++k) points.push_back({x + (k & 1) * 2, y + (k >> 1 & 1), z + (k >> 2 & 1) * 0.5});
    return bound_box<double>(points);
  };
  BOOST_TEST(separated(box(0, 0, 0), box(2.001, 0, 0), 0.0));
  BOOST_TEST(!separated(box(0, 0, 0), box(1.999, 0, 0), 0.0));
  BOOST_TEST(!separated(box(0, 0, 0), box(2.001, 0, 0), 0.01));  // within the slack
  // Two bars across each other, apart along the cross product of their edges alone.
  const Bound_box<double> along = bound_box<double>(Points{{-1, -1, 0}, {1, 1, 0}, {-1, -1, 0.01}, {1, 1, 0.01}}),
                          across =
                              bound_box<double>(Points{{-1, 1, 0.05}, {1, -1, 0.05}, {-1, 1, 0.06}, {1, -1, 0.06}});
  BOOST_TEST(separated(along, across, 0.0));
}

BOOST_AUTO_TEST_CASE(what_overflows_is_apart_from_nothing)
{
  const auto huge = bound_box<double>(Points{{1e308, 1e308, 0}, {-1e308, 1, 1e308}, {1e308, -1e308, -1e308}});
  Bound_box<double> dot;
  dot.fill({0, 0, 0});
  BOOST_TEST(!separated(huge, dot, 0.0));
  BOOST_TEST(!separated(huge, bound_box<double>(Points{{5, 5, 5}}), std::numeric_limits<double>::infinity()));
}

BOOST_AUTO_TEST_SUITE_END()
