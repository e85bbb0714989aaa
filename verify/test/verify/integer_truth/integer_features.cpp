#include "verify/integer_truth/integer_features.h"

#include "verify/test/support/object_cases.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <map>

BOOST_AUTO_TEST_SUITE(test_integer_features)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;
using tetracone::kernel::Contact;

namespace {

using Pairs = std::vector<Feature_pair>;

Pairs by_cgal(const Object_case& c) { return features(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b); }

/// The kind of the only edge of a stick, from vertex 0 to vertex 1, against the only face of the other body.
Contact of_stick(const Vertex& from, const Vertex& to, const Polyhedron& face)
{
  const Object_case c = object_case(polygon({from, to}), Pose(), face, Pose());
  const Pairs pairs = integer_truth::features(c);
  BOOST_TEST((pairs == by_cgal(c)));
  const auto found = std::find_if(pairs.begin(), pairs.end(), [](const Feature_pair& pair) { return pair.body == 0; });
  return found == pairs.end() ? Contact::none : found->kind;
}

std::map<Contact, int>& operator+=(std::map<Contact, int>& seen, const Pairs& pairs)
{
  for (const Feature_pair& pair : pairs) ++seen[pair.kind];
  return seen;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_stick_and_a_frame_meet_in_every_kind)
{
  const Polyhedron sheet = holed_square(4, 2);
  BOOST_TEST((of_stick({0, 0, -1}, {0, 0, 1}, sheet) == Contact::none));
  BOOST_TEST((of_stick({3, 0, -1}, {3, 0, -2}, sheet) == Contact::none));
  BOOST_TEST((of_stick({3, 0, -1}, {3, 0, 1}, sheet) == Contact::edge_face));
  BOOST_TEST((of_stick({3, 0, 0}, {3, 0, 1}, sheet) == Contact::vertex_face));
  BOOST_TEST((of_stick({3, 0, 0}, {3, 0, 0}, sheet) == Contact::vertex_face));
  BOOST_TEST((of_stick({2, 0, -1}, {2, 0, 1}, sheet) == Contact::edge_edge));
  BOOST_TEST((of_stick({4, 0, -3}, {4, 0, 1}, sheet) == Contact::edge_edge));
  BOOST_TEST((of_stick({2, 0, 0}, {2, 0, 1}, sheet) == Contact::vertex_edge));
  BOOST_TEST((of_stick({2, 2, -1}, {2, 2, 2}, sheet) == Contact::vertex_edge));
  BOOST_TEST((of_stick({4, 4, 0}, {4, 4, 2}, sheet) == Contact::vertex_vertex));
  // In the plane.
  BOOST_TEST((of_stick({-1, 0, 0}, {1, 1, 0}, sheet) == Contact::none));
  BOOST_TEST((of_stick({5, 0, 0}, {5, 9, 0}, sheet) == Contact::none));
  BOOST_TEST((of_stick({-1, 0, 0}, {2, 1, 0}, sheet) == Contact::vertex_edge));
  BOOST_TEST((of_stick({0, 0, 0}, {2, 2, 0}, sheet) == Contact::vertex_vertex));
  BOOST_TEST((of_stick({3, 5, 0}, {5, 3, 0}, sheet) == Contact::vertex_edge));
  BOOST_TEST((of_stick({4, 4, 0}, {5, 5, 0}, sheet) == Contact::vertex_vertex));
  BOOST_TEST((of_stick({3, 0, 0}, {3, 1, 0}, sheet) == Contact::coplanar_overlap));
  BOOST_TEST((of_stick({1, 0, 0}, {3, 0, 0}, sheet) == Contact::coplanar_overlap));
  BOOST_TEST((of_stick({0, 4, 0}, {0, 9, 0}, sheet) == Contact::vertex_edge));
  BOOST_TEST((of_stick({0, 2, 0}, {0, -2, 0}, sheet) == Contact::coplanar_overlap));  // through the hole, on both walls
  BOOST_TEST((of_stick({4, 1, 0}, {4, 9, 0}, sheet) == Contact::coplanar_overlap));
  BOOST_TEST((of_stick({4, 4, 0}, {4, 9, 0}, sheet) == Contact::vertex_vertex));
}

BOOST_AUTO_TEST_CASE(a_stick_and_a_face_on_a_line_meet_where_its_loops_are)
{
  const Polyhedron line = polygon({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}});
  BOOST_TEST((of_stick({1, -1, 0}, {1, 1, 0}, line) == Contact::edge_edge));
  BOOST_TEST((of_stick({1, 0, 0}, {1, 1, 0}, line) == Contact::vertex_edge));
  BOOST_TEST((of_stick({1, 0, 0}, {1, 0, 0}, line) == Contact::vertex_edge));
  BOOST_TEST((of_stick({2, -1, 0}, {2, 1, 0}, line) == Contact::vertex_edge));
  BOOST_TEST((of_stick({4, 0, 0}, {5, 0, 0}, line) == Contact::vertex_vertex));
  BOOST_TEST((of_stick({3, 0, 0}, {5, 0, 0}, line) == Contact::coplanar_overlap));
  BOOST_TEST((of_stick({5, 0, 0}, {6, 0, 0}, line) == Contact::none));
}

BOOST_AUTO_TEST_CASE(faces_of_any_loops_have_the_features_of_cgals_rationals)
{
  scenes::Random random(5);
  std::map<Contact, int> seen;
  for (int k = 0; k < 1500; ++k) {
    const Polyhedron a = any_loops(random, 2), b = any_loops(random, 2);
    const Pose pose_a = k % 3 == 0 ? random_rotation(random, 2) : Pose();
    const Pose pose_b = k % 2 == 0 ? composed(pose_a, translation(integer(random, -1, 1), 0, 0))
                                   : random_rotation(random, 1, {0, Rational(1) / 3, 0});
    const Object_case c = object_case(a, pose_a, b, pose_b);
    const Pairs pairs = integer_truth::features(c);
    BOOST_TEST((pairs == by_cgal(c)), k);
    seen += pairs;
  }
  for (const Contact kind : {Contact::vertex_vertex, Contact::vertex_edge, Contact::vertex_face, Contact::edge_edge,
                             Contact::edge_face, Contact::coplanar_overlap})
    BOOST_TEST(seen[kind] > 20, to_string(kind));
}

BOOST_AUTO_TEST_SUITE_END()
