#ifndef TETRACONE_EXPERIMENTS_SUPPORT_DRAW_H
#define TETRACONE_EXPERIMENTS_SUPPORT_DRAW_H

#include <filesystem>
#include <string>

namespace tetracone::experiments {

/// Draws what is in the folder: runs experiments/report/SCRIPT OUT, of the sources or, where they are gone, as installed
/// with the program, by Debian's Python with matplotlib; the script prints its summary. Throws covering::Input_error when there is no such script, and std::runtime_error, with the
/// script's last word on it, when it fails.
void draw(const std::string& script, const std::filesystem::path& out);

}  // namespace tetracone::experiments

#endif
