#include "verify/cases/lego.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <utility>

namespace tetracone::verify::lego {
namespace {

using covering::Index;
using kernel::Rational;
using kernel::Solid_relation;
using Loop = std::vector<Index>;
using Face = std::vector<Loop>;

/// A square of the border of a set of cells.
struct Square {
  int axis, side;  ///< side 1: the cell is below it, along the axis
  Cell corner;     ///< the least one

  friend auto operator<=>(const Square&, const Square&) = default;
};

/// Returns the squares that have a cell on one side and none on the other.
std::vector<Square> border(const Cells& cells)
{
  std::vector<Square> squares;
  for (const Cell& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        Cell beyond = cell, corner = cell;
        beyond[axis] += 2 * side - 1;
        corner[axis] += side;
        if (!cells.contains(beyond)) squares.push_back({axis, side, corner});
      }
  return squares;
}

/// Makes the faces of shells.
class Builder {
 public:
  Builder(const Division& division, Random& random) : division_(division), random_(random) {}

  void add(const Shell& shell)
  {
    if (!division_.is_one_mesh) numbers_.clear();
    const std::vector<Square> squares = border(shell.cells);
    for (const auto& group : merged(squares)) add_face(group, shell.turn);
  }

  covering::Polyhedron result()
  {
    if (division_.is_straight) leave_out_straight_vertices();
    for (const Face& face : faces_) polyhedron_.add_face(face);
    return std::move(polyhedron_);
  }

 private:
  /// Groups squares of one plane and side that share an edge.
  std::vector<std::vector<Square>> merged(const std::vector<Square>& squares)
  {
    std::map<Square, std::size_t> number;
    for (std::size_t k = 0; k < squares.size(); ++k) number[squares[k]] = k;
    std::vector<std::size_t> parent(squares.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto root = [&](std::size_t k) {
      while (parent[k] != k) k = parent[k];
      return k;
    };
    for (std::size_t k = 0; k < squares.size(); ++k)
      for (const int step : {1, 2}) {
        Square next = squares[k];
        ++next.corner[(next.axis + step) % 3];
        if (number.contains(next) && random_.unit() < division_.merged) parent[root(k)] = root(number[next]);
      }
    std::map<std::size_t, std::vector<Square>> groups;
    for (std::size_t k = 0; k < squares.size(); ++k) groups[root(k)].push_back(squares[k]);
    std::vector<std::vector<Square>> result;
    for (auto& [of, group] : groups) result.push_back(std::move(group));
    return result;
  }

  Index vertex(const Cell& at)
  {
    const auto [found, is_new] = numbers_.try_emplace(at, Index(polyhedron_.vertices.size()));
    if (is_new) polyhedron_.vertices.push_back({double(at[0]), double(at[1]), double(at[2])});
    return found->second;
  }

  /// The corners of a square, counterclockwise seen from outside where `turn` is 1.
  Loop corners(const Square& square, int turn)
  {
    Loop loop;
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      Cell at = square.corner;
      at[(square.axis + 1) % 3] += i;
      at[(square.axis + 2) % 3] += j;
      loop.push_back(vertex(at));
    }
    if ((square.side == 1) != (turn == 1)) std::ranges::reverse(loop);
    return loop;
  }

  void add_face(const std::vector<Square>& group, int turn)
  {
    if (group.size() == 1 && random_.unit() < division_.halved) {
      Loop loop = corners(group[0], turn);
      std::rotate(loop.begin(), loop.begin() + std::ptrdiff_t(random_.bits() % 4), loop.end());
      faces_.push_back({{loop[0], loop[1], loop[2]}});
      faces_.push_back({{loop[0], loop[2], loop[3]}});
      return;
    }
    std::multimap<Index, Index> edges;  // those between two squares of the group cancel
    for (const Square& square : group) {
      const Loop loop = corners(square, turn);
      for (std::size_t k = 0; k < 4; ++k) {
        const Index from = loop[k], to = loop[(k + 1) % 4];
        const auto [first, last] = edges.equal_range(to);
        const auto back = std::find_if(first, last, [&](const auto& edge) { return edge.second == from; });
        if (back != last)
          edges.erase(back);
        else
          edges.emplace(from, to);
      }
    }
    Face face;
    while (!edges.empty()) {
      Loop loop = {edges.begin()->first};
      for (auto edge = edges.begin(); edge != edges.end(); edge = edges.find(loop.back())) {
        loop.push_back(edge->second);
        edges.erase(edge);
      }
      loop.pop_back();  // the first once more
      face.push_back(std::move(loop));
    }
    // The outer loop is the longest along some axis: it surrounds the others.
    const auto size = [&](const Loop& loop) {
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const Index v : loop) {
        const double x = polyhedron_.vertices[v][(group[0].axis + 1) % 3];
        low = std::min(low, x);
        high = std::max(high, x);
      }
      return high - low;
    };
    std::iter_swap(face.begin(), std::ranges::max_element(face, {}, size));
    faces_.push_back(std::move(face));
  }

  /// Leaves out vertices through which each loop runs straight on. The edges on either side of one cancel one another
  /// in pairs, and so do the edges without it.
  void leave_out_straight_vertices()
  {
    std::vector<bool> is_corner(polyhedron_.vertices.size());
    const auto step = [&](const Loop& loop, std::size_t k) {
      const auto &from = polyhedron_.vertices[loop[k % loop.size()]],
                 &to = polyhedron_.vertices[loop[(k + 1) % loop.size()]];
      return kernel::Vertex{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    };
    for (const Face& face : faces_)
      for (const Loop& loop : face)
        for (std::size_t k = 0; k < loop.size(); ++k)
          if (step(loop, k) != step(loop, k + 1)) is_corner[loop[(k + 1) % loop.size()]] = true;
    for (Face& face : faces_)
      for (Loop& loop : face) std::erase_if(loop, [&](Index v) { return !is_corner[v]; });
  }

  const Division& division_;
  Random& random_;
  covering::Polyhedron polyhedron_;
  std::map<Cell, Index> numbers_;
  std::vector<Face> faces_;
};

/// The strata of the grid of half cells: its cells, squares, edges and corners. Coordinate 2 h + 1 of a stratum stands
/// for the open interval from h to h + 1 halves, and coordinate 2 h for h itself. So a cell spans five coordinates, of
/// which the first and the last are its walls.
class Strata {
 public:
  /// Coordinates run from `low` to `high` on each axis; no cell's wall is there.
  Strata(const Bricks& bricks, const Cell& offset, int low, int high)
      : low_(low), size_(high - low + 1), winding_(std::size_t(size_) * size_ * size_), surface_(winding_.size())
  {
    // Calls what(place) for the strata of a cell or square, without those within `wall` of its ends.
    const auto for_strata = [&](const Cell& corner, int wall, const Cell& extent, const auto& what) {
      Cell s;
      for (int i = 0; i < 3; ++i) s[i] = 4 * corner[i] + 2 * offset[i];
      for (int x = wall; x <= extent[0] - wall; ++x)
        for (int y = wall; y <= extent[1] - wall; ++y)
          for (int z = wall; z <= extent[2] - wall; ++z) what(place({s[0] + x, s[1] + y, s[2] + z}));
    };
    for (const Shell& shell : bricks) {
      for (const Cell& cell : shell.cells)
        for_strata(cell, 1, {4, 4, 4}, [&](std::size_t at) { winding_[at] += shell.turn; });
      for (const Square& square : border(shell.cells)) {
        Cell extent = {4, 4, 4};
        extent[square.axis] = 0;
        for_strata(square.corner, 0, extent, [&](std::size_t at) { surface_[at] = true; });
      }
    }
  }

  bool on_surface(const Cell& s) const { return surface_[place(s)]; }
  bool in_solid(const Cell& s) const { return on_surface(s) || cells_about(s).second > 0; }
  bool in_interior(const Cell& s) const
  {
    const auto [all, in] = cells_about(s);
    return all == in;
  }

 private:
  std::size_t place(const Cell& s) const
  {
    return std::size_t((s[0] - low_) + size_ * ((s[1] - low_) + size_ * (s[2] - low_)));
  }

  /// How many half cells have this stratum or border on it, and how many of them have a winding number other than 0.
  std::pair<int, int> cells_about(const Cell& s) const
  {
    std::pair<int, int> count{0, 0};
    const auto reach = [&](int i) { return s[i] % 2 == 0 ? 1 : 0; };
    for (int x = -reach(0); x <= reach(0); x += 2)
      for (int y = -reach(1); y <= reach(1); y += 2)
        for (int z = -reach(2); z <= reach(2); z += 2) {
          ++count.first;
          count.second += winding_[place({s[0] + x, s[1] + y, s[2] + z})] != 0;
        }
    return count;
  }

  int low_, size_;
  std::vector<int> winding_;
  std::vector<bool> surface_;
};

/// Two bodies in one grid of half cells, the second moved by `offset` halves of a cell.
struct Two_bodies {
  Two_bodies(const Bricks& a_, const Bricks& b_, const Cell& offset)
      : low(end(a_, b_, offset, -1)),
        high(end(a_, b_, offset, 1)),
        a(a_, {0, 0, 0}, low, high),
        b(b_, offset, low, high)
  {}

  /// Calls what(stratum, its dimension) for all strata about which there are cells.
  template <class What>
  void for_strata(const What& what) const
  {
    for (int x = low + 1; x < high; ++x)
      for (int y = low + 1; y < high; ++y)
        for (int z = low + 1; z < high; ++z) what(Cell{x, y, z}, std::abs(x % 2) + std::abs(y % 2) + std::abs(z % 2));
  }

  int low, high;
  Strata a, b;

 private:
  static int end(const Bricks& a, const Bricks& b, const Cell& offset, int sign)
  {
    int end = INT_MIN;
    for (const auto& [bricks, off] : {std::pair{&a, Cell{0, 0, 0}}, {&b, offset}})
      for (const Shell& shell : *bricks)
        for (const Cell& cell : shell.cells)
          for (int i = 0; i < 3; ++i) end = std::max(end, sign * (4 * cell[i] + 2 * off[i] + 2) + 4);
    return sign * end;
  }
};

}  // namespace

Cells block(const Cell& low, const Cell& high)
{
  Cells cells;
  for (int x = low[0]; x < high[0]; ++x)
    for (int y = low[1]; y < high[1]; ++y)
      for (int z = low[2]; z < high[2]; ++z) cells.insert({x, y, z});
  return cells;
}

covering::Polyhedron solid(const Bricks& bricks, const Division& division, Random& random)
{
  Builder builder(division, random);
  for (const Shell& shell : bricks) builder.add(shell);
  return builder.result();
}

Solid_overlap overlap(const Bricks& a, const Bricks& b, const Cell& offset)
{
  const Two_bodies bodies(a, b, offset);
  const Strata &of_a = bodies.a, &of_b = bodies.b;
  Solid_overlap result;
  bool meet = false, interiors_meet = false;
  bool a_in_b = true, b_in_a = true, a_in_interior = true, b_in_interior = true;
  std::array<long, 3> sum = {0, 0, 0};
  long count = 0;
  result.contact = {Solid_relation::disjoint, -1};
  bodies.for_strata([&](const Cell& s, int dimension) {
    const bool in_a = of_a.in_solid(s), in_b = of_b.in_solid(s);
    const bool deep_a = of_a.in_interior(s), deep_b = of_b.in_interior(s);
    meet = meet || (in_a && in_b);
    interiors_meet = interiors_meet || (deep_a && deep_b);
    a_in_b = a_in_b && (!in_a || in_b);
    b_in_a = b_in_a && (!in_b || in_a);
    a_in_interior = a_in_interior && (!in_a || deep_b);
    b_in_interior = b_in_interior && (!in_b || deep_a);
    if (of_a.on_surface(s) && of_b.on_surface(s))
      result.contact.dimension = std::max(result.contact.dimension, dimension);
    if (dimension < 3 || !deep_a || !deep_b) return;
    ++count;
    for (int i = 0; i < 3; ++i) sum[i] += s[i];
  });
  Solid_relation& relation = result.contact.relation;
  if (!meet)
    relation = Solid_relation::disjoint;
  else if (a_in_b && b_in_a)
    relation = Solid_relation::equal;
  else if (a_in_b)
    relation = a_in_interior ? Solid_relation::inside : Solid_relation::covered_by;
  else if (b_in_a)
    relation = b_in_interior ? Solid_relation::contains : Solid_relation::covers;
  else
    relation = interiors_meet ? Solid_relation::overlap : Solid_relation::meet;

  result.volume = Rational(count) / 8;
  if (count > 0)
    for (int i = 0; i < 3; ++i) result.centroid[i] = Rational(sum[i]) / Rational(4 * count);
  return result;
}

Shared_squares shared_squares(const Bricks& a, const Bricks& b, const Cell& offset)
{
  const Two_bodies bodies(a, b, offset);
  Shared_squares shared;
  bodies.for_strata([&](const Cell& s, int dimension) {
    if (dimension != 2 || !bodies.a.on_surface(s) || !bodies.b.on_surface(s)) return;
    const std::size_t axis = s[0] % 2 == 0 ? 0 : s[1] % 2 == 0 ? 1 : 2;
    Cell below = s, above = s;
    --below[axis];
    ++above[axis];
    ++shared.count[axis];
    shared.outward[axis] += int(bodies.a.in_interior(below)) - int(bodies.a.in_interior(above));
  });
  return shared;
}

namespace {

/// Returns the half cells of a body whose winding number is not 0.
std::vector<Cell> half_cells(const Bricks& bricks, const Cell& offset)
{
  std::map<Cell, int> winding;
  for (const Shell& shell : bricks)
    for (const Cell& cell : shell.cells)
      for (const Cell& half : block({0, 0, 0}, {2, 2, 2})) {
        Cell at;
        for (int i = 0; i < 3; ++i) at[i] = 2 * cell[i] + half[i] + offset[i];
        winding[at] += shell.turn;
      }
  std::vector<Cell> cells;
  for (const auto& [at, turns] : winding)
    if (turns != 0) cells.push_back(at);
  return cells;
}

}  // namespace

Solid_exits exits(const Bricks& a, const Bricks& b, const Cell& offset, int axis, int sign)
{
  // By the column of half cells along the axis: the places of the half cells in it.
  const auto columns = [&](const Bricks& bricks, const Cell& off) {
    std::map<std::pair<int, int>, std::vector<int>> columns;
    for (const Cell& at : half_cells(bricks, off))
      columns[{at[(axis + 1) % 3], at[(axis + 2) % 3]}].push_back(sign * at[axis]);
    return columns;
  };
  const auto of_a = columns(a, {0, 0, 0}), of_b = columns(b, offset);
  // Half cells of one column, which are `steps` apart, overlap at shifts of less than a half from that.
  std::set<int> steps;
  for (const auto& [column, places] : of_a)
    if (const auto other = of_b.find(column); other != of_b.end())
      for (const int from : places)
        for (const int to : other->second) steps.insert(to - from);
  if (!steps.contains(0)) return {0, 0};
  int first = 1;
  while (steps.contains(first)) ++first;
  return {Rational(first) / 2, Rational(*steps.rbegin() + 1) / 2};
}

Rational squared_depth(const Bricks& a, const Bricks& b, const Cell& offset)
{
  // Half cells overlap after translations within a cube of two halves about the step from one to the other.
  Cells steps;
  for (const Cell& from : half_cells(a, {0, 0, 0}))
    for (const Cell& to : half_cells(b, offset)) steps.insert({to[0] - from[0], to[1] - from[1], to[2] - from[2]});
  // The other translations are a closed set of cells, squares, edges and corners of the grid of halves. Coordinate 2 h
  // of one of these stands for h, and 2 h + 1 for the interval from h to h + 1.
  const auto is_free = [&](const Cell& s) {
    Cell low, high;
    for (int i = 0; i < 3; ++i) {
      low[i] = (s[i] - (s[i] & 1)) / 2;
      high[i] = low[i] + 1 + (s[i] & 1);
    }
    return std::ranges::none_of(block(low, high), [&](const Cell& step) { return steps.contains(step); });
  };
  int most = 1;
  for (const Cell& step : steps)
    for (const int x : step) most = std::max(most, 2 * std::abs(x) + 2);
  long least = LONG_MAX;
  for (int x = -most; x <= most; ++x)
    for (int y = -most; y <= most; ++y)
      for (int z = -most; z <= most; ++z) {
        // The nearest point of the interval from h to h + 1, and of h, is as many halves away.
        const long i = std::abs(x) / 2, j = std::abs(y) / 2, k = std::abs(z) / 2, square = i * i + j * j + k * k;
        if (square < least && is_free({x, y, z})) least = square;
      }
  return Rational(least) / 4;
}

}  // namespace tetracone::verify::lego
