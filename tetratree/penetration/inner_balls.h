#ifndef TETRACONE_TETRATREE_PENETRATION_INNER_BALLS_H
#define TETRACONE_TETRATREE_PENETRATION_INNER_BALLS_H

#include "tetracone/kernel/contact/rational_map.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/interval.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/locator/point_locator.h"
#include "tetracone/tetratree/query/bvh8_points.h"

#include <CGAL/gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// An open ball.
struct Ball {
  std::array<double, 3> centre;
  double radius;
};

/// Returns the largest of some balls, at most `most`, the largest first. It leaves out each ball that sticks out of a
/// kept one by less than `share` times that one's radius.
inline std::vector<Ball> largest_balls(std::vector<Ball> balls, std::size_t most, double share)
{
  std::ranges::sort(balls, [](const Ball& x, const Ball& y) { return x.radius > y.radius; });
  std::vector<Ball> kept;
  for (const Ball& ball : balls) {
    if (kept.size() == most) break;
    const bool is_new = std::ranges::none_of(kept, [&](const Ball& other) {
      return std::hypot(other.centre[0] - ball.centre[0], other.centre[1] - ball.centre[1],
                        other.centre[2] - ball.centre[2]) +
                 ball.radius <
             other.radius * (1 + share);
    });
    if (is_new) kept.push_back(ball);
  }
  return kept;
}

/// Balls inside a solid about any point, and some that stand for the solid, in the coordinates of a view. A view is an
/// affine map x -> M x + t.
///
/// A ball about an inner point has the distance to the surface as its radius, which `Bvh8_points` bounds. M makes a
/// vector of length r at least r s and at most r S long. S^2 is the largest eigenvalue of M^T M; with N the inverse of
/// M, 1 / s^2 is that of N^T N. By Gershgorin's theorem an eigenvalue is no more than the largest sum of magnitudes in
/// a row. A centre's error shortens the radius. One object serves one thread.
class Inner_balls {
 public:
  /// Finds the balls that stand for the solid, at points of a grid. `is_border` says that inner points of the solid are
  /// arbitrarily near to each point of the surface, as in `Solid_sides::is_simple`. Requires a closed surface, and
  /// the tree and the locator of one body. Both must outlive this object.
  Inner_balls(const Bvh8& tree, const Point_locator& locator, bool is_border)
      : is_border_(is_border), locator_(&locator), points_(tree)
  {
    std::array<double, 3> low, high;
    low.fill(HUGE_VAL);
    high.fill(-HUGE_VAL);
    for (const covering::Vertex& v : tree.model().vertices())
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = kernel::minimum(low[k], v[k]);
        high[k] = kernel::maximum(high[k], v[k]);
      }
    const double size = kernel::maximum(high[0] - low[0], high[1] - low[1], high[2] - low[2]), step = size / grid;
    if (!(size >= 0x1p-200 && size <= 0x1p200)) return;
    std::vector<Ball> balls;
    const auto at = [&](std::size_t k, int i) { return low[k] + (i + 0.5) * step; };
    for (int i = 0; i < grid && at(0, i) < high[0]; ++i)
      for (int j = 0; j < grid && at(1, j) < high[1]; ++j)
        for (int k = 0; k < grid && at(2, k) < high[2]; ++k) {
          const Ball ball{{at(0, i), at(1, j), at(2, k)}, signed_distance({at(0, i), at(1, j), at(2, k)})};
          if (ball.radius > 0) balls.push_back(ball);
        }
    own_ = largest_balls(std::move(balls), most_balls, least_share);
  }

  /// Sets the view: a row-major 3x4 matrix from the body's coordinates, with det M != 0.
  void see(const std::array<kernel::Rational, 12>& map)
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    std::array<kernel::Interval, 12> m;
    for (std::size_t k = 0; k < 12; ++k) m[k] = CGAL::to_interval(map[k]);
    // Each number of the inverse has an error of one rounding.
    const kernel::Rational_map view{kernel::Pose(map)};
    std::array<std::array<kernel::Interval, 3>, 3> n;
    for (std::size_t i = 0; i < 3; ++i) {
      shift_[i] = kernel::nearest_double(map[4 * i + 3]);
      for (std::size_t j = 0; j < 3; ++j) {
        n[i][j] = CGAL::to_interval(view.inverse_row(i)[j]);
        inverse_[i][j] = kernel::nearest_double(view.inverse_row(i)[j]);
      }
    }
    // Returns an upper bound of the largest eigenvalue of the transpose of a matrix times the matrix.
    const auto largest = [](const auto& entry) {
      double most = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        kernel::Interval row = 0;
        for (std::size_t j = 0; j < 3; ++j)
          row += CGAL::abs(entry(0, i) * entry(0, j) + entry(1, i) * entry(1, j) + entry(2, i) * entry(2, j));
        most = kernel::maximum(most, row.sup());
      }
      return most;
    };
    const auto is_in_range = [](double x) { return x >= 0x1p-400 && x <= 0x1p400; };
    const double most = largest([&](std::size_t i, std::size_t j) { return n[i][j]; }),
                 stretch = largest([&](std::size_t i, std::size_t j) { return m[4 * i + j]; });
    seen_.clear();
    scale_ = 0;
    if (!is_in_range(most) || !is_in_range(stretch)) return;
    scale_ = (kernel::Interval(1) / CGAL::sqrt(kernel::Interval(most))).inf();
    stretch_ = CGAL::sqrt(kernel::Interval(stretch)).sup();
    for (const Ball& ball : own_) {
      Ball image;
      double error = 0;
      const std::array<kernel::Interval, 3> about = kernel::image(ball.centre, m);
      for (std::size_t k = 0; k < 3; ++k) {
        const kernel::Interval& x = about[k];
        image.centre[k] = x.inf() / 2 + x.sup() / 2;
        error += kernel::maximum(x.sup() - image.centre[k], image.centre[k] - x.inf());
      }
      image.radius = -(error + -scale_ * ball.radius);  // rounded down, as upward rounding has it
      if (image.radius >= 0x1p-200 && image.radius <= 0x1p200) seen_.push_back(image);
    }
  }

  /// Returns the balls that stand for the solid, in the view. There is none where the view has no bound.
  const std::vector<Ball>& seen() const { return seen_; }

  /// True if inner points of the solid are arbitrarily near to each point of the surface.
  bool is_border() const { return is_border_; }

  /// Returns a lower bound of the signed distance of a point to the surface, both in the view. Above 0 it is the radius
  /// of a ball inside the solid. Below 0 it is minus an upper bound of the distance, and the point may be anywhere. It
  /// is -inf where nothing is known. Requires that `see` was called.
  double radius_about(const std::array<double, 3>& point)
  {
    covering::Vertex own;
    double error = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      double magnitude = 0;
      own[i] = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        own[i] += inverse_[i][j] * (point[j] - shift_[j]);
        magnitude += std::abs(inverse_[i][j]) * (std::abs(point[j]) + std::abs(shift_[j]));
      }
      error += magnitude * kernel::few_roundings + kernel::underflow_slack;
      if (!(magnitude <= 0x1p200)) return -HUGE_VAL;
    }
    if (scale_ == 0) return -HUGE_VAL;
    // A signed distance changes by no more than the point moves.
    const double distance = signed_distance(own) - error;
    return distance > 0 ? scale_ * distance * (1 - kernel::few_roundings)
                        : stretch_ * distance * (1 + kernel::few_roundings) - kernel::underflow_slack;
  }

 private:
  /// Returns a lower bound of the signed distance to the surface, which is above 0 for a point inside.
  double signed_distance(const covering::Vertex& x)
  {
    const auto [low, high] = points_.bounds(x);
    return locator_->locate(x) == covering::Location::inside
               ? low * (1 - kernel::few_roundings)
               : -(high * (1 + kernel::few_roundings) + kernel::underflow_slack);
  }

  static constexpr int grid = 16;                // points along the longest side of the solid's box
  static constexpr std::size_t most_balls = 64;  // that stand for the solid
  static constexpr double least_share = 0.125;   // of a ball's radius, by which others stick out

  bool is_border_;
  const Point_locator* locator_;
  Bvh8_points points_;
  std::vector<Ball> own_, seen_;    // in the body's coordinates, and in the view
  double scale_ = 0, stretch_ = 0;  // s, 0 where nothing is known; and S
  std::array<std::array<double, 3>, 3> inverse_{};
  std::array<double, 3> shift_{};
};

}  // namespace tetracone::tetratree

#endif
