#ifndef TETRACONE_TETRATREE_PENETRATION_INNER_BALLS_H
#define TETRACONE_TETRATREE_PENETRATION_INNER_BALLS_H

#include "tetracone/kernel/contact/crossing_polytope.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/interval.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/locator/point_locator.h"
#include "tetracone/tetratree/query/bvh8_points.h"

#include <CGAL/gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// An open ball.
struct Ball {
  std::array<double, 3> centre;
  double radius;
};

/// Keeps the largest balls, at most `most`. It leaves out each ball that sticks out of a kept one by less than a share
/// of that one's radius.
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

/// Returns balls whose points are all inside the solid, in its own coordinates. Their centres are points of a grid. A
/// radius is less than the distance from the centre to the surface.
inline std::vector<Ball> inner_balls(const Bvh8& tree, const Point_locator& locator)
{
  constexpr int grid = 16;  // points along the longest side of the solid's box
  std::array<double, 3> low, high;
  low.fill(HUGE_VAL);
  high.fill(-HUGE_VAL);
  for (const covering::Vertex& v : tree.model().vertices())
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = kernel::minimum(low[k], v[k]);
      high[k] = kernel::maximum(high[k], v[k]);
    }
  const double size = kernel::maximum(high[0] - low[0], high[1] - low[1], high[2] - low[2]), step = size / grid;
  if (!(size >= 0x1p-200 && size <= 0x1p200)) return {};
  std::vector<Ball> balls;
  Bvh8_points points(tree);
  for (double x = low[0] + step / 2; x < high[0]; x += step)
    for (double y = low[1] + step / 2; y < high[1]; y += step)
      for (double z = low[2] + step / 2; z < high[2]; z += step) {
        const covering::Vertex centre = {x, y, z};
        if (locator.locate(centre) != Location::inside) continue;
        if (const std::optional<Surface_point> nearest = points.by_enclosures(centre))
          balls.push_back({{x, y, z}, nearest->distance * (1 - kernel::few_roundings)});
      }
  return largest_balls(std::move(balls), 64, 0.02);
}

/// Returns balls inside the solid in the coordinates of a view: a row-major 3x4 matrix M from the body's coordinates.
///
/// M makes a vector of length r at least r s long, where s^2 is the least eigenvalue of M^T M. By Gershgorin's theorem
/// that is no less than a diagonal entry, less the magnitudes of the others of its row. A centre's error shortens the
/// radius.
inline std::vector<Ball> seen_balls(const std::vector<Ball>& balls, const std::array<kernel::Rational, 12>& map)
{
  const CGAL::Protect_FPU_rounding<true> upward;
  std::array<kernel::Interval, 12> m;
  for (std::size_t k = 0; k < 12; ++k) m[k] = CGAL::to_interval(map[k]);
  kernel::Interval least = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    kernel::Interval row = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const kernel::Interval product = m[i] * m[j] + m[4 + i] * m[4 + j] + m[8 + i] * m[8 + j];
      row += i == j ? product : -CGAL::abs(product);
    }
    least = (CGAL::min)(least, row);
  }
  std::vector<Ball> seen;
  if (!(least.inf() >= 0x1p-400 && least.sup() <= 0x1p400)) return seen;
  const kernel::Interval scale = CGAL::sqrt(least);
  for (const Ball& ball : balls) {
    Ball image;
    kernel::Interval radius = scale * ball.radius;
    for (std::size_t k = 0; k < 3; ++k) {
      const kernel::Interval x =
          m[4 * k] * ball.centre[0] + m[4 * k + 1] * ball.centre[1] + m[4 * k + 2] * ball.centre[2] + m[4 * k + 3];
      image.centre[k] = x.inf() / 2 + x.sup() / 2;
      radius -= (CGAL::max)(kernel::Interval(x.sup()) - image.centre[k], image.centre[k] - kernel::Interval(x.inf()));
    }
    image.radius = radius.inf();
    if (image.radius >= 0x1p-200 && image.radius <= 0x1p200) seen.push_back(image);
  }
  return seen;
}

/// The translations of A for which a ball inside it meets a ball inside B. They are balls, too.
class Translation_balls {
 public:
  Translation_balls() = default;
  /// Balls inside the bodies, in one view. Translations that are asked for have coordinates of at most `most`.
  Translation_balls(const std::vector<Ball>& in_a, const std::vector<Ball>& in_b, double most)
  {
    std::vector<Ball> all;
    for (const Ball& a : in_a)
      for (const Ball& b : in_b) {
        Ball ball;
        double magnitude = most;
        for (std::size_t k = 0; k < 3; ++k) {
          ball.centre[k] = b.centre[k] - a.centre[k];
          magnitude += std::abs(a.centre[k]) + std::abs(b.centre[k]);
        }
        ball.radius = (a.radius + b.radius) * (1 - kernel::few_roundings) - magnitude * kernel::few_roundings;
        double square = 0;
        for (const double x : ball.centre) square += x * x;
        if (ball.radius >= 0x1p-200 && std::sqrt(square) - ball.radius < 2 * most) all.push_back(ball);
      }
    balls_ = largest_balls(std::move(all), 1000, 0.01);
  }

  /// True when one of the balls surely has all translations of the box.
  bool hold(const kernel::Translation_box& box) const
  {
    return std::ranges::any_of(balls_, [&](const Ball& ball) {
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = std::abs(box.centre[k] - ball.centre[k]) + box.half[k];
        square += x * x;
      }
      return square < ball.radius * ball.radius * (1 - kernel::few_roundings);
    });
  }

 private:
  std::vector<Ball> balls_;
};

}  // namespace tetracone::tetratree

#endif
