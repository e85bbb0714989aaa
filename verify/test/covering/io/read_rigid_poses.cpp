#include "tetracone/covering/io/read_rigid_poses.h"

#include "verify/test/support/suite.h"
#include "verify/test/support/temporary_file.h"

BOOST_AUTO_TEST_SUITE(test_read_rigid_poses)

using tetracone::covering::read_rigid_poses;
using tetracone::verify::Temporary_file;

std::string error_of(const std::string& text) { return tetracone::verify::error_of(text, read_rigid_poses); }

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

BOOST_AUTO_TEST_CASE(matrices_that_are_rotations_are_read_as_quaternions)
{
  const Temporary_file file("rigid",
                            "3/5 -4/5 0 1/7  4/5 3/5 0 2  0 0 1 3\n"
                            "0.6,-0.8,0,0, 0.8,0.6,0,0, 0,0,1,0, 0,0,0,1\n"
                            "1 0 0 5\n0 -1 0 6\n0 0 -1 7\n0 0 0 1\n1 0 0 0 0 0 0\n");
  const auto poses = read_rigid_poses(file.path());
  BOOST_REQUIRE(poses.size() == 4u);
  const auto& q = poses[0].pose.quaternion;
  BOOST_TEST((q[0] == 2 * q[3] && q[1] == 0 && q[2] == 0));
  BOOST_TEST(poses[0].matrix_error.value() == 0);
  BOOST_TEST(poses[0].pose.translation[0] == tetracone::kernel::Rational(1) / 7);
  // 0.6 and 0.8 are no sides of a right triangle as doubles.
  BOOST_TEST(poses[1].matrix_error.value() > 0);
  BOOST_TEST(poses[1].matrix_error.value() < 1e-15);
  BOOST_TEST(poses[2].line == 3u);
  BOOST_TEST(poses[2].pose.quaternion[1] == 1);
  BOOST_TEST(!poses[3].matrix_error);
}

BOOST_AUTO_TEST_CASE(what_is_none_is_refused_with_its_line)
{
  BOOST_TEST(error_of("1 0 0 0 0 0 0\n1 0 0 0 1\n").find(":2: 5 numbers; expected 7") != std::string::npos);
  for (const char* no_rotation :
       {"2 0 0 0 0 2 0 0 0 0 2 0\n", "1 0 0 0 0 1 0 0 0 0 -1 0\n", "1 1e-3 0 0 0 1 0 0 0 0 1 0\n"})
    BOOST_TEST(error_of(no_rotation).find(":1: the 3x3 part is no rotation; expected one to 1e-5") !=
               std::string::npos);
  BOOST_TEST(error_of("0 0 0 0 1 2 3\n").find(":1: the quaternion is 0") != std::string::npos);
  BOOST_TEST(error_of("1 0 0 nan 1 2 3\n").find(":1: 'nan' as number 4") != std::string::npos);
  BOOST_TEST(error_of("# nothing\n").find("holds no pose") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
