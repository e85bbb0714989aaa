#include "verify/truth/overlap_truth.h"

#include "verify/test/support/object_cases.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <stdexcept>

BOOST_AUTO_TEST_SUITE(test_overlap_truth)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using tetracone::kernel::Solid_contact;
using tetracone::kernel::Solid_relation;
namespace kernel = tetracone::kernel;

namespace {

Solid_contact contact(const Polyhedron& a, const Polyhedron& b)
{
  return solid_overlap(object_case(a, Pose(), b, Pose())).contact;
}

/// A body and a segment from p to q: a face of two corners.
Polyhedron with_whisker(Polyhedron body, const Vertex& p, const Vertex& q)
{
  append(body, polygon({p, q}));
  return body;
}

/// A body and a triangle with both of its sides: nothing is inside.
Polyhedron with_sheet(Polyhedron body, const std::array<Vertex, 3>& corners)
{
  Polyhedron sheet = polygon({corners[0], corners[1], corners[2]});
  sheet.add_polygon({0, 2, 1});
  append(body, sheet);
  return body;
}

}  // namespace

BOOST_AUTO_TEST_CASE(segments_and_sheets_of_a_surface_are_parts_of_the_solid_that_have_no_interior)
{
  const Polyhedron room = cube(4), small = cube(1);
  const auto whisker_to = [&](double x) { return with_whisker(small, {3, 3, 3}, {x, 3, 3}); };
  BOOST_TEST((contact(whisker_to(3.5), room) == Solid_contact{Solid_relation::inside, -1}));
  BOOST_TEST((contact(whisker_to(4), room) == Solid_contact{Solid_relation::covered_by, 0}));
  BOOST_TEST((contact(whisker_to(5), room) == Solid_contact{Solid_relation::overlap, 0}));
  BOOST_TEST((contact(room, whisker_to(4)) == Solid_contact{Solid_relation::covers, 0}));
  const auto sheet_to = [&](double x) { return with_sheet(small, {Vertex{3, 3, 3}, {x, 3, 3}, {3, 3, 2}}); };
  BOOST_TEST((contact(sheet_to(3.5), room) == Solid_contact{Solid_relation::inside, -1}));
  BOOST_TEST((contact(sheet_to(4), room) == Solid_contact{Solid_relation::covered_by, 0}));
  BOOST_TEST((contact(sheet_to(5), room) == Solid_contact{Solid_relation::overlap, 1}));
  // Outside of the room they meet nothing but the whisker, which is within a solid that has no interior there.
  const Polyhedron far = with_whisker(small, {8, 8, 8}, {9, 8, 8}), speck = polygon({{8.5, 8, 8}});
  BOOST_TEST((contact(speck, far) == Solid_contact{Solid_relation::covered_by, 0}));
  BOOST_TEST((contact(speck, speck) == Solid_contact{Solid_relation::equal, 0}));
  BOOST_TEST((contact(polygon({{8.5, 8, 8}, {9.5, 8, 8}}), far) == Solid_contact{Solid_relation::meet, 1}));
  BOOST_TEST((contact(polygon({{0, 0, 0}}), far) == Solid_contact{Solid_relation::inside, -1}));
  BOOST_TEST((contact(polygon({{1, 0, 0}}), far) == Solid_contact{Solid_relation::covered_by, 0}));
  BOOST_TEST((contact(polygon({{7, 0, 0}}), far) == Solid_contact{Solid_relation::disjoint, -1}));
}

BOOST_AUTO_TEST_CASE(a_membrane_is_no_border_of_the_interior)
{
  // Boxes side by side: what touches the wall between them lies in the interior, but not at the wall's border.
  Polyhedron boxes = box({-4, -4, -4}, {0, 4, 4});
  append(boxes, box({0, -4, -4}, {4, 4, 4}));
  BOOST_TEST((contact(box({0, -1, -1}, {1, 1, 1}), boxes) == Solid_contact{Solid_relation::inside, 2}));
  BOOST_TEST((contact(box({-1, -1, -1}, {1, 1, 1}), boxes) == Solid_contact{Solid_relation::inside, 1}));
  BOOST_TEST((contact(tetrahedron({0, 0, 0}, {2, 1, 0}, {2, 0, 1}, {2, -1, -1}), boxes) ==
              Solid_contact{Solid_relation::inside, 0}));
  BOOST_TEST((contact(box({0, -1, -1}, {1, 1, 4}), boxes) == Solid_contact{Solid_relation::covered_by, 2}));
  BOOST_TEST((contact(box({-4, -4, -4}, {4, 4, 4}), boxes) == Solid_contact{Solid_relation::equal, 2}));
  // A shell twice, one inside the other and turned, is a cavity.
  const Polyhedron hollow = cube_with_cavity();
  BOOST_TEST((contact(cube(2), hollow) == Solid_contact{Solid_relation::meet, 2}));
  BOOST_TEST((contact(cube(1), hollow) == Solid_contact{Solid_relation::disjoint, -1}));
  BOOST_TEST((contact(hollow, cube(3)) == Solid_contact{Solid_relation::covered_by, 2}));
  BOOST_TEST((contact(hollow, cube(2.5)) == Solid_contact{Solid_relation::overlap, -1}));
}

BOOST_AUTO_TEST_CASE(every_body_is_equal_to_itself_and_all_of_its_volume_is_the_overlap)
{
  scenes::Random random(5);
  for (const auto& [name, body] : closed_bodies()) {
    const Object_case c = object_case(body, Pose(), shuffled(body, random), Pose());
    const Solid_overlap overlap = solid_overlap(c);
    BOOST_TEST((overlap.contact == Solid_contact{Solid_relation::equal, 2}), name);
    const Object_case in_a_room = object_case(body, Pose(), cube(8), Pose());
    const Solid_overlap whole = solid_overlap(in_a_room);
    BOOST_TEST((whole.contact == Solid_contact{Solid_relation::inside, -1}), name);
    BOOST_TEST((whole.volume == overlap.volume && whole.centroid == overlap.centroid), name);
    BOOST_TEST((whole.volume > 0), name);
  }
}

BOOST_AUTO_TEST_CASE(an_open_surface_has_no_solid)
{
  BOOST_CHECK_THROW(contact(without_last_face(cube(1)), cube(1)), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
