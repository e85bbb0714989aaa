#include "tetracone/tetratree/query/bvh8_self_contacts.h"

#include "tetracone/covering/star_faces.h"
#include "verify/integer_truth/integer_contacts.h"
#include "verify/test/support/scenes.h"
#include "verify/test/support/self_touching.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/self_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bvh8_self_contacts)

namespace scenes = tetracone::verify::scenes;
namespace verify = tetracone::verify;
using namespace tetracone::tetratree;
using tetracone::covering::Polyhedron;

namespace {

/// What tells a piece from others, without its place. Polygons of one pair count as one.
using Piece_name =
    std::tuple<Index, Index, tetracone::kernel::Piece, tetracone::kernel::Feature, tetracone::kernel::Feature>;

template <class Pieces>
std::vector<Piece_name> names(const Pieces& pieces)
{
  std::vector<Piece_name> names;
  for (const auto& p : pieces) {
    const Piece_name name(p.face_a, p.face_b, p.kind, p.in_a, p.in_b);
    if (p.kind == tetracone::kernel::Piece::polygon && std::ranges::count(names, name) > 0) continue;
    names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

std::vector<Piece_name> found_in(const Polyhedron& body)
{
  const Bvh8 tree(body, tetracone::covering::star_faces(body));
  const auto found = Bvh8_self_contacts(tree, body).improper();
  BOOST_TEST(Bvh8_self_contacts(tree, body).is_simple() == found.pieces.empty());
  BOOST_TEST(
      std::ranges::is_sorted(found.pieces, {}, [](const Found_piece& p) { return std::pair(p.face_a, p.face_b); }));
  return names(found.pieces);
}

}  // namespace

BOOST_AUTO_TEST_CASE(pairs_are_those_of_both_truths)
{
  scenes::Random random(4601);
  int pairs = 0, simple = 0, bodies = 0;
  for (const auto& [name, body] : scenes::self_touching_bodies(random, 60)) {
    BOOST_TEST_INFO_SCOPE(name);
    const auto found = found_in(body);
    const auto whole = verify::with_itself(body);
    const auto expected = names(verify::improper_pieces(verify::contacts(whole), body));
    BOOST_TEST((found == expected));
    BOOST_TEST((names(verify::improper_pieces(verify::integer_truth::contacts(whole), body)) == expected));
    pairs += int(found.size());
    simple += found.empty();
    ++bodies;
  }
  BOOST_TEST(pairs > 1000);
  BOOST_TEST(simple > 10);
  BOOST_TEST(simple < bodies - 40);
}

BOOST_AUTO_TEST_CASE(meshes_in_space_and_in_a_plane_are_simple_until_a_vertex_goes_through)
{
  scenes::Random random(4602);
  for (Polyhedron body :
       {scenes::blob(random, 4, 0.999, 1), scenes::triangulated(scenes::torus(40, 20)), scenes::grid(20)}) {
    BOOST_TEST(found_in(body).empty());
    // A corner of face 0 goes beyond a face that has none of its corners.
    const auto corner = body.loop(0, 0)[0];
    const auto far = [&](Index f) {
      return std::ranges::none_of(body.loop(f, 0), [&](Index v) { return std::ranges::count(body.loop(0, 0), v) > 0; });
    };
    Index other = Index(5 * body.face_count() / 8);
    while (!far(other)) ++other;
    const auto through = body.loop(other, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      body.vertices[corner][k] = 0;
      for (const Index v : through) body.vertices[corner][k] += body.vertices[v][k] / 2;
    }
    BOOST_TEST(!found_in(body).empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()
