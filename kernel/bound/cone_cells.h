#ifndef TETRACONE_KERNEL_BOUND_CONE_CELLS_H
#define TETRACONE_KERNEL_BOUND_CONE_CELLS_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace tetracone::kernel {

/// A point in local units, relative to the origin of a covering. A point of a model has coordinates |x| <= 1, with an
/// error of at most `local_error` each.
using Local_point = std::array<double, 3>;
using Local_triangle = std::array<Local_point, 3>;
/// Upper bound of the error of a local coordinate of a model: verify/proofs/cone_proofs.h.
inline constexpr double local_error = 0x1p-51;

/// Returns |x| + |y| + |z|.
inline double octahedral_norm(const Local_point& p) { return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]); }

/// Upper bound of the error of `cone_determinant` in double (verify/proofs/distance_proofs.h). a and b are points of a
/// model; the norm of p is at most 4.
///
/// For |a_k|, |b_k| <= 1 the minors of a and b are at most 2. So the six products sum to at most 8 in absolute value,
/// each rounded at most five times. Errors of the coordinates add at most 8 e for a, 8 e for b and 6 e for p, e =
/// `local_error`. The sum of all errors is below 2^-46.
inline constexpr double cone_side_bound = 0x1p-44;
/// Returns det[a, b, p].
template <class Number>
Number cone_determinant(const std::array<Number, 3>& a, const std::array<Number, 3>& b, const std::array<Number, 3>& p)
{
  return determinant(a, b, p);
}
/// Returns the sign of det[a, b, p]; 0 where the filter is uncertain.
inline int cone_side(const Local_point& a, const Local_point& b, const Local_point& p)
{
  const double side = cone_determinant(a, b, p);
  return side > cone_side_bound ? 1 : side < -cone_side_bound ? -1 : 0;
}

/// The answer of `cone_holds` where the filter is uncertain.
inline constexpr int cone_undecided = 2;
/// Returns how the edges of the triangle w a b turn about p, 1 or -1, where the line from the origin through p meets
/// its interior. Returns 0 where the line misses it, and `cone_undecided` where the filter is uncertain.
inline int cone_holds(const Local_point& w, const Local_point& a, const Local_point& b, const Local_point& p)
{
  const double wa = cone_determinant(w, a, p), ab = cone_determinant(a, b, p), bw = cone_determinant(b, w, p);
  const double least = -maximum_of_defined(-wa, -ab, -bw), most = maximum_of_defined(wa, ab, bw);
  if (least < -cone_side_bound && most > cone_side_bound) return 0;
  return least > cone_side_bound ? 1 : most < -cone_side_bound ? -1 : cone_undecided;
}

/// Upper bound of the error of `plane_determinant` in double: verify/proofs/distance_proofs.h.
///
/// Differences are at most 2 among corners, and those from p sum to at most 7. Minors are at most 8, products at most
/// 56 in all, each rounded at most eight times with its differences. Errors of the coordinates, 2 e in a difference,
/// add at most 2 e (28 + 28 + 24). The sum of all errors is below 2^-43.
inline constexpr double plane_side_bound = 0x1p-42;
/// Returns det[b - a, c - a, p - a].
template <class Number>
Number plane_determinant(const std::array<Number, 3>& a, const std::array<Number, 3>& b, const std::array<Number, 3>& c,
                         const std::array<Number, 3>& p)
{
  return determinant(difference(b, a), difference(c, a), difference(p, a));
}
/// Returns the sign of det[b - a, c - a, p - a], the side of the plane a b c on which p lies. Returns 0 where the
/// filter is uncertain.
inline int plane_side(const Local_point& a, const Local_point& b, const Local_point& c, const Local_point& p)
{
  const double side = plane_determinant(a, b, c, p);
  return side > plane_side_bound ? 1 : side < -plane_side_bound ? -1 : 0;
}

/// A triangle of a model, with its plane normal . x = offset.
struct Local_facet {
  Local_triangle corner;
  Local_point normal;
  double offset;

  explicit Local_facet(const Local_triangle& triangle) : corner(triangle)
  {
    normal = normal_of(corner);
    offset = dot(normal, corner[0]);
  }

  // Both are proved in verify/proofs/cone_proofs.h.
  static constexpr double normal_error = 0x1p-46,  ///< upper bound of the error of a component of the normal
      offset_error = 0x1p-43;                      ///< upper bound of the error of the offset
};

/// Cells of directions about an origin. Each octant of the octahedron |x| + |y| + |z| = 1 has an n x n lattice, whose
/// half below the diagonal is used. (JS08 section 2.1 halves the edges of the same octahedron.)
///
/// In an octant, coordinates are taken as positive. There r = x + y + z is linear, and central projection (a, b, c) = n
/// (x, y, z) / r maps triangles to triangles. Cell (i, j) is i <= a <= i + 1, j <= b <= j + 1 and c >= 0. Its *wide*
/// cell extends `wide_margin` farther on all sides, also across the sides of the octant, with the octant's r.
///
/// A direction in local units whose norm is at least `core` lies, with its error, in the wide cell that it is given.
/// All that `for_cells` states of a cell holds for its wide cell. So it stays true when a point is moved by an
/// infinitesimal, or was assigned to the neighbour of its cell.
class Cone_cells {
 public:
  static constexpr int most = 1 << 10;     ///< the largest n
  static constexpr double core = 0x1p-20;  ///< least norm of a point for which cells answer

  /// The width by which a wide cell extends beyond its cell: an upper bound of the error of lattice coordinates
  /// (verify/proofs/cone_proofs.h).
  static constexpr double wide_margin = 0x1p-10;
  /// The width by which intervals of a, b and c are extended: `wide_margin`, and the error of clipped corners
  /// (verify/proofs/cone_proofs.h).
  static constexpr double lattice_margin = 0x1p-8;
  /// The width by which intervals of norms are extended: the errors of norms and points, and their rounding to float
  /// (verify/proofs/cone_proofs.h).
  static constexpr double norm_margin = 0x1p-21;
  // Both are divided by n, and proved in verify/proofs/cone_proofs.h.
  static constexpr double widening = 0x1p-9,  ///< widens the octant to which triangles are clipped
      near_side = 0x1p-7;  ///< upper bound of a corner's distance beyond it, for triangles in it of norms up to 3
  /// Upper bound of the error of the norm at which a plane meets a direction, both known in double:
  /// verify/proofs/cone_proofs.h.
  static constexpr double plane_margin = 0x1p-24;
  /// The least slope g of a plane that is used: see `Plane`.
  static constexpr double least_slope = 0x1p-16;

  /// Returns a lattice coordinate, n a / r, of a point of coordinate a and norm r.
  template <class Number>
  static Number on_lattice(const Number& coordinate, const Number& n, const Number& norm)
  {
    return coordinate * (n / norm);
  }
  /// Returns a coordinate of the point at a share of an edge.
  template <class Number>
  static Number on_edge(const Number& from, const Number& to, const Number& share)
  {
    return from + share * (to - from);
  }
  /// Returns the change of a plane's g by a step of the lattice, from its components along a and c.
  template <class Number>
  static Number slope_of_step(const Number& along_a, const Number& along_c, const Number& n)
  {
    return (along_a - along_c) / n;
  }
  /// Returns g at a point of the lattice.
  template <class Number>
  static Number slope_at(const Number& along_c, const Number& per_a, const Number& a, const Number& per_b,
                         const Number& b)
  {
    return along_c + per_a * a + per_b * b;
  }
  /// Returns an upper bound of the change of g from the middle of a cell to any point of the widened cell.
  template <class Number>
  static Number half_spread(const Number& per_a, const Number& per_b)
  {
    using std::abs;
    return (abs(per_a) + abs(per_b)) * Number(0.5 + lattice_margin);
  }

  /// Requires 1 <= n <= most.
  explicit Cone_cells(int n) : n_(n) {}

  int n() const { return n_; }
  /// Returns the number of cells.
  std::size_t count() const { return 8 * octant_size(); }

  /// Returns the number of the cell of a point. Requires that `norm` is its `octahedral_norm`, and at least `core`.
  std::size_t cell(const Local_point& p, double norm) const
  {
    const double scale = n_ / norm;
    const int i = minimum(int(std::abs(p[0]) * scale), n_ - 1);
    const int j = minimum(int(std::abs(p[1]) * scale), n_ - 1 - i);
    const std::size_t octant = std::size_t(p[0] < 0) + 2 * std::size_t(p[1] < 0) + 4 * std::size_t(p[2] < 0);
    return octant * octant_size() + row(i) + std::size_t(j);
  }

  /// Directions whose convex hull holds a wide cell. Their norm is 1 by the octant's r. Two are equal for a triangle.
  using Corners = std::array<Local_point, 4>;

  /// Calls what(cell, direction, corners) for every cell in order, with a direction of norm 1 well within it.
  template <class What>
  void for_directions(const What& what) const
  {
    std::size_t cell = 0;
    for (int octant = 0; octant < 8; ++octant)
      for (int i = 0; i < n_; ++i)
        for (int j = 0; i + j < n_; ++j) {
          const double a = (i + 1.0 / 3) / n_, b = (j + 1.0 / 3) / n_;
          what(cell++, turned(octant, a, b), corners(octant, i, j));
        }
  }

  /// Calls what(cell, low, high) for each cell whose wide cell the triangle may meet at a norm of `core` or more. All
  /// norms at which it does are strictly between low and high, by more than the error of a norm. Returns false when the
  /// triangle may come nearer to the origin than `core`. Requires a model's points.
  ///
  /// The triangle is clipped to the octant, a little widened, and to r >= core / 4.
  template <class What>
  bool for_cells(const Local_facet& facet, const What& what) const
  {
    bool is_beyond_core = true;
    unsigned reached[2] = {0, 0};  // axes on whose positive, negative side a corner is, or nearly
    for (const Local_point& p : facet.corner)
      for (int k = 0; k < 3; ++k) {
        if (p[k] >= -near_side / n_) reached[0] |= 1u << k;
        if (p[k] <= near_side / n_) reached[1] |= 1u << k;
      }
    for (unsigned octant = 0; octant < 8; ++octant) {
      if (((~octant & ~reached[0]) | (octant & ~reached[1])) & 7) continue;
      Polygon part = in_octant(facet.corner, octant);
      const double wider = widening / n_;
      for (int k = 0; k < 3 && part.count > 0; ++k)
        part.clip([&](const Local_point& p) { return p[k] + wider * (p[0] + p[1] + p[2]); });
      for (int k = 0; k < part.count; ++k) is_beyond_core = is_beyond_core && norm(part.corner[k]) > 2 * core;
      if (!is_beyond_core) part.clip([](const Local_point& p) { return norm(p) - core / 4; });
      if (part.count > 0) place(octant, part, Plane(facet, octant, n_), what);
    }
    return is_beyond_core;
  }

 private:
  struct Polygon {
    std::array<Local_point, 16> corner;  // 7, and those that rounding may add
    int count = 0;

    /// Clips the polygon to the points where the linear function is not negative.
    template <class Function>
    void clip(const Function& value)
    {
      std::array<double, 16> at;
      bool all = true;
      for (int k = 0; k < count; ++k) {
        at[k] = value(corner[k]);
        all = all && at[k] >= 0;
      }
      if (all) return;
      Polygon left;
      for (int k = 0; k < count; ++k) {
        const int next = k + 1 == count ? 0 : k + 1;
        if (at[k] >= 0) left.corner[left.count++] = corner[k];
        if ((at[k] >= 0) == (at[next] >= 0)) continue;
        const double share = at[k] / (at[k] - at[next]);
        Local_point& cut = left.corner[left.count++];
        for (int c = 0; c < 3; ++c) cut[c] = on_edge(corner[k][c], corner[next][c], share);
      }
      *this = left;
    }
  };

  std::size_t octant_size() const { return std::size_t(n_) * std::size_t(n_ + 1) / 2; }
  std::size_t row(int i) const { return std::size_t(i) * std::size_t(2 * n_ - i + 1) / 2; }

  /// Returns the direction (a, b, 1 - a - b) of an octant.
  static Local_point turned(int octant, double a, double b)
  {
    return {octant & 1 ? -a : a, octant & 2 ? -b : b, octant & 4 ? a + b - 1 : 1 - a - b};
  }

  /// Returns the corners of cell (i, j), or of its half below the diagonal where the diagonal crosses it.
  Corners corners(int octant, int i, int j) const
  {
    const auto at = [&](double a, double b) { return turned(octant, a / n_, b / n_); };
    constexpr double m = lattice_margin;
    const Local_point first = at(i - m, j - m);
    if (i + j == n_ - 1) return {first, first, at(i + 1 + 3 * m, j - m), at(i - m, j + 1 + 3 * m)};
    return {first, at(i + 1 + m, j - m), at(i - m, j + 1 + m), at(i + 1 + m, j + 1 + m)};
  }

  static double norm(const Local_point& in_octant) { return in_octant[0] + in_octant[1] + in_octant[2]; }

  static Polygon in_octant(const Local_triangle& triangle, unsigned octant)
  {
    Polygon turned;
    turned.count = 3;
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < 3; ++c) turned.corner[k][c] = octant >> c & 1 ? -triangle[k][c] : triangle[k][c];
    return turned;
  }

  /// The plane of a triangle in the coordinates of an octant. Along a direction (a, b, c) / n it is at the norm D / g,
  /// g linear in a and b. So the norm over a cell is between those at its corners, where g keeps its sign.
  class Plane {
   public:
    Plane(const Local_facet& facet, unsigned octant, int n) : offset_(facet.offset)
    {
      const auto turned = [&](unsigned k) { return octant >> k & 1 ? -facet.normal[k] : facet.normal[k]; };
      along_c_ = turned(2);
      per_a_ = slope_of_step(turned(0), along_c_, double(n));
      per_b_ = slope_of_step(turned(1), along_c_, double(n));
      half_spread_ = half_spread(per_a_, per_b_);
    }

    /// Narrows the bounds of the norms within wide cell (i, j), if the plane faces all of it.
    void narrow(int i, int j, double& low, double& high) const
    {
      const double middle = slope_at(along_c_, per_a_, i + 0.5, per_b_, j + 0.5);
      const double side = middle > 0 ? 1 : -1, far = side * middle - half_spread_;
      if (!(far >= least_slope)) return;
      low = maximum(low, side * offset_ / (side * middle + half_spread_) - plane_margin);
      high = minimum(high, side * offset_ / far + plane_margin);
    }

   private:
    double offset_, along_c_, per_a_, per_b_, half_spread_;
  };

  template <class What>
  void place(unsigned octant, const Polygon& part, const Plane& plane, const What& what) const
  {
    double low[4], high[4];  // of a, b, c and r
    for (int k = 0; k < part.count; ++k) {
      const Local_point& p = part.corner[k];
      const double r = norm(p), n = n_;
      const double at[4] = {on_lattice(p[0], n, r), on_lattice(p[1], n, r), on_lattice(p[2], n, r), r};
      for (int c = 0; c < 4; ++c) {
        low[c] = k == 0 ? at[c] : minimum(low[c], at[c]);
        high[c] = k == 0 ? at[c] : maximum(high[c], at[c]);
      }
    }
    for (int c = 0; c < 3; ++c) {
      low[c] -= lattice_margin;
      high[c] += lattice_margin;
    }
    const auto whole = [this](double x) { return std::clamp(int(std::floor(x)), -1, n_); };
    const int first_i = maximum(0, whole(low[0])), last_i = minimum(n_ - 1, whole(high[0]));
    for (int i = first_i; i <= last_i; ++i) {
      const int first_j = maximum(0, whole(low[1]), int(std::ceil(n_ - i - 2 - high[2])));
      const int last_j = minimum(n_ - 1 - i, whole(high[1]), int(std::floor(n_ - i - low[2])));
      const bool several = last_i - first_i + last_j - first_j > 1;
      for (int j = first_j; j <= last_j; ++j) {
        double r_low = low[3], r_high = high[3];
        if (several) plane.narrow(i, j, r_low, r_high);
        if (r_low <= r_high)
          what(octant * octant_size() + row(i) + std::size_t(j), float(r_low - norm_margin),
               float(r_high + norm_margin));
      }
    }
  }

  int n_;
};

}  // namespace tetracone::kernel

#endif
