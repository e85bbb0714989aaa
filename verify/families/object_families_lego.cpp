#include "verify/cases/lego.h"
#include "verify/cases/object_placing.h"
#include "verify/families/object_families.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tetracone::verify::object_family {
namespace {

using lego::block;
using lego::Bricks;
using lego::Cell;
using lego::Cells;

/// Two bodies, of which B is moved by half cells.
struct Lego_pair {
  Bricks a, b;
  Cell offset;
};

Cell any_cell(Random& random, int low, int high)
{
  Cell cell;
  for (int& x : cell) x = integer(random, low, high);
  return cell;
}

/// Some of the cells, and not none of them.
Cells part_of(Random& random, const Cells& cells)
{
  Cells part;
  while (part.empty())
    for (const Cell& cell : cells)
      if (random.bits() % 2 == 0) part.insert(cell);
  return part;
}

/// A block, or some of its cells: in those, cells touch in edges and corners, and there are holes.
Cells any_cells(Random& random)
{
  const Cells cells = block({0, 0, 0}, any_cell(random, 1, random.bits() % 4 == 0 ? 3 : 2));
  return random.bits() % 2 == 0 ? cells : part_of(random, cells);
}

/// Shells whose solid is that of the cells. Walls between shells are membranes in the solid's interior.
Bricks as_bricks(Random& random, const Cells& cells)
{
  const int turn = random.bits() % 4 == 0 ? -1 : 1;
  Bricks bricks = {{cells, turn}};
  switch (random.bits() % 4) {
    case 0:  // twice there: a winding number of 2
      bricks.push_back({part_of(random, cells), turn});
      break;
    case 1:  // in two parts
      if (const Cells part = part_of(random, cells); part.size() < cells.size()) {
        for (const Cell& cell : part) bricks[0].cells.erase(cell);
        bricks.push_back({part, turn});
      }
      break;
    case 2:  // cell by cell
      if (cells.size() > 6) break;
      bricks.clear();
      for (const Cell& cell : cells) bricks.push_back({{cell}, turn});
      break;
    default: break;
  }
  return bricks;
}

/// Shells that may cancel one another, which leaves sheets: walls with nothing on either side.
Bricks any_bricks(Random& random)
{
  Bricks bricks;
  for (int k = integer(random, 2, 3); k > 0; --k)
    bricks.push_back({any_cells(random), random.bits() % 2 == 0 ? -1 : 1});
  return bricks;
}

Lego_pair any_pair(Random& random, int kind)
{
  const auto of = [&](const Cells& cells) { return as_bricks(random, cells); };
  const Cells cells = any_cells(random);
  Lego_pair pair{of(cells), {}, {0, 0, 0}};
  switch (kind) {
    case 1:  // anywhere
      pair.b = of(any_cells(random));
      pair.offset = any_cell(random, -4, 4);
      break;
    case 2:  // a copy
      pair.b = of(cells);
      break;
    case 3:  // a part
      pair.b = of(part_of(random, cells));
      break;
    case 4: {  // beside A, at a wall, an edge or a corner of its box; or half a cell off
      pair.b = of(any_cells(random));
      pair.offset = any_cell(random, -2, 2);
      const int away = random.bits() % 4 == 0 ? 1 : 0, first = integer(random, 0, 2);
      for (int k = integer(random, 1, 3); k > 0; --k) {
        int& x = pair.offset[std::size_t(first + k) % 3];
        for (const Cell& cell : cells) x = std::max(x, 2 * (cell[std::size_t(first + k) % 3] + 1) + away);
      }
      break;
    }
    case 5: {  // within
      const int n = integer(random, 2, 3);
      pair.a = of(block({0, 0, 0}, {n, n, n}));
      pair.b = of({{0, 0, 0}});
      pair.offset = any_cell(random, 1, 2 * n - 3);
      break;
    }
    case 6: {  // in a cavity, or at its walls
      Cells hollow = block({0, 0, 0}, {4, 4, 4});
      for (const Cell& cell : block({1, 1, 1}, {3, 3, 3})) hollow.erase(cell);
      pair.a = {{hollow}};
      pair.b = of(random.bits() % 4 == 0 ? block({0, 0, 0}, {2, 2, 2}) : Cells{{0, 0, 0}});
      pair.offset = random.bits() % 2 == 0 ? Cell{3, 3, 3} : any_cell(random, 1, 5);
      break;
    }
    case 7:  // of cancelling shells, and one of them
      pair.a = any_bricks(random);
      pair.b = random.bits() % 2 == 0 ? Bricks{pair.a[0]} : any_bricks(random);
      pair.offset = random.bits() % 2 == 0 ? Cell{0, 0, 0} : any_cell(random, -2, 2);
      break;
    default:  // half overlaps of aligned bodies
      pair.b = of(cells);
      while (pair.offset == Cell{0, 0, 0}) pair.offset = any_cell(random, -1, 1);
  }
  return pair;
}

Body as_body(Random& random, const Bricks& bricks)
{
  constexpr std::array shares = {0.0, 0.5, 1.0};
  lego::Division division;
  division.merged = shares[random.bits() % 3];
  division.halved = shares[random.bits() % 3];
  division.is_one_mesh = random.bits() % 2 == 0;
  division.is_straight = random.bits() % 2 == 0;
  return shared(lego::solid(bricks, division, random));
}

/// An exact affine map of any kind.
Pose any_frame(Random& random)
{
  switch (random.bits() % 4) {
    case 0: return fraction_map(random, integer(random, -8, 8));
    case 1: return wild_map(random, 8);
    default: return motion(random, exact_motion(random));
  }
}

}  // namespace

/// The answers are counted, in the grid of half cells.
Object_case lego_bricks(Random& random, double parameter)
{
  Lego_pair pair = any_pair(random, static_cast<int>(parameter));
  if (random.bits() % 2 == 0) {
    std::swap(pair.a, pair.b);
    for (int& x : pair.offset) x = -x;
  }
  const Pose frame = any_frame(random);
  Object_case c;
  c.a = as_body(random, pair.a);
  c.b = as_body(random, pair.b);
  c.pose_a = frame;
  c.pose_b = composed(frame, Pose::translation(pair.offset[0] / 2.0, pair.offset[1] / 2.0, pair.offset[2] / 2.0));

  Solid_overlap overlap = lego::overlap(pair.a, pair.b, pair.offset);
  c.surface = overlap.contact.dimension >= 0;
  c.solid = overlap.contact.relation != kernel::Solid_relation::disjoint;
  const auto column = [&](int k) { return turned(frame, {k == 0, k == 1, k == 2}); };
  const Rational determinant = dot(column(0), cross(column(1), column(2)));
  if (overlap.volume > 0) {
    overlap.volume *= Rational(abs(determinant));
    overlap.centroid = image(frame, overlap.centroid);
  }
  c.overlap = overlap;

  // The area of a square of half cells is a quarter. A frame that mirrors turns its vector's image around.
  const lego::Shared_squares squares = lego::shared_squares(pair.a, pair.b, pair.offset);
  c.shared.emplace();
  for (int k = 0; k < 3; ++k) {
    const Exact_vector area = cross(column((k + 1) % 3), column((k + 2) % 3));
    c.shared->vector = sum(c.shared->vector, times(Rational(sgn(determinant) * squares.outward[k]) / 4, area));
    if (squares.count[k] > 0)
      c.shared->squares.push_back(Rational(squares.count[k] * squares.count[k]) / 16 * dot(area, area));
  }
  std::ranges::sort(c.shared->squares);

  const int axis = int(random.bits() % 3), sign = random.bits() % 2 == 0 ? 1 : -1;
  Exact_vector direction = {0, 0, 0};
  direction[axis] = sign;
  c.exits = {turned(frame, direction), lego::exits(pair.a, pair.b, pair.offset, axis, sign)};
  const Rational square = dot(column(0), column(0));
  bool is_similarity = true;
  for (int k = 0; k < 3; ++k)
    is_similarity = is_similarity && dot(column(k), column(k)) == square && dot(column(k), column((k + 1) % 3)) == 0;
  if (is_similarity) c.squared_depth = square * lego::squared_depth(pair.a, pair.b, pair.offset);
  return c;
}

}  // namespace tetracone::verify::object_family
