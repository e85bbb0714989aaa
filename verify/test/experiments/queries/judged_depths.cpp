#include "experiments/queries/judged_depths.h"

#include "experiments/peers/depth_peer.h"
#include "verify/cases/shape_generators.h"
#include "verify/test/support/csv_rows.h"
#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>

BOOST_AUTO_TEST_SUITE(test_judged_depths)

using namespace tetracone;
using experiments::depth_peers;

BOOST_AUTO_TEST_CASE(answers_are_counted_once_each_and_some_library_is_right_about_boxes)
{
  const verify::Temporary_file file("depths.csv", experiments::judged_depths(6, 7));
  const auto rows = verify::csv_rows(file.path());
  BOOST_TEST(rows.size() == 3 * depth_peers().size());
  bool some_is_right = depth_peers().empty();
  for (const auto& row : rows) {
    const auto count = [&row](const std::string& name) { return std::stoi(row.at(name)); };
    const int above_zero = 6 - count("apart") - count("failed") - count("infinite") - count("negative");
    BOOST_TEST(count("pairs") == 6);
    BOOST_TEST(count("off_hundredth") <= count("off_millionth"));
    BOOST_TEST(count("off_millionth") <= above_zero);
    BOOST_TEST(row.at("mean_off").empty() == (above_zero == 0));
    some_is_right =
        some_is_right || (row.at("shape") == "boxes; turned" && above_zero == 6 && count("off_hundredth") == 0);
  }
  BOOST_TEST(some_is_right);
}

BOOST_AUTO_TEST_CASE(every_library_says_how_deep_clear_overlaps_are_and_that_others_are_apart)
{
  const auto mesh = experiments::peer_mesh(verify::unit_cube());
  for (const experiments::Named_depth_peer& each : depth_peers()) {
    const auto peer = each.make(*mesh, *mesh);
    const auto overlap = peer->depth(kernel::Pose(), kernel::Pose::translation(0.75, 0.125, 0.0625));
    BOOST_TEST_REQUIRE(overlap.has_value(), each.name);
    // FCL's own solver tells it with the other sign.
    BOOST_TEST(std::abs(*overlap) > 0.1, each.name << ": " << *overlap);
    BOOST_TEST(std::abs(*overlap) < 0.5, each.name << ": " << *overlap);
    BOOST_TEST(!peer->depth(kernel::Pose(), kernel::Pose::translation(3, 0.5, 0.25)).has_value(), each.name);
  }
}

BOOST_AUTO_TEST_SUITE_END()
