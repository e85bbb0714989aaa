#ifndef TETRACONE_EXPERIMENTS_REPORT_DRAW_REPORT_H
#define TETRACONE_EXPERIMENTS_REPORT_DRAW_REPORT_H

#include <filesystem>

namespace tetracone::experiments {

/// Draws OUT/report.html with its figures and tables from what is in OUT, by report.py and Debian's matplotlib.
/// Throws std::runtime_error when that fails, or when the folder's name holds a quote.
void draw_report(const std::filesystem::path& out);

}  // namespace tetracone::experiments

#endif
