#ifndef TETRACONE_EXPERIMENTS_SUPPORT_OUTPUT_FILE_H
#define TETRACONE_EXPERIMENTS_SUPPORT_OUTPUT_FILE_H

#include "tetracone/covering/io/input_error.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace tetracone::experiments {

/// Makes a folder of results, where it is not there yet. Throws covering::Input_error when it cannot be made: before the work, not after it.
inline void make_folder(const std::filesystem::path& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) throw covering::Input_error(folder.native(), 0, "cannot be made", "expected a folder that may be written");
}

/// Writes the whole file under a temporary name beside it, then renames: a reader sees the old file or the new one, never a
/// part. Throws covering::Input_error when it cannot be written; then nothing is left behind.
inline void write_whole(const std::filesystem::path& file, const std::string& text)
{
  const std::filesystem::path temporary = file.native() + ".part" + std::to_string(getpid());
  bool done = false;
  {
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    done = !out.fail();
  }
  std::error_code error;
  if (done) std::filesystem::rename(temporary, file, error);
  if (!done || error) {
    std::filesystem::remove(temporary, error);
    throw covering::Input_error(file.native(), 0, "cannot be written", "expected a file in a folder that may be written");
  }
}

}  // namespace tetracone::experiments

#endif
