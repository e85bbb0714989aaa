#include "verify/truth/planar_face.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_planar_face)

using namespace tetracone::verify;
using tetracone::kernel::Rational;

namespace {

using Point_2 = Exact::Point_2;
using Point_3 = Exact::Point_3;
using Grid = std::array<int, 2>;
using Grid_loops = std::vector<std::vector<Grid>>;

/// A plane of points origin + x u + y v.
struct Plane {
  std::array<int, 3> origin, u, v;
  Point_3 operator()(const Rational& x, const Rational& y) const
  {
    const auto at = [&](int i) { return Rational(origin[i] + x * u[i] + y * v[i]); };
    return {at(0), at(1), at(2)};
  }
  Point_3 operator()(const Grid& p) const { return (*this)(p[0], p[1]); }
};

/// Planes whose normals are largest in each component and of each sign, two of them axis-parallel.
const std::array<Plane, 7> planes = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                      {{1, 2, 3}, {0, 1, 0}, {0, 0, 1}},
                                      {{-1, 0, 5}, {1, 0, 1}, {0, 1, 1}},
                                      {{2, 1, 0}, {0, 1, 3}, {1, 0, -2}},
                                      {{0, 4, 0}, {3, 1, 0}, {0, 1, 2}},
                                      {{0, 0, -7}, {2, -1, 1}, {1, 3, 4}},
                                      {{5, 5, 5}, {-1, 0, 1}, {1, -1, 0}}}};

Planar_face face_on(const Plane& plane, const Grid_loops& loops)
{
  std::vector<std::vector<Point_3>> placed;
  for (const auto& loop : loops) {
    placed.emplace_back();
    for (const Grid& p : loop) placed.back().push_back(plane(p));
  }
  return Planar_face(placed);
}

/// Where 2 * p is, by whole numbers and angles: no orientation test and no ray.
Place place_by_angles(const Grid_loops& loops, const Grid& twice)
{
  bool on_edge = false;
  double angle = 0;
  for (const auto& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Grid a = loop[k], b = loop[(k + 1) % loop.size()];
      const int ax = 2 * a[0] - twice[0], ay = 2 * a[1] - twice[1], bx = 2 * b[0] - twice[0], by = 2 * b[1] - twice[1];
      if (ax == 0 && ay == 0) return Place::vertex;
      const int cross = ax * by - ay * bx, dot = ax * bx + ay * by;
      if (cross == 0 && dot < 0) on_edge = true;
      angle += std::atan2(double(cross), double(dot));
    }
  // A corner may stand later in the list than an edge through it: corners were looked for in all of it.
  if (on_edge) return Place::edge;
  return std::lround(angle / (2 * std::numbers::pi)) != 0 ? Place::face : Place::outside;
}

void check_on_grid(const Grid_loops& loops, int low, int high)
{
  for (const Plane& plane : planes) {
    const Planar_face face = face_on(plane, loops);
    for (int x = 2 * low; x <= 2 * high; ++x)
      for (int y = 2 * low; y <= 2 * high; ++y) {
        const Point_3 p = plane(Rational(x) / 2, Rational(y) / 2);
        BOOST_TEST_INFO_SCOPE("point (" << x << ", " << y << ") / 2");
        BOOST_TEST((face.locate(p) == place_by_angles(loops, {x, y})));
        if (!face.base()) continue;
        BOOST_TEST((face.side(p) == CGAL::ZERO));
        BOOST_TEST((face.lift(face.project(p)) == p));
      }
  }
}

const Grid_loops holed_square = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}};

}  // namespace

BOOST_AUTO_TEST_CASE(a_hole_is_outside_and_its_boundary_is_not)
{
  check_on_grid(holed_square, -1, 5);
  const Planar_face face = face_on(planes[5], holed_square);
  BOOST_TEST((face.locate(planes[5](2, 2)) == Place::outside));
  BOOST_TEST((face.locate(planes[5](1, 2)) == Place::edge));
  BOOST_TEST((face.locate(planes[5](3, 3)) == Place::vertex));
  BOOST_TEST((face.locate(planes[5](Rational(1) / 2, 2)) == Place::face));
}

BOOST_AUTO_TEST_CASE(loops_that_cross_touch_or_run_twice_are_located_by_their_winding_number)
{
  check_on_grid({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, -1, 5);                                    // a bow tie
  check_on_grid({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}}, -1, 5);    // twice around
  check_on_grid({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}}, -1, 5);  // 2 in the inner square
  check_on_grid({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 0}, {0, 4}, {4, 4}, {4, 0}}}, -1,
                5);                                                          // all but the loops cancel
  check_on_grid({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}, -1, 5);          // touches its own edge
  check_on_grid({{{0, 0}, {4, 0}, {2, 0}, {2, 2}, {2, 0}, {0, 4}}}, -1, 5);  // spurs
  check_on_grid({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 2}}}, -1, 5);        // a loop that is a point
}

BOOST_AUTO_TEST_CASE(random_loops_agree_with_angles)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> coordinate(0, 4), size(1, 7), count(1, 2);
  for (int round = 0; round < 25; ++round) {
    Grid_loops loops(count(random));
    for (auto& loop : loops) {
      loop.resize(size(random));
      for (Grid& p : loop) p = {coordinate(random), coordinate(random)};
    }
    BOOST_TEST_INFO_SCOPE("round " << round);
    check_on_grid(loops, -1, 5);
  }
}

BOOST_AUTO_TEST_CASE(faces_on_a_line_or_in_a_point_are_their_loops)
{
  const Planar_face line({{{0, 0, 0}, {2, 2, 2}, {1, 1, 1}}});
  BOOST_TEST(!line.base());
  BOOST_TEST(line.is_planar());
  BOOST_TEST((line.locate({1, 1, 1}) == Place::vertex));
  BOOST_TEST((line.locate({Rational(1) / 2, Rational(1) / 2, Rational(1) / 2}) == Place::edge));
  BOOST_TEST((line.locate({3, 3, 3}) == Place::outside));
  BOOST_TEST((line.locate({1, 1, 0}) == Place::outside));
  const Planar_face point({{{1, 2, 3}, {1, 2, 3}}});
  BOOST_TEST(!point.base());
  BOOST_TEST((point.locate({1, 2, 3}) == Place::vertex));
  BOOST_TEST((point.locate({1, 2, 4}) == Place::outside));
}

BOOST_AUTO_TEST_CASE(a_base_is_three_corners_that_are_not_on_one_line_wherever_they_stand)
{
  const Planar_face face({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{1, 0, 0}, {1, 1, 0}}});
  BOOST_TEST_REQUIRE(face.base().has_value());
  const auto& [p, q, r] = *face.base();
  BOOST_TEST(!CGAL::collinear(p, q, r));
  BOOST_TEST((face.locate({1, Rational(1) / 2, 0}) == Place::edge));
}

BOOST_AUTO_TEST_CASE(planar_means_exactly_planar)
{
  BOOST_TEST(Planar_face({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}).is_planar());
  BOOST_TEST(!Planar_face({{{0, 0, 0}, {1, 0, 0}, {1, 1, Rational(5e-324)}, {0, 1, 0}}}).is_planar());
  BOOST_TEST(!Planar_face({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 1}}}).is_planar());
}

BOOST_AUTO_TEST_SUITE_END()
