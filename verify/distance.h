#ifndef TETRACONE_VERIFY_DISTANCE_H
#define TETRACONE_VERIFY_DISTANCE_H

#include "verify/case.h"

namespace tetracone::verify {

/// How far a case is from degenerate, in exact arithmetic: the least over the determinants D whose signs decide it.
/// Minus infinity: exactly degenerate. Plus infinity: no determinant was needed.
struct Distance {
  double log2_rho;   ///< log2 of |D| / P, P the sum of the absolute values of the products of D's differences: rounding errs below some u
  double log2_ulps;  ///< log2 of the distance |D| / |n| of a vertex from a plane (edges: of two lines) in ulps of the largest coordinate
};

Distance distance(Predicate predicate, const Predicate_case& c);

/// Over the elements of the two bodies whose boxes meet or nearly so.
Distance distance(const Object_case& c);

}  // namespace tetracone::verify

#endif
