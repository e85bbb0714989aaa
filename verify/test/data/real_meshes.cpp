// The meshes that `experiments/support/fetch_models.sh` brings, in place of the paper's.

#include "tetracone/covering/check.h"
#include "verify/cases/shape_generators.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>

BOOST_AUTO_TEST_SUITE(test_real_meshes)

using namespace tetracone;
using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(real_meshes_have_the_papers_counts)
{
  const std::filesystem::path models = std::filesystem::path(TETRACONE_SOURCE_DIR) / ".cache" / "models";
  const auto small = small_mesh(models), large = large_mesh(models);
  if (!small || !large) {
    std::cout << "SKIPPED: no models; experiments/support/fetch_models.sh brings them\n";
    return;
  }
  BOOST_TEST(small->face_count() == 760u);
  BOOST_TEST(small->vertices.size() == 382u);
  BOOST_TEST(large->face_count() == 7172u);
  for (const auto& mesh : {*small, *large}) {
    const covering::Check check = covering::check(mesh);
    BOOST_TEST(check.closed);
    BOOST_TEST(check.degenerate_faces.empty());
    BOOST_TEST((check.orientation == covering::Orientation::outward));
    BOOST_TEST_REQUIRE(check.shells.size() == 1u);
    BOOST_TEST_REQUIRE(check.shells[0].genus.has_value());
    BOOST_TEST(*check.shells[0].genus == 0u);
    BOOST_TEST(std::abs(radius(mesh) - 1) < 1e-14);
  }
}

BOOST_AUTO_TEST_SUITE_END()
