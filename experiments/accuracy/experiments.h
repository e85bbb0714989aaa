#ifndef TETRACONE_EXPERIMENTS_ACCURACY_EXPERIMENTS_H
#define TETRACONE_EXPERIMENTS_ACCURACY_EXPERIMENTS_H

#include "experiments/support/experiment.h"

namespace tetracone::experiments {

/// The experiments of accuracy. Each takes its folder of results as `out`, and throws covering::Input_error when that
/// cannot be written.

/// Measures the effect of compiler flags on signs. It compiles compiler_probe.cpp with g++ and clang++, where they are
/// installed. The flags are -O0, -O2 and -O3, with and without contraction of products and sums, -march=native and
/// -ffast-math. It needs the sources from which this program was built; its own programs are temporary files. It runs
/// each and writes OUT/compilers.csv: one row for each compiler, flags, subject and test. A compiler that refuses, or a
/// program that crashes, is a row of its own. Throws std::runtime_error without a compiler.
void run_compilers(const Experiment_options& options);

/// Writes cases of all families of pairs with their truth, for other libraries. OUT/dataset/ holds the tables cases,
/// predicates and triangles, as JSON Lines and as CSV of the same rows. It also holds the polyhedra as triangles in
/// meshes/NAME.off, and families.csv. README.md is the card: it describes every column and every family, as
/// croissant.json does for programs. A reader and a scorer in Python come with example.py, which runs a toy library.
/// The licence, dataset.json and SHA256SUMS complete it; dataset.json has version, seed and numbers of cases. Numbers
/// of a case are exact: decimals of doubles that read back as equal, or "n/d". Its two distances to degeneracy are
/// rounded to sixteenths. An infinite number is the text "inf" or "-inf". `cases` is the number of cases per family and
/// level; `full` multiplies it by 20. Throws std::runtime_error when the two truths disagree.
void export_dataset(const Experiment_options& options);

/// Lists every constant of an error bound that has a proof, a test or a reason by hand. A proved one has its value in
/// the code and the value that is proved to be enough. It also has the worst error that hill climbing finds, or the
/// reason why no search exists. A constant that a test checks, or that has only a reason by hand, has no numbers.
/// Writes OUT/error_bounds.csv, one row per proof, test or reason, and prints a line per proof. Throws
/// std::runtime_error without Gappa.
void run_error_bounds(const Experiment_options& options);

/// Measures how often each method of deciding whether moving primitives meet is wrong, and how long it takes. It asks
/// ten times `cases` pairs of each family (`full`: 500 times), judged by verify/truth. Unless `queries` is empty, it
/// also asks the queries of that folder, in the form of Wang et al. (2021), judged by their own truth. A query without
/// truth is left out. Writes OUT/motion.csv, one row per family and subject, and OUT/motion_relations.csv: how often
/// each metamorphic relation held. Its row "first time" says how often `kernel::first_contact_time` was right. Throws
/// covering::Input_error for bad queries.
void run_motion(const Experiment_options& options);

/// Maps the answers of each arithmetic at size x size neighbouring doubles about a degenerate position. It follows
/// Kettner, Mehlhorn, Pion, Schirra and Yap (2008, Fig. 2), for predicates in 3D. These are the sign of a barycentric
/// coordinate, segment against triangle, the classification in a cone, and the collision of two bodies. A point near
/// (1/2, 1/2, 1/2) moves by one double per column in x and one per row in y. Everything is under one exact rotation,
/// which rounding kernels must round. Writes OUT/sign_maps.csv, one row for each map, subject and row of the grid. A
/// dot is -, 0 or +, or ? where the kernel has no answer; yes is + and no is -. Throws std::logic_error when the exact
/// picture differs from the truth, which is checked in every 16th row and column. Requires size >= 1.
void run_sign_maps(const Experiment_options& options);

/// Measures how many doubles from the exact place each kernel changes its answer. A body, turned exactly, moves
/// straight at another. Each path has one exact rotation of everything. The exact answer changes between two
/// neighbouring doubles of its path. There are 20 paths (`full`: 400) per motion; one without contact has no rows.
/// Writes OUT/stability.csv, one row for each motion, path and subject. A row has the exact threshold: the last double
/// without contact. It also has the distance of the subject's threshold, in doubles and in ulps of the exact one.
/// Throws std::logic_error when brute force in rationals denies an exact threshold.
void run_stability(const Experiment_options& options);

}  // namespace tetracone::experiments

#endif
