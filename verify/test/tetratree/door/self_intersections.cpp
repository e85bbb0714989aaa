#include "tetracone/tetratree/door/tetracone.h"
#include "verify/integer_truth/integer_contacts.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/self_touching.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/self_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_self_intersections)

using namespace tetracone;
namespace scenes = verify::scenes;

namespace {

verify::Contact_forms sorted(verify::Contact_forms forms)
{
  std::sort(forms.begin(), forms.end());
  return forms;
}

verify::Contact_forms forms_of(const Contacts& contacts)
{
  verify::Contact_forms forms;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    std::vector<std::vector<verify::Exact_point>> loops;
    for (const auto& loop : contacts.exact_loops(k)) {
      loops.emplace_back();
      for (const auto& x : loop)
        loops.back().push_back({kernel::Rational(x[0]), kernel::Rational(x[1]), kernel::Rational(x[2])});
    }
    const Contact_piece piece = contacts[k];
    forms.push_back(verify::piece_form(piece.face_a, piece.face_b, piece.kind, piece.in_a, piece.in_b, loops));
  }
  return sorted(verify::with_joined_polygons(forms));
}

std::vector<std::string> pairs_of(const Polyhedron& polyhedron)
{
  const Body body(polyhedron);
  std::vector<std::string> pairs;
  const Contacts contacts = body.self_intersections();
  for (std::size_t k = 0; k < contacts.size(); ++k)
    pairs.push_back(std::to_string(contacts[k].face_a) + " " + std::to_string(contacts[k].face_b) + " " +
                    std::string(to_string(contacts[k].kind)));
  BOOST_TEST(body.is_simple() == pairs.empty());
  return pairs;
}

using Strings = std::vector<std::string>;

}  // namespace

BOOST_AUTO_TEST_CASE(pieces_and_their_places_are_those_of_both_truths)
{
  scenes::Random random(4603);
  std::size_t pieces = 0;
  for (const auto& [name, polyhedron] : scenes::self_touching_bodies(random, 12)) {
    BOOST_TEST_INFO_SCOPE(name);
    const verify::Contact_forms found = forms_of(Body(polyhedron).self_intersections());
    const auto whole = verify::with_itself(polyhedron);
    BOOST_TEST(
        (found == sorted(verify::with_joined_polygons(verify::improper_pieces(verify::contacts(whole), polyhedron)))));
    BOOST_TEST((found == sorted(verify::improper_pieces(verify::integer_truth::contacts(whole), polyhedron))));
    pieces += found.size();
  }
  BOOST_TEST(pieces > 300u);
}

BOOST_AUTO_TEST_CASE(equal_coordinates_are_one_vertex_and_a_t_junction_is_improper)
{
  // A square of two triangles without a common number.
  Polyhedron square;
  square.vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {-0.0, 0, -0.0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}};
  square.add_polygon({0, 1, 2});
  square.add_polygon({3, 4, 5});
  BOOST_TEST(pairs_of(square) == Strings());
  // The second side is cut at the middle of the common edge.
  Polyhedron cut = square;
  cut.add_polygon({3, 6, 5});
  BOOST_TEST(pairs_of(cut) == (Strings{"0 2 segment", "1 2 coplanar"}));
  // A face twice; a zero-area face in an edge that both have, and one with half of it.
  Polyhedron twice = square;
  twice.add_polygon({1, 2, 0});
  twice.add_polygon({0, 2, 2});
  twice.add_polygon({0, 6, 6});
  BOOST_TEST(pairs_of(twice) == (Strings{"0 2 coplanar", "0 4 segment", "1 4 segment", "2 4 segment", "3 4 segment"}));
}

BOOST_AUTO_TEST_CASE(an_edge_of_many_faces_is_proper_and_so_are_edges_of_faces_with_holes)
{
  Polyhedron fan;
  fan.vertices = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 1, 0}};
  for (Index k = 2; k < 7; ++k) fan.add_polygon({0, 1, k});
  BOOST_TEST(pairs_of(fan) == Strings());
  Polyhedron blocks = scenes::cube_with_tunnel();
  BOOST_TEST(pairs_of(blocks) == Strings());
  // A second block beside the first: all that they share beyond edges of both are the faces between them.
  append(blocks, scenes::moved(scenes::cube_with_tunnel(), 1, {6, 0, 0}));
  BOOST_TEST(pairs_of(blocks) == (Strings{"2 10 coplanar"}));
}

BOOST_AUTO_TEST_SUITE_END()
