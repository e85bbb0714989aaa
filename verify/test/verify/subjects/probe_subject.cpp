#include "verify/subjects/probe_subject.h"

#include "verify/families/probe_families.h"
#include "verify/integer_truth/integer_probes.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_probe_subject)

using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(exact_subjects_place_points_right_and_double_does_not)
{
  for (const Point_subject& subject : point_subjects()) {
    const auto ask = subject.make();
    int wrong = 0, asked = 0;
    for (const Probe_family& family : point_families())
      for (std::uint64_t k = 0; k < 32; k += 3, ++asked) {
        const Probe_case c = family.probe_case(5, k);
        const auto place = (*ask)(c);
        BOOST_TEST((place.outcome == Outcome::yes), subject.name);
        wrong += place.answer != integer_truth::Probed_body(*c.body).where(c.from);
      }
    if (subject.is_exact) BOOST_TEST(wrong == 0, subject.name);
    if (subject.name == "double covering") BOOST_TEST(wrong > asked / 50);
  }
}

BOOST_AUTO_TEST_CASE(exact_subjects_meet_faces_right_and_double_does_not)
{
  for (const Ray_subject& subject : ray_subjects()) {
    const auto ask = subject.make();
    int wrong = 0, asked = 0;
    for (const Probe_family& family : ray_families())
      for (std::uint64_t k = 0; k < 32; k += 3, ++asked) {
        const Probe_case c = family.probe_case(11, k);
        const auto told = (*ask)(c);
        const auto& [first, all] = told.answer;
        BOOST_TEST_REQUIRE((told.outcome == Outcome::yes), subject.name);
        std::vector<Ray_hit> expected;
        for (const auto& [t, face] : integer_truth::Probed_body(*c.body).hits(c.from, c.direction))
          expected.push_back({face, tetracone::kernel::nearest_double(t)});
        wrong += all != expected || first.has_value() == expected.empty() || (first && *first != expected[0]);
      }
    BOOST_TEST((wrong == 0) == subject.is_exact, subject.name);
  }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_asked_is_no_answer)
{
  Probe_case c = point_families()[0].probe_case(1, 0);
  c.from[1] = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(((*point_subjects()[0].make())(c).outcome == Outcome::failed));
  BOOST_TEST(((*ray_subjects()[0].make())(c).outcome == Outcome::failed));
}

BOOST_AUTO_TEST_SUITE_END()
