#ifndef TETRACONE_EXPERIMENTS_REPORT_METHOD_FIGURES_H
#define TETRACONE_EXPERIMENTS_REPORT_METHOD_FIGURES_H

#include "experiments/support/experiment_options.h"

namespace tetracone::experiments {

/// Draws the pictures of JS08's method for a model. OUT/method.json holds its covering, tree, bounding volumes and
/// hull. It also holds the model's image by a point near its farthest vertex, which the model meets there. A body whose
/// flat faces have holes is there too. From it draw_method.py draws OUT/figures/method_*.svg and .pdf. Without a model,
/// it is a star-shaped body of 760 triangles. Throws covering::Input_error for a model that cannot be read or is no
/// solid, and std::runtime_error when the figures cannot be drawn.
void run_method_figures(const Experiment_options& options);

}  // namespace tetracone::experiments

#endif
