#ifndef TETRACONE_EXPERIMENTS_SUPPORT_OUTPUT_FILE_H
#define TETRACONE_EXPERIMENTS_SUPPORT_OUTPUT_FILE_H

#include <filesystem>
#include <string>
#include <vector>

namespace tetracone::experiments {

/// Makes a folder of results if it does not exist. Throws covering::Input_error when it cannot be made. Call it before
/// the work, not after it.
void make_folder(const std::filesystem::path& folder);

/// Writes the whole file under a temporary name beside it, then renames it. A reader sees the old file or the new one,
/// never a part. Links are followed. A device, a FIFO, or the file that standard output already is, is written
/// directly. Throws covering::Input_error, with the system's reason, when it cannot be written; then nothing is left
/// behind.
void write_whole(const std::filesystem::path& file, const std::string& text);

/// Writes the table to the file `csv` by `write_whole`, which may throw, or to standard output if `csv` is empty.
void write_answers(const std::string& csv, const std::string& text);

/// Throws covering::Input_error when `output` is one of the files, under any name. Call it before the work.
void refuse_input(const std::filesystem::path& output, const std::vector<std::filesystem::path>& inputs);

/// True when both names lead to one file, even if that file does not exist yet.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace tetracone::experiments

#endif
