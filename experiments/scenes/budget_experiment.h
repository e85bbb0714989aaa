#ifndef TETRACONE_EXPERIMENTS_SCENES_BUDGET_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SCENES_BUDGET_EXPERIMENT_H

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Measures how much of a frame a budget decides. A thousand wandering bodies of 760 triangles get budgets of 1/32 to 4
/// times the median time of a frame without a budget, which another scene measures. Each frame is asked by itself, and
/// then all frames in a row by one scene, which continues with the pairs that it left undecided. Scenes without a
/// budget judge the decided pairs; the distance judges the bound of the undecided ones. Writes out/budget.csv, one row
/// per budget and way of asking, over all frames except the first. Requires at least two frames.
void run_budget(const std::filesystem::path& out, std::size_t frames, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
