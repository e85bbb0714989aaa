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

/// What roots of sums of squares may lose by rounding, and what is multiplied with them, a share of themselves.
inline constexpr double step_rounding = 0x1p-48;

/// Absolute errors of the bounds below. Under 2^-1022 a product and the nearest double of a fraction are off by up to
/// 2^-1075 =: e, whatever their size.
///
/// An entry's error is multiplied with |c_j| + half_j, the centre and half the extent of a body's box. A step of two
/// poses has the most of them: 6 e in the centre's images, one of each pose in three rows, and 2 e sqrt(3) times
/// `reach_in_halves` <= 2 in what turns.
inline constexpr double entry_underflow = 0x1p-1072;
/// The products themselves, and roots of sums of squares that underflow: of at most 37 squares, 37^(1/2) e^(1/2).
inline constexpr double placed_underflow = 0x1p-534;

template <class Number>
Number square_in_halves(const Number& vertex, const Number& centre, const Number& half)
{
  const Number part = (vertex - centre) / half;
  return part * part;
}

/// A box about the vertices of a body where it was modelled: what bounds its place and its motion under any pose,
/// before there is a tree.
struct Body_extent {
  std::array<double, 3> centre{}, half{};
  /// At least the length of what vertices are from the centre, each coordinate in units of its half; of a ball 1, of
  /// corners the root of 3.
  double reach_in_halves = 2;
  /// Upper bound of the absolute error of a coordinate of an image, and of a step: `placed_underflow`, and
  /// `entry_underflow` times the sum of |c_j| + half_j. It matters where poses undo coordinates near the largest double.
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
      // Each difference is off by one rounding.
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

  /// Whether a box turned with the body bounds it much better than one along the world's axes.
  bool is_long() const
  {
    return kernel::maximum(half[0], half[1], half[2]) >= 2 * kernel::minimum(half[0], half[1], half[2]);
  }
};

/// What the bounds below may lose by rounding, a share of the magnitudes of their terms: four roundings of a sum of
/// products, as many of a second such sum, one of each entry of a fraction, two of what joins both. Absolute errors are
/// `Body_extent::underflow`.
inline constexpr double placed_rounding = 16 * kernel::unit_roundoff<double>;

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
    const double slack = placed_rounding * x.terms + extent.underflow;
    box.low[i] = rounded_below(x.at - x.reach - slack);
    box.high[i] = rounded_above(x.at + x.reach + slack);
  }
  return box;
}

/// What a direction that is rounded to float takes from a reach, a share of its |.|_1 as a rounded sum: |p_k| <= 1 locally.
inline constexpr float slack_of_direction = 4 * kernel::unit_roundoff<float>;

/// A box about the placed body by how far the body itself reaches along each axis: unit h(M_i) from its local origin.
/// Beyond `Local_scale::is_in_range` nothing is known; within it, absolute errors are below 2^-1075 times 2^202.
///
/// `table` is the body's, `scale` its tree's.
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
    // The sums' own roundings are shares of what they are made of.
    box.high[i] = rounded_above(at + up + slack + placed_rounding * (std::abs(at) + std::abs(up)));
    box.low[i] = rounded_below(at - down - slack - placed_rounding * (std::abs(at) + std::abs(down)));
  }
  return box;
}

/// Where the centre of a body's box is, rounded, and how far its points have turned about there since it was placed: the
/// sum of its steps.
struct alignas(32) Body_place {
  std::array<double, 3> at{};
  double turned = 0;
};

/// A step of a body from one pose to the next.
struct Body_step {
  std::array<double, 3> at;  ///< where it leads: the centre's image, rounded as it always is
  /// At least |(q - at) - (p - at before)| for the images p and q of any of the body's points; not finite where nothing is
  /// known.
  double turned;
};

/// What a row of two poses says of a step, in every arithmetic. Of its vectors of two the lanes sum up to what is meant.
template <class Two>
struct Step_of_row {
  Two at;       ///< M'_i c + t'_i
  Two turn;     ///< sum_j |dM_ij| half_j
  Two squares;  ///< sum_j (|dM_ij| half_j)^2
  Two terms;    ///< sum_j (|M_ij| + |M'_ij|) (|c_j| + half_j) + |t_i| + |t'_i|

  /// Of rows (M_i0, M_i1), (M_i2, t_i) from one pose to the next; `centre` is (c_0, c_1), (c_2, 1), `half` (half_0,
  /// half_1), (half_2, 0).
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

/// Of a point c + v, q - p = dM v + (the centres' change), and |dM v|^2 is at most sum_i (sum_j |dM_ij| half_j)^2, and at
/// most reach_in_halves^2 sum_ij (|dM_ij| half_j)^2, by the inequality of Cauchy and Schwarz over j.
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
  // Both centres are off by placed_rounding of their terms, in each coordinate; entries of fractions are rounded in that
  // too.
  step.turned = std::sqrt(square) * (1 + step_rounding) + placed_rounding * (terms[0] + terms[1]) + extent.underflow;
  return step;
}

}  // namespace tetracone::tetratree

#endif
