#ifndef TETRACONE_EXPERIMENTS_ACCURACY_DATASET_H
#define TETRACONE_EXPERIMENTS_ACCURACY_DATASET_H

#include <cstdint>
#include <filesystem>

namespace tetracone::experiments {

/// Cases of all families with their truth, for other libraries: OUT/dataset/ holds cases.csv and cases.json (the same
/// rows), the polyhedra as triangles in meshes/NAME.off, predicates.csv, families.csv, a README.md that says what
/// every column and every family is, a reader and a scorer in Python, example.py, which runs a toy library on it, the
/// licence, the version and
/// SHA256SUMS. Every number is exact: decimals of doubles that read back as the same, or "n/d". `cases` per family and
/// level. Throws covering::Input_error when `out` cannot be written.
void export_dataset(const std::filesystem::path& out, std::uint64_t cases, std::uint64_t seed);

}  // namespace tetracone::experiments

#endif
