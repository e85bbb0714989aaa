#ifndef TETRACONE_EXPERIMENTS_ACCURACY_DATASET_H
#define TETRACONE_EXPERIMENTS_ACCURACY_DATASET_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Writes cases of all families with their truth, for other libraries. OUT/dataset/ holds cases and predicates, as
/// JSON Lines and as CSV of the same rows, the polyhedra as triangles in meshes/NAME.off, and families.csv. README.md
/// is the card: it describes every column and every family, as croissant.json does for programs. A reader and a scorer
/// in Python come with example.py, which runs a toy library. The licence, the version and SHA256SUMS complete it.
/// Every number is exact: decimals of doubles that read back as equal, or "n/d". `cases` is their number per family
/// and level. Throws covering::Input_error when `out` cannot be written.
void export_dataset(const std::filesystem::path& out, std::uint64_t cases, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
