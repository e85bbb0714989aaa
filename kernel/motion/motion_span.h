#ifndef TETRACONE_KERNEL_MOTION_MOTION_SPAN_H
#define TETRACONE_KERNEL_MOTION_MOTION_SPAN_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"

#include <array>
#include <cassert>
#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace tetracone::kernel {

/// Returns an axis divided by the largest magnitude of its components, so that bounds accept its length. The axis 0
/// becomes NaN, with which no bound separates anything.
inline Vertex scaled_to_one(const Vertex& v)
{
  return scaled(v, 1 / maximum(std::abs(v[0]), std::abs(v[1]), std::abs(v[2])));
}

/// The part of a body's local units that the bounds need. A local point p is o + unit p in its own coordinates, where
/// unit is a power of two.
struct Motion_units {
  Vertex origin;
  double unit;
};

/// Returns the least and the largest l . p of a box's points: centre + sum_k s_k half_edge[k], |s_k| <= 1.
template <class Number>
std::array<Number, 2> range_of_box(const std::array<Number, 3>& l, const std::array<Number, 3>& centre,
                                   const std::array<std::array<Number, 3>, 3>& half_edge)
{
  using std::abs;
  const Number at = dot(l, centre),
               reach = abs(dot(l, half_edge[0])) + abs(dot(l, half_edge[1])) + abs(dot(l, half_edge[2]));
  return {at - reach, at + reach};
}

/// A box of the points centre + sum_k s_k half_edge[k], |s_k| <= 1, in local units.
struct Moving_box {
  Vertex centre;
  std::array<Vertex, 3> half_edge;

  /// Returns `range_of_box` of this box.
  std::array<double, 2> range(const Vertex& l) const { return range_of_box(l, centre, half_edge); }
};

/// The times of a span, from 0 to 1 over it, at which bodies may meet. They are apart before and after.
struct Time_window {
  double from = 0, until = 1;

  bool is_empty() const { return from > until; }

  friend Time_window common(const Time_window& x, const Time_window& y)
  {
    return {maximum(x.from, y.from), minimum(x.until, y.until)};
  }
};

/// A span of time from m / 2^k to (m+1) / 2^k, with the motion of two bodies in it, in double.
///
/// Points of both, in common coordinates and times their common divisor, are forms in time. At each time of the span
/// they are sums of their coefficients in Bernstein's basis, with weights that are not negative. Take the gaps of two
/// hulls along an axis, one at each coefficient. Where a function that is linear in time lies below them, the hulls are
/// apart while it is positive.
class Motion_span {
 public:
  /// The largest number of coefficients of a form. Two rigid motions have 6.
  static constexpr std::size_t most_coefficients = 8;

  /// Upper bound of the error of a time in the span, as a fraction of it. A time is a quotient of at most 1, by a
  /// difference of opposite signs (verify/proofs/motion_proofs.h).
  static constexpr double rounding_of_times = 0x1p-50;

  /// The maps of both bodies' local points. `offset` leads from the place of A's local origin to the place of B's.
  /// `weight` is their divisor, up to a power of two.
  struct Maps {
    std::array<std::array<Vertex, 3>, 2> row;
    Vertex offset;
    double weight = 1;
  };

  /// The span that is all of the time. Requires forms of at most `most_coefficients`.
  Motion_span(const Pair_motion& motion, const Motion_units& a, const Motion_units& b) : size_(motion.size())
  {
    assert(size_ <= most_coefficients);
    const int least = Pair_motion::exponent_of(b.origin, Pair_motion::exponent_of(a.origin));
    const Form_vector from = motion.image(0, a.origin, least), to = motion.image(1, b.origin, least);
    std::array<Integer_form, 3> offset;
    for (int i = 0; i < 3; ++i) offset[i] = to[i] - from[i];
    const std::array<long, 2> unit = {std::ilogb(a.unit), std::ilogb(b.unit)};

    // One power of two scales all numbers so that the largest is at most 1. It changes no separation.
    long largest = LONG_MIN;
    const auto see = [&](const Integer_form& form, long exponent) {
      for (std::size_t i = 0; i < form.size(); ++i)
        if (sgn(form[i]) != 0) largest = maximum(largest, long(mpz_sizeinbase(form[i].get_mpz_t(), 2)) + exponent);
    };
    for (int i = 0; i < 3; ++i) {
      see(offset[i], least);
      for (int j = 0; j < 3; ++j)
        for (int body = 0; body < 2; ++body) see(motion.entry(body, 4 * i + j), unit[body]);
    }
    const auto rounded = [&](const Integer_form& form, std::size_t i, long exponent) {
      long own;
      const double x = mpz_get_d_2exp(&own, form[i].get_mpz_t());
      const long place = own + exponent - largest;
      return place < -1000 ? 0.0 : std::ldexp(x, int(place)) / binomial(i);
    };
    const long of_weight = long(mpz_sizeinbase(motion.divisor()[0].get_mpz_t(), 2));
    for (std::size_t i = 0; i < size_; ++i) {
      Maps& maps = coefficient_[i];
      for (int j = 0; j < 3; ++j) {
        maps.offset[j] = rounded(offset[j], i, least);
        for (int k = 0; k < 3; ++k)
          for (int body = 0; body < 2; ++body)
            maps.row[body][j][k] = rounded(motion.entry(body, 4 * j + k), i, unit[body]);
      }
      maps.weight = rounded(motion.divisor(), i, largest - of_weight);
    }
    find_error();
    find_landmarks();
  }

  /// Returns the span that is all of the time, where every point of both moves on a line between poses of doubles.
  /// Returns nothing for poses of fractions, and for numbers near the ends of the doubles' range.
  static std::optional<Motion_span> of_lines(const std::array<Pose, 2>& a, const Motion_units& in_a,
                                             const std::array<Pose, 2>& b, const Motion_units& in_b)
  {
    Motion_span span;
    span.size_ = 2;
    double terms = 0, largest = 0;
    for (int end = 0; end < 2; ++end) {
      const Pose &of_a = a[end], &of_b = b[end];
      if (of_a.is_rational() || of_b.is_rational()) return std::nullopt;
      Maps& maps = span.coefficient_[end];
      for (int j = 0; j < 3; ++j) {
        // The error is 24 u^2 of the terms, and the rounding of the sum.
        Double_double offset = Double_double::sum(of_b[4 * j + 3], -of_a[4 * j + 3]);
        double magnitude = std::abs(of_b[4 * j + 3]) + std::abs(of_a[4 * j + 3]);
        for (int k = 0; k < 3; ++k) {
          const auto of_b_origin = Double_double::product(of_b[4 * j + k], in_b.origin[k]),
                     of_a_origin = Double_double::product(-of_a[4 * j + k], in_a.origin[k]);
          offset = offset + of_b_origin + of_a_origin;
          magnitude += std::abs(of_b_origin.high) + std::abs(of_a_origin.high);
          maps.row[0][j][k] = of_a[4 * j + k] * in_a.unit;
          maps.row[1][j][k] = of_b[4 * j + k] * in_b.unit;
          largest = maximum(largest, std::abs(maps.row[0][j][k]), std::abs(maps.row[1][j][k]));
        }
        maps.offset[j] = offset.high;
        terms = maximum(terms, magnitude);
        largest = maximum(largest, std::abs(offset.high));
      }
    }
    if (!(largest >= 0x1p-300 && maximum(terms, largest) <= 0x1p300)) return std::nullopt;
    const double to_one = std::ldexp(1.0, -std::ilogb(largest));
    for (int end = 0; end < 2; ++end) span.coefficient_[end] = times(span.coefficient_[end], to_one);
    span.find_error();
    span.error_ += 0x1p-90 * terms * to_one;
    span.find_landmarks();
    return span;
  }

  /// Returns the first or the second half. Requires k() < 60, as `find_error` does.
  Motion_span half(bool second) const
  {
    Motion_span half = *this;
    half.m_ = 2 * m_ + second;
    half.k_ = k_ + 1;
    // De Casteljau's algorithm.
    for (std::size_t round = 1; round < size_; ++round)
      for (std::size_t i = 0; i + round < size_; ++i) {
        const std::size_t to = second ? i : size_ - 1 - i;
        half.coefficient_[to] = average(half.coefficient_[to], half.coefficient_[second ? to + 1 : to - 1]);
      }
    half.find_landmarks();
    return half;
  }

  /// Return m and k: the span is from m / 2^k to (m+1) / 2^k.
  std::uint64_t m() const { return m_; }
  unsigned k() const { return k_; }
  /// Return the times of its start and of its middle.
  double start() const { return std::ldexp(double(m_), -int(k_)); }
  double middle() const { return std::ldexp(double(2 * m_ + 1), -int(k_) - 1); }

  /// Returns an upper bound of the fraction of the span that is before a time.
  double share_before(double time) const { return std::ldexp(time - start(), int(k_)) + rounding_of_times; }

  /// Points of a body, as each coefficient of a span places them.
  template <std::size_t n>
  using Points = std::array<std::array<Vertex, n>, most_coefficients>;

  /// Returns the placed local points of body 0 or 1.
  template <std::size_t n>
  Points<n> placed(int body, const std::array<Vertex, n>& local) const
  {
    Points<n> points;
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t k = 0; k < n; ++k) {
        points[i][k] = direction(coefficient_[i], body, local[k]);
        for (int j = 0; j < 3 && body == 1; ++j) points[i][k][j] += coefficient_[i].offset[j];
      }
    return points;
  }

  /// Returns the times at which the hulls of points, of A and of B, may meet, as far as this axis tells. Along an axis
  /// so short or so long that products may be lost, these are all times.
  template <std::size_t n, std::size_t m>
  Time_window near_along(const Vertex& axis, const Points<n>& a, const Points<m>& b) const
  {
    return near_by(axis, [&](std::size_t i) { return std::array{range(axis, a[i]), range(axis, b[i])}; });
  }

  /// Returns the times at which two boxes may meet, as far as this axis tells. Along an axis so short or so long that
  /// products may be lost, these are all times.
  Time_window near_along(const Vertex& axis, const Moving_box& a, const Moving_box& b) const
  {
    return near_by(axis, [&](std::size_t i) {
      const Maps& maps = coefficient_[i];
      const double offset = dot(axis, maps.offset);
      auto of_b = b.range(across(axis, maps.row[1]));
      for (double& x : of_b) x += offset;
      return std::array{a.range(across(axis, maps.row[0])), of_b};
    });
  }

  /// Returns the maps of the span's i-th coefficient in Bernstein's basis, not divided by their weight.
  const Maps& coefficient(std::size_t i) const { return coefficient_[i]; }
  /// Returns the number of coefficients.
  std::size_t size() const { return size_; }

  /// Returns an upper bound of the error of a difference of images under these maps, along an axis, relative to
  /// |axis|_1.
  double error() const { return error_; }

  /// Returns the bodies' maps in the middle of the span, divided by the divisor. They are not exact.
  const Maps& at_middle() const { return landmark_[1]; }

  /// Returns approximately the bodies' maps at this fraction of the span, divided by the divisor.
  Maps about(double share) const
  {
    // A parabola goes through the start, the middle and the end.
    const double first = (1 - share) * (1 - 2 * share), middle = 4 * share * (1 - share),
                 last = share * (2 * share - 1);
    const auto mean = [&](double x, double y, double z) { return first * x + middle * y + last * z; };
    const auto& [start, half, end] = landmark_;
    return each_entry(mean, start, half, end);
  }

  /// Returns approximately the relative motion, in the span, of parts of a body that are 1 apart in its local units.
  double turn(int body) const { return turn_[body]; }
  /// Returns approximately the length of a local unit of a body in common units.
  double scale(int body) const { return scale_[body]; }

  /// Returns approximately the least distance of hulls that bounds can detect, in common units.
  double resolution() const { return error_ / landmark_[1].weight; }

  /// Returns the zero of a linear function that is `from` at 0 and `to` at 1, of opposite signs.
  template <class Number>
  static Number zero_between(const Number& from, const Number& to)
  {
    return from / (from - to);
  }

  /// Returns the row vector axis . L, where L has these rows.
  template <class Number>
  static std::array<Number, 3> across(const std::array<Number, 3>& axis,
                                      const std::array<std::array<Number, 3>, 3>& row)
  {
    const auto along = [&](std::size_t k) { return axis[0] * row[0][k] + axis[1] * row[1][k] + axis[2] * row[2][k]; };
    return {along(0), along(1), along(2)};
  }

  /// Returns the image of a body's local vector by the linear part of its map.
  static Vertex direction(const Maps& maps, int body, const Vertex& v)
  {
    return {dot(maps.row[body][0], v), dot(maps.row[body][1], v), dot(maps.row[body][2], v)};
  }

  /// Returns the vector from a local point of A to one of B.
  static Vertex between(const Maps& maps, const Vertex& a, const Vertex& b)
  {
    return sum(maps.offset, difference(direction(maps, 1, b), direction(maps, 0, a)));
  }

  /// Returns the maps of what(the entries of `given`), with a weight of 1.
  template <class What, class... Given>
  static Maps each_entry(const What& what, const Given&... given)
  {
    Maps maps;
    for (int i = 0; i < 3; ++i) {
      maps.offset[i] = what(given.offset[i]...);
      for (int body = 0; body < 2; ++body)
        for (int k = 0; k < 3; ++k) maps.row[body][i][k] = what(given.row[body][i][k]...);
    }
    return maps;
  }

  /// Returns the maps divided by their weight, which stays.
  static Maps over_weight(const Maps& maps)
  {
    Maps quotient = each_entry([&](double x) { return x / maps.weight; }, maps);
    quotient.weight = maps.weight;
    return quotient;
  }

 private:
  Motion_span() = default;

  template <std::size_t n>
  [[gnu::always_inline]] static std::array<double, 2> range(const Vertex& axis, const std::array<Vertex, n>& points)
  {
    std::array<double, 2> range = {dot(axis, points[0]), dot(axis, points[0])};
    for (std::size_t k = 1; k < n; ++k) {
      const double at = dot(axis, points[k]);
      range = {minimum(range[0], at), maximum(range[1], at)};
    }
    return range;
  }

  /// A function that is linear in time, below a form. The roundings of its few sums are far below the error that is
  /// subtracted.
  struct Line {
    double first, last, above = 0;

    void lower(double share, double gap) { above = maximum(above, first + (last - first) * share - gap); }

    /// Returns the times when it is not positive; all the time where they are not known.
    [[gnu::always_inline]] Time_window at_most_0() const
    {
      const double from = first - above, to = last - above;
      if (from > 0 && to > 0) return {1, 0};
      const double share = zero_between(from, to);
      if (!(share >= 0 && share <= 1)) return {};
      if (from > 0) return {share - rounding_of_times, 1};
      if (to > 0) return {0, share + rounding_of_times};
      return {};
    }
  };

  /// Returns the times at which hulls may meet whose ranges along the axis at coefficient i are ranges(i). Gaps of
  /// either sense, less the error, are forms with these coefficients.
  template <class Ranges>
  Time_window near_by(const Vertex& axis, const Ranges& ranges) const
  {
    const double length = std::abs(axis[0]) + std::abs(axis[1]) + std::abs(axis[2]), error = length * error_;
    if (!(length >= 0x1p-100 && length <= 0x1p100)) return {};
    const auto gaps = [&](std::size_t i) {
      const auto [a, b] = ranges(i);
      return std::array{b[0] - a[1] - error, a[0] - b[1] - error};
    };
    const auto first = gaps(0), last = gaps(size_ - 1);
    Line before{first[0], last[0]}, behind{first[1], last[1]};
    for (std::size_t i = 1; i + 1 < size_; ++i) {
      const double share = double(i) / double(size_ - 1);
      const auto gap = gaps(i);
      before.lower(share, gap[0]);
      behind.lower(share, gap[1]);
    }
    return common(before.at_most_0(), behind.at_most_0());
  }

  double binomial(std::size_t k) const
  {
    double value = 1;
    for (std::size_t j = 0; j < k; ++j) value = value * double(size_ - 1 - j) / double(j + 1);
    return value;
  }

  static Maps average(const Maps& x, const Maps& y)
  {
    const auto mean = [](double a, double b) { return 0.5 * (a + b); };
    Maps z = each_entry(mean, x, y);
    z.weight = mean(x.weight, y.weight);
    return z;
  }

  /// Computes the error of a difference of ranges, relative to |axis|_1. The largest terms of the whole motion are
  /// used, which no half exceeds. u is the unit roundoff.
  ///
  /// A coefficient has a relative error of 4 u, since it is rounded and divided. It has one u more for each average, 7
  /// for each of 60 halvings at most. Underflow is below the slack. A local point has coordinates of at most 1, each
  /// with an error of 2 u. A box about such points has a centre and half-edges whose rows sum to less than 8. Products
  /// and sums with an axis, a centre and half-edges lose less than 40 u of their terms. The total is less than 500 u of
  /// `terms`, and `few_roundings` is 8192 u.
  void find_error()
  {
    double offset = 0, linear = 0;
    for (std::size_t i = 0; i < size_; ++i)
      for (int j = 0; j < 3; ++j) {
        offset = maximum(offset, std::abs(coefficient_[i].offset[j]));
        for (const auto& row : coefficient_[i].row)
          linear = maximum(linear, std::abs(row[j][0]), std::abs(row[j][1]), std::abs(row[j][2]));
      }
    const double terms = offset + 2 * 8 * linear;
    error_ = few_roundings * terms + underflow_slack;
  }

  void find_landmarks()
  {
    // The middle as the last of De Casteljau's averages.
    std::array<Maps, most_coefficients> averages = coefficient_;
    for (std::size_t last = size_ - 1; last > 0; --last)
      for (std::size_t i = 0; i < last; ++i) averages[i] = average(averages[i], averages[i + 1]);
    landmark_ = {over_weight(coefficient_[0]), over_weight(averages[0]), over_weight(coefficient_[size_ - 1])};
    for (int body = 0; body < 2; ++body) {
      turn_[body] = scale_[body] = 0;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const auto at = [&](int k) { return landmark_[k].row[body][i][j]; };
          turn_[body] = maximum(turn_[body], 2 * std::abs(at(1) - at(0)), 2 * std::abs(at(2) - at(1)));
          scale_[body] = maximum(scale_[body], std::abs(at(1)));
        }
    }
  }

  /// Returns the maps times a power of two, except their weight.
  static Maps times(const Maps& maps, double factor)
  {
    Maps product = each_entry([&](double x) { return x * factor; }, maps);
    product.weight = maps.weight;
    return product;
  }

  std::size_t size_ = 0;
  std::uint64_t m_ = 0;
  unsigned k_ = 0;
  std::array<Maps, most_coefficients> coefficient_;
  std::array<Maps, 3> landmark_;
  std::array<double, 2> turn_, scale_;
  double error_ = 0;
};

}  // namespace tetracone::kernel

#endif
