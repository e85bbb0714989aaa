#include "verify/integer_truth/integer_features.h"

#include "verify/families/families.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_integer_features)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;
using tetracone::kernel::Contact;

namespace {

using Pairs = std::vector<Feature_pair>;

Object_case object_case(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b, const Pose& pose_b)
{
  return {std::make_shared<const Polyhedron>(a), std::make_shared<const Polyhedron>(b), pose_a, pose_b, {}, {}, {}};
}

Pairs by_cgal(const Object_case& c) { return features(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b); }

/// The kind of the only edge of a stick, from vertex 0 to vertex 1, against the only face of the other body.
Contact of_stick(const Vertex& from, const Vertex& to, const Polyhedron& face)
{
  Polyhedron stick;
  stick.vertices = {from, to};
  stick.add_polygon({0, 1});
  const Object_case c = object_case(stick, Pose(), face, Pose());
  const Pairs pairs = integer_truth::features(c);
  BOOST_TEST((pairs == by_cgal(c)));
  const auto found = std::find_if(pairs.begin(), pairs.end(), [](const Feature_pair& pair) { return pair.body == 0; });
  return found == pairs.end() ? Contact::none : found->kind;
}

/// A square with a square hole, in the plane z = 0.
Polyhedron frame()
{
  Polyhedron result;
  for (const double half : {4.0, 2.0})
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      result.vertices.push_back({half * x, half * y, 0});
  result.add_face({{0, 1, 2, 3}, {7, 6, 5, 4}});
  return result;
}

std::map<Contact, int>& operator+=(std::map<Contact, int>& seen, const Pairs& pairs)
{
  for (const Feature_pair& pair : pairs) ++seen[pair.kind];
  return seen;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_stick_and_a_frame_meet_in_every_kind)
{
  const Polyhedron sheet = frame();
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
  Polyhedron line;
  line.vertices = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}};
  line.add_polygon({0, 1, 2});
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
  // Up to three loops of up to five corners of a grid: they cross, repeat and cancel themselves and each other.
  scenes::Random random(5);
  const auto face = [&](int radius) {
    Polyhedron result;
    std::vector<std::vector<Index>> loops(integer(random, 1, 3));
    for (auto& loop : loops)
      for (int k = integer(random, 1, 5); k > 0; --k) {
        loop.push_back(Index(result.vertices.size()));
        result.vertices.push_back(
            {double(integer(random, -radius, radius)), double(integer(random, -radius, radius)), 0});
      }
    result.add_face(loops);
    return result;
  };
  std::map<Contact, int> seen;
  for (int k = 0; k < 1500; ++k) {
    const Polyhedron a = face(2), b = face(2);
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

BOOST_AUTO_TEST_CASE(every_family_has_the_features_of_cgals_rationals)
{
  std::map<Contact, int> seen;
  for (const Family& family : families())
    for (std::uint64_t k = 0; k < 2 * family.sweep.size(); ++k) {
      const Object_case c = family.object_case(8, k);
      if (c.a->face_count() + c.b->face_count() > 1000) continue;
      const Pairs pairs = integer_truth::features(c);
      BOOST_TEST((pairs == by_cgal(c)), family.name << ' ' << k);
      BOOST_TEST(pairs.empty() == !collide(Brute_body(*c.a), c.pose_a, Brute_body(*c.b), c.pose_b, Question::surface));
      seen += pairs;
    }
  for (const Contact kind : {Contact::vertex_vertex, Contact::vertex_edge, Contact::vertex_face, Contact::edge_edge,
                             Contact::edge_face, Contact::coplanar_overlap})
    BOOST_TEST(seen[kind] > 100, to_string(kind));
}

BOOST_AUTO_TEST_SUITE_END()
