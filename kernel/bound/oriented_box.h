#ifndef TETRACONE_KERNEL_BOUND_ORIENTED_BOX_H
#define TETRACONE_KERNEL_BOUND_ORIENTED_BOX_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/number/floating_point.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace tetracone::kernel {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

/// Mean and covariance of points.
struct Spread {
  Vector mean = Vector::Zero();
  Matrix covariance = Matrix::Zero();

  explicit Spread(std::span<const Vector> points)
  {
    for (const Vector& p : points) mean += p;
    mean /= double(points.size());
    for (const Vector& p : points) covariance += (p - mean) * (p - mean).transpose();
    covariance /= double(points.size());
  }

  double size() const { return covariance.trace(); }

  /// Orthonormal columns, that of greatest spread the last; those of the identity where no direction is told from
  /// another.
  Matrix principal_axes() const
  {
    if (!(size() > 0)) return Matrix::Identity();
    Eigen::SelfAdjointEigenSolver<Matrix> solver;
    solver.computeDirect(covariance);
    return solver.eigenvectors().allFinite() ? solver.eigenvectors() : Matrix::Identity();
  }
};

/// A box about points: columns of `axes` orthonormal, up to rounding.
struct Oriented_box {
  Matrix axes;
  Vector centre, extent;

  /// The box of these axes about the points.
  Oriented_box(const Matrix& orthonormal, std::span<const Vector> points) : axes(orthonormal)
  {
    Vector low = Vector::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vector& p : points) {
      const Vector s = axes.transpose() * p;
      low = low.cwiseMin(s);
      high = high.cwiseMax(s);
    }
    centre = axes * (0.5 * (low + high));
    extent = 0.5 * (high - low);
  }

  double surface() const { return extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0]; }
};

namespace detail {

/// Right-handed axes: the first is `first`, the second as near to `second` as can be. Requires that the squares
/// of their lengths, times 1e-20, are no denormals.
inline Matrix axes_from(const Vector& first, const Vector& second)
{
  Matrix axes;
  axes.col(0) = first.normalized();
  Vector other = second - second.dot(axes.col(0)) * axes.col(0);
  if (!(other.squaredNorm() > 1e-20 * second.squaredNorm())) {
    int least = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(axes(i, 0)) < std::abs(axes(least, 0))) least = i;
    other = Vector::Unit(least) - axes(least, 0) * axes.col(0);
  }
  axes.col(1) = other.normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

/// The axes turned about axis `about` by the angle of this tangent.
inline Matrix turned(const Matrix& axes, int about, double tangent)
{
  const double c = 1 / std::sqrt(1 + tangent * tangent), s = tangent * c;
  const int i = (about + 1) % 3, j = (about + 2) % 3;
  Matrix result = axes;
  result.col(i) = c * axes.col(i) + s * axes.col(j);
  result.col(j) = c * axes.col(j) - s * axes.col(i);
  return result;
}

}  // namespace detail

/// A box of little surface about the points: from the eigenvectors of their covariance, turned about each axis in turn
/// while that makes the surface smaller, by `rounds` rounds of halved angles. Of many points, some 500 tell how to
/// turn.
inline Oriented_box fitted_box(std::span<const Vector> points, int rounds)
{
  constexpr std::size_t enough = 512;
  std::vector<Vector> some;
  std::span<const Vector> tried = points;
  if (points.size() > enough) {
    const std::size_t step = (points.size() + enough - 1) / enough;
    for (std::size_t k = 0; k < points.size(); k += step) some.push_back(points[k]);
    tried = some;
  }
  const Matrix start = Spread(points).principal_axes();
  Oriented_box best(detail::axes_from(start.col(0), start.col(2)), tried);
  double tangent = 0.5;
  for (int round = 0; round < rounds; ++round, tangent *= 0.5)
    for (int axis = 0; axis < 3; ++axis)
      for (const double t : {tangent, -tangent}) {
        const Oriented_box turned(detail::turned(best.axes, axis, t), tried);
        if (turned.surface() < best.surface()) {
          best = turned;
          break;
        }
      }
  return some.empty() ? best : Oriented_box(best.axes, points);
}

/// The box of a triangle: its plane, and along its longest edge.
inline Oriented_box triangle_box(std::span<const Vector, 3> corners)
{
  int longest = 0;
  double length = -1;
  for (int k = 0; k < 3; ++k) {
    const double here = (corners[(k + 1) % 3] - corners[k]).squaredNorm();
    if (here > length) {
      longest = k;
      length = here;
    }
  }
  // So small that squares of its sides' products would underflow: as good as a point.
  if (!(length > 0x1p-400)) return Oriented_box(Matrix::Identity(), corners);
  const Vector edge = corners[(longest + 1) % 3] - corners[longest];
  const Vector normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (!(normal.squaredNorm() > 1e-24 * length * length))
    return Oriented_box(detail::axes_from(edge, Vector(1, 0, 0)), corners);
  return Oriented_box(detail::axes_from(normal, edge), corners);
}

/// Writes the box into a lane, relative to the node's origin, in float. `points` are all that it must hold; the extents
/// are found again for the float axes and centre, and axes that came out not orthonormal are those of the identity
/// instead. `point_error` bounds how far a coordinate of a point may be from the exact one.
///
/// With axes a_i that are orthonormal but for a defect d, y = p - c is sum_i s_i a_i with |s_i| <= |a_i . y| + 3 d
/// max_k |a_k . y| (1 + 4 d); the sums below are rounded 6 times in double, far below `few_roundings` of |y|_1.
inline void store_lane(Obb8& boxes, int lane, const Oriented_box& box, const Vector& node_origin,
                       std::span<const Vector> points, double point_error)
{
  std::array<Vector, 3> axis;
  Vector centre;
  for (int i = 0; i < 3; ++i) {
    boxes.centre[i][lane] = static_cast<float>(box.centre[i] - node_origin[i]);
    centre[i] = double(boxes.centre[i][lane]) + node_origin[i];
    for (int k = 0; k < 3; ++k) {
      boxes.axis[i][k][lane] = static_cast<float>(box.axes(k, i));
      axis[i][k] = boxes.axis[i][k][lane];
    }
  }
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      if (!(std::abs(axis[i].dot(axis[j]) - (i == j)) <= axis_defect)) {
        store_lane(boxes, lane, Oriented_box(Matrix::Identity(), points), node_origin, points, point_error);
        return;
      }
  Vector extent = Vector::Zero();
  double size = 0;
  for (const Vector& p : points) {
    const Vector y = p - centre;
    for (int i = 0; i < 3; ++i) extent[i] = maximum(extent[i], std::abs(axis[i].dot(y)));
    size = maximum(size, y.cwiseAbs().sum());
  }
  const double margin =
      axis_defect_factor * axis_defect * extent.maxCoeff() + few_roundings * size + axis_norm_1 * point_error;
  for (int i = 0; i < 3; ++i)
    boxes.extent[i][lane] =
        std::nextafter(static_cast<float>(extent[i] + margin), std::numeric_limits<float>::infinity());
}

/// Where the triangle lies in the lane that `store_lane` has written for it; 0 where it is not as `Apex_code` says,
/// which is checked.
inline Apex_code apex_code(const Obb8& boxes, int lane, const Vector& node_origin, std::span<const Vector, 3> corners)
{
  const double e1 = boxes.extent[1][lane], e2 = boxes.extent[2][lane], tolerance = apex_tolerance * (e1 + e2);
  const Vector centre = node_origin + Vector(boxes.centre[0][lane], boxes.centre[1][lane], boxes.centre[2][lane]);
  const auto along = [&](int i, const Vector& p) {
    return (p - centre).dot(Vector(boxes.axis[i][0][lane], boxes.axis[i][1][lane], boxes.axis[i][2][lane]));
  };
  const Vector* top = &corners[0];
  for (const Vector& p : corners)
    if (along(2, p) > along(2, *top)) top = &p;
  if (!(e1 > 0)) return 0;
  const auto code = Apex_code(apex_steps + 1 + std::lround(apex_steps * std::clamp(along(1, *top) / e1, -1.0, 1.0)));
  // Before the lines from (-e1, -e2) and from (e1, -e2) to the apex, each by its normal (x, y) and reach.
  const double apex = apex_of(code);
  for (const auto& [x, y, reach] : {std::array{-2 * e2, e1 * (1 + apex), e1 * e2 * (1 - apex)},
                                    std::array{2 * e2, e1 * (1 - apex), e1 * e2 * (1 + apex)}})
    for (const Vector& p : corners)
      if (!(x * along(1, p) + y * along(2, p) <= reach + tolerance * (std::abs(x) + y))) return 0;
  return code;
}

}  // namespace tetracone::kernel

#endif
