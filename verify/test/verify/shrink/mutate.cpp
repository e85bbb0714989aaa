// Mutations: small, legal, and different from case to case.

#include "verify/shrink/mutate.h"

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/planarity.h"
#include "verify/cases/case_numbers.h"
#include "verify/cases/shape_generators.h"
#include "verify/test/support/object_cases.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_mutate)

using namespace tetracone;
using covering::Index;
using kernel::Pose;
using verify::Object_case;
using verify::Predicate_case;
using verify::Random;

namespace {

Object_case boxes()
{
  Object_case c = verify::scenes::object_case(verify::prism_with_tunnel(), Pose::from_quaternion(1, 2, 3, 4),
                                              verify::complex_two(), Pose::translation(0.1, 0.2, 0.3));
  c.origin = {"stacked", 1, 2, 3};
  c.surface = c.solid = true;
  return c;
}

void check_finite(const verify::Case_numbers& n)
{
  for (const auto& points : n.points)
    for (const auto& v : points)
      for (const double x : v) BOOST_REQUIRE(std::isfinite(x));
  for (const Pose& pose : n.poses) BOOST_REQUIRE((pose.determinant_sign() != CGAL::ZERO));
}

/// How many numbers differ; many where bodies were swapped.
std::size_t changes(const verify::Case_numbers& a, const verify::Case_numbers& b)
{
  std::size_t count = 0;
  for (int body = 0; body < 2; ++body) {
    for (std::size_t i = 0; i < std::min(a.points[body].size(), b.points[body].size()); ++i)
      for (int k = 0; k < 3; ++k) count += a.points[body][i][k] != b.points[body][i][k];
    for (int k = 0; k < 12; ++k) count += a.poses[body].exact(k) != b.poses[body].exact(k);
  }
  return count;
}

}  // namespace

BOOST_AUTO_TEST_CASE(mutants_are_planar_closed_and_of_unknown_answer)
{
  const Object_case c = boxes();
  Random random(1);
  std::size_t bent = 0, changed = 0;
  for (int k = 0; k < 100; ++k) {
    const Object_case m = verify::mutated(c, random);
    check_finite(numbers_of(m));
    if (m.a == c.a && m.b == c.b && m.pose_a == c.pose_a && m.pose_b == c.pose_b) continue;
    ++changed;
    BOOST_TEST((!m.surface && !m.solid));
    BOOST_TEST(m.origin.family == "stacked");
    for (const auto& body : {m.a, m.b}) {
      BOOST_TEST(covering::is_closed(*body));
      for (Index f = 0; f < body->face_count(); ++f)
        BOOST_TEST((covering::planarity(*body, f) != covering::Planarity::off_plane));
    }
    bent += m.a->face_count() + m.b->face_count() > c.a->face_count() + c.b->face_count();
  }
  BOOST_TEST(changed > 90u);
  BOOST_TEST(bent > 20u, "moved vertices bend faces");
}

BOOST_AUTO_TEST_CASE(the_same_random_state_gives_the_same_mutant)
{
  const Object_case c = boxes();
  Random one(5), other(5);
  for (int k = 0; k < 20; ++k)
    BOOST_TEST(changes(numbers_of(verify::mutated(c, one)), numbers_of(verify::mutated(c, other))) == 0u);
}

BOOST_AUTO_TEST_CASE(a_point_comes_to_where_the_other_body_has_one)
{
  Predicate_case c{};
  c.v = {{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}, {-1, 2, 8}}};
  c.p = {11, 12, 13};
  c.q = {14, 15, 16};
  c.r = {17, 18, 19};
  c.pose_b = Pose::translation(100, 200, 300);
  Random random(2);
  bool found = false;
  for (int k = 0; k < 200 && !found; ++k) {
    const auto n = numbers_of(verify::mutated(c, random));
    for (const auto& x : n.points[0])
      for (const auto& y : n.points[1])
        found = found || (n.poses[1] == c.pose_b && x == kernel::Vertex{y[0] + 100, y[1] + 200, y[2] + 300});
  }
  BOOST_TEST(found);
}

BOOST_AUTO_TEST_CASE(most_mutants_differ_in_a_few_numbers)
{
  Predicate_case c{};
  c.v = {{{0.1, 0.2, 0.3}, {1.1, 0, 0}, {0, 1.2, 0}, {0, 0, 1.3}}};
  c.p = {0.4, 0.5, 0.6};
  Random random(3);
  int few = 0;
  for (int k = 0; k < 100; ++k) few += changes(numbers_of(c), numbers_of(verify::mutated(c, random))) <= 9;
  BOOST_TEST(few > 50);
}

BOOST_AUTO_TEST_CASE(the_ends_of_the_doubles_stay_finite)
{
  constexpr double largest = std::numeric_limits<double>::max();
  Predicate_case c{};
  c.v = {{{largest, -largest, largest}, {0x1p-1074, 0, 0}, {0, largest, 0}, {0, 0, -largest}}};
  c.p = {largest, largest, -largest};
  c.pose_b = Pose(std::array<double, 12>{largest, 0, 0, 0, 0, 0x1p-1022, 0, 0, 0, 0, 1, -largest});
  Random random(4);
  for (int k = 0; k < 200; ++k) check_finite(numbers_of(verify::mutated(c, random)));
}

BOOST_AUTO_TEST_SUITE_END()
