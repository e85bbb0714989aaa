#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_DISTANCE_TO_DEGENERACY_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_DISTANCE_TO_DEGENERACY_H

#include "verify/cases/case.h"

namespace tetracone::verify {

/// The distance of a case from degeneracy, in exact arithmetic: for each measure the least over the determinants D
/// whose signs decide it. Coordinates of any magnitude neither overflow nor underflow it; a logarithm has an error of
/// some 1e-12. Minus infinity: exactly degenerate. Plus infinity: no determinant was needed.
struct Distance {
  double log2_rho;   ///< log2 of |D| / P, P the sum of the absolute values of the products of D's differences: rounding
                     ///< errs below some u
  double log2_ulps;  ///< log2 of the distance |D| / |n| of a vertex from a plane (edges: of two lines) in ulps of the
                     ///< largest coordinate
};

/// The distance over the determinants of a predicate. [a b c x] is the side of x of the plane of a, b, c; differences
/// are taken to x.
///  - orientation: [v1 v2 v3 p];
///  - tetra-cone: its volume [v1 v2 v3 v0], and p against its three planes; tetrahedron: against its four;
///  - segment-triangle: p and q against the plane of v1 v2 v3, and the line pq against the lines of the three edges;
///  - solid: p and the covering's origin q against the four planes, p against the six inner ones, through q and an
///    edge;
///  - classification: the two volumes, p q r against the cone's planes, and v1 v2 v3 against other planes. These go
///    through v0 and the edges of p q r.
///
/// The largest coordinate is taken over the named points.
Distance distance(Predicate predicate, const Predicate_case& c);

/// The distance over pairs of an edge of one body and a face of the other. Their boxes meet when grown by 2^-20 of
/// their longest side. It takes the ends of the edge against the face's plane. Where they are not strictly on one side
/// of it, it also takes the edge's line against the lines of the face's edges. A face that spans no plane is exactly
/// degenerate. Only the first 2000 pairs of each direction are taken, in the order of the faces and then of the edges.
/// The largest coordinate is taken over all placed vertices.
Distance distance(const Object_case& c);

}  // namespace tetracone::verify

#endif
