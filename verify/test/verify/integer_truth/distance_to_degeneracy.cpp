#include "verify/integer_truth/distance_to_degeneracy.h"

#include "verify/integer_truth/integer_truth.h"
#include "verify/test/support/object_cases.h"
#include "verify/test/support/rationals.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_distance_to_degeneracy)

// Planted by hand, and caught by these tests:
// - the determinant's minus a plus;
// - the permanent without one of its absolute values;
// - n not halved after its square;
// - the exponent of the largest coordinate one too high;
// - the denominator forgotten;
// - boxes not grown;
// - edges' lines asked where both ends are on one side;
// - edges of one body only;
// - a wrong point in one determinant of `solid`, of `classification`.

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;
namespace exact = tetracone::verify::rationals;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Predicate_case points(const std::array<Vertex, 4>& v, const Vertex& p, const Vertex& q = {0, 0, 0},
                      const Vertex& r = {0, 0, 0})
{
  return {v, p, q, r, Pose(), Pose(), {}};
}

void check_near(double value, double expected)
{
  if (std::isinf(expected))
    BOOST_TEST(value == expected);
  else
    BOOST_TEST(std::abs(value - expected) < 1e-9, value << " is not " << expected);
}

}  // namespace

BOOST_AUTO_TEST_CASE(rho_and_ulps_are_those_of_rational_arithmetic)
{
  Random random(1);
  for (int k = 0; k < 500; ++k) {
    Predicate_case c{};
    for (Vertex* x : {&c.v[0], &c.v[1], &c.v[2], &c.v[3], &c.p}) *x = real_vertex(random, 3);
    c.pose_a = k % 2 == 0 ? random_rotation(random, 3, {Rational(1) / 3, 0, 0}) : random_affine(random);
    c.pose_b = k % 3 == 0 ? rounded(random_rotation(random)) : Pose();
    const exact::Vector p = exact::image(c.pose_b, exact::exactly(c.p));
    std::array<exact::Vector, 3> v, x;
    Rational largest = 0;
    for (int i = 0; i < 3; ++i) {
      v[i] = exact::image(c.pose_a, exact::exactly(c.v[i + 1]));
      x[i] = exact::minus(v[i], p);
      for (int j = 0; j < 3; ++j) largest = std::max({largest, Rational(abs(v[i][j])), Rational(abs(p[j]))});
    }
    std::array<int, 3> order{0, 1, 2};
    Rational permanent = 0;
    do permanent += abs(Rational(x[0][order[0]] * x[1][order[1]] * x[2][order[2]]));
    while (std::next_permutation(order.begin(), order.end()));
    const Rational determinant = abs(exact::determinant(x[0], x[1], x[2]));
    const exact::Vector n = exact::outer(exact::minus(v[1], v[0]), exact::minus(v[2], v[0]));
    const auto log2 = [](const Rational& value) { return std::log2(CGAL::to_double(value)); };
    const Distance found = distance(Predicate::orientation, c);
    check_near(found.log2_rho, log2(Rational(determinant / permanent)));
    check_near(found.log2_ulps, log2(determinant) - log2(exact::inner(n, n)) / 2 - (std::floor(log2(largest)) - 52));
    BOOST_TEST(found.log2_rho <= 0);
  }
}

BOOST_AUTO_TEST_CASE(no_magnitude_overflows_or_underflows)
{
  const auto scaled = [](double s) {
    Predicate_case c = points({Vertex{0, 0, 0}, {0, 0, 0}, {4 * s, 0, 0}, {0, 4 * s, 0}}, {s, s, s});
    return distance(Predicate::orientation, c);
  };
  const Distance one = scaled(1);
  for (const double s : {0x1p-1074, 0x1p-1000, 0x1p-400, 0x1p400, 0x1p1020}) {
    check_near(scaled(s).log2_rho, one.log2_rho);
    check_near(scaled(s).log2_ulps, one.log2_ulps);
  }
  // Denormal heights over a plane of huge corners.
  const Predicate_case steep =
      points({Vertex{0, 0, 0}, {0, 0, 0}, {0x1p1020, 0, 0}, {0, 0x1p1020, 0}}, {1, 1, 0x1p-1074});
  check_near(distance(Predicate::orientation, steep).log2_ulps, -1074 - (1020 - 52));
}

BOOST_AUTO_TEST_CASE(each_predicate_has_its_determinants_and_no_others)
{
  // Exactly four of the seven points v0 v1 v2 v3 p q r, in this order, are in one plane: all 35 choices.
  const auto has = [](Predicate predicate, const std::array<int, 4>& four) {
    const auto among = [&](int low, int high) { return low <= four[0] && four[3] <= high; };
    switch (predicate) {
      case Predicate::orientation: return among(1, 4);
      case Predicate::tetra_cone: return among(0, 4) && four[0] == 0;
      case Predicate::tetrahedron: return among(0, 4);
      case Predicate::segment_triangle: return among(1, 5);
      case Predicate::triangle_triangle: return among(1, 6);
      case Predicate::solid: return among(0, 5) && four[3] > 3;
      default: return four[0] == 0;
    }
  };
  Random random(5);
  for (int bits = 0; bits < 128; ++bits) {
    std::vector<int> in;
    for (int k = 0; k < 7; ++k)
      if (bits >> k & 1) in.push_back(k);
    if (in.size() != 4) continue;
    std::array<Vertex, 7> x;
    for (Vertex& point : x) point = grid_vertex(random, 100000);
    for (int i = 0; i < 3; ++i) x[in[3]][i] = x[in[0]][i] + 2 * x[in[1]][i] - 2 * x[in[2]][i];
    const Predicate_case c = points({x[0], x[1], x[2], x[3]}, x[4], x[5], x[6]);
    for (const Predicate predicate : all_predicates)
      BOOST_TEST_CONTEXT(to_string(predicate) << " " << in[0] << in[1] << in[2] << in[3])
      {
        const Distance d = distance(predicate, c);
        const bool expected = has(predicate, {in[0], in[1], in[2], in[3]});
        BOOST_TEST((d.log2_rho == -infinite) == expected);
        BOOST_TEST((d.log2_ulps == -infinite) == expected);
      }
  }
}

BOOST_AUTO_TEST_CASE(an_answer_changes_only_through_a_degenerate_case)
{
  // Between two answers that differ, the distance in ulps falls below the step.
  Random random(2);
  int changes = 0;
  for (int k = 0; k < 60; ++k) {
    std::array<Vertex, 7> x;
    for (Vertex& point : x) point = real_vertex(random, 1);
    for (const Predicate predicate : all_predicates) {
      const auto at = [&](double t) {
        Predicate_case c = points({x[0], x[1], x[2], x[3]}, x[4], x[5], x[6]);
        c.pose_b = translation(t, t / 2, -t);
        return c;
      };
      double low = -2, high = 2;
      const auto of_low = integer_truth::answer(predicate, at(low));
      for (const double t : {-1.0, -0.5, 0.0, 0.5, 1.0, 2.0})
        if (integer_truth::answer(predicate, at(t)) != of_low) {
          high = t;
          break;
        }
      if (integer_truth::answer(predicate, at(high)) == of_low) continue;
      ++changes;
      for (int step = 0; step < 44; ++step) {
        const double middle = (low + high) / 2;
        (integer_truth::answer(predicate, at(middle)) == of_low ? low : high) = middle;
      }
      // The step is 2^-42 or less, an ulp 2^-53 or more.
      const double near = distance(predicate, at(low)).log2_ulps, far = distance(predicate, at(-2)).log2_ulps;
      BOOST_TEST_CONTEXT(to_string(predicate)) BOOST_TEST(near < 13);
      BOOST_TEST(far > near);
    }
  }
  BOOST_TEST(changes > 100);
}

BOOST_AUTO_TEST_CASE(gaps_between_boxes_are_counted_in_ulps)
{
  // A cube on a larger one, small enough that none of its edges is in a plane of the other. The largest coordinate is 3
  // and a bit.
  const Polyhedron below = box({-3, -3, 0}, {3, 3, 1}), above = box({-1, -1.25, 1}, {1, 1.25, 2.75});
  for (const int ulps : {1, 2, 64, 4096}) {
    const Distance gap = distance(object_case(below, Pose(), above, translation(0, 0, ulps * 0x1p-51)));
    check_near(gap.log2_ulps, std::log2(ulps));
    // Along an axis the difference is exact: a small distance, and yet no sum that cancels.
    BOOST_TEST(gap.log2_rho > -4);
    const Distance swapped = distance(object_case(above, translation(0, 0, ulps * 0x1p-51), below, Pose()));
    check_near(swapped.log2_ulps, gap.log2_ulps);
    check_near(swapped.log2_rho, gap.log2_rho);
  }
  const Distance touching = distance(object_case(below, Pose(), above, Pose()));
  BOOST_TEST(touching.log2_rho == -infinite);
  BOOST_TEST(touching.log2_ulps == -infinite);
  const Distance apart = distance(object_case(below, Pose(), above, translation(0, 0, 0.125)));
  BOOST_TEST(apart.log2_rho == infinite);
  BOOST_TEST(apart.log2_ulps == infinite);
}

BOOST_AUTO_TEST_CASE(bodies_that_cross_are_as_far_from_degenerate_as_their_elements)
{
  // A stick through the top of a box: 1/4 from an edge's line, 1/8 above the plane.
  Polyhedron stick = polygon({{1.75, 0.5, 0.5}, {1.75, 0.5, 1.125}});
  const Polyhedron body = box({-2, -2, -1}, {2, 2, 1});
  const Distance through = distance(object_case(body, Pose(), stick, Pose()));
  check_near(through.log2_ulps, std::log2(0.125) + 51);
  // A turn that permutes the axes changes neither boxes nor determinants.
  const Pose turn = Pose::from_quaternion(1, 1, 1, 1, {0, 0, 0});
  const Distance turned = distance(object_case(body, turn, stick, turn));
  check_near(turned.log2_ulps, through.log2_ulps);
  check_near(turned.log2_rho, through.log2_rho);
  // The stick's own face spans no plane: an edge near it is near what is exactly degenerate.
  stick.vertices[1] = {1.75, 0.5, 1};
  BOOST_TEST(distance(object_case(body, Pose(), stick, Pose())).log2_ulps == -infinite);
}

BOOST_AUTO_TEST_CASE(meshes_of_many_faces_are_cut_off_and_not_slow)
{
  Random random(4);
  const Polyhedron a = blob(random, 3, 0.9, 1.1), b = blob(random, 3, 0.9, 1.1);
  // About no axis: the bodies have edges in the planes between the axes.
  const Distance d = distance(object_case(a, Pose(), b, rounded(Pose::from_quaternion(5, 2, -3, 1))));
  BOOST_TEST(std::isfinite(d.log2_rho));
  BOOST_TEST(std::isfinite(d.log2_ulps));
}

BOOST_AUTO_TEST_SUITE_END()
