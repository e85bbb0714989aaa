#include "verify/integer_truth/integer_probes.h"

#include "verify/test/support/scenes.h"
#include "verify/truth/point_truth.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(test_integer_probes)

using namespace tetracone::verify;
namespace scenes = tetracone::verify::scenes;
using tetracone::kernel::Rational;
using tetracone::kernel::Vertex;
using Hits = std::vector<std::pair<Rational, Index>>;

BOOST_AUTO_TEST_CASE(a_cube_by_hand)
{
  const auto cube = scenes::unit_cube();
  const integer_truth::Probed_body body(cube);
  const Point_truth first(cube);
  for (const auto& [point, place] : std::vector<std::pair<Vertex, int>>{{{0.5, 0.5, 0.5}, 1},
                                                                        {{0, 0, 0}, 0},
                                                                        {{0, 0.5, 0}, 0},
                                                                        {{0.5, 0.5, 1}, 0},
                                                                        {{0.5, 0.5, std::nextafter(1.0, 2.0)}, -1},
                                                                        {{0.5, 0.5, std::nextafter(1.0, 0.0)}, 1},
                                                                        {{2, 0, 0}, -1},
                                                                        {{0x1p-1074, 0x1p-1074, 0x1p-1074}, 1},
                                                                        {{-0x1p1000, 0.5, 0.5}, -1}}) {
    BOOST_TEST(body.where(point) == place);
    BOOST_TEST(first(point) == place);
  }
  BOOST_TEST(body.hits({-1, 0.5, 0.5}, {2, 0, 0}).size() == 2);
  BOOST_TEST(body.hits({-1, 0.5, 0.5}, {2, 0, 0})[1].first == 1);
  BOOST_TEST(body.hits({0.5, 0.5, 0.5}, {0, 0, -3})[0].first == Rational(1) / 6);
  BOOST_TEST(body.hits({-1, 0.5, 0.5}, {-2, 0, 0}).empty());
  BOOST_TEST(body.hits({-1, 0, 0}, {1, 0, 0}).size() == 4);       // along an edge: two faces on the way, and both ends'
  BOOST_TEST(body.hits({1, 1, 1}, {1, 1, 1}).size() == 3);        // from a vertex away
  BOOST_TEST(body.hits({0.5, 0, 0.5}, {1, 0, 0})[0].first == 0);  // in a face
}

BOOST_AUTO_TEST_CASE(faces_on_a_line_are_met_where_they_are)
{
  scenes::Polyhedron flat;
  flat.vertices = {{0, 0, 0}, {2, 0, 0}, {1, 1, 1}};
  flat.add_polygon({0, 1});
  flat.add_polygon({2});
  const integer_truth::Probed_body body(flat);
  BOOST_TEST((body.hits({1, -1, 0}, {0, 2, 0}) == Hits{{Rational(1) / 2, 0}}));
  BOOST_TEST((body.hits({-1, 0, 0}, {1, 0, 0}) == Hits{{1, 0}}));
  BOOST_TEST((body.hits({1, 0, 0}, {-1, 0, 0}) == Hits{{0, 0}}));
  BOOST_TEST((body.hits({0, 0, 0}, {1, 1, 1}) == Hits{{0, 0}, {1, 1}}));
  BOOST_TEST(body.hits({0, 1, 0}, {1, 0, 0}).empty());
}

BOOST_AUTO_TEST_SUITE_END()
