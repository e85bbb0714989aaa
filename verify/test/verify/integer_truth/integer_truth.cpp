#include "verify/integer_truth/integer_truth.h"

#include "verify/integer_truth/integer_features.h"
#include "verify/test/support/object_cases.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <map>

BOOST_AUTO_TEST_SUITE(test_integer_truth)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;
using tetracone::kernel::Contact;
using tetracone::kernel::Question;

namespace {

Polyhedron dot(const Vertex& at) { return polygon({at}); }

}  // namespace

BOOST_AUTO_TEST_CASE(faces_of_any_loops_meet_and_have_the_features_as_in_cgals_rationals)
{
  Random random(5);
  std::map<Contact, int> seen;
  int apart = 0;
  for (int k = 0; k < 1500; ++k) {
    const Polyhedron a = any_loops(random, 2), b = any_loops(random, 2);
    const Pose pose_a = k % 3 == 0 ? random_rotation(random, 2) : Pose();
    const Pose pose_b = k % 2 == 0 ? composed(pose_a, translation(integer(random, -1, 1), 0, 0))
                                   : random_rotation(random, 1, {0, Rational(1) / 3, 0});
    const Object_case c = object_case(a, pose_a, b, pose_b);
    const auto pairs = integer_truth::features(c);
    BOOST_TEST((pairs == features(Brute_body(a), pose_a, Brute_body(b), pose_b)), k);
    BOOST_TEST(integer_truth::collide(c, Question::surface) == !pairs.empty(), k);
    for (const auto& pair : pairs) ++seen[pair.kind];
    apart += pairs.empty();
  }
  for (const Contact kind : {Contact::vertex_vertex, Contact::vertex_edge, Contact::vertex_face, Contact::edge_edge,
                             Contact::edge_face, Contact::coplanar_overlap})
    BOOST_TEST(seen[kind] > 20, to_string(kind));
  BOOST_TEST(apart > 100);
}

BOOST_AUTO_TEST_CASE(points_are_in_voxel_solids_where_their_cells_are_full)
{
  // Points of the grid of halves: the vertical ray runs through vertices, along edges and in faces.
  Random random(4);
  for (int k = 0; k < 3; ++k) {
    const Voxels voxels(random, 3);
    const Polyhedron solid = voxels.solid();
    for (int x = -1; x <= 7; ++x)
      for (int y = -1; y <= 7; ++y)
        for (int z = -1; z <= 7; ++z) {
          const Object_case c = object_case(solid, Pose(), dot({x / 2.0, y / 2.0, z / 2.0}), Pose());
          const int where = voxels.where(x, y, z);
          BOOST_TEST(integer_truth::collide(c, Question::surface) == (where == 0));
          BOOST_TEST(integer_truth::collide(c, Question::solid) == (where >= 0));
        }
  }
}

BOOST_AUTO_TEST_SUITE_END()
