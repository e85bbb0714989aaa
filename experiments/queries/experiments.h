#ifndef TETRACONE_EXPERIMENTS_QUERIES_EXPERIMENTS_H
#define TETRACONE_EXPERIMENTS_QUERIES_EXPERIMENTS_H

#include "experiments/support/experiment.h"

namespace tetracone::experiments {

/// The experiments of queries. Each writes its rows to `out` and prints the rows of its first table, one line each.
/// Each throws covering::Input_error when `out` cannot be written.

/// Measures how fast all contacts of two colliding bodies of 7172 triangles are found, and how many of FCL's pairs of
/// faces are wrong. Our pairs are the truth. The methods are asked in turn, in those poses of contour and circular
/// trajectories in which surfaces meet. The fastest time of each pose counts. `race_frames` is the number of poses of a
/// trajectory, those of bodies apart included; the circular one has eight circles. Writes out/contacts.csv, one row per
/// method, object and trajectory. Throws covering::Input_error when a model does not exist.
void run_contacts(const Experiment_options& options);

/// Measures the cost and the error of a distance: the fast tree, exact and in double, against FCL's trees in one run.
/// The bodies are a star-shaped body against itself on both trajectories, of about 7000 triangles and, with `full`,
/// 71,000; and cubes that touch or are 2^-k apart. On the trajectories our exact distances are the truth. It also asks
/// whether bodies are within a tenth of their size. Writes out/distance.csv, one row per trajectory, size, subject and
/// question.
void run_distance(const Experiment_options& options);

/// Measures the cost of the exact first contact of two moving bodies, in static questions of the same tree. It also
/// counts the contacts that static questions at 10, 100 and 1000 times miss, and those that FCL's continuousCollide
/// misses. The motions are steps of the contour trajectory and of the circular one, and throws through a body and
/// through a thin plate. B moves, and each course has `race_frames` motions. Our own first contacts are the truth;
/// tests judge them. Writes out/moving_bodies.csv, one row per course and subject. It also measures a face that lands
/// flat on a face against the same motion tilted by a thousandth; the least of nine times counts. Writes
/// out/landings.csv, one row per pair of bodies and motion.
void run_moving_bodies(const Experiment_options& options);

/// Measures the cost of exits and depths of a star-shaped body that overlaps itself turned, beside the first contact of
/// the reversed translation. The bodies have 200 and 1000 triangles and, with `full`, 7172. Each has `race_frames` / 50
/// places of two kinds, at least one. In shallow ones the last exit along a random direction is a hundredth of the
/// body's size, and depths are bracketed to 1e-9. In deep ones it is a third, and they are bracketed to 1e-3. Writes
/// three tables:
/// - out/penetration.csv: one row per body, overlap and question;
/// - out/penetration_widths.csv: how narrow a bracket is after more and more boxes of translations;
/// - out/penetration_peers.csv: how far off other libraries are on convex pairs (`judged_depths`), 100 of each shape
///   or, with `full`, 1000.
void run_penetration(const Experiment_options& options);

/// Measures the cost of locating a point in a solid, and of the first hit of a ray. The methods are the table over
/// cones, the boxes of the fast tree, the paper's tetra-tree, exact and in double, and CGAL's Side_of_triangle_mesh and
/// AABB_tree. The bodies are two generated ones, each of 7,000 and of 70,000 triangles, and `meshes`. Points are random
/// in their box and within 1e-3 of their surface, `points` of each (`full`: 20 times as many), and as many rays. Times
/// are of the processor. Set-up includes reading the file, except for the tetra-tree, which takes the mesh in memory.
/// The truth judges every answer. Writes out/points.csv, one row per body, kind of question and method. While it runs,
/// out/points_body.off holds the body. Throws covering::Input_error for an invalid model, and for one with faces that
/// are no triangles.
void run_points(const Experiment_options& options);

/// Measures the relation and the overlap of boxes and of bodies of 7172 triangles that collide, against `collide` and
/// `contacts`. It also measures signed distances to bodies of 70000 triangles, against CGAL's nearest points without a
/// sign. The 20000 points are random or near the surface. Self-intersections are measured against CGAL's, of 70000
/// triangles or, with `full`, a million. `race_frames` counts the poses of each course. Writes out/measures.csv, one
/// row per question and way. Writes out/touching.csv, what each peer says of boxes that touch or overlap
/// (`touching_csv`): 100 pairs of each kind or, with `full`, 1000.
void run_measures(const Experiment_options& options);

}  // namespace tetracone::experiments

#endif
