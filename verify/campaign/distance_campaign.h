#ifndef TETRACONE_VERIFY_CAMPAIGN_DISTANCE_CAMPAIGN_H
#define TETRACONE_VERIFY_CAMPAIGN_DISTANCE_CAMPAIGN_H

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tetracone::verify {

/// What a campaign of distances has asked.
struct Distance_tally {
  std::uint64_t cases = 0;         ///< pairs of placed bodies
  std::uint64_t answers = 0;       ///< judged: distances, squares, points and limits, both questions
  std::vector<std::string> wrong;  ///< "family 3, case 7: what is wrong"
};

/// Asks the library for the distances of `cases` cases of each family from `first` on, and judges them by the truth in
/// rationals: the exact square, that its nearest points are as far apart and lie where is said, the rounded root,
/// limits at the distance and beside it, and what must not change: bodies swapped, and both moved by one integer map.
/// Bodies of more than `most_faces` faces are left out. Calls `step` after each case.
Distance_tally judge_distances(
    std::uint64_t seed, std::uint64_t first, std::uint64_t cases, std::size_t most_faces,
    const std::function<void()>& step = [] {});

}  // namespace tetracone::verify

#endif
