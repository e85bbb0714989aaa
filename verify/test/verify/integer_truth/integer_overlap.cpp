#include "verify/integer_truth/integer_overlap.h"

#include "verify/families/families.h"
#include "verify/test/support/object_cases.h"
#include "verify/truth/overlap_truth.h"

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_integer_overlap)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using integer_truth::agrees;
using integer_truth::Volumes;
using tetracone::kernel::Rational;
using tetracone::kernel::Solid_relation;

namespace {

Volumes volumes(const Polyhedron& a, const Polyhedron& b, const Pose& pose_b = Pose())
{
  return integer_truth::volumes(object_case(a, Pose(), b, pose_b));
}

}  // namespace

BOOST_AUTO_TEST_CASE(volumes_of_boxes_and_of_shells_with_any_winding_are_known)
{
  const Volumes corner = volumes(cube(2), cube(2), translation(1, 2, 3));
  BOOST_TEST((corner.both == 3 * 2 && corner.only_a == 64 - 6 && corner.only_b == 64 - 6));
  const Volumes hollow = volumes(cube_with_cavity(), turned(cube(2)));
  BOOST_TEST((hollow.both == 0 && hollow.only_a == 6 * 36 - 64 && hollow.only_b == 64));
  Polyhedron twice = cube(1);
  append(twice, cube(1));
  const Volumes same = volumes(twice, cube(1));
  BOOST_TEST((same.both == 8 && same.only_a == 0 && same.only_b == 0));
  const Volumes corners =
      volumes(tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), cube(1), translation(-1, -1, -1));
  BOOST_TEST((corners.both == 0 && corners.only_a == Rational(1, 6) && corners.only_b == 8));
}

BOOST_AUTO_TEST_CASE(the_two_truths_agree_on_small_bodies_of_every_kind)
{
  int overlaps = 0, tried = 0;
  for (const char* name : {"lego", "random", "shear", "duplicates", "degenerate-face", "sliver", "nested-touching",
                           "face-on-face", "covering-apex", "true-rotation"})
    for (std::uint64_t k = 0; k < 24; ++k) {
      const Object_case c = find_family(name)->object_case(4, k);
      if (c.a->face_count() > 8 || c.b->face_count() > 8) continue;
      const Solid_overlap overlap = solid_overlap(c);
      BOOST_TEST(agrees(integer_truth::volumes(c), overlap), name << ' ' << k);
      overlaps += overlap.volume > 0;
      ++tried;
    }
  BOOST_TEST(tried > 60);
  BOOST_TEST(overlaps > 20);
}

BOOST_AUTO_TEST_CASE(what_contradicts_the_volumes_is_noticed)
{
  const auto says = [](Solid_relation relation, int both) {
    return Solid_overlap{{relation, 2}, Rational(both), {0, 0, 0}};
  };
  const Volumes part{3, 0, 2}, halves{3, 2, 2}, apart{0, 2, 2}, all{3, 0, 0};
  BOOST_TEST(agrees(part, says(Solid_relation::covered_by, 3)));
  BOOST_TEST(!agrees(part, says(Solid_relation::covered_by, 2)));
  for (const Solid_relation relation : {Solid_relation::covers, Solid_relation::contains, Solid_relation::equal})
    BOOST_TEST(!agrees(part, says(relation, 3)));
  BOOST_TEST(agrees(halves, says(Solid_relation::overlap, 3)));
  for (const Solid_relation relation : {Solid_relation::inside, Solid_relation::covered_by, Solid_relation::covers,
                                        Solid_relation::disjoint, Solid_relation::meet, Solid_relation::equal})
    BOOST_TEST(!agrees(halves, says(relation, 3)));
  BOOST_TEST(agrees(apart, says(Solid_relation::meet, 0)));
  BOOST_TEST(!agrees(apart, says(Solid_relation::overlap, 0)));
  BOOST_TEST(agrees(all, says(Solid_relation::equal, 3)));
}

BOOST_AUTO_TEST_SUITE_END()
