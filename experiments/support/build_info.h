#ifndef TETRACONE_EXPERIMENTS_SUPPORT_BUILD_INFO_H
#define TETRACONE_EXPERIMENTS_SUPPORT_BUILD_INFO_H

#include <algorithm>
#include <fstream>
#include <string>

namespace tetracone::experiments {

/// Returns the text as a field of a CSV, with semicolons for commas and without double quotes.
inline std::string field(std::string text)
{
  std::replace(text.begin(), text.end(), ',', ';');
  std::erase(text, '"');
  return text;
}

/// Returns the name and version of the compiler that the program was built with.
inline std::string compiler()
{
#ifdef __clang__
  return field("clang " __clang_version__);
#else
  return field("g++ " __VERSION__);
#endif
}

/// The flags that the program was built with.
inline std::string compiler_flags() { return field(TETRACONE_FLAGS); }

/// Returns the processor's name, or "unknown" if the system does not give it.
inline const std::string& processor()
{
  static const std::string name = [] {
    std::ifstream cpuinfo("/proc/cpuinfo");
    for (std::string line; std::getline(cpuinfo, line);) {
      if (line.starts_with("model name")) return field(line.substr(std::min(line.size(), line.find(':') + 2)));
    }
    return std::string("unknown");
  }();
  return name;
}

/// The command line that makes this process's rows again, from the project's folder: `build/tetracone experiment NAME`,
/// with all sizes. The command sets it before its first row.
inline std::string& again()
{
  static std::string words;
  return words;
}

}  // namespace tetracone::experiments

#endif
