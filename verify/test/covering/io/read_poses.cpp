#include "tetracone/covering/io/read_poses.h"

#include "verify/test/support/suite.h"
#include "verify/test/support/temporary_file.h"

BOOST_AUTO_TEST_SUITE(test_read_poses)

using namespace tetracone::kernel;
using namespace tetracone::covering;
using tetracone::verify::Temporary_file;

const std::string identity = "1 0 0 0  0 1 0 0  0 0 1 0\n";

std::vector<Pose> poses_of(const std::string& text)
{
  const Temporary_file file("poses.txt", text);
  return read_poses(file.path());
}

std::string error_of(const std::string& text) { return tetracone::verify::error_of(text, read_poses); }

BOOST_AUTO_TEST_CASE(the_sample_file_holds_three_poses)
{
  const auto poses = read_poses(std::string(TETRACONE_SOURCE_DIR) + "/verify/test/models/poses.txt");
  BOOST_REQUIRE(poses.size() == 3u);
  BOOST_TEST(poses[0].is_identity());
  BOOST_TEST((poses[1] == Pose(std::array<double, 12>{0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0})));
  BOOST_TEST(poses[2].is_rational());
  BOOST_TEST((poses[2].exact(0) == Rational(3) / 5));
  BOOST_TEST((poses[2].exact(3) == Rational(1) / 3));
  BOOST_TEST((poses[2].exact(11) == Rational(-5) / 2));
}

BOOST_AUTO_TEST_CASE(comments_are_skipped_and_decimals_stand_for_their_nearest_doubles_beside_fractions)
{
  BOOST_TEST(poses_of("# one\n\n  \t\r\n1 0 0 0 0 1 0 0 0 0 1 0# trailing\r\n" + identity + "1 0 0 0 0 1 0 0 0 0 1 5")
                 .size() == 3u);
  const auto poses = poses_of("1/3 0 0 0.1  0 1 0 0  0 0 1 0\n");
  BOOST_TEST((poses[0].exact(3) == Rational(0.1)));
  BOOST_TEST((poses[0].exact(0) == Rational(1) / 3));
}

BOOST_AUTO_TEST_CASE(a_matrix_of_four_rows_stands_on_one_line_or_on_four)
{
  const std::string rows = "0 -1 0 1/3\n1 0 0 2  # y\n\n0,0,1,0.5\n0 0 0 1\n";
  const auto poses = poses_of("0 -1 0 1/3  1 0 0 2  0 0 1 0.5  0 0 0 1\n" + rows + identity + rows);
  BOOST_REQUIRE(poses.size() == 4u);
  const auto expected = poses_of("0 -1 0 1/3 1 0 0 2 0 0 1 0.5\n")[0];
  for (const int k : {0, 1, 3}) BOOST_TEST((poses[k] == expected), k);
  BOOST_TEST(poses[2].is_identity());
  const std::string last = " the last row of a 4x4 matrix is another; expected 0 0 0 1";
  BOOST_TEST(error_of(identity + "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2\n") == ":2:" + last);
  BOOST_TEST(error_of("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 1/9 0 1\n") == ":4:" + last);
  BOOST_TEST(error_of("1 0 0 0\n0 1 0 0\n0 0 1 0\n" + identity) == ":4: 12 numbers; expected 4, row 4 of a 4x4 matrix");
  BOOST_TEST(error_of("1 0 0 0\n0 1 0 0\n") == ":2: the file ends here; expected row 3 of a 4x4 matrix");
  BOOST_TEST(error_of("1 0 0 0\n0 1 0 0\n0 x 1 0\n").starts_with(":3: 'x' as number 2"));
}

BOOST_AUTO_TEST_CASE(the_first_thing_wrong_is_named_with_its_line)
{
  BOOST_TEST(error_of("") == ": holds no pose; expected twelve numbers a line");
  BOOST_TEST(error_of("# nothing\n\n") == ": holds no pose; expected twelve numbers a line");
  BOOST_TEST(error_of(identity + "1 2 3\n") == ":2: 3 numbers; expected 12 or 16, the rows of a 3x4 or 4x4 matrix");
  BOOST_TEST(error_of("#\n1 0 0 0 0 1 0 0 0 0 1 0 0\n") ==
             ":2: 13 numbers; expected 12 or 16, the rows of a 3x4 or 4x4 matrix");
  BOOST_TEST(error_of("1 0 0 0 0 x 0 0 0 0 1 0\n") ==
             ":1: 'x' as number 6; expected a finite decimal number or a fraction n/d");
  for (const std::string& word : std::vector<std::string>{"nan", "inf", "-inf", "1e400", "1/0", "1.5/2", "0x1",
                                                          "1" + std::string(400, '0') + "/1"})
    BOOST_TEST(error_of("1 0 0 " + word + " 0 1 0 0 0 0 1 0\n").starts_with(":1: '"), word);
}

BOOST_AUTO_TEST_CASE(a_flat_matrix_is_refused_exactly)
{
  const std::string flat = ": the 3x3 part has determinant 0; expected a matrix that flattens nothing";
  BOOST_TEST(error_of("1 2 3 0 2 4 6 0 0 0 1 0\n") == ":1" + flat);
  BOOST_TEST(error_of("0 0 0 0 0 0 0 0 0 0 0 0\n") == ":1" + flat);
  BOOST_TEST(error_of(identity + "1/3 1 0 0  1 3 0 0  0 0 1 0\n") == ":2" + flat);
  // As doubles 1/3 * 3 is not 1: far from flat in exact arithmetic, though the rounded determinant is 0.
  BOOST_TEST(error_of("0.3333333333333333 1 0 0  1 3 0 0  0 0 1 0\n") == "no error");
  // Determinants that underflow are not 0.
  BOOST_TEST(error_of("1e-200 0 0 0  0 1e-200 0 0  0 0 1e-200 0\n") == "no error");
  BOOST_TEST(error_of("5e-324 0 0 0  0 5e-324 0 0  0 0 5e-324 0\n") == "no error");
  BOOST_TEST(error_of("1e300 0 0 0  0 1e300 0 0  0 0 1e300 0\n") == "no error");
  BOOST_TEST(error_of("1e300 1e300 0 0  1e300 1e300 0 0  0 0 1 0\n") == ":1" + flat);
}

BOOST_AUTO_TEST_CASE(what_is_no_file_is_refused_in_one_line)
{
  BOOST_CHECK_THROW(read_poses("no/such/file"), Input_error);
  BOOST_CHECK_THROW(read_poses(TETRACONE_SOURCE_DIR), Input_error);
  const std::string message =
      Input_error("a\nb", 3, in_quotes(std::string("\x01\xff") + std::string(100, 'y')), "expected z").what();
  BOOST_TEST(message == "a?b:3: '??" + std::string(38, 'y') + "...'; expected z");
}

BOOST_AUTO_TEST_SUITE_END()
