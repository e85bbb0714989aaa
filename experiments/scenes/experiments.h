#ifndef TETRACONE_EXPERIMENTS_SCENES_EXPERIMENTS_H
#define TETRACONE_EXPERIMENTS_SCENES_EXPERIMENTS_H

#include "experiments/support/experiment.h"

namespace tetracone::experiments {

/// The experiments of scenes. Each writes its rows to `out`, and prints them as a table; `run_demand` prints one in
/// ten. Each throws covering::Input_error when `out` cannot be written.

/// Measures how much of a frame a budget decides. A thousand wandering bodies of 760 triangles get budgets of 1/32 to 4
/// times the median time of a frame without a budget, which another scene measures. Each frame is asked by itself, and
/// then all frames in a row by one scene, which continues with the pairs that it left undecided. Scenes without a
/// budget judge the decided pairs; the distance judges the bound of the undecided ones. There are `race_frames` / 20
/// frames, at least two. Writes out/budget.csv, one row per budget and way of asking. Rows leave out the first frame,
/// except in `wrong`.
void run_budget(const Experiment_options& options);

/// Measures the gain of remembering the last pose against a body's motion from one pose to the next. Smooth walks of
/// `race_frames` poses, and of 5, 25 and 125 times as many, at some clearances and in contact, are asked with and
/// without memory in turn. Writes out/coherence.csv, one row per walk and question.
void run_coherence(const Experiment_options& options);

/// Measures the fraction of all nodes and tables that the frames of a scene need. 200 bodies of 7000 triangles, each
/// with its own model, are drawn to the middle, so that ever more come near one another. Two scenes play the same
/// `race_frames` / 10 frames, at least two: one builds on demand, the other builds its trees first. Writes
/// out/demand.csv, one row per frame, with the nodes, bytes, signs and time so far.
void run_demand(const Experiment_options& options);

/// Measures how fast the colliding pairs of many bodies are found, frame after frame. The methods are `Scene` on one
/// thread and on two, our queries on the pairs of CGAL's box intersection, and the scenes of three libraries. These are
/// FCL, Bullet and ODE. All are asked on the same poses in one run. Answers are compared with the truth in rationals:
/// on all frames for a thousand bodies, on the last frame for more. For 10^5 bodies, only a tenth of the pairs are
/// compared. There are `race_frames` / 20 frames, at least two, and at most five of 10^5 bodies. Means leave out the
/// first frame, which has a column of its own. Scenes have a thousand bodies of 80 or 760 triangles, ten thousand of
/// 80, and long boxes. `full` adds 10^5 bodies, ten thousand of 760 triangles, and a thousand of 7000. Writes
/// out/scenes.csv, one row per scene and method.
void run_scenes(const Experiment_options& options);

}  // namespace tetracone::experiments

#endif
