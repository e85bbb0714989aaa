#include "tetracone/kernel/bound/cone_slab.h"

#include "verify/cases/random.h"
#include "verify/test/support/suite.h"

BOOST_AUTO_TEST_SUITE(test_cone_slab)

using namespace tetracone::kernel;
using tetracone::verify::Random;

Local_point along(const Local_point& p, double share) { return {p[0] * share, p[1] * share, p[2] * share}; }

BOOST_AUTO_TEST_CASE(what_is_before_a_triangle_is_never_beyond_its_slab)
{
  Random random(4);
  long told = 0, asked = 0;
  for (int round = 0; round < 200; ++round) {
    const Cone_cells cells(1 + round % 9);
    Local_triangle t;
    const Local_point about = along(random.direction(), 0.5);
    for (Local_point& p : t)
      for (int k = 0; k < 3; ++k) p[k] = about[k] + 0.3 * random.symmetric();
    const Local_facet facet(t);
    std::map<std::size_t, Cone_slab> slabs;
    std::map<std::size_t, std::pair<float, float>> norms;
    cells.for_cells(facet, [&](std::size_t cell, float low, float high) { norms[cell] = {low, high}; });
    cells.for_directions([&](std::size_t cell, const Local_point&, const Cone_cells::Corners& corners) {
      if (norms.contains(cell)) slabs.emplace(cell, Cone_slab(corners, std::span(&facet, 1)));
    });
    for (int k = 0; k < 50; ++k) {
      const Local_point p = random.in_triangle(t);
      const double norm = octahedral_norm(p);
      if (norm < 0.01) continue;
      const std::size_t cell = cells.cell(p, norm);
      BOOST_REQUIRE(slabs.contains(cell));
      BOOST_TEST((norms[cell].first < norm && norm < norms[cell].second));
      BOOST_TEST(slabs[cell].side(p) == 0);
      const int before = slabs[cell].side(along(p, 0.9)), beyond = slabs[cell].side(along(p, 1.1));
      BOOST_TEST(before <= 0);
      BOOST_TEST(beyond >= 0);
      told += (before != 0) + (beyond != 0);
      asked += 2;
    }
  }
  BOOST_TEST(told > asked / 4);
}

BOOST_AUTO_TEST_CASE(a_slab_tells_nothing_where_a_triangle_is_seen_edge_on)
{
  const Cone_cells cells(2);
  const Local_facet through_origin({{{0.5, 0.1, 0.1}, {0.25, 0.05, 0.05}, {0.5, 0.2, 0.2}}});
  cells.for_directions([&](std::size_t, const Local_point& d, const Cone_cells::Corners& corners) {
    if (d[0] < 0 || d[1] < 0 || d[2] < 0) return;
    const Cone_slab slab(corners, std::span(&through_origin, 1));
    for (const double norm : {0.1, 1.0, 2.0}) BOOST_TEST(slab.side(along(d, norm)) == 0);
  });
}

BOOST_AUTO_TEST_CASE(a_line_through_a_triangle_is_told_from_one_beside_it)
{
  const Local_point w = {1, 0, 0}, a = {0, 1, 0}, b = {0, 0, 1};
  BOOST_TEST(cone_holds(w, a, b, {0.1, 0.1, 0.1}) == cone_side(w, a, b));
  BOOST_TEST(cone_holds(w, b, a, {0.1, 0.1, 0.1}) == cone_side(w, b, a));
  BOOST_TEST(cone_holds(w, a, b, {-0.1, -0.1, -0.1}) == -cone_side(w, a, b));
  BOOST_TEST(cone_holds(w, a, b, {0.1, 0.1, -0.1}) == 0);
  BOOST_TEST(cone_holds(w, a, b, {0.5, 0.5, 0}) == cone_undecided);
}

BOOST_AUTO_TEST_SUITE_END()
