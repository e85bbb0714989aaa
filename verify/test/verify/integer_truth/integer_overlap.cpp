#include "verify/integer_truth/integer_overlap.h"

#include "verify/families/families.h"
#include "verify/test/support/object_cases.h"
#include "verify/truth/overlap_truth.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_integer_overlap)

using namespace tetracone::verify;
using namespace tetracone::verify::scenes;
using integer_truth::agrees;
using integer_truth::Volumes;
using tetracone::kernel::Rational;
using tetracone::kernel::Solid_relation;

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
