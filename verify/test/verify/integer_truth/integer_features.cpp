#include "verify/integer_truth/integer_features.h"

#include "verify/test/support/object_cases.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <map>

BOOST_AUTO_TEST_SUITE(test_integer_features)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;
using tetracone::kernel::Contact;

namespace {

using Pairs = std::vector<Feature_pair>;

Pairs by_cgal(const Object_case& c) { return features(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b); }

std::map<Contact, int>& operator+=(std::map<Contact, int>& seen, const Pairs& pairs)
{
  for (const Feature_pair& pair : pairs) ++seen[pair.kind];
  return seen;
}

}  // namespace

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
