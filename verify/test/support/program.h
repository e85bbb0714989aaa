#ifndef TETRACONE_VERIFY_TEST_SUPPORT_PROGRAM_H
#define TETRACONE_VERIFY_TEST_SUPPORT_PROGRAM_H

#include "verify/test/support/temporary_file.h"

#include <boost/test/unit_test.hpp>

#include <sys/wait.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

/// Runs the program `tetracone` as its users do, in a shell.
namespace tetracone::verify {

inline const std::string program = TETRACONE_PROGRAM, source = TETRACONE_SOURCE_DIR,
                         models = source + "/verify/test/models/", cube = models + "cube.off";

inline std::string contents(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// True when the process has ended within ten seconds. An orphan may be gone or not yet reaped.
inline bool ends_soon(pid_t process)
{
  for (int k = 0; k < 1000; ++k, std::this_thread::sleep_for(std::chrono::milliseconds(10))) {
    std::ifstream status("/proc/" + std::to_string(process) + "/stat");
    std::string number, name, state;
    if (!(status >> number >> name >> state) || state == "Z") return true;
  }
  return false;
}

/// The results of a run of the program.
struct Run {
  int status;
  std::string out, error;
};

inline std::string in_quotes(const std::filesystem::path& path) { return "'" + path.native() + "'"; }

/// Runs commands of the shell. Fails the test if the shell does not exit by itself.
inline Run run_shell(const std::string& commands)
{
  const Temporary_file error("stderr", "");
  std::FILE* const pipe = ::popen(("exec 2>" + in_quotes(error.path()) + "\n" + commands).c_str(), "r");
  BOOST_REQUIRE(pipe);
  Run result;
  char buffer[4096];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) != 0;) result.out.append(buffer, n);
  const int status = ::pclose(pipe);
  BOOST_REQUIRE(WIFEXITED(status));
  result.status = WEXITSTATUS(status);
  result.error = contents(error.path());
  return result;
}

/// Runs the program with these words, in the shell's quoting. Fails the test if the program does not exit by itself.
inline Run run(const std::string& words) { return run_shell(in_quotes(program) + " " + words); }

/// Runs the program, and checks for status 2, an empty standard output, and one line on standard error with `says`.
inline void check_refused(const std::string& words, const std::string& says = "")
{
  const Run r = run(words);
  BOOST_TEST(r.status == 2, words);
  BOOST_TEST(r.out.empty(), words);
  BOOST_TEST(r.error.find('\n') + 1 == r.error.size(), words << ": " << r.error);
  BOOST_TEST(r.error.size() > 10, words);
  BOOST_TEST(contains(r.error, says), words << ": " << r.error);
}

}  // namespace tetracone::verify

#endif
