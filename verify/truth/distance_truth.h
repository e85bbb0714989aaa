#ifndef TETRACONE_VERIFY_TRUTH_DISTANCE_TRUTH_H
#define TETRACONE_VERIFY_TRUTH_DISTANCE_TRUTH_H

#include "verify/truth/placed_body.h"

#include <vector>

/// Squared distances, exactly, by two formulations that share nothing with what they judge, nor with each other but the
/// exact images of points.
namespace tetracone::verify {

using kernel::Rational;

/// The hull of one, two or three points, which are not on one line, or not the same.
using Simplex = std::vector<Exact::Point_3>;

/// By features: the least of the squared distances of vertices to triangles and of edges, each CGAL's in rationals; 0
/// where the two meet.
Rational squared_distance_by_features(const Simplex& a, const Simplex& b);

/// As a convex quadratic program: min |sum x_i a_i - sum y_j b_j|^2 over convex weights. For each choice of corners
/// that have weight, the conditions of Karush, Kuhn and Tucker are linear equations; a solution of them whose weights
/// are not negative, and along whose difference no other corner is nearer, is the least. Some choice of affinely
/// independent differences has one.
Rational squared_distance_by_program(const Simplex& a, const Simplex& b);

/// The squared distance of the surfaces, by all pairs of elements whose outward-rounded boxes are not farther apart
/// than a pair already found.
Rational squared_distance(const Placed_body& a, const Placed_body& b,
                          Rational (*of)(const Simplex&, const Simplex&) = squared_distance_by_features);

}  // namespace tetracone::verify

#endif
