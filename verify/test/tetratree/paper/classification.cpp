#include "tetracone/tetratree/paper/classification.h"

#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_classification)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using rationals::Vector;
using scenes::Random;

namespace {

using Exact_signs = std::tuple<Epick, Epeck, Rational_kernel, Adaptive>;

// A lattice about 0 whose rays at distance 4096 / 2^level are small integers.
constexpr Cone_lattice unit_lattice{};

Tetra_cone random_cone(Random& random, int level)
{
  Tetra_cone cone = Tetra_cone::octant(scenes::integer(random, 0, 7));
  for (; level > 1; --level) cone = cone.child(scenes::integer(random, 0, 3));
  return cone;
}

Vector vector(const Direction& d) { return {d[0], d[1], d[2]}; }

// The truth: the triangle, as a polygon, cut by the three half-spaces of the cone one after the other; what is left
// is not empty.
bool meets(const Tetra_cone& cone, const Vector& origin, const std::array<Vertex, 3>& triangle)
{
  std::vector<Vector> polygon;
  for (const Vertex& v : triangle) polygon.push_back(rationals::minus(rationals::exactly(v), origin));
  for (int k = 0; k < 3 && !polygon.empty(); ++k) {
    const Vector inward = rationals::outer(vector(cone.ray[k]), vector(cone.ray[(k + 1) % 3]));
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

bool is_flat(const Vector& origin, const std::array<Vertex, 3>& t)
{
  const auto at = [&](int i) { return rationals::minus(rationals::exactly(t[i]), origin); };
  return rationals::determinant(at(0), at(1), at(2)) == 0;
}

template <class K>
Classified classified(const Tetra_cone& cone, const std::array<Vertex, 3>& t,
                      const Cone_lattice& lattice = unit_lattice)
{
  return classify<K>(Cone_points<K>(lattice, cone), point<K>(t[0]), point<K>(t[1]), point<K>(t[2]));
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

KERNEL_TEST_CASE(a_tetrahedron_that_is_not_flat_is_classified_exactly_where_its_triangle_meets_the_cone, K, Exact_signs)
{
  Random random(1);
  std::map<Classified, int> seen;
  int wrong = 0, too_few = 0, flat_and_apart = 0;
  const int samples = std::is_same_v<K, Adaptive> ? 20'000 : 3'000;
  for (int n = 0; n < samples; ++n) {
    const Tetra_cone cone = random_cone(random, 1 + n % 6);
    const auto triangle = hard_triangle(random, cone);
    const Classified answer = classified<K>(cone, triangle);
    const bool truth = meets(cone, {0, 0, 0}, triangle);
    ++seen[answer];
    if (!is_flat({0, 0, 0}, triangle)) {
      wrong += (answer != Classified::no) != truth;
    } else {
      too_few += truth && answer == Classified::no;
      flat_and_apart += !truth && answer != Classified::no;
    }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(too_few == 0);
  BOOST_TEST(flat_and_apart > 0);  // allowed, and not rare in these samples
  for (const Classified kind : {Classified::no, Classified::vertex_in_cone, Classified::ray_in_tetrahedron,
                                Classified::edge_crosses_border, Classified::flat})
    BOOST_TEST(seen[kind] > samples / 200);
}

KERNEL_TEST_CASE(real_triangles_and_models_far_from_the_coordinate_origin_are_classified_exactly, K, Exact_signs)
{
  Random random(2);
  int wrong = 0, met = 0;
  for (int n = 0; n < 1'000; ++n) {
    const double offset = n % 3 == 0 ? 0 : n % 3 == 1 ? 1e9 : -1e-3;
    std::vector<Vertex> vertices;
    for (int k = 0; k < 10; ++k) {
      vertices.push_back(scenes::real_vertex(random, 1));
      for (double& x : vertices.back()) x += offset;
    }
    const Cone_lattice lattice = cone_lattice(vertices);
    const std::array<Vertex, 3> triangle = {vertices[0], vertices[1], vertices[2]};
    const Tetra_cone cone = random_cone(random, 1 + n % 4);
    const bool truth = meets(cone, rationals::exactly(lattice.origin), triangle);
    wrong += (classified<K>(cone, triangle, lattice) != Classified::no) != truth;
    met += truth;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(met > 100);
}

BOOST_AUTO_TEST_CASE(no_order_of_the_corners_nor_of_the_rays_changes_the_answer)
{
  using K = Adaptive;
  Random random(3);
  int wrong = 0;
  for (int n = 0; n < 3'000; ++n) {
    const Tetra_cone cone = random_cone(random, 1 + n % 5);
    const auto triangle = hard_triangle(random, cone);
    const bool first = classified<K>(cone, triangle) != Classified::no;
    std::array<int, 3> order = {0, 1, 2};
    do {
      const std::array<Vertex, 3> permuted = {triangle[order[0]], triangle[order[1]], triangle[order[2]]};
      for (int turn = 0; turn < 3; ++turn) {  // rays in the cyclic orders, which keep the cone positive
        const Tetra_cone same{cone.ray[turn], cone.ray[(turn + 1) % 3], cone.ray[(turn + 2) % 3]};
        wrong += (classified<K>(same, permuted) != Classified::no) != first;
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(a_triangle_in_a_cone_is_in_a_child_of_it_and_one_in_a_child_is_in_the_cone)
{
  using K = Adaptive;
  Random random(4);
  int lost = 0, gained = 0, classified_in_cone = 0;
  for (int n = 0; n < 5'000; ++n) {
    const Tetra_cone cone = random_cone(random, 1 + n % 5);
    const auto triangle = hard_triangle(random, cone);
    bool in_child = false;
    for (int k = 0; k < 4; ++k) in_child = in_child || classified<K>(cone.child(k), triangle) != Classified::no;
    const Classified answer = classified<K>(cone, triangle);
    const bool flat = is_flat({0, 0, 0}, triangle);
    classified_in_cone += answer != Classified::no;
    if (!flat || meets(cone, {0, 0, 0}, triangle)) lost += answer != Classified::no && !in_child;
    if (!flat) gained += answer == Classified::no && in_child;
  }
  BOOST_TEST(lost == 0);
  BOOST_TEST(gained == 0);
  BOOST_TEST(classified_in_cone > 500);
}

BOOST_AUTO_TEST_CASE(each_of_the_papers_tests_decides_its_own_figure)
{
  using K = Adaptive;
  const Tetra_cone cone = Tetra_cone::octant(0);
  BOOST_TEST((classified<K>(cone, {{{1, 1, 1}, {-1, 2, 2}, {2, -1, 2}}}) == Classified::vertex_in_cone));  // Fig. 6a
  BOOST_TEST(
      (classified<K>(cone, {{{3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}}}) == Classified::ray_in_tetrahedron));  // Fig.
                                                                                                            // 6b
  BOOST_TEST(
      (classified<K>(cone.child(3), {{{9, -1, -1}, {-1, 9, -1}, {-1, -1, 9}}}) == Classified::ray_in_tetrahedron));
  BOOST_TEST((classified<K>(cone, {{{5, 4, -1}, {-1, 4, 5}, {-2, 9, 4}}}) == Classified::edge_crosses_border));  // Fig.
                                                                                                                 // 6c
  BOOST_TEST((classified<K>(cone, {{{-1, 1, 1}, {-1, 2, 1}, {-1, 1, 2}}}) == Classified::no));  // Fig. 6d
  BOOST_TEST((classified<K>(cone, {{{0, 0, 0}, {-1, -2, -3}, {-3, -1, -1}}}) == Classified::vertex_in_cone));  // at V0
  BOOST_TEST((classified<K>(cone, {{{-1, -1, -1}, {2, 2, 2}, {-1, -1, -1}}}) == Classified::vertex_in_cone));
  BOOST_TEST((classified<K>(cone, {{{-1, 1, 0}, {1, -1, 0}, {-1, 1, 0}}}) == Classified::flat));  // through V0
}

BOOST_AUTO_TEST_CASE(rounding_kernels_classify_plain_triangles_alike)
{
  Random random(5);
  int different = 0;
  for (int n = 0; n < 2'000; ++n) {
    const Tetra_cone cone = random_cone(random, 1 + n % 4);
    const std::array<Vertex, 3> triangle = {scenes::grid_vertex(random, 9), scenes::grid_vertex(random, 9),
                                            scenes::grid_vertex(random, 9)};
    const Classified exact = classified<Adaptive>(cone, triangle);
    different += classified<Double>(cone, triangle) != exact || classified<Float>(cone, triangle) != exact;
  }
  BOOST_TEST(different == 0);  // integers this small are exact in both
}

// Planted and seen to fail: without the third test,
// a_tetrahedron_that_is_not_flat_is_classified_exactly_where_its_triangle_meets_the_cone, real_triangles_...,
// each_of_the_papers_tests_... and a_triangle_in_a_cone_is_in_a_child_of_it_...

BOOST_AUTO_TEST_SUITE_END()
