#ifndef TETRACONE_TETRATREE_SCENE_BODY_EXTENT_H
#define TETRACONE_TETRATREE_SCENE_BODY_EXTENT_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/simd/short_vectors.h"
#include "tetracone/tetratree/fast/support_table.h"
#include "tetracone/tetratree/scene/world_box.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace tetracone::tetratree {

/// Upper bound of the relative error of a root of a sum of squares, and of the product and sums after it
/// (verify/proofs/scene_proofs.h).
inline constexpr double step_rounding = 0x1p-48;

/// Upper bound of the absolute error of the bounds below by an entry that underflows, for each unit of |c_j| + half_j
/// (verify/proofs/scene_proofs.h). Under 2^-1022 a product, and the nearest double of a fraction, have an error of at
/// most 2^-1075 =: e, whatever their size.
///
/// An entry's error is multiplied with |c_j| + half_j, the centre and half the extent of a body's box. A step between
/// two poses has the largest error. It is 6 e in the centre's images, one for each pose in three rows, and 2 e sqrt(3)
/// times `reach_in_halves` <= 2 in the rotation.
inline constexpr double entry_underflow = 0x1p-1072;
/// Upper bound of the absolute error by products, and by roots of sums of at most 37 squares that underflow: 37^(1/2)
/// e^(1/2) (verify/proofs/scene_proofs.h).
inline constexpr double placed_underflow = 0x1p-534;

/// Returns the square of a coordinate's distance from the centre, in units of half the extent.
template <class Number>
Number square_in_halves(const Number& vertex, const Number& centre, const Number& half)
{
  const Number part = (vertex - centre) / half;
  return part * part;
}

/// A box about the vertices of a model. It bounds where a body is, and its motion, under any pose, before there is a
/// tree.
struct Body_extent {
  std::array<double, 3> centre{}, half{};
  /// Upper bound of the length of a vertex minus the centre, each coordinate in units of its half: 1 for a ball, the
  /// root of 3 for corners.
  double reach_in_halves = 2;
  /// Upper bound of the absolute error of a coordinate of an image, and of a step. It is `placed_underflow`, plus
  /// `entry_underflow` times the sum of |c_j| + half_j. It matters where poses undo coordinates near the largest
  /// double.
  double underflow = placed_underflow;

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
      // Each difference has one rounding.
      half[k] = kernel::maximum(high - centre[k], centre[k] - low) * (1 + 0x1p-50);
      underflow += entry_underflow * std::abs(centre[k]) + entry_underflow * half[k];
    }
    double most = 0;
    for (const kernel::Vertex& v : vertices) {
      double square = 0;
      for (int k = 0; k < 3; ++k) {
        if (half[k] > 0) square += square_in_halves(v[k], centre[k], half[k]);
      }
      most = kernel::maximum(most, square);
    }
    if (most <= 3) reach_in_halves = std::sqrt(most) * (1 + step_rounding);
  }

  /// True when a box turned with the body bounds it much better than one along the world's axes.
  bool is_long() const
  {
    return kernel::maximum(half[0], half[1], half[2]) >= 2 * kernel::minimum(half[0], half[1], half[2]);
  }
};

/// Upper bound of the error of the bounds below, as a fraction of the sum of their terms' magnitudes
/// (verify/proofs/scene_proofs.h). It covers four roundings of a sum of products and four of a second such sum. It also
/// covers one rounding of each entry of a fraction, and two of the total. Absolute errors are `Body_extent::underflow`.
inline constexpr double placed_rounding = 16 * kernel::unit_roundoff<double>;

/// A coordinate of the image of a box, by a row m of a map and its translation t: `at` of the centre, `reach` from
/// there, and `terms`, the sum of the magnitudes of all terms.
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
/// Returns coordinate i of the image of the box of `extent`.
inline Placed_coordinate<double> placed_coordinate(const Body_extent& extent, const kernel::Pose& pose, int i)
{
  return {{pose[4 * i], pose[4 * i + 1], pose[4 * i + 2]}, pose[4 * i + 3], extent.centre, extent.half};
}

/// Returns a box about the placed body, the image of its model's box: |x_i - M_i c - t_i| <= sum_j |M_ij| half_j.
inline World_box world_box(const Body_extent& extent, const kernel::Pose& pose)
{
  World_box box;
  for (int i = 0; i < 3; ++i) {
    const Placed_coordinate<double> x = placed_coordinate(extent, pose, i);
    const double slack = placed_rounding * x.terms + extent.underflow;
    box.low[i] = rounded_below(x.at - x.reach - slack);
    box.high[i] = rounded_above(x.at + x.reach + slack);
  }
  return box;
}

/// Upper bound of the error of a reach from a direction that is rounded to float, as a fraction of the direction's
/// rounded |.|_1. It suffices since |p_k| <= 1 locally (verify/proofs/scene_proofs.h).
inline constexpr float slack_of_direction = 4 * kernel::unit_roundoff<float>;

/// Returns a box about the placed body, by its reaches along the rows M_i of the pose. The box is all of space where
/// the scale is not in range (`Local_scale::is_in_range`), or an |M_i|_1 is not in 1e-30 .. 1e30. Else absolute errors
/// are below 2^-1075 times 2^202.
///
/// `table` and `scale` belong to the body's tree.
inline World_box world_box(Support_table& table, const kernel::Local_scale& scale, const kernel::Pose& pose)
{
  static_assert(placed_underflow >= 0x1p-1074 * 0x1p201);
  if (!scale.is_in_range()) return {};
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
    // The roundings of these sums are relative to their operands.
    box.high[i] = rounded_above(at + up + slack + placed_rounding * (std::abs(at) + std::abs(up)));
    box.low[i] = rounded_below(at - down - slack - placed_rounding * (std::abs(at) + std::abs(down)));
  }
  return box;
}

/// The rounded centre of a body's box, and the sum of `Body_step::turned` since the body was placed. The sum is an
/// upper bound of the distance by which a point has moved relative to the centre.
struct alignas(32) Body_place {
  std::array<double, 3> at{};
  double turned = 0;
};

/// A step of a body from one pose to the next.
struct Body_step {
  std::array<double, 3> at;  ///< the centre's image under the next pose; all steps round it alike
  /// Upper bound of |(q - at) - (p - at before)| for the images p and q of any point of the body. It is not finite
  /// where there is no bound.
  double turned;
};

/// The contribution of one row of two poses to a step, in every arithmetic. Each member's value is the sum of its two
/// lanes.
template <class Two>
struct Step_of_row {
  Two at;       ///< M'_i c + t'_i
  Two turn;     ///< sum_j |dM_ij| half_j
  Two squares;  ///< sum_j (|dM_ij| half_j)^2
  Two terms;    ///< sum_j (|M_ij| + |M'_ij|) (|c_j| + half_j) + |t_i| + |t'_i|

  /// Takes rows (M_i0, M_i1), (M_i2, t_i) of one pose and of the next. `centre` is (c_0, c_1), (c_2, 1); `half` is
  /// (half_0, half_1), (half_2, 0).
  Step_of_row(const std::array<Two, 2>& from, const std::array<Two, 2>& to, const std::array<Two, 2>& centre,
              const std::array<Two, 2>& half)
      : Step_of_row(to[0] * centre[0] + to[1] * centre[1],
                    {turn_of(from[0], to[0], half[0]), turn_of(from[1], to[1], half[1])},
                    terms_of(from[0], to[0], centre[0], half[0]) + terms_of(from[1], to[1], centre[1], half[1]))
  {}

 private:
  Step_of_row(const Two& image, const std::array<Two, 2>& turns, const Two& sum_of_terms)
      : at(image), turn(turns[0] + turns[1]), squares(turns[0] * turns[0] + turns[1] * turns[1]), terms(sum_of_terms)
  {}

  static Two turn_of(const Two& from, const Two& to, const Two& half)
  {
    using kernel::magnitudes;
    return magnitudes(to - from) * half;
  }
  static Two terms_of(const Two& from, const Two& to, const Two& centre, const Two& half)
  {
    using kernel::magnitudes;
    return (magnitudes(from) + magnitudes(to)) * (magnitudes(centre) + half);
  }
};

/// Returns the step of a body from one pose to the next.
///
/// A point c + v moves by q - p = dM v + (the centres' change). |dM v|^2 is at most sum_i (sum_j |dM_ij| half_j)^2. It
/// is also at most reach_in_halves^2 sum_ij (|dM_ij| half_j)^2, by the inequality of Cauchy and Schwarz over j.
inline Body_step body_step(const Body_extent& extent, const kernel::Pose& from, const kernel::Pose& to)
{
  using Two = kernel::Two_doubles;
  using Twos = std::array<Two, 2>;
  const std::array<double, 3>&c = extent.centre, &h = extent.half;
  const Twos centre = {Two{c[0], c[1]}, Two{c[2], 1}}, half = {Two{h[0], h[1]}, Two{h[2], 0}};
  Body_step step;
  Two squares{}, terms{};
  double square_of_turns = 0;
  for (int i = 0; i < 3; ++i) {
    const auto row = [i](const kernel::Pose& pose) {
      const double* const entries = pose.entries().data() + 4 * i;
      return Twos{kernel::two_from(entries), kernel::two_from(entries + 2)};
    };
    const Step_of_row<Two> of_row(row(from), row(to), centre, half);
    step.at[std::size_t(i)] = of_row.at[0] + of_row.at[1];
    const double turn = of_row.turn[0] + of_row.turn[1];
    square_of_turns += turn * turn;
    squares += of_row.squares;
    terms += of_row.terms;
  }
  const double by_length = extent.reach_in_halves * extent.reach_in_halves * (squares[0] + squares[1]),
               square = by_length < square_of_turns ? by_length : square_of_turns;
  // Both centres have an error of placed_rounding times their terms in each coordinate. It includes the rounding of a
  // fraction's entries.
  step.turned = std::sqrt(square) * (1 + step_rounding) + placed_rounding * (terms[0] + terms[1]) + extent.underflow;
  return step;
}

}  // namespace tetracone::tetratree

#endif
