#ifndef TETRACONE_EXPERIMENTS_SUPPORT_RESUMABLE_CSV_H
#define TETRACONE_EXPERIMENTS_SUPPORT_RESUMABLE_CSV_H

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// Some rows of a table, made on demand.
struct Table_part {
  std::string name;                   ///< a file name
  std::function<std::string()> make;  ///< a CSV with its header
};

/// Writes out/NAME.csv from its parts in order. Each part is saved in a folder under out/NAME/ as soon as it is made,
/// and is not made again. The folder's name encodes the version and the command line `again()`; the same command line
/// therefore resumes the run. Progress goes to stderr on a terminal. Requires parts of different names and of one
/// header. Throws covering::Input_error when `out` cannot be written.
void write_table(const std::filesystem::path& out, const std::string& name, const std::vector<Table_part>& parts);

}  // namespace tetracone::experiments

#endif
