#include "verify/integer_truth/rounded_pair.h"

#include "tetracone/covering/covering.h"
#include "verify/test/support/object_cases.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <tuple>

BOOST_AUTO_TEST_SUITE(test_rounded_pair)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using Random = tetracone::verify::scenes::Random;

namespace {

Rounded_body as_it_is(const Polyhedron& body)
{
  Rounded_body result{body, {}};
  const tetracone::covering::Covering covering(body);
  for (Index f = 0; f < body.face_count(); ++f) result.planes.push_back(covering.plane_basis(f));
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_not_rounded_meets_as_in_cgals_rationals)
{
  Random random(23);
  const std::vector<Named> bodies = closed_bodies();
  std::array<int, 3> seen{};
  for (int k = 0; k < 600; ++k) {
    const Polyhedron& a = bodies[integer(random, 0, int(bodies.size()) - 1)].body;
    const Polyhedron b =
        moved(bodies[integer(random, 0, int(bodies.size()) - 1)].body, k % 2 == 0 ? 1 : 0.125,
              {integer(random, -8, 8) / 4.0, integer(random, -8, 8) / 4.0, integer(random, -8, 8) / 4.0});
    const Brute_body brute_a(a), brute_b(b);
    const bool surface = collide(brute_a, Pose(), brute_b, Pose(), Question::surface),
               solid = collide(brute_a, Pose(), brute_b, Pose(), Question::solid);
    const Rounded_pair pair(as_it_is(a), as_it_is(b), Question::solid);
    BOOST_TEST(pair.collide() == solid, k);
    BOOST_TEST(pair.is_contained() == (solid && !surface), k);
    BOOST_TEST(Rounded_pair(as_it_is(a), as_it_is(b), Question::surface).collide() == surface, k);
    const std::vector<Feature_pair> expected = features(brute_a, Pose(), brute_b, Pose());
    std::size_t count = 0;
    for (const auto& [body, edges_of, faces_of] : {std::tuple{0, &brute_a, &b}, {1, &brute_b, &a}})
      for (const auto& [from, to] : edges_of->edges())
        for (Index f = 0; f < faces_of->face_count(); ++f) count += pair.edge_meets_face(body, from, to, f);
    BOOST_TEST(count == expected.size(), k);
    for (const Feature_pair& f : expected) BOOST_TEST(pair.edge_meets_face(f.body, f.edge_from, f.edge_to, f.face), k);
    ++seen[surface ? 0 : solid ? 1 : 2];
  }
  for (const int count : seen) BOOST_TEST(count > 30);
}

BOOST_AUTO_TEST_CASE(a_bent_face_meets_the_edge_that_its_loop_winds_about)
{
  // A square with a corner a little off the plane of the three others, and an edge through its middle.
  const Polyhedron square = polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0x1p-40}, {0, 1, 0}});
  const Rounded_body bent{square, {std::array<Index, 3>{0, 1, 3}}};
  const auto meets = [&](const Vertex& from, const Vertex& to) {
    return Rounded_pair({polygon({from, to}), {std::nullopt}}, bent, Question::surface).edge_meets_face(0, 0, 1, 0);
  };
  BOOST_TEST(meets({0.5, 0.5, -1}, {0.5, 0.5, 1}));
  BOOST_TEST(meets({0.75, 0.75, 0x1p-60}, {0.75, 0.75, -1}));
  BOOST_TEST(!meets({0.75, 0.75, 0x1p-60}, {0.75, 0.75, 1}));
  BOOST_TEST(!meets({1.5, 0.5, -1}, {1.5, 0.5, 1}));
  BOOST_TEST(meets({1, 0.5, -1}, {1, 0.5, 1}));
}

BOOST_AUTO_TEST_CASE(infinite_images_are_found)
{
  Rounded_body body = as_it_is(unit_cube());
  BOOST_TEST(body.is_finite());
  body.surface.vertices[3][1] = std::numeric_limits<double>::infinity();
  BOOST_TEST(!body.is_finite());
  body.surface.vertices[3][1] = std::nan("");
  BOOST_TEST(!body.is_finite());
}

BOOST_AUTO_TEST_SUITE_END()
