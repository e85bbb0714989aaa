#include "verify/integer_truth/integer_contacts.h"

#include "verify/families/families.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/cgal_contacts.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_integer_contacts)

using namespace tetracone::verify;
using tetracone::kernel::Feature;
using tetracone::kernel::Piece;
using tetracone::kernel::Pose;
using Polyhedron = tetracone::covering::Polyhedron;

namespace {

Object_case face_pair(const Polyhedron& a, const Polyhedron& b)
{
  return {std::make_shared<const Polyhedron>(a), std::make_shared<const Polyhedron>(b), Pose(), Pose(), {}, {}, {}};
}

/// Both truths' list, by kinds.
std::map<Piece, int> kinds_of(const Polyhedron& a, const Polyhedron& b)
{
  const Object_case c = face_pair(a, b);
  const Contact_forms forms = contacts(c);
  BOOST_TEST((with_joined_polygons(forms) == integer_truth::contacts(c)));
  std::map<Piece, int> kinds;
  for (const Contact_piece_form& form : forms) ++kinds[form.kind];
  return kinds;
}

/// A square about (x, 0, 0) with a square hole, in the plane z = 0.
Polyhedron frame(double x)
{
  Polyhedron frame;
  for (const double half : {4.0, 2.0})
    for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      frame.vertices.push_back({x + half * i, half * j, 0});
  frame.add_face({{0, 1, 2, 3}, {7, 6, 5, 4}});
  return frame;
}

Polyhedron polygon(std::vector<tetracone::kernel::Vertex> corners)
{
  Polyhedron polygon;
  polygon.vertices = std::move(corners);
  std::vector<tetracone::covering::Index> loop(polygon.vertices.size());
  for (std::size_t k = 0; k < loop.size(); ++k) loop[k] = tetracone::covering::Index(k);
  polygon.add_polygon(loop);
  return polygon;
}

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
  const Contact_forms along = contacts(face_pair(flat, upright));
  BOOST_TEST_REQUIRE(along.size() == 1u);
  BOOST_TEST((along[0].kind == Piece::segment && along[0].in_a == Feature::edge && along[0].in_b == Feature::edge));
  const Polyhedron spike = polygon({{0.5, 0.5, 0}, {1, 0.5, 1}, {0.5, 1, 1}});
  const Contact_forms tip = contacts(face_pair(flat, spike));
  BOOST_TEST_REQUIRE(tip.size() == 1u);
  BOOST_TEST((tip[0].kind == Piece::point && tip[0].in_a == Feature::interior && tip[0].in_b == Feature::vertex));
}

BOOST_AUTO_TEST_CASE(the_truths_agree_on_every_family)
{
  std::map<Piece, int> seen;
  for (const Family& family : families())
    for (std::uint64_t k = 0; k < 2; ++k) {
      const Object_case c = family.object_case(3, k);
      if (c.a->face_count() * c.b->face_count() > 20000) continue;
      const Contact_forms forms = contacts(c);
      BOOST_TEST((with_joined_polygons(forms) == integer_truth::contacts(c)), family.name << ' ' << k);
      for (const Contact_piece_form& form : forms) ++seen[form.kind];
    }
  BOOST_TEST(seen.size() == 3u);
}

BOOST_AUTO_TEST_SUITE_END()
