#include "verify/integer_truth/integer_probes.h"

#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_integer_probes)

using namespace tetracone::verify;
namespace scenes = tetracone::verify::scenes;
using tetracone::kernel::Rational;
using Hits = std::vector<std::pair<Rational, Index>>;

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
