#ifndef TETRACONE_TETRATREE_SCENE_BODY_EXTENT_H
#define TETRACONE_TETRATREE_SCENE_BODY_EXTENT_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/fast/support_table.h"
#include "tetracone/tetratree/scene/world_box.h"

#include <array>
#include <cmath>
#include <cstddef>
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

/// A coordinate of the image of a box, by a row m of a map and its translation t: of the centre, how far it reaches from
/// there, and the magnitudes of all terms.
template <class Number>
struct Placed_coordinate {
  Number at, reach, terms;

  Placed_coordinate(const std::array<Number, 3>& m, const Number& t, const std::array<Number, 3>& centre,
                    const std::array<Number, 3>& half)
      : at(t), reach(0), terms(magnitude(t))
  {
    for (std::size_t j = 0; j < 3; ++j) {
      const Number size = magnitude(m[j]);
      at = at + m[j] * centre[j];
      reach = reach + size * half[j];
      terms = terms + size * (magnitude(centre[j]) + half[j]);
    }
  }

 private:
  static Number magnitude(const Number& x)
  {
    using std::abs;
    return abs(x);
  }
};
inline Placed_coordinate<double> placed_coordinate(const Body_extent& extent, const kernel::Pose& pose, int i)
{
  return {{pose[4 * i], pose[4 * i + 1], pose[4 * i + 2]}, pose[4 * i + 3], extent.centre, extent.half};
}

/// About the placed body: the image of the box of its model, |x_i - M_i c - t_i| <= sum_j |M_ij| half_j.
inline World_box world_box(const Body_extent& extent, const kernel::Pose& pose)
{
  World_box box;
  for (int i = 0; i < 3; ++i) {
    const Placed_coordinate<double> x = placed_coordinate(extent, pose, i);
    const double slack = placed_rounding * x.terms + placed_underflow;
    box.low[i] = rounded_below(x.at - x.reach - slack);
    box.high[i] = rounded_above(x.at + x.reach + slack);
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
    const kernel::Four_floats d = {float(pose[4 * i]), float(pose[4 * i + 1]), float(pose[4 * i + 2]), 0};
    const kernel::Four_floats norm = kernel::sum_of_lanes(kernel::magnitudes(d));
    if (!(norm[0] >= 1e-30f && norm[0] <= 1e30f)) return {};
    const auto reach = [&](const Support_table::Place& place) {
      float found = kernel::sum_of_lanes(table.reach(place))[0];
      if (!(found < std::numeric_limits<float>::infinity())) {
        table.find(place);
        found = kernel::sum_of_lanes(table.reach(place))[0];
      }
      return scale.unit * (double(found) + double(Support_table::slack + slack_of_direction) * double(norm[0]));
    };
    const double slack = placed_rounding * terms + placed_underflow;
    const Support_table::Place place = Support_table::place(d, norm);
    const double up = reach(place), down = reach(Support_table::opposite(place));
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
    std::array<double, 3> change;
    double entries = std::abs(to[4 * i + 3]) + std::abs(from[4 * i + 3]);
    for (std::size_t j = 0; j < 3; ++j) {
      const double p = from[4 * i + int(j)], q = to[4 * i + int(j)];
      change[j] = q - p;
      entries += (std::abs(p) + std::abs(q)) * (std::abs(extent.centre[j]) + extent.half[j]);
    }
    const Placed_coordinate<double> x(change, to[4 * i + 3] - from[4 * i + 3], extent.centre, extent.half);
    const double along = std::abs(x.at) + x.reach + placed_rounding * x.terms + 2 * rounding_of_entries * entries;
    squares += along * along;
  }
  // Squares that underflow are of what is far below the last term.
  return std::sqrt(squares) * (1 + 0x1p-48) + 0x1p-500;
}

}  // namespace tetracone::tetratree

#endif
