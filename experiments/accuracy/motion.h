#ifndef TETRACONE_EXPERIMENTS_ACCURACY_MOTION_H
#define TETRACONE_EXPERIMENTS_ACCURACY_MOTION_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// How often is each way to decide whether moving primitives meet wrong, and how long does it take? `cases` pairs of
/// each family, judged by the truth of verify/truth; and all queries of `queries`, a folder as Wang et al. (2021) publish
/// them, judged by their own, where it is not empty. Writes OUT/motion.csv, a row a family and subject, and
/// OUT/motion_relations.csv: how often each metamorphic relation held. Of the subject `adaptive` the first times are
/// judged too. Throws covering::Input_error where something cannot be read or written.
void run_motion(const std::filesystem::path& out, const std::filesystem::path& queries, std::uint64_t cases,
                std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
