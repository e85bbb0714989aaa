#ifndef TETRACONE_EXPERIMENTS_ACCURACY_MOTION_H
#define TETRACONE_EXPERIMENTS_ACCURACY_MOTION_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Measures how often each method of deciding whether moving primitives meet is wrong, and how long it takes. It asks
/// `cases` pairs of each family, judged by the truth of verify/truth. It also asks all queries in `queries`, a folder
/// in the form of Wang et al. (2021), judged by their own truth, unless `queries` is empty. The first times of the
/// subject `adaptive` are judged too. Writes OUT/motion.csv, one row per family and subject, and
/// OUT/motion_relations.csv: how often each metamorphic relation held. Throws covering::Input_error when a file cannot
/// be read or written.
void run_motion(const std::filesystem::path& out, const std::filesystem::path& queries, std::uint64_t cases,
                std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
