#ifndef TETRACONE_KERNEL_BOUND_CONE_SLAB_H
#define TETRACONE_KERNEL_BOUND_CONE_SLAB_H

#include "tetracone/kernel/bound/cone_cells.h"
#include "tetracone/kernel/number/floating_point.h"

#include <array>
#include <cmath>
#include <span>

namespace tetracone::kernel {

/// A slab |n . x - d| <= 1 about what triangles have in a cell of directions, with n . x growing along each ray of the
/// cell: what is beyond it on a ray is beyond all of them, and what is before it before all.
class Cone_slab {
 public:
  /// Tells nothing.
  Cone_slab() = default;

  /// Of triangles of a model, in the wide cell whose corners these are. It tells nothing where no plane faces all of the
  /// cell.
  ///
  /// A triangle's part in the cell lies in the hull of its corners, and, where its plane faces all of the cell, of the
  /// plane's points on the cell's corners. With |N_k| <= 8, N is off by 2^-48 in a component, D = N . a by 2^-46 and g =
  /// N . direction by 2^-46: for g >= 2^-20 a point's norm r = D / g, at most 4 where it counts, is off by less than
  /// 2^-23. Rounding n / w and d / w to float adds 2^-24 (3 + 3) / w over |x|_1 <= 3: `margin` is more than both.
  Cone_slab(const Cone_cells::Corners& corners, std::span<const Local_triangle> triangles)
  {
    Local_point n{};
    for (const Local_triangle& t : triangles) {
      const Local_point normal = normal_of(t);
      const double facing = dot(normal, corners.direction[0]) < 0 ? -1 : 1;
      for (int k = 0; k < 3; ++k) n[k] += facing * normal[k];
    }
    const double length = std::sqrt(dot(n, n));
    if (!(length >= 0x1p-100)) return;
    for (double& x : n) x /= length;
    std::array<double, 4> ascent;
    for (int c = 0; c < corners.count; ++c) {
      ascent[c] = dot(n, corners.direction[c]);
      if (!(ascent[c] >= 0x1p-8)) return;
    }
    double low = 0, high = 0;
    bool is_first = true;
    for (const Local_triangle& t : triangles) {
      const double at[3] = {dot(n, t[0]), dot(n, t[1]), dot(n, t[2])};
      double least = minimum(at[0], at[1], at[2]), most = maximum(at[0], at[1], at[2]);
      narrow(t, corners, ascent, least, most);
      low = is_first ? least : minimum(low, least);
      high = is_first ? most : maximum(high, most);
      is_first = false;
    }
    const double width = maximum(0.5 * (high - low), 0.0) + margin;
    for (int k = 0; k < 3; ++k) normal_[k] = float(n[k] / width);
    offset_ = float(0.5 * (high + low) / width);
  }

  /// 1 beyond the slab, -1 before it, 0 where it does not tell. Requires a point of the cell of norm at most 4.
  int side(const Local_point& p) const
  {
    const double at = normal_[0] * p[0] + normal_[1] * p[1] + normal_[2] * p[2] - offset_;
    return at > 1 ? 1 : at < -1 ? -1 : 0;
  }

 private:
  static constexpr double margin = 0x1p-19;

  static double dot(const Local_point& a, const Local_point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  static Local_point normal_of(const Local_triangle& t)
  {
    const Local_point &a = t[0], &b = t[1], &c = t[2];
    Local_point normal;
    for (int k = 0; k < 3; ++k) {
      const int u = (k + 1) % 3, v = (k + 2) % 3;
      normal[k] = (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
    }
    return normal;
  }

  /// Heights of the plane's points on the corners of the cell, where there are such.
  static void narrow(const Local_triangle& t, const Cone_cells::Corners& corners, const std::array<double, 4>& ascent,
                     double& least, double& most)
  {
    const Local_point normal = normal_of(t);
    const double offset = dot(normal, t[0]), side = offset < 0 ? -1 : 1;
    double low = 0, high = 0;
    for (int c = 0; c < corners.count; ++c) {
      const double g = side * dot(normal, corners.direction[c]);
      if (!(g >= 0x1p-20)) return;
      const double height = side * offset / g * ascent[c];
      low = c == 0 ? height : minimum(low, height);
      high = c == 0 ? height : maximum(high, height);
    }
    if (!(high <= 4)) return;
    least = maximum(least, low);
    most = minimum(most, high);
  }

  std::array<float, 3> normal_{};
  float offset_ = 0;
};

}  // namespace tetracone::kernel

#endif
