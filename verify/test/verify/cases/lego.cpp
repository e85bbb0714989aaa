#include "verify/cases/lego.h"

#include "tetracone/covering/check.h"
#include "tetracone/covering/covering.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_lego)

using namespace tetracone;
using namespace tetracone::verify;
using namespace tetracone::verify::lego;
using kernel::Rational;
using kernel::Solid_contact;
using kernel::Solid_relation;

namespace {

const Cells cube = {{0, 0, 0}}, big = block({0, 0, 0}, {3, 3, 3});

Cells hollow()
{
  Cells cells = big;
  cells.erase({1, 1, 1});
  return cells;
}

Solid_contact contact(const Cells& a, const Cells& b, const Cell& offset)
{
  return overlap({{a}}, {{b}}, offset).contact;
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_relation_and_dimension_is_counted)
{
  BOOST_TEST((contact(cube, cube, {3, 0, 0}) == Solid_contact{Solid_relation::disjoint, -1}));
  BOOST_TEST((contact(cube, cube, {2, 2, -2}) == Solid_contact{Solid_relation::meet, 0}));
  BOOST_TEST((contact(cube, cube, {2, 2, 1}) == Solid_contact{Solid_relation::meet, 1}));
  BOOST_TEST((contact(cube, cube, {2, 1, 1}) == Solid_contact{Solid_relation::meet, 2}));
  BOOST_TEST((contact(cube, cube, {1, 0, 0}) == Solid_contact{Solid_relation::overlap, 2}));
  BOOST_TEST((contact(cube, cube, {1, 1, 1}) == Solid_contact{Solid_relation::overlap, 1}));
  BOOST_TEST((contact(cube, cube, {0, 0, 0}) == Solid_contact{Solid_relation::equal, 2}));
  BOOST_TEST((contact(cube, big, {-1, -2, -3}) == Solid_contact{Solid_relation::inside, -1}));
  BOOST_TEST((contact(big, cube, {1, 2, 3}) == Solid_contact{Solid_relation::contains, -1}));
  BOOST_TEST((contact(cube, big, {0, -2, -3}) == Solid_contact{Solid_relation::covered_by, 2}));
  BOOST_TEST((contact(big, cube, {0, 2, 3}) == Solid_contact{Solid_relation::covers, 2}));
  BOOST_TEST((contact(hollow(), cube, {2, 2, 2}) == Solid_contact{Solid_relation::meet, 2}));
}

BOOST_AUTO_TEST_CASE(membranes_lie_in_the_interior_and_sheets_do_not)
{
  // A wall between two halves of a box is no border, whether their windings are equal or not.
  const Cells left = block({0, 0, 0}, {2, 4, 4}), right = block({2, 0, 0}, {4, 4, 4});
  for (const int turn : {1, -1})
    BOOST_TEST(
        (overlap({{cube}}, {{left}, {right, turn}}, {-4, -3, -3}).contact == Solid_contact{Solid_relation::inside, 2}));
  // A cube taken from another one leaves its walls, which have an interior nowhere.
  const Bricks sheet = {{cube, 1}, {cube, -1}};
  BOOST_TEST((overlap(sheet, sheet, {0, 0, 0}).contact == Solid_contact{Solid_relation::equal, 2}));
  BOOST_TEST((overlap(sheet, {{big}}, {-2, -2, -2}).contact == Solid_contact{Solid_relation::inside, -1}));
  BOOST_TEST((overlap(sheet, {{cube}}, {0, 0, 0}).contact == Solid_contact{Solid_relation::covered_by, 2}));
  BOOST_TEST((overlap(sheet, {{big}}, {-1, -2, -7}).contact == Solid_contact{Solid_relation::disjoint, -1}));
  BOOST_TEST((overlap(sheet, {{big}}, {-2, -2, -5}).contact == Solid_contact{Solid_relation::meet, 1}));
}

BOOST_AUTO_TEST_CASE(overlaps_are_counted_with_their_centroid)
{
  const Solid_overlap half = overlap({{cube}}, {{cube}}, {1, 0, -1});
  BOOST_TEST((half.volume == Rational(1, 4)));
  BOOST_TEST((half.centroid == std::array<Rational, 3>{Rational(3, 4), Rational(1, 2), Rational(1, 4)}));
  const Solid_overlap none = overlap({{cube}}, {{cube}}, {2, 0, 0});
  BOOST_TEST((none.volume == 0 && none.centroid == std::array<Rational, 3>{0, 0, 0}));
}

BOOST_AUTO_TEST_CASE(every_division_of_a_surface_is_closed_planar_and_has_the_volume_of_its_cells)
{
  Random random(1);
  Cells stairs;
  for (int k = 0; k < 3; ++k) stairs.insert({k, k, k == 2 ? 1 : k});
  for (const Cells& cells : {cube, big, hollow(), stairs})
    for (const double merged : {0.0, 0.5, 1.0})
      for (const double halved : {0.0, 0.5, 1.0})
        for (const bool is_one_mesh : {false, true})
          for (const bool is_straight : {false, true}) {
            const Bricks bricks = {{cells}, {big, -1}, {cells}};
            const covering::Polyhedron body = solid(bricks, {merged, halved, is_one_mesh, is_straight}, random);
            BOOST_TEST(covering::is_closed(body));
            for (covering::Index f = 0; f < body.face_count(); ++f)
              BOOST_TEST((covering::planarity(body, f) == covering::Planarity::planar));
            BOOST_TEST((covering::volume(body) == 2 * long(cells.size()) - long(big.size())));
          }
  const covering::Polyhedron merged = solid({{hollow()}}, {1, 0, true, true}, random);
  BOOST_TEST(merged.face_count() == 12);
  BOOST_TEST(merged.corner_count() == 48);
}

BOOST_AUTO_TEST_SUITE_END()
