#include "tetracone/tetratree/fast/support_table.h"

#include "verify/test/support/object_cases.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_support_table)

using namespace tetracone::tetratree;
namespace kernel = tetracone::kernel;
using namespace tetracone::verify::scenes;
using Direction = std::array<float, 3>;  // of floats, so that the table rounds nothing

namespace {

std::vector<Named> bodies()
{
  Random random(1);
  std::vector<Named> all = {{"cube", unit_cube()},
                            {"sphere", blob(random, 4, 1, 1)},
                            {"blob", blob(random, 4, 0.5, 1.5)},
                            {"star", star_prism()},
                            {"torus", torus(20, 9)},
                            {"tetrahedra", random_tetrahedra(random, 30, 9)},
                            {"tiny", moved(unit_cube(), 0x1p-200)},
                            {"far", moved(unit_cube(), 1, {0x1p40, 0, 0})},
                            {"thin", box({0, 0, 0}, {1, 1e-6, 1e-12})},
                            {"dot", polygon({{1, 2, 3}})}};
  return all;
}

/// Random, along axes, in the planes between octants, in the lattice's directions and on its edges, and a hair off
/// each.
Direction direction(Random& random, int kind)
{
  const int way = kind % 6, axis = integer(random, 0, 2), i = integer(random, 0, 16), j = integer(random, 0, 16 - i);
  Direction d;
  for (float& x : d) x = float(real(random, -1, 1));
  if (way == 1) d = {0, 0, 0};
  if (way >= 3) d = {float(16 - i - j), float(i), float(j)};
  if (way == 1) d[axis] = random() % 2 ? 1 : -1;
  if (way == 2) d[axis] = random() % 2 ? 0.0f : -0.0f;
  if (way == 4) d[axis] += float(real(random, 0, 1));  // between two directions of the lattice
  for (float& x : d) {
    if (way == 3 || way == 4) x *= random() % 2 ? 1 : -1;
    if (way == 5) x = std::nextafter(x, float(integer(random, -1, 1)));
  }
  if (d[0] == 0 && d[1] == 0 && d[2] == 0) d[0] = 1;
  const float scale = std::ldexp(1.0f, integer(random, -60, 60));
  for (float& x : d) x *= scale;
  return d;
}

/// The farthest of all vertices; each is on the surface.
double reach(const Bvh8& tree, const Direction& d)
{
  double best = -HUGE_VAL;
  for (Index v = 0; v < tree.model().vertices().size(); ++v)
    best = kernel::maximum(best, kernel::Vector(d[0], d[1], d[2]).dot(tree.local(v)));
  return best;
}

double along(const Direction& d, const kernel::Vector& p)
{
  return double(d[0]) * p[0] + double(d[1]) * p[1] + double(d[2]) * p[2];
}

Support_table::Place place(const Direction& d)
{
  const kernel::Four_floats four = {d[0], d[1], d[2], 0};
  return Support_table::place(four, kernel::sum_of_lanes(kernel::magnitudes(four)));
}
struct Support {
  float bound;
  kernel::Vector point;
};
Support support(Support_table& table, const Direction& d)
{
  const auto at = place(d);
  table.find(at);
  const kernel::Four_floats point = table.point(at);
  return {kernel::sum_of_lanes(table.reach(at))[0], {point[0], point[1], point[2]}};
}
double sum(const Direction& d) { return std::abs(double(d[0])) + std::abs(double(d[1])) + std::abs(double(d[2])); }

}  // namespace

BOOST_AUTO_TEST_CASE(the_bound_is_above_the_farthest_vertex_and_not_far_above)
{
  for (const auto& [name, body] : bodies()) {
    Bvh8 tree(body);
    Support_table table(tree);
    double size = 0;
    for (Index v = 0; v < body.vertices.size(); ++v) size = kernel::maximum(size, tree.local(v).norm());
    Random random(2);
    int below = 0, far_above = 0, point_off = 0;
    double loosest = 0;
    for (int k = 0; k < 6000; ++k) {
      const Direction d = direction(random, k);
      const auto found = support(table, d);
      const double exact = reach(tree, d), slack = double(Support_table::slack) * sum(d),
                   length = std::hypot(double(d[0]), double(d[1]), double(d[2]));
      below += double(found.bound) + slack < exact;
      // Let p be the support of d, and p_k that of corner d_k of its lattice triangle. Then h(d_k) - p . d_k <= (p_k -
      // p) . (d_k - d). The first factor is at most twice the size and the second at most sqrt(2/3) / 16 |d|_1. A round
      // body stays far below this bound.
      const double above = double(found.bound) - slack - exact;
      far_above += above > (name == "sphere" ? 0.01 * size * length : 2 * size * std::sqrt(2.0 / 3) / 16 * sum(d));
      if (size > 0) loosest = kernel::maximum(loosest, above / (size * length));
      point_off += std::abs(along(d, found.point) - found.bound) > 4 * slack;
    }
    BOOST_TEST_INFO_SCOPE(name);
    BOOST_TEST_MESSAGE(name << ": bound above by " << loosest << " of the size");
    BOOST_TEST(below == 0);
    BOOST_TEST(far_above == 0);
    BOOST_TEST(point_off == 0);
  }
}

BOOST_AUTO_TEST_CASE(weights_make_the_direction_of_the_corners)
{
  // In the coordinates (n - i - j, i, j) / n of the corners in an octant.
  Random random(5);
  int off = 0, negative = 0, outside = 0;
  for (int k = 0; k < 20000; ++k) {
    const Direction d = direction(random, k);
    const auto at = place(d);
    const int octant = at.first / (18 * 18), j = at.first / 18 % 18, i = at.first % 18;
    outside += octant != std::signbit(d[0]) + 2 * std::signbit(d[1]) + 4 * std::signbit(d[2]) || i > 16 || j > 16;
    double made[3] = {0, 0, 0};
    for (int corner = 0; corner < 4; ++corner) {
      const int y = i + corner % 2, z = j + corner / 2;
      const double weight = at.weight[corner] * at.sum[0] / 16;
      negative += at.weight[corner] < 0;
      made[0] += weight * (16 - y - z);
      made[1] += weight * y;
      made[2] += weight * z;
    }
    double apart = 0;
    for (int c = 0; c < 3; ++c) apart += std::abs(made[c] - std::abs(double(d[c])));
    off += apart > Support_table::slack * sum(d);
  }
  BOOST_TEST(off == 0);
  BOOST_TEST(negative == 0);
  BOOST_TEST(outside == 0);
}

BOOST_AUTO_TEST_CASE(the_opposite_place_is_that_of_the_opposite_direction)
{
  Random random(9);
  int other = 0;
  for (int k = 0; k < 2000; ++k) {
    const Direction d = direction(random, k);
    const auto at = Support_table::opposite(place(d)), there = place({-d[0], -d[1], -d[2]});
    other += at.first != there.first || at.sum[0] != there.sum[0];
    for (int i = 0; i < 4; ++i) other += at.weight[i] != there.weight[i] || (i < 3 && at.at[i] != there.at[i]);
  }
  BOOST_TEST(other == 0);
}

BOOST_AUTO_TEST_CASE(what_is_not_known_has_no_finite_reach)
{
  Random random(6);
  Bvh8 tree(unit_cube());
  int finite = 0, not_found = 0, knows = 0, does_not_know = 0;
  for (int k = 0; k < 600; ++k) {
    Support_table table(tree);
    const Direction d = direction(random, k);
    const auto at = place(d);
    const auto reach = [&] { return kernel::sum_of_lanes(table.reach(at))[0]; };
    finite += reach() < HUGE_VALF;
    knows += table.knows(at);
    table.find(at);
    not_found += !(reach() < HUGE_VALF);
    does_not_know += !table.knows(at);
  }
  BOOST_TEST(finite == 0);
  BOOST_TEST(not_found == 0);
  BOOST_TEST(knows == 0);
  BOOST_TEST(does_not_know == 0);
}

BOOST_AUTO_TEST_CASE(asked_again_or_by_another_table_the_answer_is_the_same)
{
  Random random(3);
  const Polyhedron body = blob(random, 3, 0.5, 1.5);
  Bvh8 tree(body), other_tree(body);
  other_tree.make_all();
  Support_table table(tree), other(other_tree);
  std::vector<Direction> asked;
  std::vector<Support> answers;
  for (int k = 0; k < 2000; ++k) {
    asked.push_back(direction(random, k));
    answers.push_back(support(table, asked.back()));
  }
  int different = 0;
  for (std::size_t k = asked.size(); k-- > 0;) {  // the other way round
    different +=
        support(table, asked[k]).bound != answers[k].bound || support(table, asked[k]).point != answers[k].point;
    different += support(other, asked[k]).bound != answers[k].bound;
  }
  BOOST_TEST(different == 0);
  BOOST_TEST(table.bytes() < 11000u);
}

BOOST_AUTO_TEST_CASE(the_point_reaches_as_far_as_the_body_in_the_directions_of_three_corners)
{
  for (const auto& [name, body] : bodies()) {
    Bvh8 tree(body);
    Support_table table(tree);
    Random random(7);
    BOOST_TEST_INFO_SCOPE(name);
    int off = 0;
    for (int k = 0; k < 1000; ++k) {
      const Direction d = direction(random, k);
      const auto at = place(d);
      const kernel::Vector point = support(table, d).point;
      const int j = at.first / 18 % 18, i = at.first % 18;
      for (int corner = 0; corner < 4; ++corner) {
        if (!(at.weight[corner] > 0)) continue;
        const int y = i + corner % 2, z = j + corner / 2;
        const auto with_sign = [&](int c, int x) { return std::signbit(d[c]) ? -float(x) : float(x); };
        const Direction of_corner = {with_sign(0, 16 - y - z), with_sign(1, y), with_sign(2, z)};
        off += std::abs(along(of_corner, point) - reach(tree, of_corner)) > 4 * double(Support_table::slack) * 18;
      }
    }
    BOOST_TEST(off == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
