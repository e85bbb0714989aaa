#ifndef TETRACONE_EXPERIMENTS_QUERIES_JUDGED_DEPTHS_H
#define TETRACONE_EXPERIMENTS_QUERIES_JUDGED_DEPTHS_H

#include <cstdint>
#include <string>

namespace tetracone::experiments {

/// Returns how far the depths of other libraries are from the exact one, for convex pairs whose interiors meet. The CSV
/// has a row per shape and peer. A row counts the pairs, and of these the answers that are
///
/// - `apart`: the peer says that the bodies are apart;
/// - `failed`: it threw;
/// - `infinite`: no finite number;
/// - `negative`: at most 0;
/// - `off_millionth`, `off_hundredth`: off by more than this part of the depth, of those above 0.
///
/// `mean_off` and `most_off` are the mean and the largest error of those above 0, as a part of the depth; without any,
/// nothing and 0. `ns` is the mean time of an answer of the peer in nanoseconds, and `exact_ns` ours; what is prepared
/// once is left out. The shapes are boxes turned, boxes in one frame, and hulls of 100 points of a sphere; each has
/// `pairs` pairs. Requires pairs >= 1.
std::string judged_depths(int pairs, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
