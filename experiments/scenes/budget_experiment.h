#ifndef TETRACONE_EXPERIMENTS_SCENES_BUDGET_EXPERIMENT_H
#define TETRACONE_EXPERIMENTS_SCENES_BUDGET_EXPERIMENT_H

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// How much of a frame a budget decides: a thousand bodies of 760 triangles that wander, with budgets of 1/32 to 4 times
/// the median time of a frame that is asked without one by a scene of its own. Each frame alone so, and all in a row by
/// one scene, which goes on with what it left undecided. What is decided is judged by scenes without a budget; that
/// undecided bodies are as near as is said, by their distance. Writes out/budget.csv, a row a budget and way of asking,
/// of all frames but the first. Requires two frames at least.
void run_budget(const std::filesystem::path& out, std::size_t frames, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
