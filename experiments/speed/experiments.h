#ifndef TETRACONE_EXPERIMENTS_SPEED_EXPERIMENTS_H
#define TETRACONE_EXPERIMENTS_SPEED_EXPERIMENTS_H

#include "experiments/support/experiment.h"

namespace tetracone::experiments {

/// The experiments of speed. Each writes its rows to `out` in parts, except `threads`: stopped and started again, it
/// continues. Each throws covering::Input_error when the models do not exist or `out` cannot be written.

/// Measures the cost of each choice of JS08. The paper's tree is asked in double with one choice changed at a time, and
/// in steps from the paper's listing to the fast tree. The objects are star-shaped ones of 760 triangles and others of
/// 7172, with FCL in the same run. Writes out/ablation.csv, out/ablation.svg and .pdf, and prints the table of steps.
/// `full`: all poses on the large objects.
void run_ablation(const Experiment_options& options);

/// Tests the claims of JS08 section 4 about the paper's tree, except frames per second, in double:
/// - the cost and gain of adjusting bounding tetrahedra;
/// - the depth that suits a relative size, and the effect of that size on the number of tests;
/// - the effect of B's rotation.
///
/// Meshes of the cat's and the horse's size are asked against themselves at relative sizes 1:1 to 1:16. Writes
/// out/paper.csv, out/paper.svg and .pdf, and prints the tables. `full`: every pose for every tree.
void run_paper(const Experiment_options& options);

/// Measures the fast tree and the paper's against FCL, CGAL, Bullet and ODE in one run, with shared poses and judged
/// answers. Real and generated meshes move on both trajectories at relative sizes 1:1 and 1:8, and in degenerate near
/// contact. `programs` take part. Writes out/peers.csv, out/peers.svg and .pdf, and prints the means. `full`: also
/// 70000 triangles.
void run_peers(const Experiment_options& options);

/// Measures how time per query, build and memory grow with the number of triangles, 10^3 to 10^5 (`full`: 10^6), of one
/// geometry in equal poses. It also measures the fraction of the tree that queries build when nodes are built on
/// demand. Writes out/scaling.csv, out/scaling.svg and .pdf, and prints the fitted exponents.
void run_scaling(const Experiment_options& options);

/// Runs the robustness and time study. Every subject is asked on the trajectories of JS08 section 4 and on exactly
/// degenerate contacts. Its answers are judged by brute force in rationals, and its time is measured. `programs` are
/// subjects too. Writes out/study.csv, one row for each workload, question and subject. Draws the report, unless
/// `rows_alone`. `full`: 20 times as many poses.
void run_study(const Experiment_options& options);

/// Measures what exactness costs in contact: the adaptive kernel, double and EPECK on one tree, and FCL, on the study's
/// degenerate contacts alone. Other questions than collisions are asked there too, of kernels that answer them
/// (contact_questions.h). Writes out/contact_cost.csv, one row for each workload, question and subject, and prints the
/// ratios.
void run_contact_cost(const Experiment_options& options);

/// Measures the queries per second that 1, 2, 4 ... threads make on the same two bodies, up to twice the number of
/// processors. The bodies are fresh ones, whose nodes are built on demand, and warm ones. The poses of a contour
/// trajectory are dealt out in turn. It also measures how fast the threads build bodies of 70,000 and 700,000 triangles
/// with all nodes, per triangle. Writes out/threads.csv and prints it as a table.
void run_threads(const Experiment_options& options);

}  // namespace tetracone::experiments

#endif
