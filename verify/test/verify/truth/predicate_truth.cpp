#include "verify/truth/predicate_truth.h"

#include "verify/integer_truth/integer_truth.h"

#include <boost/test/unit_test.hpp>

#include <optional>
#include <string>

namespace tetracone::verify {

std::ostream& operator<<(std::ostream& out, Predicate predicate) { return out << to_string(predicate); }

}  // namespace tetracone::verify

BOOST_AUTO_TEST_SUITE(test_predicate_truth)

using namespace tetracone::verify;
using tetracone::kernel::Pose;
using tetracone::kernel::Vertex;

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

}  // namespace

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

BOOST_AUTO_TEST_CASE(triangles_are_closed_and_may_be_segments_and_points)
{
  // v1 v2 v3 is the corner's face x + y + z = 2.
  const auto meets = [](const Vertex& p, const Vertex& q, const Vertex& r) {
    return both(Predicate::triangle_triangle, corner(p, q, r)).value();
  };
  BOOST_TEST(meets({0, 0, 0}, {3, 0, 0.25}, {0, 3, 0.25}) == 1);           // across
  BOOST_TEST(meets({2, 0, 0}, {3, 0, 1}, {3, 0, -1}) == 1);                // in a corner
  BOOST_TEST(meets({2 + 0x1p-51, 0, 0}, {3, 0, 1}, {3, 0, -1}) == 0);      // and next to it
  BOOST_TEST(meets({0.5, 0.5, 1}, {0.5, 1, 0.5}, {1, 0.5, 0.5}) == 1);     // inside, in its plane
  BOOST_TEST(meets({2, 1, -1}, {3, 0, -1}, {2, 2, -2}) == 0);              // beside, in its plane
  BOOST_TEST(meets({0, 0, 0}, {1, 1, 1}, {2, 2, 2}) == 1);                 // a segment through it
  BOOST_TEST(meets({1, 1, 0}, {1, 1, 0}, {1, 1, 0}) == 1);                 // a point of an edge
  BOOST_TEST(meets({1, 1, 5e-324}, {1, 1, 5e-324}, {1, 1, 5e-324}) == 0);  // and one above it
}

BOOST_AUTO_TEST_SUITE_END()
