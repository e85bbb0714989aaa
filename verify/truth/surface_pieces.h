#ifndef TETRACONE_VERIFY_TRUTH_SURFACE_PIECES_H
#define TETRACONE_VERIFY_TRUTH_SURFACE_PIECES_H

#include "tetracone/kernel/number/number.h"
#include "verify/cases/exact_map.h"
#include "verify/truth/placed_body.h"

#include <array>
#include <cstddef>
#include <vector>

/// The surfaces of two placed bodies, cut along each other and along themselves. Everything is rational.
namespace tetracone::verify {

using object_family::Exact_vector;

/// A point, a segment or a triangle of a placed surface.
struct Placed_element {
  int dimension;  ///< only dimension + 1 corners are used; the others repeat the first
  int winding;    ///< of its face's loops about a triangle; else 0
  std::array<Exact_vector, 3> corner;
  Exact_vector low, high;  ///< its box
  Exact_vector normal;     ///< of a triangle, on the side from which its corners run counterclockwise; else 0

  Placed_element(int dimension, int winding, const std::array<Exact_vector, 3>& corner);

  /// Returns true when the boxes, which are closed, share a point.
  bool is_near(const Placed_element& other) const;
};

/// True when the two elements share a point, by CGAL.
bool meet(const Placed_element& x, const Placed_element& y);

/// Returns the least common denominator of a body's placed points.
mpz_class common_denominator(const Placed_body& placed);

/// Returns the exact elements of a body's surface, times `scale`: integers cost less than fractions.
std::vector<Placed_element> placed_elements(const Placed_body& placed, const mpz_class& scale);

/// A trapezoid of a triangle. No element of either surface enters its relative interior, unless it contains all of it.
/// So what is said of one point of the relative interior holds for all.
struct Surface_piece {
  std::array<Exact_vector, 4> corner;  ///< counterclockwise, seen from the upper side; two may be equal
  int body;                            ///< whose triangle it is a part of: 0 or 1
  std::array<bool, 2> is_on{};         ///< whether it lies on the surface of body 0, of body 1
  bool is_first = true;  ///< no element before this one, of both surfaces in their order, contains the piece
  /// winding[body][side]: the winding number below the piece (side 0) or above it (side 1), along an axis that crosses
  /// it.
  std::array<std::array<int, 2>, 2> winding{};

  /// True when the side, 0 below or 1 above, is in both solids.
  bool is_common(int side) const { return winding[0][side] != 0 && winding[1][side] != 0; }
};

/// Returns pieces whose union is the union of all triangles of both surfaces.
std::vector<Surface_piece> surface_pieces(const std::array<std::vector<Placed_element>, 2>& surfaces);

/// True when the solids of both surfaces have a side of some piece in common: their interiors share a point.
bool share_interior(const std::vector<Surface_piece>& pieces);

/// A part of a surface's segment, or a point of it. No element of either surface ends or begins between its ends.
struct Curve_piece {
  Exact_vector from, to, middle;
  int body;  ///< whose element it is a part of: 0 or 1
};

/// Returns pieces whose union is the union of all segments and points that are elements of their own.
std::vector<Curve_piece> curve_pieces(const std::array<std::vector<Placed_element>, 2>& surfaces);

}  // namespace tetracone::verify

#endif
