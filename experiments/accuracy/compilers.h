#ifndef TETRACONE_EXPERIMENTS_ACCURACY_COMPILERS_H
#define TETRACONE_EXPERIMENTS_ACCURACY_COMPILERS_H

#include <filesystem>

namespace tetracone::experiments {

/// Measures the effect of compiler flags on signs. It compiles compiler_probe.cpp with g++ and clang++, where they are
/// installed, at -O0, -O2 and -O3, with and without contraction of products and sums, -march=native and -ffast-math. It
/// runs each program and writes OUT/compilers.csv: one row for each compiler, flags, subject and test. A compiler that
/// refuses, or a program that crashes, is a row of its own. Takes two minutes. Throws std::runtime_error without a
/// compiler, covering::Input_error when `out` cannot be written.
void run_compilers(const std::filesystem::path& out);

}  // namespace tetracone::experiments

#endif
