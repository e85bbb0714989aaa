#include "verify/cases/lego.h"

#include "tetracone/covering/check.h"
#include "tetracone/covering/covering.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_lego)

using namespace tetracone;
using namespace tetracone::verify;
using namespace tetracone::verify::lego;

namespace {

const Cells cube = {{0, 0, 0}}, big = block({0, 0, 0}, {3, 3, 3});

Cells hollow()
{
  Cells cells = big;
  cells.erase({1, 1, 1});
  return cells;
}

}  // namespace

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
