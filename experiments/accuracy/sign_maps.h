#ifndef TETRACONE_EXPERIMENTS_ACCURACY_SIGN_MAPS_H
#define TETRACONE_EXPERIMENTS_ACCURACY_SIGN_MAPS_H

#include <filesystem>

namespace tetracone::experiments {

/// Maps the answers of each arithmetic at size x size neighbouring doubles about a degenerate position, in the manner
/// of Kettner, Mehlhorn, Pion, Schirra and Yap (2008, Fig. 2), for predicates in 3D. These are the sign of a
/// barycentric coordinate, segment against triangle, the classification in a cone, and the collision of two bodies. A
/// point near (1/2, 1/2, 1/2) moves by one double per column in x and one per row in y; everything is under one exact
/// rotation, which rounding kernels must round. Writes OUT/sign_maps.csv, one row for each map, subject and row of the
/// grid: -, 0 or + per dot. Takes a minute or two with 256. Throws std::logic_error when the exact picture differs from
/// the truth, which is checked in every 16th row and column; covering::Input_error when `out` cannot be written.
/// Requires size >= 1.
void run_sign_maps(const std::filesystem::path& out, int size = 256);

}  // namespace tetracone::experiments

#endif
