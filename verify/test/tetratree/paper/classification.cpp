#include "tetracone/tetratree/paper/classification.h"

#include "verify/test/support/cones.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_classification)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using rationals::Vector;
using scenes::Random;

namespace {

using K = Adaptive;

// The truth: the triangle, as a polygon, cut by the three half-spaces of the cone one after the other; what is left
// is not empty.
bool meets(const Tetra_cone& cone, const std::array<Vertex, 3>& triangle)
{
  std::vector<Vector> polygon;
  for (const Vertex& v : triangle) polygon.push_back(rationals::exactly(v));
  for (int k = 0; k < 3 && !polygon.empty(); ++k) {
    const Vector inward = rationals::outer(scenes::ray(cone, k), scenes::ray(cone, k + 1));
    std::vector<Vector> rest;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const Rational at_p = rationals::inner(inward, p), at_q = rationals::inner(inward, q);
      if (at_p >= 0) rest.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
        const Rational share = at_p / (at_p - at_q);
        rest.push_back(rationals::plus(p, rationals::times(share, rationals::minus(q, p))));
      }
    }
    polygon = rest;
  }
  return !polygon.empty();
}

bool is_flat(const std::array<Vertex, 3>& t)
{
  return rationals::determinant(rationals::exactly(t[0]), rationals::exactly(t[1]), rationals::exactly(t[2])) == 0;
}

// About a lattice at 0, whose rays at distance 4096 / 2^level are small integers.
Classified classified(const Tetra_cone& cone, const std::array<Vertex, 3>& t)
{
  return classify<K>(Cone_points<K>(Cone_lattice(), cone), point<K>(t[0]), point<K>(t[1]), point<K>(t[2]));
}

// A triangle that is near the cone's rays and borders: corners are small sums of rays of it and of its like, or small
// integers.
std::array<Vertex, 3> hard_triangle(Random& random, const Tetra_cone& cone)
{
  std::array<Vertex, 3> triangle;
  for (Vertex& v : triangle) {
    v = scenes::grid_vertex(random, 2);
    if (scenes::integer(random, 0, 1) == 0) continue;
    v = {0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      const int share = scenes::integer(random, -1, 2);
      for (int k = 0; k < 3; ++k) v[k] += share * cone.ray[i][k];
    }
  }
  return triangle;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_triangle_in_a_cone_is_in_a_child_of_it_and_one_in_a_child_is_in_the_cone)
{
  Random random(4);
  int missed = 0, lost = 0, gained = 0, classified_in_cone = 0;
  for (int n = 0; n < 5'000; ++n) {
    const Tetra_cone cone = scenes::random_cone(random, 1 + n % 5);
    const auto triangle = hard_triangle(random, cone);
    bool in_child = false;
    for (int k = 0; k < 4; ++k) in_child = in_child || classified(cone.child(k), triangle) != Classified::no;
    const Classified answer = classified(cone, triangle);
    const bool flat = is_flat(triangle), truth = meets(cone, triangle);
    classified_in_cone += answer != Classified::no;
    missed += truth && answer == Classified::no;  // flat or not
    if (!flat || truth) lost += answer != Classified::no && !in_child;
    if (!flat) gained += answer == Classified::no && in_child;
  }
  BOOST_TEST(missed == 0);
  BOOST_TEST(lost == 0);
  BOOST_TEST(gained == 0);
  BOOST_TEST(classified_in_cone > 500);
}

BOOST_AUTO_TEST_CASE(each_of_the_papers_tests_decides_its_own_figure)
{
  const Tetra_cone cone = Tetra_cone::octant(0);
  BOOST_TEST((classified(cone, {{{1, 1, 1}, {-1, 2, 2}, {2, -1, 2}}}) == Classified::vertex_in_cone));  // Fig. 6a
  // Fig. 6b
  BOOST_TEST((classified(cone, {{{3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}}}) == Classified::ray_in_tetrahedron));
  BOOST_TEST((classified(cone.child(3), {{{9, -1, -1}, {-1, 9, -1}, {-1, -1, 9}}}) == Classified::ray_in_tetrahedron));
  // Fig. 6c
  BOOST_TEST((classified(cone, {{{5, 4, -1}, {-1, 4, 5}, {-2, 9, 4}}}) == Classified::edge_crosses_border));
  BOOST_TEST((classified(cone, {{{-1, 1, 1}, {-1, 2, 1}, {-1, 1, 2}}}) == Classified::no));                 // Fig. 6d
  BOOST_TEST((classified(cone, {{{0, 0, 0}, {-1, -2, -3}, {-3, -1, -1}}}) == Classified::vertex_in_cone));  // at V0
  BOOST_TEST((classified(cone, {{{-1, -1, -1}, {2, 2, 2}, {-1, -1, -1}}}) == Classified::vertex_in_cone));
  BOOST_TEST((classified(cone, {{{-1, 1, 0}, {1, -1, 0}, {-1, 1, 0}}}) == Classified::flat));  // through V0
}

BOOST_AUTO_TEST_SUITE_END()
