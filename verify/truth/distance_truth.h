#ifndef TETRACONE_VERIFY_TRUTH_DISTANCE_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_DISTANCE_TRUTH_H

#include "verify/truth/placed_body.h"

#include <vector>

/// Exact squared distances by two formulations. Neither shares anything with the code that it judges, nor with the
/// other except the exact images of points.
namespace tetracone::verify {

using kernel::Rational;

/// The hull of one point, of two different points, or of three points that are not on one line.
using Simplex = std::vector<Exact::Point_3>;

/// Returns the squared distance by features: the least over vertices against triangles and over edges, each computed by
/// CGAL in rationals; 0 if the two meet.
Rational squared_distance_by_features(const Simplex& a, const Simplex& b);

/// Returns the squared distance as a convex quadratic program: min |sum x_i a_i - sum y_j b_j|^2 over convex weights.
/// For each choice of corners with weight, the conditions of Karush, Kuhn and Tucker are linear equations. A solution
/// gives the minimum if its weights are not negative and no other corner is nearer along its difference. Some choice of
/// affinely independent differences has such a solution.
Rational squared_distance_by_program(const Simplex& a, const Simplex& b);

/// Returns the squared distance of the surfaces, by all pairs of elements whose outward-rounded boxes are not farther
/// apart than a pair already found.
Rational squared_distance(const Placed_body& a, const Placed_body& b,
                          Rational (*of)(const Simplex&, const Simplex&) = squared_distance_by_features);

/// True when `x` is the double nearest to the root of `square`: the root is not beyond the middle to either neighbour.
bool is_nearest_root(double x, const Rational& square);

}  // namespace tetracone::verify

#endif
