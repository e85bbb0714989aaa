#ifndef TETRACONE_TETRATREE_QUERY_SPAN_REFERENCE_H
#define TETRACONE_TETRATREE_QUERY_SPAN_REFERENCE_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_sweep.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace tetracone::tetratree {

/// Two bodies in a span of time as two similarities that move on lines, with an upper bound of the difference.
///
/// In the span's common coordinates the reference places local points p of A at R_0 p and q of B at R_1 q + r. Both are
/// similarities near the middle of the span, with entries in double, taken as exact. Coefficient i of the span, divided
/// by its weight, places them at C_0i p and C_1i q + c_i. M, m and H, h come from the mean and half the difference of
/// the first and last coefficients. The x_i go from -1 to 1 in equal steps. Then, except for a rest (the distance of
/// the inner coefficients from the line through the outer ones),
///
///     C_ki = R_k + M_k + x_i H_k,   c_i = r + m + x_i h.
///
/// The position at a time is a weighted mean of the coefficients, with weights that are not negative. The mean of the
/// x_i is the time x, from -1 to 1, if the weights are equal. Otherwise its error is at most the range of the weights
/// over the least one. A mean of (x_i - x) w_i equals that of (x_i - x) (w_i - w), where w is the middle of their
/// range. So n . (q - p) of images at the time x, with |n| <= 1, is its value in the reference plus
///
///     n . (M_1 q + m - M_0 p) + x n . (H_1 q + h - H_0 p),
///
/// except for the rest. `kernel::find_near` tests this.
class Span_reference {
 public:
  using Vertex = kernel::Vertex;

  /// The reference of a span. It is of use where `is_certifiable`.
  explicit Span_reference(const kernel::Motion_span& span)
  {
    const auto& middle = span.at_middle();
    std::array<kernel::Pose, 2> pose;
    std::array<double, 2> bent;
    for (std::size_t k = 0; k < 2; ++k) {
      rotation_[k] = nearest_similarity(middle.row[k]);
      bent[k] = norm(difference(middle.row[k], rotation_[k]));
      const auto& r = rotation_[k];
      const Vertex shift = k == 0 ? Vertex{0, 0, 0} : middle.offset;
      pose[k] = kernel::Pose(std::array{r[0][0], r[0][1], r[0][2], shift[0], r[1][0], r[1][1], r[1][2], shift[1],
                                        r[2][0], r[2][1], r[2][2], shift[2]});
    }
    const kernel::Local_scale units;
    into_[0] = kernel::Box_map(pose[1], units, pose[0], units);
    into_[1] = kernel::Box_map(pose[0], units, pose[1], units);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& r = rotation_[k];
      scale_[k] = std::sqrt(r[0][0] * r[0][0] + r[1][0] * r[1][0] + r[2][0] * r[2][0]);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) direction_[k][i][j] = r[i][j] / scale_[k];
    }
    find_sweep(span, middle.offset);
    // A map that is far from a similarity stays far from the reference in all parts of the span.
    for (std::size_t k = 0; k < 2; ++k) is_certifiable_ = is_certifiable_ && bent[k] <= most_bent * scale_[k];
    is_certifiable_ = is_certifiable_ && into_[0].is_similarity() && into_[1].is_similarity();
  }

  /// True when the reference bounds the motion.
  bool is_certifiable() const { return is_certifiable_; }

  /// Writes the test of the node `boxes` of body `body` against box `lane` of the node `from` of the other body. `apex`
  /// says where a triangle lies in that box. `known` are the times outside of which they are known to be apart. The
  /// nodes and the reference must outlive the test, which is meaningless unless `is_certifiable`.
  void ask(kernel::Sweep_test& test, std::size_t body, const kernel::Obb8& boxes, const kernel::Obb8& from, int lane,
           float apex, const kernel::Known_times& known) const
  {
    test.boxes = &boxes;
    test.map = &into_[1 - body];
    test.from = &from;
    test.lane = lane;
    test.apex = apex;
    test.sweep = &sweep_[body];
    test.known = known;
  }

  /// Upper bound of twice |n|_1 of a direction of length 1, and of the error of sums of coefficients. Proved in
  /// verify/proofs/reference_proofs.h.
  static constexpr double errors_along = 4;
  /// Upper bound of the relative difference between R_k^T over the square of its scale, which maps differences into
  /// local units, and the inverse of R_k. Proved in verify/proofs/reference_proofs.h.
  static constexpr double direction_error = 0x1p-19;
  /// Upper bound of the length of the local coordinates of every point of a box: of its centre plus its radius. Proved
  /// in verify/proofs/reference_proofs.h.
  static constexpr double most_local = 4;

  /// Returns an upper bound of the loss of a gap by the rest and by rounding, wherever the bodies are, in common units.
  double rest() const { return rest_; }
  /// Returns the part of `rest` that halves of the span do not reduce: rounding, and the error of directions where the
  /// maps are no similarities.
  double lasting_rest() const { return lasting_rest_; }

 private:
  using Rows = std::array<Vertex, 3>;
  using Placing = kernel::Motion_span::Maps;  // the weight is not used

  static double dot(const Vertex& a, const Vertex& b) { return kernel::dot(a, b); }

  static double norm(const Rows& m) { return std::sqrt(dot(m[0], m[0]) + dot(m[1], m[1]) + dot(m[2], m[2])); }
  static Rows difference(const Rows& x, const Rows& y)
  {
    return {kernel::difference(x[0], y[0]), kernel::difference(x[1], y[1]), kernel::difference(x[2], y[2])};
  }

  /// Returns the similarity nearest to a map that almost is one, by Newton's iteration for the polar decomposition
  /// (Higham, "Computing the polar decomposition", SIAM J. Sci. Stat. Comput. 1986).
  static Rows nearest_similarity(Rows m)
  {
    const double volume = dot(m[0], kernel::cross(m[1], m[2])), scale = std::cbrt(std::abs(volume));
    for (Vertex& row : m)
      for (double& x : row) x /= scale;
    for (int round = 0; round < 4; ++round) {
      const Rows cofactors = {kernel::cross(m[1], m[2]), kernel::cross(m[2], m[0]), kernel::cross(m[0], m[1])};
      const double over = 1 / dot(m[0], cofactors[0]);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) m[i][j] = 0.5 * (m[i][j] + cofactors[i][j] * over);
    }
    for (Vertex& row : m)
      for (double& x : row) x *= scale;
    return m;
  }

  /// Finds the sweeps and the rest. The error of a mean of coefficients is at most that of the line between the first
  /// and the last. It is taken along n in A's or B's units. A computed direction changes n . d by a fraction of |d|,
  /// where d leads from the reference to a coefficient.
  void find_sweep(const kernel::Motion_span& span, const Vertex& offset)
  {
    const std::size_t last = span.size() - 1;
    double least_weight = span.coefficient(0).weight, most_weight = least_weight;
    for (std::size_t i = 1; i <= last; ++i) {
      least_weight = kernel::minimum(least_weight, span.coefficient(i).weight);
      most_weight = kernel::maximum(most_weight, span.coefficient(i).weight);
    }
    const auto over_weight = [&](std::size_t i) { return kernel::Motion_span::over_weight(span.coefficient(i)); };
    const Placing first = over_weight(0), end = over_weight(last),
                  middle = sum(sum(first, 0.5, end, 0.5), 1, {rotation_, offset, 1}, -1),
                  half = sum(end, 0.5, first, -0.5);
    double rest = 0;
    for (std::size_t i = 1; i < last; ++i) {
      const double share = double(i) / double(last);
      rest = kernel::maximum(rest, norm(sum(over_weight(i), 1, sum(first, 1 - share, end, share), -1)));
    }
    lasting_rest_ = errors_along * span.error() / least_weight + direction_error * norm(middle);
    rest_ = lasting_rest_ + (rest + (most_weight - least_weight) / least_weight * norm(half)) +
            direction_error * (norm(half) + rest);
    is_certifiable_ = least_weight > 0 && rest_ < 1;
    for (std::size_t k = 0; k < 2; ++k)
      sweep_[k] = {seen_from(k, middle), seen_from(k, half), rest_ / scale_[k] * (1 + kernel::few_roundings)};
  }

  static Placing sum(const Placing& x, double by_x, const Placing& y, double by_y)
  {
    return kernel::Motion_span::each_entry([&](double a, double b) { return by_x * a + by_y * b; }, x, y);
  }

  /// Returns an upper bound of the relative displacement of two points under these maps.
  static double norm(const Placing& x)
  {
    return std::sqrt(dot(x.offset, x.offset)) + most_local * (norm(x.row[0]) + norm(x.row[1]));
  }

  /// Returns the displacement away from the body, along its own axes, in its units.
  kernel::Point_way seen_from(std::size_t body, const Placing& x) const
  {
    const double per_unit = 1 / scale_[body], away = body == 0 ? per_unit : -per_unit;
    const auto along_axes = [&](const Vertex& v, double factor) {
      return kernel::Motion_span::across({factor * v[0], factor * v[1], factor * v[2]}, direction_[body]);
    };
    std::array<Rows, 2> rows;
    for (std::size_t l = 0; l < 3; ++l)
      for (std::size_t k = 0; k < 2; ++k) {
        const Vertex column = along_axes({x.row[k][0][l], x.row[k][1][l], x.row[k][2][l]}, per_unit);
        for (std::size_t j = 0; j < 3; ++j) rows[k][j][l] = column[j];
      }
    return {along_axes(x.offset, away), rows[1 - body], rows[body]};
  }

  /// Largest distance of a map from its similarity, relative to its scale, at which the reference is used.
  static constexpr double most_bent = 0.125;

  std::array<kernel::Box_map, 2> into_;  // from body k's units into the other's
  std::array<kernel::Box_sweep, 2> sweep_;
  double rest_ = 0, lasting_rest_ = 0;
  std::array<double, 2> scale_;   // the length of a column
  std::array<Rows, 2> rotation_;  // R_k
  // R_k over the length of a column: a gap g along a direction in local units is g times that length along its image.
  std::array<Rows, 2> direction_;
  bool is_certifiable_ = true;
};

}  // namespace tetracone::tetratree

#endif
