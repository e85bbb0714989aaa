#ifndef TETRACONE_EXPERIMENTS_SUPPORT_DRAW_H
#define TETRACONE_EXPERIMENTS_SUPPORT_DRAW_H

#include <filesystem>
#include <string>

namespace tetracone::experiments {

/// Draws the tables in the folder `out`. It runs experiments/report/SCRIPT OUT, with Debian's Python and matplotlib.
/// The script is that of the sources or, where they are gone, the one installed with the program. Its summary goes to
/// our standard output, and its warnings to stderr. Throws covering::Input_error when there is no such script, and
/// std::runtime_error with the last line of the script's errors when it fails. Throws std::runtime_error for a folder
/// with a quote in its name, too.
void draw(const std::string& script, const std::filesystem::path& out);

}  // namespace tetracone::experiments

#endif
