#include "tetracone/covering/io/file_bytes.h"

#include "tetracone/covering/io/read.h"
#include "verify/test/support/suite.h"
#include "verify/test/support/temporary_file.h"

#include <sys/stat.h>
#include <fstream>

BOOST_AUTO_TEST_SUITE(test_file_bytes)

using namespace tetracone::covering;
using namespace tetracone::verify;

BOOST_AUTO_TEST_CASE(a_file_a_pipe_and_a_file_of_no_size_are_read_alike)
{
  const std::string triangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const Temporary_file file("triangle.off", triangle), empty("empty.off", "");
  BOOST_TEST(File_bytes(file.path()).bytes() == triangle);
  BOOST_TEST(File_bytes(empty.path()).bytes().empty());
  // Its size is told as 0.
  BOOST_TEST(File_bytes("/proc/self/status").bytes().starts_with("Name:"));

  const auto pipe = temporary_path("pipe.off");
  BOOST_TEST_REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::thread writer([&] { std::ofstream(pipe) << triangle; });
  BOOST_TEST(read(pipe).face_count() == 1);
  writer.join();
  std::filesystem::remove(pipe);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_read_is_said)
{
  BOOST_CHECK_THROW(File_bytes("/dev/null"), Input_error);
  BOOST_CHECK_THROW(File_bytes("/tmp"), Input_error);
  BOOST_CHECK_THROW(File_bytes(temporary_path("missing.off")), Input_error);
}

BOOST_AUTO_TEST_SUITE_END()
