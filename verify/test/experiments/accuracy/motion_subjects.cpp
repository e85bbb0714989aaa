#include "experiments/accuracy/motion_subjects.h"

#include "verify/families/motion_families.h"
#include "verify/truth/motion_truth.h"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <map>
#include <string>

BOOST_AUTO_TEST_SUITE(test_motion_subjects)

using namespace tetracone::experiments;
using namespace tetracone::verify;
using tetracone::kernel::Moving_kind;
using tetracone::kernel::Moving_pair;

BOOST_AUTO_TEST_CASE(every_subject_knows_clear_contact_and_clear_misses)
{
  const auto falling = [](double x) {
    return Moving_pair{
        Moving_kind::vertex_face,
        {{{{x, 0.25, 1}, {x, 0.25, -2}}, {{0, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {0, 1, 0}}}}};
  };
  const auto crossing = [](double x) {
    return Moving_pair{
        Moving_kind::edge_edge,
        {{{{x, -1, 1}, {x, -1, -2}}, {{x, 1, 1}, {x, 1, -2}}, {{-1, 0, 0}, {-1, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}}}};
  };
  for (const Motion_subject& subject : motion_subjects()) {
    BOOST_TEST(subject.meet(falling(0.25)), std::string(subject.name));
    BOOST_TEST(!subject.meet(falling(1.25)), std::string(subject.name));
    BOOST_TEST(subject.meet(crossing(0.25)), std::string(subject.name));
    BOOST_TEST(!subject.meet(crossing(1.25)), std::string(subject.name));
  }
}

BOOST_AUTO_TEST_CASE(each_method_errs_as_it_must)
{
  std::map<std::string, int> invented, missed;
  for (const std::string family : {"anywhere", "grazing", "coplanar"})
    for (const Motion_family& f : motion_families()) {
      if (f.name != family) continue;
      for (std::uint64_t k = 0; k < 60; ++k) {
        const Moving_pair pair = motion_case(f, 5, k);
        const bool truth = truly_meet_in_motion(pair);
        for (const Motion_subject& subject : motion_subjects()) {
          const bool answer = subject.meet(pair);
          const std::string where = family + " " + std::string(subject.name);
          invented[where] += answer && !truth;
          missed[where] += !answer && truth;
        }
      }
    }
  for (const std::string family : {"anywhere", "grazing", "coplanar"}) {
    BOOST_TEST(invented[family + " adaptive"] + missed[family + " adaptive"] == 0);
    BOOST_TEST(missed[family + " inclusion"] == 0);  // conservative
  }
  for (const std::string subject : {"double", "tolerance", "root-parity", "inclusion"})
    BOOST_TEST(missed["anywhere " + subject] + invented["anywhere " + subject] <= 1, subject);
  // Two crossings cancel; a volume that is zero all the time has no roots.
  BOOST_TEST(missed["grazing root-parity"] > 0);
  BOOST_TEST(missed["coplanar double"] > 0);
}

BOOST_AUTO_TEST_SUITE_END()
