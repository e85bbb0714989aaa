#include "tetracone/tetratree/locator/point_locator.h"

#include "verify/test/support/scenes.h"
#include "verify/truth/point_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_point_locator)

namespace scenes = tetracone::verify::scenes;
namespace verify = tetracone::verify;
using namespace tetracone::tetratree;
using tetracone::covering::Polyhedron;
using tetracone::covering::Vertex;
using tetracone::kernel::Rational;

namespace {

using Model = Point_locator::Model;

}  // namespace

BOOST_AUTO_TEST_CASE(every_point_is_where_the_truth_has_it_alone_and_with_others)
{
  scenes::Random random(20261);
  std::array<long, 3> answers{};
  for (const auto& [name, body] : scenes::bodies_of_any_size()) {
    BOOST_TEST_INFO_SCOPE(name);
    const Model model(body);
    const Point_locator locator(model);
    const verify::Point_truth truth(body);
    const std::vector<Vertex> points = scenes::hard_points(body, model.lattice().origin, random);
    std::vector<tetracone::covering::Location> together(points.size());
    locator.locate(points, together);
    int wrong = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const int expected = truth(points[k]);
      ++answers[expected + 1];
      wrong += int(locator.locate(points[k])) != expected || int(together[k]) != expected;
    }
    BOOST_TEST(wrong == 0);
  }
  for (const long count : answers) BOOST_TEST(count > 100);
}

BOOST_AUTO_TEST_CASE(a_triangle_behind_the_origin_does_not_decide)
{
  const Model model(scenes::tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  const Point_locator locator(model);
  for (int k = 0; k <= 64; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      Vertex on_edge{};
      on_edge[std::size_t(axis)] = k / 64.0;
      BOOST_TEST((locator.locate(on_edge) == tetracone::covering::Location::on_surface));
    }
}

BOOST_AUTO_TEST_CASE(fractions_are_located_as_they_are)
{
  scenes::Random random(5);
  const Polyhedron body = scenes::cube_with_tunnel();
  const Model model(body);
  const Point_locator locator(model);
  const verify::Point_truth truth(body);
  std::array<long, 3> answers{};
  for (int k = 0; k < 300; ++k) {
    std::array<Rational, 3> p;
    for (Rational& x : p) x = Rational(scenes::integer(random, -9, 9)) / 3;
    if (k % 2 == 0) p[k / 2 % 3] += Rational(1) / Rational("1000000000000000000000000000000000000000007");
    const int expected = truth(p);
    ++answers[expected + 1];
    BOOST_TEST(int(locator.locate(p)) == expected);
  }
  for (const long a : answers) BOOST_TEST(a > 20);
}

BOOST_AUTO_TEST_CASE(fractions_beyond_the_largest_double_are_outside)
{
  constexpr double most = std::numeric_limits<double>::max();
  const Model model(scenes::box({-most, 0, 0}, {most, 1, 1}));
  const Point_locator locator(model);
  const auto at = [&](const Rational& x) {
    return locator.locate(std::array<Rational, 3>{x, Rational(1, 2), Rational(1, 2)});
  };
  using tetracone::covering::Location;
  BOOST_TEST((at(Rational(most)) == Location::on_surface));
  BOOST_TEST((at(Rational(most) / 3) == Location::inside));
  for (const int sign : {-1, 1}) BOOST_TEST((at(sign * 5 * Rational(most)) == Location::outside));
}

BOOST_AUTO_TEST_CASE(a_star_shaped_body_asks_signs_near_its_surface_alone)
{
  scenes::Random random(6);
  const Polyhedron body = scenes::triangulated(scenes::torus(60, 30));
  const Model model(body);
  const Point_locator locator(model);
  Point_locator::K::decided_by() = {};
  for (int k = 0; k < 1000; ++k) locator.locate(scenes::real_vertex(random, 4));
  BOOST_TEST(Point_locator::K::decided_by()[Point_locator::K::Stage::filter] < 20);
  BOOST_TEST(locator.bytes() < 90 * body.face_count());
}

BOOST_AUTO_TEST_SUITE_END()
