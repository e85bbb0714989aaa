#ifndef TETRACONE_TETRATREE_SCENE_BODY_EXTENT_H
#define TETRACONE_TETRATREE_SCENE_BODY_EXTENT_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/fast/support_table.h"
#include "tetracone/tetratree/scene/world_box.h"

#include <array>
#include <cmath>
#include <span>

namespace tetracone::tetratree {

/// A box about the vertices of a body where it was modelled: what bounds its place and its motion under any pose,
/// before there is a tree.
struct Body_extent {
  std::array<double, 3> centre{}, half{};

  Body_extent() = default;
  /// Requires a vertex.
  explicit Body_extent(std::span<const kernel::Vertex> vertices)
  {
    for (int k = 0; k < 3; ++k) {
      double low = vertices[0][k], high = low;
      for (const kernel::Vertex& v : vertices) {
        low = kernel::minimum(low, v[k]);
        high = kernel::maximum(high, v[k]);
      }
      centre[k] = 0.5 * low + 0.5 * high;
      // The rounded centre is between them; each difference is off by one rounding.
      half[k] = kernel::maximum(high - centre[k], centre[k] - low) * (1 + 0x1p-50);
    }
  }

  /// Whether a box turned with the body bounds it much better than one along the world's axes.
  bool is_long() const
  {
    return kernel::maximum(half[0], half[1], half[2]) >= 2 * kernel::minimum(half[0], half[1], half[2]);
  }
};

/// What the bounds below may lose by rounding, a share of the magnitudes of their terms: four roundings of a sum of
/// products, as many of a second such sum, one of each entry of a fraction, two of what joins both; and what products
/// lose by underflow.
inline constexpr double placed_rounding = 16 * kernel::unit_roundoff<double>, placed_underflow = 0x1p-1000;

/// About the placed body: the image of the box of its model, |x_i - M_i c - t_i| <= sum_j |M_ij| half_j.
inline World_box world_box(const Body_extent& extent, const kernel::Pose& pose)
{
  World_box box;
  for (int i = 0; i < 3; ++i) {
    double at = pose[4 * i + 3], reach = 0, terms = std::abs(at);
    for (int j = 0; j < 3; ++j) {
      const double m = pose[4 * i + j], size = std::abs(m);
      at += m * extent.centre[j];
      reach += size * extent.half[j];
      terms += size * (std::abs(extent.centre[j]) + extent.half[j]);
    }
    const double slack = placed_rounding * terms + placed_underflow;
    box.low[i] = rounded_below(at - reach - slack);
    box.high[i] = rounded_above(at + reach + slack);
  }
  return box;
}

/// The same by how far the body itself reaches along each axis: unit h(M_i) from its local origin. A direction is
/// rounded to float, which moves h by as much of |M_i|_1, since |p_k| <= 1 locally; its norm is a rounded sum.
///
/// `table` is the body's, `scale` its tree's.
inline World_box world_box(Support_table& table, const kernel::Local_scale& scale, const kernel::Pose& pose)
{
  constexpr float slack_of_direction = 4 * kernel::unit_roundoff<float>;
  World_box box;
  for (int i = 0; i < 3; ++i) {
    double at = pose[4 * i + 3], terms = std::abs(at);
    for (int j = 0; j < 3; ++j) {
      const double part = pose[4 * i + j] * scale.origin[j];
      at += part;
      terms += std::abs(part);
    }
    const auto reach = [&](float sign) {
      const kernel::Four_floats d = {sign * float(pose[4 * i]), sign * float(pose[4 * i + 1]),
                                     sign * float(pose[4 * i + 2]), 0};
      const kernel::Four_floats norm = kernel::sum_of_lanes(kernel::magnitudes(d));
      if (!(norm[0] >= 1e-30f && norm[0] <= 1e30f)) return std::numeric_limits<double>::infinity();
      const Support_table::Place place = Support_table::place(d, norm);
      float found = kernel::sum_of_lanes(table.reach(place))[0];
      if (!(found < std::numeric_limits<float>::infinity())) {
        table.find(place);
        found = kernel::sum_of_lanes(table.reach(place))[0];
      }
      return scale.unit * (double(found) + double(Support_table::slack + slack_of_direction) * double(norm[0]));
    };
    const double slack = placed_rounding * terms + placed_underflow;
    const double up = reach(1), down = reach(-1);
    // The sums' own roundings are shares of what they are made of.
    box.high[i] = rounded_above(at + up + slack + placed_rounding * (std::abs(at) + std::abs(up)));
    box.low[i] = rounded_below(at - down - slack - placed_rounding * (std::abs(at) + std::abs(down)));
  }
  return box;
}

/// At least how far any point of the body moves from one pose to the other: per axis, that is |dM_i c + dt_i| + sum_j
/// |dM_ij| half_j. Infinite or undefined where nothing is known; 0 only of equal poses.
inline double motion(const Body_extent& extent, const kernel::Pose& from, const kernel::Pose& to)
{
  if (from == to) return 0;
  // The entries of fractions are rounded, each on its own.
  const double rounding_of_entries = from.is_rational() || to.is_rational() ? kernel::unit_roundoff<double> : 0;
  double squares = 0;
  for (int i = 0; i < 3; ++i) {
    const double dt = to[4 * i + 3] - from[4 * i + 3];
    double at = dt, reach = 0, terms = std::abs(dt), entries = std::abs(to[4 * i + 3]) + std::abs(from[4 * i + 3]);
    for (int j = 0; j < 3; ++j) {
      const double p = from[4 * i + j], q = to[4 * i + j], dm = q - p;
      const double farthest = std::abs(extent.centre[j]) + extent.half[j];
      at += dm * extent.centre[j];
      reach += std::abs(dm) * extent.half[j];
      terms += std::abs(dm) * farthest;
      entries += (std::abs(p) + std::abs(q)) * farthest;
    }
    const double along = std::abs(at) + reach + placed_rounding * terms + 2 * rounding_of_entries * entries;
    squares += along * along;
  }
  // Squares that underflow are of what is far below the last term.
  return std::sqrt(squares) * (1 + 0x1p-48) + 0x1p-500;
}

}  // namespace tetracone::tetratree

#endif
