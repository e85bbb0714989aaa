#ifndef TETRACONE_EXPERIMENTS_REPORT_METHOD_FIGURES_H
#define TETRACONE_EXPERIMENTS_REPORT_METHOD_FIGURES_H

#include "experiments/support/experiment_options.h"

namespace tetracone::experiments {

/// The pictures of JS08's method, of a model: OUT/method.json holds its covering, tree, bounding volumes and hull, with
/// a mirror image of it that it meets with its farthest vertex. From it draw_method.py draws OUT/figures/method_*.svg
/// and .pdf. No model: a star-shaped body of 760 triangles. Throws covering::Input_error for a model that cannot be
/// read or is no solid, and std::runtime_error when the figures cannot be drawn.
void run_method_figures(const Experiment_options& options);

}  // namespace tetracone::experiments

#endif
