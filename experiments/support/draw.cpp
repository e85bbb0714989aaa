#include "experiments/support/draw.h"

#include "experiments/support/run_command.h"
#include "tetracone/covering/io/input_error.h"

#include <unistd.h>

#include <iostream>
#include <stdexcept>

namespace tetracone::experiments {
namespace {

/// Runs the command with our standard output; its errors are kept.
Ran run(const std::string& command)
{
  std::cout.flush();
  const int output = ::dup(STDOUT_FILENO);
  const Ran ran = run_command(command + " 2>&1 >&" + std::to_string(output));
  ::close(output);
  return ran;
}

std::string last_line(std::string text)
{
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

/// Returns the path of the script: among the sources that the program was built from, else as installed with the
/// program.
std::filesystem::path script_path(const std::string& script)
{
  namespace fs = std::filesystem;
  const fs::path built = fs::path(TETRACONE_SOURCE_DIR "/experiments/report") / script;
  std::error_code none;
  const fs::path prefix = fs::read_symlink("/proc/self/exe", none).parent_path().parent_path();
  const fs::path installed = prefix / "share/tetracone/experiments/report" / script;
  return !fs::exists(built, none) && fs::exists(installed, none) ? installed : built;
}

}  // namespace

void draw(const std::string& script, const std::filesystem::path& out)
{
  if (out.native().find('\'') != std::string::npos)
    throw std::runtime_error("the folder's name holds a quote; expected one without");
  const std::filesystem::path path = script_path(script);
  if (!std::filesystem::exists(path))
    throw covering::Input_error(path.native(), 0, "no such file",
                                "expected it among the sources that this program was built from, or installed with it");
  const Ran ran = run("'" TETRACONE_PYTHON "' '" + path.native() + "' '" + out.native() + "'");
  if (ran.status == 0) {
    std::cerr << ran.out;
    return;
  }
  // A script reports its own errors in our form; Python's own error is the last line, after its trace.
  const std::string last = last_line(ran.out);
  if (last.find("; expected") != std::string::npos) throw std::runtime_error(last);
  throw std::runtime_error(script + " failed: " + (last.empty() ? "status " + std::to_string(ran.status) : last) +
                           "; expected python3 with matplotlib, and enough memory");
}

}  // namespace tetracone::experiments
