#include "verify/truth/predicate_truth.h"

#include "verify/integer_truth/integer_truth.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

// Planted by hand, and caught by these tests: the sign of the orientation, in either truth; the cone without its apex;
// the clip without crossings, with the half-space open, and with planes not turned inward; a triangle on a line by
// unsorted corners; inequalities of pivots with the wrong sign; bounds combined with the wrong sign; constants that
// must be > 0; rows without coefficients forgotten.

namespace tetracone::verify {

std::ostream& operator<<(std::ostream& out, Predicate predicate) { return out << to_string(predicate); }

}  // namespace tetracone::verify

BOOST_AUTO_TEST_SUITE(test_predicate_truth)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;

namespace {

using Answer = std::optional<int>;

std::string text(Answer answer) { return answer ? std::to_string(*answer) : "not asked"; }

/// The answer of both truths, which must agree.
Answer both(Predicate predicate, const Predicate_case& c)
{
  const Answer first = true_answer(predicate, c), second = integer_truth::answer(predicate, c);
  BOOST_TEST_CONTEXT(predicate)
  BOOST_TEST(text(first) == text(second));
  return first;
}

/// The corner of the positive octant.
Predicate_case corner(const Vertex& p, const Vertex& q = {0, 0, 0}, const Vertex& r = {0, 0, 0})
{
  return {{Vertex{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, p, q, r, Pose(), Pose(), {}};
}

/// Both truths on cases of `make`: how often each answer came.
template <class Make>
std::map<Predicate, std::map<std::string, int>> compare(int count, Make&& make)
{
  std::map<Predicate, std::map<std::string, int>> seen;
  for (int k = 0; k < count; ++k) {
    const Predicate_case c = make(k);
    for (const Predicate predicate : all_predicates) BOOST_TEST_CONTEXT(k)++ seen[predicate][text(both(predicate, c))];
  }
  return seen;
}

Pose any_pose(Random& random)
{
  switch (integer(random, 0, 3)) {
    case 0: return Pose();
    case 1: return random_rotation(random, 3, {Rational(integer(random, -3, 3)) / 3, 0, Rational(1) / 7});
    case 2: return rounded(random_rotation(random, 3));
    default: return random_affine(random, 2);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(orientation_is_the_sign_of_its_determinant)
{
  // det[v1-p, v2-p, v3-p] of the unit vectors is positive with p at 0.
  BOOST_TEST(both(Predicate::orientation, corner({0, 0, 0})).value() == 1);
  BOOST_TEST(both(Predicate::orientation, corner({1, 1, 1})).value() == -1);
  BOOST_TEST(both(Predicate::orientation, corner({1, 1, 0})).value() == 0);
  Predicate_case mirrored = corner({0, 0, 0});
  mirrored.pose_a = Pose(std::array<double, 12>{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  BOOST_TEST(both(Predicate::orientation, mirrored).value() == -1);
}

BOOST_AUTO_TEST_CASE(orientation_follows_the_parity_of_all_24_permutations)
{
  Random random(1);
  for (int k = 0; k < 300; ++k) {
    const Pose pose = any_pose(random);
    std::array<Vertex, 4> x;
    for (Vertex& point : x) point = grid_vertex(random, k % 2 == 0 ? 2 : 50);
    Predicate_case c = {{x[0], x[0], x[1], x[2]}, x[3], x[0], x[0], pose, pose, {}};
    const int sign = both(Predicate::orientation, c).value();
    std::array<int, 4> order{0, 1, 2, 3};
    do {
      int parity = 1;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j) parity *= order[j] > order[i] ? -1 : 1;
      c.v = {x[0], x[order[0]], x[order[1]], x[order[2]]};
      c.p = x[order[3]];
      BOOST_TEST(both(Predicate::orientation, c).value() == parity * sign);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

BOOST_AUTO_TEST_CASE(cones_are_closed_and_have_an_apex_and_no_end)
{
  for (const Vertex& p : {Vertex{1, 1, 1}, {0, 0, 0}, {1, 0, 0}, {3, 3, 0}, {100, 200, 1e300}, {0, 0, 5e-324}})
    BOOST_TEST(both(Predicate::tetra_cone, corner(p)).value() == 1);
  for (const Vertex& p : {Vertex{-1, 1, 1}, {-1, -1, -1}, {1, -5e-324, 0}, {0, 0, -1}})
    BOOST_TEST(both(Predicate::tetra_cone, corner(p)).value() == 0);
  Predicate_case flat = corner({1, 1, 1});
  flat.v[3] = {1, 1, 0};
  for (const Predicate predicate : {Predicate::tetra_cone, Predicate::tetrahedron, Predicate::classification})
    BOOST_TEST(!both(predicate, flat));
}

BOOST_AUTO_TEST_CASE(tetrahedra_and_solids_are_closed)
{
  struct Known {
    Vertex p;
    int place;
  };
  for (const auto& [p, place] : {Known{{0.5, 0.5, 0.5}, 1},
                                 {{0, 0, 0}, 0},
                                 {{1, 1, 0}, 0},
                                 {{0.5, 0.5, 1}, 0},
                                 {{0.5, 0, 0.25}, 0},
                                 {{2, 0, 0}, 0},
                                 {{1, 1, 5e-324}, -1},
                                 {{-1, 0, 0}, -1},
                                 {{3, 0, 0}, -1},
                                 {{0.75, 0.75, 0.75}, -1}}) {
    const Predicate_case c = corner(p, {7, -3, 2});
    BOOST_TEST(both(Predicate::solid, c).value() == place);
    BOOST_TEST(both(Predicate::tetrahedron, c).value() == (place >= 0 ? 1 : 0));
    Predicate_case inward = c;
    std::swap(inward.v[0], inward.v[2]);
    BOOST_TEST(both(Predicate::solid, inward).value() == place);
    BOOST_TEST(both(Predicate::tetrahedron, inward).value() == (place >= 0 ? 1 : 0));
  }
}

BOOST_AUTO_TEST_CASE(a_flat_solid_is_its_surface)
{
  // A quadrangle, a triangle with a point in it, a segment, a point.
  struct Known {
    std::array<Vertex, 4> v;
    Vertex on, off;
  };
  const Vertex o{0, 0, 0}, x{2, 0, 0}, y{0, 2, 0}, xy{2, 2, 0}, m{0.5, 0.5, 0};
  for (const auto& [v, on, off] : {Known{{o, x, xy, y}, {1, 1, 0}, {1, 1, 1}},
                                   {{o, x, y, m}, {1, 1, 0}, {1.5, 1, 0}},
                                   {{o, o, x, x}, {0.5, 0, 0}, {3, 0, 0}},
                                   {{x, x, x, x}, x, o}}) {
    Predicate_case c = {v, on, {5, 5, 5}, {}, Pose(), Pose(), {}};
    BOOST_TEST(both(Predicate::solid, c).value() == 0);
    c.p = off;
    BOOST_TEST(both(Predicate::solid, c).value() == -1);
  }
}

BOOST_AUTO_TEST_CASE(segments_and_triangles_may_be_degenerate)
{
  const auto answer = [](const Vertex& p, const Vertex& q, const Vertex& a, const Vertex& b, const Vertex& c) {
    return both(Predicate::segment_triangle, {{Vertex{9, 9, 9}, a, b, c}, p, q, {8, 8, 8}, Pose(), Pose(), {}}).value();
  };
  const Vertex o{0, 0, 0}, x{4, 0, 0}, y{0, 4, 0};
  BOOST_TEST(answer({1, 1, -1}, {1, 1, 1}, o, x, y) == 1);   // across
  BOOST_TEST(answer({1, 1, 1}, {1, 1, 2}, o, x, y) == 0);    // ends before
  BOOST_TEST(answer({1, 1, 0}, {1, 1, 2}, o, x, y) == 1);    // an end on it
  BOOST_TEST(answer({2, 2, -1}, {2, 2, 1}, o, x, y) == 1);   // through an edge
  BOOST_TEST(answer({4, 0, -1}, {4, 0, 1}, o, x, y) == 1);   // through a corner
  BOOST_TEST(answer({3, 3, -1}, {3, 3, 1}, o, x, y) == 0);   // beside
  BOOST_TEST(answer({-1, 1, 0}, {9, 1, 0}, o, x, y) == 1);   // in its plane, across
  BOOST_TEST(answer({1, 1, 0}, {1.5, 1, 0}, o, x, y) == 1);  // in its plane, within
  BOOST_TEST(answer({4, 4, 0}, {5, 4, 0}, o, x, y) == 0);    // in its plane, beside
  BOOST_TEST(answer({0, 8, 0}, {0, 4, 0}, o, x, y) == 1);    // in its plane, at a corner
  BOOST_TEST(answer({1, 1, 0}, {1, 1, 0}, o, x, y) == 1);    // points
  BOOST_TEST(answer({1, 1, 1}, {1, 1, 1}, o, x, y) == 0);
  BOOST_TEST(answer({1, -1, 0}, {1, 1, 0}, o, x, {2, 0, 0}) == 1);  // a triangle on a line, any order
  BOOST_TEST(answer({3, -1, 0}, {3, 1, 0}, o, {2, 0, 0}, x) == 1);
  BOOST_TEST(answer({5, -1, 0}, {5, 1, 0}, o, {2, 0, 0}, x) == 0);
  BOOST_TEST(answer({5, 0, 0}, {9, 0, 0}, o, {2, 0, 0}, x) == 0);  // on its line
  BOOST_TEST(answer({4, 0, 0}, {9, 0, 0}, {2, 0, 0}, x, o) == 1);
  BOOST_TEST(answer({3, 0, 0}, {3, 0, 0}, {2, 0, 0}, x, o) == 1);
  BOOST_TEST(answer({0, 0, 0}, {4, 4, 0}, {2, 2, 0}, {2, 2, 0}, {2, 2, 0}) == 1);  // a point
  BOOST_TEST(answer({0, 0, 0}, {4, 4, 0}, {2, 3, 0}, {2, 3, 0}, {2, 3, 0}) == 0);
  BOOST_TEST(answer(x, x, x, x, x) == 1);
  BOOST_TEST(answer(x, x, y, y, y) == 0);
}

BOOST_AUTO_TEST_CASE(a_triangle_is_classified_where_it_meets_the_cone)
{
  const auto answer = [](const Vertex& p, const Vertex& q, const Vertex& r) {
    return both(Predicate::classification, corner(p, q, r)).value();
  };
  BOOST_TEST(answer({1, 1, 5}, {5, 1, 1}, {1, 5, 2}) == 1);           // within
  BOOST_TEST(answer({19, -5, -5}, {-5, 19, -5}, {-5, -5, 19}) == 1);  // around: no corner is in it, no edge meets it
  BOOST_TEST(answer({9, -1, 1}, {-1, 9, 1}, {-1, -1, 2}) == 1);       // across
  BOOST_TEST(answer({-1, -1, 5}, {-1, 1, 5}, {-5, 0, 5}) == 0);       // beside
  BOOST_TEST(answer({-1, -1, -1}, {-1, -2, -3}, {-3, -1, -5}) == 0);  // behind
  BOOST_TEST(answer({0, 0, 1}, {-1, -2, 3}, {-3, -1, 5}) == 1);       // a corner on an edge
  BOOST_TEST(answer({-1, 1, 3}, {1, -1, 3}, {-5, -5, 2}) == 1);       // an edge on an edge
  BOOST_TEST(answer({-1, 1, 3}, {1, -1.5, 3}, {-5, -5, 2}) == 0);
  BOOST_TEST(!both(Predicate::classification, corner({1, 1, 1}, {2, 2, 2}, {5, 0, 0})));
}

BOOST_AUTO_TEST_CASE(the_truths_agree_on_a_small_grid)
{
  // So small that points coincide, and all kinds of degenerate positions come often.
  Random random(3);
  const auto seen = compare(6000, [&](int k) {
    Predicate_case c{};
    for (Vertex* x : {&c.v[0], &c.v[1], &c.v[2], &c.v[3], &c.p, &c.q, &c.r}) *x = grid_vertex(random, 1 + k % 3);
    if (k % 4 == 0) c.pose_a = c.pose_b = any_pose(random);
    return c;
  });
  BOOST_TEST(seen.at(Predicate::orientation).at("0") > 300);
  BOOST_TEST(seen.at(Predicate::solid).at("0") > 200);
  BOOST_TEST(seen.at(Predicate::solid).at("1") > 10);
  for (const Predicate predicate : {Predicate::tetra_cone, Predicate::tetrahedron, Predicate::classification})
    for (const char* answer : {"0", "1", "not asked"}) BOOST_TEST(seen.at(predicate).at(answer) > 100);
  for (const char* answer : {"0", "1"}) BOOST_TEST(seen.at(Predicate::segment_triangle).at(answer) > 500);
}

BOOST_AUTO_TEST_SUITE_END()
