#include "experiments/queries/touching.h"

#include "experiments/peers/peer.h"
#include "verify/test/support/csv_rows.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <set>
#include <string>

BOOST_AUTO_TEST_SUITE(test_touching)

using namespace tetracone;

BOOST_AUTO_TEST_CASE(every_kind_has_its_relation_and_what_is_exact_says_that_touching_bodies_collide)
{
  const verify::Temporary_file file("touching.csv", experiments::touching_csv(4, 7));
  const auto rows = verify::csv_rows(file.path());
  std::set<std::string> kinds, peers;
  for (const auto& row : rows) {
    kinds.insert(row.at("kind") + ": " + row.at("relation"));
    peers.insert(row.at("peer"));
    BOOST_TEST(row.at("wrong_relations") == "0");
    BOOST_TEST(row.at("asked") == "4");
    if (row.at("peer") == "CGAL RMCD EPECK") BOOST_TEST(row.at("collide") == "4", row.at("kind"));
    // Trees of surfaces have no solids.
    if (row.at("kind") == "inside" && row.at("peer").starts_with("FCL")) BOOST_TEST(row.at("collide") == "0");
  }
  BOOST_TEST((kinds == std::set<std::string>{"faces touch: meet", "edges touch: meet", "corners touch: meet",
                                             "aligned overlap: overlap", "half overlap: overlap", "equal: equal",
                                             "inside: contains"}));
  BOOST_TEST(peers.size() == experiments::peers().size());
  BOOST_TEST(rows.size() == 2 * kinds.size() * peers.size());
}

BOOST_AUTO_TEST_SUITE_END()
