#ifndef TETRACONE_KERNEL_BOUND_CONE_SLAB_H
#define TETRACONE_KERNEL_BOUND_CONE_SLAB_H

#include "tetracone/kernel/bound/cone_cells.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"

#include <array>
#include <cmath>
#include <span>

namespace tetracone::kernel {

/// A slab |n . x - d| <= 1 about the parts of triangles in a cell of directions, where n . x grows along each ray of
/// the cell. A point beyond the slab on a ray is beyond all the triangles; a point before it is before all.
class Cone_slab {
 public:
  /// A slab that answers nothing: `side` is 0.
  Cone_slab() = default;

  /// The slab of triangles of a model, in the wide cell with these corners. It answers nothing where no plane faces all
  /// of the cell.
  ///
  /// A triangle's part in the cell lies in the hull of its corners. Where its plane faces all of the cell, the part
  /// also lies in the hull of the plane's points on the cell's corners. These are at D / g, g = N . direction, times
  /// their ascent. `margin` is an upper bound of the errors of these heights, which are at most `highest`. It covers
  /// also the errors of n / w and d / w, rounded to float, over |x|_1 <= 4.
  Cone_slab(const Cone_cells::Corners& corners, std::span<const Local_facet> facets)
  {
    Local_point n{};
    for (const Local_facet& f : facets)
      for (int k = 0; k < 3; ++k) n[k] += f.offset < 0 ? -f.normal[k] : f.normal[k];
    const double length = std::sqrt(dot(n, n));
    if (!(length >= 0x1p-100)) return;
    for (double& x : n) x /= length;
    std::array<double, 4> ascent;
    for (std::size_t c = 0; c < 4; ++c) ascent[c] = dot(n, corners[c]);
    if (!(minimum(ascent[0], ascent[1], ascent[2], ascent[3]) >= 0x1p-8)) return;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Local_facet& f : facets) {
      const double at[3] = {dot(n, f.corner[0]), dot(n, f.corner[1]), dot(n, f.corner[2])};
      double least = minimum(at[0], at[1], at[2]), most = maximum(at[0], at[1], at[2]);
      narrow(f, corners, ascent, least, most);
      low = minimum(low, least);
      high = maximum(high, most);
    }
    const double width = maximum(0.5 * (high - low), 0.0) + margin;
    for (int k = 0; k < 3; ++k) normal_[k] = float(n[k] / width);
    offset_ = float(0.5 * (high + low) / width);
  }

  /// Returns 1 beyond the slab, -1 before it, 0 where it does not tell. Requires a point of the cell of norm at most 4.
  int side(const Local_point& p) const
  {
    const double at = normal_[0] * p[0] + normal_[1] * p[1] + normal_[2] * p[2] - offset_;
    return int(at > 1) - int(at < -1);
  }

  /// Upper bound of the errors of the heights of triangles and of points: verify/proofs/cone_proofs.h.
  static constexpr double margin = 0x1p-19;
  static constexpr double least_slope = 0x1p-20,  ///< the least slope g of a plane that is used
      highest = 4;                                ///< the largest height of a plane that is used

 private:
  /// Narrows the bounds to the heights of the plane's points on the cell's corners, if the plane faces all of the cell.
  static void narrow(const Local_facet& f, const Cone_cells::Corners& corners, const std::array<double, 4>& ascent,
                     double& least, double& most)
  {
    const double side = f.offset < 0 ? -1 : 1;
    std::array<double, 4> g, height;
    for (std::size_t c = 0; c < 4; ++c) g[c] = side * dot(f.normal, corners[c]);
    if (!(minimum(g[0], g[1], g[2], g[3]) >= least_slope)) return;
    for (std::size_t c = 0; c < 4; ++c) height[c] = side * f.offset / g[c] * ascent[c];
    const double high = maximum(height[0], height[1], height[2], height[3]);
    if (!(high <= highest)) return;
    least = maximum(least, minimum(height[0], height[1], height[2], height[3]));
    most = minimum(most, high);
  }

  std::array<float, 3> normal_{};
  float offset_ = 0;
};

}  // namespace tetracone::kernel

#endif
