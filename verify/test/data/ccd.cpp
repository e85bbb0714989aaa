// Published queries with their ground truth (not part of the project), of Wang et al. 2021: every answer.

#include "tetracone/covering/io/read_moving_pairs.h"
#include "tetracone/kernel/motion/first_contact.h"
#include "verify/test/support/data_folder.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>

BOOST_AUTO_TEST_SUITE(test_ccd)

using namespace tetracone::verify::scenes;
using namespace tetracone;

BOOST_AUTO_TEST_CASE(every_published_query_is_answered_as_its_ground_truth)
{
  if (without_data()) return;
  int invented = 0, missed = 0, contacts = 0, queries = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data_folder() / "ccd")) {
    if (entry.path().extension() != ".csv") continue;
    const auto kind = covering::moving_kind_of(entry.path());
    BOOST_REQUIRE(kind.has_value());
    for (const covering::Moving_query& query : covering::read_moving_pairs(entry.path(), *kind)) {
      BOOST_REQUIRE(query.truth.has_value());
      const bool meets = kernel::meet_in_motion(query.pair);
      invented += meets && !*query.truth;
      missed += !meets && *query.truth;
      contacts += *query.truth;
      ++queries;
      BOOST_TEST(kernel::first_contact_time(query.pair).has_value() == meets);
    }
  }
  BOOST_TEST(queries >= 2679);
  BOOST_TEST(contacts >= 210);
  BOOST_TEST(invented == 0);
  BOOST_TEST(missed == 0);
}

BOOST_AUTO_TEST_SUITE_END()
