#ifndef TETRACONE_VERIFY_CASES_LEGO_H
#define TETRACONE_VERIFY_CASES_LEGO_H

#include "tetracone/covering/polyhedron.h"
#include "verify/cases/case.h"
#include "verify/cases/random.h"

#include <array>
#include <set>
#include <vector>

/// Bodies of unit cells, whose relations are known by counting.
namespace tetracone::verify::lego {

/// The least corner of a cell, or an offset: integers.
using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;

/// The border of a set of cells, as a closed surface.
struct Shell {
  Cells cells;
  int turn = 1;  ///< the winding number of the cells: 1 or -1
};

/// The winding number of a cell is the sum over all shells. Shells may overlap, cancel one another, or share walls.
using Bricks = std::vector<Shell>;

/// Returns all cells from `low` to below `high`.
Cells block(const Cell& low, const Cell& high);

/// How a surface is divided into faces.
struct Division {
  double merged = 0;  ///< the share of edges between squares of one plane that are removed: 0 squares, 1 large faces
  double halved = 0;  ///< the share of lone squares that become two triangles
  bool is_one_mesh = false;  ///< shells share their vertices
  bool is_straight = false;  ///< vertices at which every loop runs straight on are left out
};

/// Returns the surface as a closed polyhedron with planar faces. Faces may have holes, and loops that touch themselves.
covering::Polyhedron solid(const Bricks& bricks, const Division& division, Random& random);

/// Returns the relation of A, and of B moved by `offset` halves of a cell, and their overlap in cells. It counts the
/// cells, squares, edges and corners of the grid of half cells.
Solid_overlap overlap(const Bricks& a, const Bricks& b, const Cell& offset);

/// The squares of half cells that two surfaces share, by the axis across them.
struct Shared_squares {
  std::array<long, 3> count{};    ///< all of them
  std::array<long, 3> outward{};  ///< those that A is below, less those that A is above
};

/// Counts the squares that A's surface shares with that of B, which is moved by `offset` halves of a cell.
Shared_squares shared_squares(const Bricks& a, const Bricks& b, const Cell& offset);

/// Returns how far A must be moved along an axis, in whole cells, for its interior to leave that of B. B is moved by
/// `offset` halves of a cell. `sign` is 1 or -1: along the axis, or against it.
Solid_exits exits(const Bricks& a, const Bricks& b, const Cell& offset, int axis, int sign);

/// Returns the squared length of the least translation of A after which the interiors share no point, in whole cells. B
/// is moved by `offset` halves of a cell.
kernel::Rational squared_depth(const Bricks& a, const Bricks& b, const Cell& offset);

}  // namespace tetracone::verify::lego

#endif
