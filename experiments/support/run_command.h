#ifndef TETRACONE_EXPERIMENTS_SUPPORT_RUN_COMMAND_H
#define TETRACONE_EXPERIMENTS_SUPPORT_RUN_COMMAND_H

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace tetracone::experiments {

/// What a command of the shell printed, and how it ended: 0 for a success, as `pclose` tells it.
struct Ran {
  int status;
  std::string out;
};

/// Runs a command in a shell, and keeps its standard output. Throws std::system_error when no shell can be started.
inline Ran run_command(const std::string& command)
{
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (!pipe) throw std::system_error(errno, std::generic_category(), "no shell can be started");
  Ran ran{0, ""};
  char buffer[4096];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) != 0;) ran.out.append(buffer, n);
  ran.status = ::pclose(pipe);
  return ran;
}

}  // namespace tetracone::experiments

#endif
