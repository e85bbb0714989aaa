#include "tetracone/covering/io/read_rays.h"

#include "verify/test/support/suite.h"
#include "verify/test/support/temporary_file.h"

BOOST_AUTO_TEST_SUITE(test_read_rays)

using namespace tetracone::covering;
using tetracone::verify::Temporary_file;

namespace {

std::string error_of(const std::string& text) { return tetracone::verify::error_of(text, read_rays); }

}  // namespace

BOOST_AUTO_TEST_CASE(rays_are_six_doubles)
{
  const Temporary_file file("rays.txt", "# one\n0.1 -2 3e-1 0 0 5 # one\n");
  const auto rays = read_rays(file.path());
  BOOST_REQUIRE(rays.size() == 1u);
  BOOST_TEST((rays[0] == std::array<double, 6>{0.1, -2, 0.3, 0, 0, 5}));
}

BOOST_AUTO_TEST_CASE(the_first_thing_wrong_is_named_with_its_line)
{
  BOOST_TEST(error_of("") == ": holds no ray; expected six numbers a line");
  BOOST_TEST(error_of("0 0 0 1 0 0\n0 0\n") == ":2: 2 numbers; expected 6, the origin and the direction of a ray");
  BOOST_TEST(error_of("0 0 1/3 1 0 0\n") == ":1: '1/3' as number 3; expected a finite decimal number");
  BOOST_TEST(error_of("0 0 1 0 -0 0\n") == ":1: the direction is 0; expected a direction of any other length");
}

BOOST_AUTO_TEST_SUITE_END()
