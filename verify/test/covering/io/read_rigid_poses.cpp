#include "tetracone/covering/io/read_rigid_poses.h"

#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_read_rigid_poses)

using tetracone::covering::Input_error;
using tetracone::covering::read_rigid_poses;
using tetracone::verify::Temporary_file;

namespace {

std::string error_of(const std::string& text)
{
  const Temporary_file file("rigid", text);
  try {
    read_rigid_poses(file.path());
  } catch (const Input_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

BOOST_AUTO_TEST_CASE(quaternions_and_translations_are_read_exactly_with_their_lines)
{
  const Temporary_file file("rigid", "# w x y z and a translation\n1 0 0 0 0 0 0\n\n2/3 -1 0.1 0 1/7 2 -3e-2\n");
  const auto poses = read_rigid_poses(file.path());
  BOOST_REQUIRE(poses.size() == 2u);
  BOOST_TEST(poses[0].line == 2u);
  BOOST_TEST(poses[1].line == 4u);
  BOOST_TEST(poses[1].pose.quaternion[0] == tetracone::kernel::Rational(2) / 3);
  BOOST_TEST(poses[1].pose.quaternion[2] == tetracone::kernel::Rational(0.1));
  BOOST_TEST(poses[1].pose.translation[0] == tetracone::kernel::Rational(1) / 7);
  BOOST_TEST(poses[1].pose.translation[2] == tetracone::kernel::Rational(-0.03));
}

BOOST_AUTO_TEST_CASE(what_is_none_is_refused_with_its_line)
{
  BOOST_TEST(error_of("1 0 0 0 0 0 0\n1 0 0 0\n").find(":2: 4 numbers; expected 7") != std::string::npos);
  BOOST_TEST(error_of("0 0 0 0 1 2 3\n").find(":1: the quaternion is 0") != std::string::npos);
  BOOST_TEST(error_of("1 0 0 nan 1 2 3\n").find(":1: 'nan' as number 4") != std::string::npos);
  BOOST_TEST(error_of("# nothing\n").find("holds no pose") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
