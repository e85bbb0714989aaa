#ifndef TETRACONE_TETRATREE_FAST_SPAN_REFERENCE_H
#define TETRACONE_TETRATREE_FAST_SPAN_REFERENCE_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/obb8_gap.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace tetracone::tetratree {

/// A pose of two bodies near all that they take over a span of time, and how far they move from it: what is apart there by
/// more than that is apart all the time.
///
/// In the span's common coordinates the reference places local points p of A at R_0 p and q of B at R_1 q + r: two
/// similarities near the middle of the span, of doubles, taken as they are. Coefficient i of the span, over its weight,
/// places them at C_0i p and C_1i q + c_i, and where n . (C_1i q + c_i - C_0i p) > 0 for all i they are apart all the time
/// (see `kernel::Motion_span`). That is what it is in the reference, and n . d_i with
///
///     d_i(p, q) = (C_1i - R_1) q + (c_i - r) - (C_0i - R_0) p.
///
/// So boxes that are apart in the reference by a gap g along n, |n| <= 1, stay apart where n . d_i > -g for all their
/// points: n . d_i of their centres, less their radii times norms of C_ki - R_k. Along the other sense likewise.
class Span_reference {
 public:
  using Vertex = kernel::Vertex;

  explicit Span_reference(const kernel::Motion_span& span) : size_(span.size())
  {
    const auto& middle = span.at_middle();
    std::array<kernel::Pose, 2> pose;
    std::array<double, 2> bent;
    for (std::size_t k = 0; k < 2; ++k) {
      rotation_[k] = nearest_similarity(middle.row[k]);
      bent[k] = norm_of_difference(middle.row[k], rotation_[k]);
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
    find_steps(span, middle.offset);
    // A map that is far from a similarity stays far from the reference in all of a span's parts.
    for (std::size_t k = 0; k < 2; ++k) is_certifiable_ = is_certifiable_ && bent[k] <= most_bent * scale_[k];
    is_certifiable_ = is_certifiable_ && into_[0].is_similarity() && into_[1].is_similarity();
  }

  /// Whether the reference tells anything.
  bool is_certifiable() const { return is_certifiable_; }

  /// From B's local units to A's.
  const kernel::Relative_frame& frame() const { return into_[1].frame(); }

  /// Of the lanes of a node of body `body`, as bits, those that are apart from a box of the other body all the time.
  /// `apex`: where a triangle lies in that box. `way`: about how far the box moves against the node, in common units; 0
  /// where all are apart.
  struct Parts {
    unsigned apart;
    double way;
  };
  Parts parts(std::size_t body, const kernel::Obb8& boxes, unsigned lanes, const kernel::Obb8& from, int lane,
              float apex) const
  {
    kernel::Certified_gaps gaps;
    kernel::certified_gaps(boxes, into_[1 - body], from, lane, apex, gaps);
    const Vertex node = {boxes.origin[0], boxes.origin[1], boxes.origin[2]}, centre = kernel::centre_of(from, lane);
    // Of the box, away from the node at its origin, along the body's own axes.
    std::array<kernel::Gap_step, kernel::Motion_span::most_coefficients> steps;
    std::array<Vertex, kernel::Motion_span::most_coefficients> shift;
    for (std::size_t i = 0; i < size_; ++i) {
      const Own_step& step = own_step_[i][body];
      const Vertex from_node = times(step.own, node), to_centre = times(step.other, centre);
      steps[i] = step.of_lanes;
      for (int k = 0; k < 3; ++k) {
        shift[i][k] = step.offset[k] + (to_centre[k] - from_node[k]);
        steps[i].shift[k] = float(shift[i][k]);
      }
    }
    const double loss = turn_[1 - body] * radius_of(from, lane) + slack_;
    const unsigned apart =
        lanes & kernel::lanes_still_apart(boxes, gaps, {steps.data(), size_}, {scale_[body], loss, turn_[body]});
    double way = 0;
    if (apart != lanes)
      for (std::size_t i = 1; i < size_; ++i) {
        const Vertex step = kernel::difference(shift[i], shift[i - 1]);
        way += std::sqrt(dot(step, step));
      }
    return {apart, way};
  }

  /// Whether triangles, in local points of A and of B, are apart all the time, that are so by a gap along an axis of length
  /// 1 in A's local units, from A to B, in the reference.
  bool are_apart(double gap_in_a, const Vertex& axis, const std::array<Vertex, 3>& a,
                 const std::array<Vertex, 3>& b) const
  {
    const Vertex n = times(direction_[0], axis);
    const double gap = gap_in_a * scale_[0] - slack_;
    bool apart = true;
    for (std::size_t i = 0; i < size_ && apart; ++i) {
      const Vertex of_a = kernel::Motion_span::across(n, step_[i].row[0]),
                   of_b = kernel::Motion_span::across(n, step_[i].row[1]);
      apart = gap + (dot(n, step_[i].offset) + kernel::minimum(dot(of_b, b[0]), dot(of_b, b[1]), dot(of_b, b[2])) -
                     kernel::maximum(dot(of_a, a[0]), dot(of_a, a[1]), dot(of_a, a[2]))) >
              0;
    }
    return apart;
  }

 private:
  using Rows = std::array<Vertex, 3>;

  /// The maps of d_i.
  struct Step {
    std::array<Rows, 2> row;
    Vertex offset;
  };

  /// The same along a body's own axes, away from it.
  struct Own_step {
    Rows own, other;
    Vertex offset;
    kernel::Gap_step of_lanes;  ///< but for its shift
  };

  static double dot(const Vertex& a, const Vertex& b) { return kernel::dot(a, b); }
  static Vertex times(const Rows& m, const Vertex& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

  static double norm_of_difference(const Rows& x, const Rows& y)
  {
    double square = 0;
    for (int i = 0; i < 3; ++i) {
      const Vertex row = kernel::difference(x[i], y[i]);
      square += dot(row, row);
    }
    return std::sqrt(square);
  }

  /// The similarity nearest to a map that is one almost, by Newton's iteration for the polar decomposition (Higham,
  /// "Computing the polar decomposition", SIAM J. Sci. Stat. Comput. 1986).
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

  /// Errors of coefficients along n, |n|_1 < 1.8, over the least weight, are given twice. A direction as computed is off
  /// by 2^-21 of itself, since R_k is a similarity but for 2^-24, and moves n . d_i by as much of |d_i|.
  void find_steps(const kernel::Motion_span& span, const Vertex& offset)
  {
    double least_weight = span.coefficient(0).weight, longest = 0;
    turn_ = {0, 0};
    for (std::size_t i = 0; i < size_; ++i) {
      const auto& maps = span.coefficient(i);
      least_weight = kernel::minimum(least_weight, maps.weight);
      Step& step = step_[i];
      double shift = 0;
      for (int j = 0; j < 3; ++j) {
        step.offset[j] = maps.offset[j] / maps.weight - offset[j];
        shift += std::abs(step.offset[j]);
      }
      for (std::size_t k = 0; k < 2; ++k) {
        double square = 0;
        for (int j = 0; j < 3; ++j) {
          for (int l = 0; l < 3; ++l) step.row[k][j][l] = maps.row[k][j][l] / maps.weight - rotation_[k][j][l];
          square += dot(step.row[k][j], step.row[k][j]);
        }
        turn_[k] = kernel::maximum(turn_[k], std::sqrt(square) * (1 + kernel::few_roundings));
      }
      longest = kernel::maximum(longest, shift);
      for (std::size_t k = 0; k < 2; ++k) own_step_[i][k] = own_step(step, k);
    }
    slack_ = 4 * span.error() / least_weight + 0x1p-20 * (longest + 2 * (turn_[0] + turn_[1]));
    is_certifiable_ = least_weight > 0 && slack_ < 1;
  }

  /// Away from the body, along its own axes.
  Own_step own_step(const Step& step, std::size_t body) const
  {
    const Rows& axes = direction_[body];
    const double sense = body == 0 ? 1 : -1;
    Own_step own;
    own.offset =
        kernel::Motion_span::across({sense * step.offset[0], sense * step.offset[1], sense * step.offset[2]}, axes);
    for (int l = 0; l < 3; ++l) {
      const auto column = [&](std::size_t k) {
        return kernel::Motion_span::across({step.row[k][0][l], step.row[k][1][l], step.row[k][2][l]}, axes);
      };
      const Vertex of_own = column(body), of_other = column(1 - body);
      for (int j = 0; j < 3; ++j) {
        own.own[j][l] = of_own[j];
        own.other[j][l] = of_other[j];
        own.of_lanes.bend[j][l] = float(of_own[j]);
      }
    }
    return own;
  }

  /// At least the distance of a lane's points from its centre: its axes are not quite of length 1.
  static double radius_of(const kernel::Obb8& boxes, int lane)
  {
    double square = 0;
    for (int k = 0; k < 3; ++k) square += double(boxes.extent[k][lane]) * double(boxes.extent[k][lane]);
    return std::sqrt(square) * (1 + double(kernel::radius_rounding));
  }

  static constexpr double most_bent = 0.125;

  std::array<kernel::Box_map, 2> into_;  // of body k into the other's frame
  std::size_t size_;
  double slack_ = 0;
  std::array<double, 2> scale_, turn_{};  // the length of a column; at least the norms of C_ki - R_k
  std::array<Rows, 2> rotation_,
      direction_;  // R_k; and over the length of a column: what is apart along a direction in
                   // local units by g is so by g times that length along its image
  std::array<Step, kernel::Motion_span::most_coefficients> step_;
  std::array<std::array<Own_step, 2>, kernel::Motion_span::most_coefficients> own_step_;
  bool is_certifiable_ = true;
};

}  // namespace tetracone::tetratree

#endif
