#include "verify/integer_truth/integer_overlap.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_integer_overlap)

using namespace tetracone::verify;
using integer_truth::agrees;
using integer_truth::Volumes;
using tetracone::kernel::Rational;
using tetracone::kernel::Solid_relation;

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
