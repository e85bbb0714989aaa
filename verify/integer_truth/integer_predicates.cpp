#include "verify/cases/tetrahedron.h"
#include "verify/integer_truth/integer_points.h"
#include "verify/integer_truth/integer_truth.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

/// The predicates on integers. Hulls and cones meet if a system of linear equations has a non-negative solution, which
/// elimination decides. Signs of orientations are used only if the predicate is one, or to decide that a case is not
/// asked.
namespace tetracone::verify::integer_truth {
namespace {

using Row = std::vector<Integer>;  ///< of an equation or inequality: the coefficients, then the constant

/// first * x - second * y, over the common divisor of its entries.
Row combined(const Integer& first, const Row& x, const Integer& second, const Row& y)
{
  Row sum(x.size());
  Integer divisor = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    sum[k] = first * x[k] - second * y[k];
    divisor = gcd(divisor, sum[k]);
  }
  if (divisor > 1)
    for (Integer& entry : sum) entry /= divisor;
  return sum;
}

/// Gauss and Jordan's elimination without fractions. For each column its pivot row, in which alone the column is not
/// zero; nothing for a column that is free.
std::vector<std::optional<std::size_t>> eliminate(std::vector<Row>& rows, std::size_t columns)
{
  std::vector<std::optional<std::size_t>> pivots(columns);
  std::size_t done = 0;
  for (std::size_t column = 0; column < columns; ++column) {
    std::size_t pivot = done;
    while (pivot < rows.size() && sgn(rows[pivot][column]) == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[done], rows[pivot]);
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (r != done && sgn(rows[r][column]) != 0)
        rows[r] = combined(rows[done][column], rows[r], Integer(rows[r][column]), rows[done]);
    pivots[column] = done++;
  }
  return pivots;
}

/// Whether some x has coefficients * x + constant >= 0 in all rows, by Fourier and Motzkin's elimination.
bool is_feasible(std::vector<Row> rows, std::size_t columns)
{
  for (std::size_t column = 0; column < columns; ++column) {
    std::vector<Row> left;
    for (const Row& row : rows)
      if (sgn(row[column]) == 0) left.push_back(row);
    for (const Row& lower : rows)
      for (const Row& upper : rows)
        if (sgn(lower[column]) > 0 && sgn(upper[column]) < 0)
          left.push_back(combined(lower[column], upper, upper[column], lower));
    rows = std::move(left);
  }
  for (const Row& row : rows)
    if (sgn(row.back()) < 0) return false;
  return true;
}

/// Whether some x >= 0 has coefficients * x = constant in all rows.
bool has_nonnegative_solution(std::vector<Row> equations)
{
  const std::size_t columns = equations[0].size() - 1;
  const auto pivots = eliminate(equations, columns);
  std::size_t rank = 0;
  for (const auto& pivot : pivots) rank += pivot.has_value();
  for (std::size_t r = rank; r < equations.size(); ++r)
    if (sgn(equations[r].back()) != 0) return false;

  std::vector<Row> inequalities;
  for (std::size_t column = 0; column < columns; ++column) {
    Row row(columns + 1);
    row[column] = 1;  // of a free unknown; one with a pivot is the constant less what the free ones take
    if (pivots[column]) {
      row = equations[*pivots[column]];
      const int direction = sgn(row[column]);
      row[column] = 0;
      for (std::size_t k = 0; k < columns; ++k) row[k] *= -direction;
      row.back() *= direction;
    }
    inequalities.push_back(std::move(row));
  }
  return is_feasible(std::move(inequalities), columns);
}

/// Whether the hull of points meets apex + the combinations with weights >= 0 of vectors, whose weights sum to 1 when
/// `convex`.
bool hull_meets(const std::vector<Integer_vector>& hull, const std::vector<Integer_vector>& vectors,
                const Integer_vector& apex, bool convex)
{
  const std::size_t columns = hull.size() + vectors.size();
  std::vector<Row> equations(5, Row(columns + 1));
  for (std::size_t k = 0; k < columns; ++k) {
    const bool of_hull = k < hull.size();
    for (int i = 0; i < 3; ++i)
      equations[i][k] = of_hull ? Integer(hull[k][i] - apex[i]) : Integer(-vectors[k - hull.size()][i]);
    equations[3][k] = of_hull ? 1 : 0;
    equations[4][k] = convex && !of_hull ? 1 : 0;
  }
  equations[3][columns] = 1;
  equations[4][columns] = convex ? 1 : 0;
  return has_nonnegative_solution(std::move(equations));
}

bool hulls_meet(const std::vector<Integer_vector>& a, const std::vector<Integer_vector>& b)
{
  return hull_meets(a, b, Integer_vector(), true);
}

bool hull_meets_cone(const std::vector<Integer_vector>& hull, const Integer_vector& apex,
                     const std::vector<Integer_vector>& through)
{
  std::vector<Integer_vector> directions;
  for (const Integer_vector& point : through) directions.push_back(difference(point, apex));
  return hull_meets(hull, directions, apex, false);
}

/// The sign of the determinant of the rows (a, 1), (b, 1), (c, 1), (d, 1), which is det[a-d, b-d, c-d]: Bareiss'
/// elimination, whose divisions have no remainder.
int orientation(const Integer_vector& a, const Integer_vector& b, const Integer_vector& c, const Integer_vector& d)
{
  std::array<std::array<Integer, 4>, 4> m;
  int sign = 1, row = 0;
  for (const Integer_vector* point : {&a, &b, &c, &d}) {
    for (int i = 0; i < 3; ++i) m[row][i] = (*point)[i];
    m[row++][3] = 1;
  }
  Integer last = 1;
  for (int k = 0; k < 3; ++k) {
    int pivot = k;
    while (pivot < 4 && sgn(m[pivot][k]) == 0) ++pivot;
    if (pivot == 4) return 0;
    if (pivot != k) {
      std::swap(m[k], m[pivot]);
      sign = -sign;
    }
    for (int i = k + 1; i < 4; ++i)
      for (int j = k + 1; j < 4; ++j) m[i][j] = (m[k][k] * m[i][j] - m[i][k] * m[k][j]) / last;
    last = m[k][k];
  }
  return sign * sgn(m[3][3]);
}

/// The position of p in the closed surface of the four faces of v: the object level's own answer, with p as the other
/// polyhedron.
int place_in_solid(const Predicate_case& c)
{
  covering::Polyhedron faces, point;
  add_tetrahedron(faces, c.v);
  point.vertices = {c.p};
  point.add_polygon({0});
  const Object_case bodies = {std::make_shared<const covering::Polyhedron>(faces),
                              std::make_shared<const covering::Polyhedron>(point),
                              c.pose_a,
                              c.pose_b,
                              {},
                              {},
                              {}};
  if (collide(bodies, kernel::Question::surface)) return 0;
  return collide(bodies, kernel::Question::solid) ? 1 : -1;
}

}  // namespace

std::optional<int> answer(Predicate predicate, const Predicate_case& c)
{
  if (predicate == Predicate::solid) return place_in_solid(c);
  Integer_points of_a = placed(c.v, c.pose_a), of_b = placed(std::array{c.p, c.q, c.r}, c.pose_b);
  bring_together(of_a, of_b);
  const auto& v = of_a.points;
  const auto& [p, q, r] = std::tie(of_b.points[0], of_b.points[1], of_b.points[2]);
  switch (predicate) {
    case Predicate::orientation: return orientation(v[1], v[2], v[3], p);
    case Predicate::tetra_cone:
      if (orientation(v[0], v[1], v[2], v[3]) == 0) return std::nullopt;
      return hull_meets_cone({p}, v[0], {v[1], v[2], v[3]});
    case Predicate::tetrahedron:
      if (orientation(v[0], v[1], v[2], v[3]) == 0) return std::nullopt;
      return hulls_meet({p}, v);
    case Predicate::segment_triangle: return hulls_meet({p, q}, {v[1], v[2], v[3]});
    case Predicate::classification:
      if (orientation(v[0], v[1], v[2], v[3]) == 0 || orientation(v[0], p, q, r) == 0) return std::nullopt;
      return hull_meets_cone({p, q, r}, v[0], {v[1], v[2], v[3]});
    case Predicate::triangle_triangle: return hulls_meet({p, q, r}, {v[1], v[2], v[3]});
    case Predicate::solid: break;
  }
  return std::nullopt;
}

}  // namespace tetracone::verify::integer_truth
