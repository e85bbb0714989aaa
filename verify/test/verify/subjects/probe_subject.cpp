#include "verify/subjects/probe_subject.h"

#include "verify/families/probe_families.h"

#include <boost/test/unit_test.hpp>

#include <limits>

BOOST_AUTO_TEST_SUITE(test_probe_subject)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(what_cannot_be_asked_is_no_answer)
{
  Probe_case c = point_families()[0].probe_case(1, 0);
  c.from[1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(((*point_subjects()[0].make())(c).outcome == Outcome::failed));
  BOOST_TEST(((*ray_subjects()[0].make())(c).outcome == Outcome::failed));
}

BOOST_AUTO_TEST_SUITE_END()
