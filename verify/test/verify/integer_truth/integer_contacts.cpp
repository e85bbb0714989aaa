#include "verify/integer_truth/integer_contacts.h"

#include "verify/test/support/object_cases.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <map>

BOOST_AUTO_TEST_SUITE(test_integer_contacts)

using namespace tetracone::verify;
using tetracone::kernel::Feature;
using tetracone::kernel::Piece;
using namespace tetracone::verify::scenes;

namespace {

/// Both truths' list, by kinds.
std::map<Piece, int> kinds_of(const Polyhedron& a, const Polyhedron& b)
{
  const Object_case c = object_case(a, Pose(), b, Pose());
  const Contact_forms forms = contacts(c);
  BOOST_TEST((with_joined_polygons(forms) == integer_truth::contacts(c)));
  std::map<Piece, int> kinds;
  for (const Contact_piece_form& form : forms) ++kinds[form.kind];
  return kinds;
}

Polyhedron frame(double x) { return holed_square(4, 2, x); }

using Kinds = std::map<Piece, int>;

}  // namespace

BOOST_AUTO_TEST_CASE(a_blade_through_a_frame_meets_it_in_two_segments)
{
  const Polyhedron blade = polygon({{-9, 0, -1}, {9, 0, -1}, {9, 0, 1}, {-9, 0, 1}});
  BOOST_TEST((kinds_of(frame(0), blade) == Kinds{{Piece::segment, 2}}));
}

BOOST_AUTO_TEST_CASE(frames_in_one_plane_share_polygons_and_where_they_touch_a_segment)
{
  BOOST_TEST((kinds_of(frame(0), frame(0)) == Kinds{{Piece::polygon, 1}}));
  BOOST_TEST((kinds_of(frame(0), frame(7)) == Kinds{{Piece::polygon, 1}}));
  BOOST_TEST((kinds_of(frame(0), frame(8)) == Kinds{{Piece::segment, 1}}));
  // Two arms of each: the holes part the overlap.
  BOOST_TEST((kinds_of(frame(0), frame(5)) == Kinds{{Piece::polygon, 1}}));
  BOOST_TEST(
      (kinds_of(frame(0), polygon({{-9, -1, 0}, {9, -1, 0}, {9, 1, 0}, {-9, 1, 0}})) == Kinds{{Piece::polygon, 2}}));
}

BOOST_AUTO_TEST_CASE(teeth_that_touch_a_line_share_points)
{
  const Polyhedron comb = polygon({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}, {4, 0, 0}, {2, -2, 0}});
  const Polyhedron plate = polygon({{0, 1, 0}, {4, 1, 0}, {4, 3, 0}, {0, 3, 0}});
  BOOST_TEST((kinds_of(comb, plate) == Kinds{{Piece::point, 2}}));
  const Polyhedron wall = polygon({{-1, 1, -1}, {5, 1, -1}, {5, 1, 1}, {-1, 1, 1}});
  BOOST_TEST((kinds_of(comb, wall) == Kinds{{Piece::point, 2}}));
}

BOOST_AUTO_TEST_CASE(the_features_are_those_that_hold_the_piece)
{
  const Polyhedron flat = polygon({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
  const Polyhedron upright = polygon({{0, 0, 0}, {1, 0, 0}, {0.5, 0, 1}});
  const Contact_forms along = contacts(object_case(flat, Pose(), upright, Pose()));
  BOOST_TEST_REQUIRE(along.size() == 1u);
  BOOST_TEST((along[0].kind == Piece::segment && along[0].in_a == Feature::edge && along[0].in_b == Feature::edge));
  const Polyhedron spike = polygon({{0.5, 0.5, 0}, {1, 0.5, 1}, {0.5, 1, 1}});
  const Contact_forms tip = contacts(object_case(flat, Pose(), spike, Pose()));
  BOOST_TEST_REQUIRE(tip.size() == 1u);
  BOOST_TEST((tip[0].kind == Piece::point && tip[0].in_a == Feature::interior && tip[0].in_b == Feature::vertex));
}

BOOST_AUTO_TEST_SUITE_END()
