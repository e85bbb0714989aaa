#ifndef TETRACONE_VERIFY_TEST_SUPPORT_DATA_FOLDER_H
#define TETRACONE_VERIFY_TEST_SUPPORT_DATA_FOLDER_H

#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace tetracone::verify::scenes {

/// Returns the folder of real data, which is not part of the project. The environment variable TETRACONE_DATA names it;
/// else it is shared/data beside the project's folder.
inline std::filesystem::path data_folder()
{
  const char* const named = std::getenv("TETRACONE_DATA");
  return named ? std::filesystem::path(named) : std::filesystem::path(TETRACONE_SOURCE_DIR) / ".." / "shared" / "data";
}

/// True, with a message, when the data do not exist.
inline bool without_data()
{
  if (std::filesystem::is_directory(data_folder())) return false;
  std::cout << "SKIPPED: no folder of real data; TETRACONE_DATA names another one\n";
  return true;
}

}  // namespace tetracone::verify::scenes

#endif
