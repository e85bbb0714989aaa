#include "tetracone/kernel/contact/face_cells.h"

#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_face_cells)

using namespace tetracone::kernel;

Rational_point at(int x, int y) { return {x, y, 0}; }

std::vector<Rational_face::Edge> loop(const std::vector<Rational_point>& corners)
{
  std::vector<Rational_face::Edge> edges;
  for (std::size_t k = 0; k < corners.size(); ++k) edges.push_back({corners[k], corners[(k + 1) % corners.size()]});
  return edges;
}

/// The area of the cells, each times its weight, by their borders.
Rational area(const Face_cells& cells, const std::vector<int>& weights)
{
  Rational twice = 0;
  cells.for_borders(
      weights, [&](const Rational_point& p, const Rational_point& q, int weight) { twice += weight * cross(p, q)[2]; });
  return twice / 2;
}

BOOST_AUTO_TEST_CASE(cells_make_up_the_face_and_no_cut_meets_their_insides)
{
  std::vector<Rational_face::Edge> edges = loop({at(0, 0), at(8, 0), at(8, 8), at(0, 8)});
  const auto hole = loop({at(2, 2), at(2, 4), at(4, 4), at(4, 2)});
  edges.insert(edges.end(), hole.begin(), hole.end());
  const Rational_face face(edges);
  const std::vector<Rational_face::Edge> cuts = {{at(0, 0), at(8, 8)}, {at(1, 7), at(7, 1)}, {at(6, 6), at(6, 6)}};
  const Face_cells cells(face, cuts);
  BOOST_TEST(cells.axis() == 2);
  BOOST_TEST(area(cells, std::vector<int>(cells.size(), 1)) == Rational(60));
  Rational below = 0;
  std::vector<int> weights(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const Rational_point x = cells.inner_point(c);
    BOOST_TEST(bool(face.locate(x) == Feature::interior));
    BOOST_TEST(cells.meets(c, x, x));
    weights[c] = x[1] < x[0];
    for (const auto& corner : cells.corners(c)) {
      BOOST_TEST(cells.meets(c, corner, corner));
      BOOST_TEST(sgn(corner[1] - corner[0]) * sgn(x[1] - x[0]) >= 0);
    }
  }
  BOOST_TEST(area(cells, weights) == Rational(30));
}

BOOST_AUTO_TEST_CASE(borders_are_as_long_as_the_weights_allow)
{
  const Rational_face face(loop({at(0, 0), at(8, 0), at(8, 8), at(0, 8)}));
  const Face_cells cells(face, {{at(1, 1), at(2, 6)}, {at(3, 1), at(7, 5)}});
  int borders = 0;
  cells.for_borders(std::vector<int>(cells.size(), 1), [&](const auto&, const auto&, int) { ++borders; });
  BOOST_TEST(borders == 4);
}

BOOST_AUTO_TEST_CASE(a_segment_meets_the_cells_on_its_way)
{
  const Rational_face face(loop({at(0, 0), at(4, 0), at(0, 4)}));
  const Face_cells cells(face, {});
  const auto meets = [&](const Rational_point& p, const Rational_point& q) {
    bool some = false;
    for (std::size_t c = 0; c < cells.size(); ++c) some = some || cells.meets(c, p, q);
    return some;
  };
  BOOST_TEST(meets(at(-1, 1), at(5, 1)));
  BOOST_TEST(meets(at(4, 0), at(9, 9)));
  BOOST_TEST(!meets(at(5, 0), at(9, 9)));
  BOOST_TEST(!meets(at(5, 0), at(0, 5)));
  BOOST_TEST(!meets(at(3, 3), at(3, 3)));
}

BOOST_AUTO_TEST_SUITE_END()
