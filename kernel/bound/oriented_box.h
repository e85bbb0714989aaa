#ifndef TETRACONE_KERNEL_BOUND_ORIENTED_BOX_H
#define TETRACONE_KERNEL_BOUND_ORIENTED_BOX_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/vector.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/short_vectors.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace tetracone::kernel {

/// Mean and covariance of points.
struct Spread {
  Vector mean;
  Matrix covariance;

  explicit Spread(std::span<const Vector> points)
      : Spread(points.size(), [&](std::size_t k) -> const Vector& { return points[k]; })
  {}

  /// The spread of point(0) .. point(count - 1), in one pass about the first point, near all others. Requires count >
  /// 0.
  template <class Point>
  Spread(std::size_t count, const Point& point)
  {
    const Vector& about = point(0);
    double x = 0, y = 0, z = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    for (std::size_t k = 1; k < count; ++k) {
      const Vector p = point(k) - about;
      x += p[0];
      y += p[1];
      z += p[2];
      xx += p[0] * p[0];
      xy += p[0] * p[1];
      xz += p[0] * p[2];
      yy += p[1] * p[1];
      yz += p[1] * p[2];
      zz += p[2] * p[2];
    }
    const double n = double(count);
    const Vector shift(x / n, y / n, z / n);
    mean = about + shift;
    covariance = {{Vector(xx, xy, xz) / n - shift * shift[0], Vector(xy, yy, yz) / n - shift * shift[1],
                   Vector(xz, yz, zz) / n - shift * shift[2]}};
  }

  /// Returns the mean squared distance from the mean.
  double size() const { return covariance.trace(); }

  /// Returns orthonormal columns, with the direction of greatest spread last. Returns the identity if all points
  /// coincide or the solver fails.
  Matrix principal_axes() const
  {
    if (!(size() > 0)) return Matrix::identity();
    Eigen::Matrix3d of_eigen;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) of_eigen(i, j) = covariance(i, j);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(of_eigen);
    Matrix axes;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        axes(i, j) = solver.eigenvectors()(i, j);
        if (!std::isfinite(axes(i, j))) return Matrix::identity();
      }
    return axes;
  }
};

/// A box about points. The columns of `axes` are orthonormal up to rounding.
struct Oriented_box {
  Matrix axes;
  Vector centre, extent;

  /// The box of these axes about the points.
  Oriented_box(const Matrix& orthonormal, std::span<const Vector> points) : axes(orthonormal)
  {
    Vector low = Vector::all(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vector& p : points) {
      const Vector s = axes.transpose() * p;
      low = smaller(low, s);
      high = larger(high, s);
    }
    centre = axes * (0.5 * (low + high));
    extent = 0.5 * (high - low);
  }

  /// Returns an eighth of the surface.
  double surface() const { return extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0]; }
};

namespace detail {

/// Returns right-handed axes: the first along `first`, the second as near to `second` as possible. Requires that the
/// squares of their lengths, times 1e-20, are no denormals.
inline Matrix axes_from(const Vector& first, const Vector& second)
{
  Matrix axes;
  auto& [x, y, z] = axes.columns;
  x = first.normalized();
  Vector other = second - second.dot(x) * x;
  if (!(other.squared_norm() > 1e-20 * second.squared_norm())) {
    int least = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(x[i]) < std::abs(x[least])) least = i;
    other = Vector::unit(least) - x[least] * x;
  }
  y = other.normalized();
  z = x.cross(y);
  return axes;
}

/// Returns the axes turned about axis `about` by the angle of this tangent.
inline Matrix turned(const Matrix& axes, int about, double tangent)
{
  const double c = 1 / std::sqrt(1 + tangent * tangent), s = tangent * c;
  const int i = (about + 1) % 3, j = (about + 2) % 3;
  Matrix result = axes;
  result.col(i) = c * axes.col(i) + s * axes.col(j);
  result.col(j) = c * axes.col(j) - s * axes.col(i);
  return result;
}

/// A sample of at most 512 points, which tells how turning axes changes the surface of the box about them. Their
/// coordinates are floats, less the mean and divided by the root of the spread. They are kept four at a time.
class Turned_points {
 public:
  Turned_points(std::span<const Vector> points, const Spread& spread, const Matrix& axes)
  {
    // Points so near to one another that squares underflow count as one point.
    const double scale = spread.size() > 0x1p-900 ? 1 / std::sqrt(spread.size()) : 0;
    const Matrix to_axes = scale * axes.transpose();
    const std::size_t step = (points.size() + most - 1) / most;
    for (std::size_t k = 0; k < points.size() || count_ % 4 != 0; k += step) {
      const Vector& p = points[k < points.size() ? k : 0];
      const Vector at = to_axes * (p - spread.mean);
      for (int i = 0; i < 3; ++i) at_[count_ / 4][std::size_t(i)][count_ % 4] = static_cast<float>(at[i]);
      ++count_;
    }
    for (int i = 0; i < 3; ++i) length_[i] = turned(i, i, 1, 0)[0];
  }

  /// Turns the axes, and returns true, if that makes the surface smaller by more than the error of float.
  bool turn(int about, double tangent)
  {
    const int i = (about + 1) % 3, j = (about + 2) % 3;
    const auto c = static_cast<float>(1 / std::sqrt(1 + tangent * tangent)), s = static_cast<float>(tangent) * c;
    const std::array<float, 2> now = turned(i, j, c, s);
    if (!(surface(length_[about], now[0], now[1]) < 0.9999f * surface(length_[about], length_[i], length_[j])))
      return false;
    length_[i] = now[0];
    length_[j] = now[1];
    for (std::size_t k = 0; 4 * k < count_; ++k) {
      auto &x = at_[k][std::size_t(i)], &y = at_[k][std::size_t(j)];
      const Four_floats before = x;
      x = c * x + s * y;
      y = c * y - s * before;
    }
    return true;
  }

 private:
  static constexpr std::size_t most = 512;

  static float surface(float x, float y, float z) { return x * y + y * z + z * x; }

  static float largest_lane(Four_floats v)
  {
    v = larger(v, __builtin_shufflevector(v, v, 2, 3, 0, 1));
    return v[0] < v[1] ? v[1] : v[0];
  }

  /// Returns the lengths of the points along axes i and j when these are turned by the angle of this cosine and sine.
  std::array<float, 2> turned(int i, int j, float c, float s) const
  {
    Four_floats low_x = four_times(std::numeric_limits<float>::infinity()), low_y = low_x, high_x = -low_x,
                high_y = -low_x;
    for (std::size_t k = 0; 4 * k < count_; ++k) {
      const auto &x = at_[k][std::size_t(i)], &y = at_[k][std::size_t(j)];
      const Four_floats turned_x = c * x + s * y, turned_y = c * y - s * x;
      low_x = smaller(low_x, turned_x);
      high_x = larger(high_x, turned_x);
      low_y = smaller(low_y, turned_y);
      high_y = larger(high_y, turned_y);
    }
    return {largest_lane(high_x) + largest_lane(-low_x), largest_lane(high_y) + largest_lane(-low_y)};
  }

  std::array<std::array<Four_floats, 3>, most / 4> at_;
  std::array<float, 3> length_;
  std::size_t count_ = 0;
};

}  // namespace detail

/// Returns the axes of a box of little surface about the points. It starts from the eigenvectors of their covariance.
/// Each of `rounds` rounds turns them about each axis if that shrinks the surface. The turn's tangent starts at 1/2,
/// and each round halves it. A sample of some 500 points decides how to turn. Requires a point.
inline Matrix fitted_axes(std::span<const Vector> points, int rounds)
{
  const Spread spread(points);
  const Matrix start = spread.principal_axes();
  Matrix axes = detail::axes_from(start.col(0), start.col(2));
  detail::Turned_points tried(points, spread, axes);
  double tangent = 0.5;
  for (int round = 0; round < rounds; ++round, tangent *= 0.5)
    for (int axis = 0; axis < 3; ++axis)
      for (const double t : {tangent, -tangent})
        if (tried.turn(axis, t)) {
          axes = detail::turned(axes, axis, t);
          break;
        }
  return axes;
}

/// Returns the box of `fitted_axes` about the points.
inline Oriented_box fitted_box(std::span<const Vector> points, int rounds)
{
  return Oriented_box(fitted_axes(points, rounds), points);
}

/// Returns the axes of a triangle: its normal, and the direction of its longest edge. A triangle without area gives the
/// edge alone, or the identity.
inline Matrix triangle_axes(std::span<const Vector, 3> corners)
{
  int longest = 0;
  double length = -1;
  for (int k = 0; k < 3; ++k) {
    const double here = (corners[(k + 1) % 3] - corners[k]).squared_norm();
    if (here > length) {
      longest = k;
      length = here;
    }
  }
  // A triangle so small that squares of its sides' products would underflow counts as a point.
  if (!(length > 0x1p-400)) return Matrix::identity();
  const Vector edge = corners[(longest + 1) % 3] - corners[longest];
  const Vector normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (!(normal.squared_norm() > 1e-24 * length * length)) return detail::axes_from(edge, Vector(1, 0, 0));
  return detail::axes_from(normal, edge);
}

/// True when these columns, whose entries are floats, may be the axes of a lane's box: see `Obb8`.
inline bool is_nearly_orthonormal(const Matrix& axes)
{
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      if (!(std::abs(axes.col(i).dot(axes.col(j)) - (i == j)) <= axis_defect)) return false;
  return true;
}

/// A box that takes in one point after the other, to be written into a lane. Its axes are the given ones in float, or
/// the identity where these are not orthonormal.
class Lane_box {
 public:
  /// Requires a point `about` near those that will be added: errors grow with the distance from it.
  Lane_box(const Matrix& axes, const Vector& about) : about_(about)
  {
    const Matrix in_float = axes.in_float();
    if (!is_nearly_orthonormal(in_float)) {
      *this = Lane_box(Matrix::identity(), about);
      return;
    }
    const auto& axis = in_float.columns;
    for (int k = 0; k < 3; ++k) across_[k] = {axis[0][k], axis[1][k], axis[2][k]};
  }

  [[gnu::always_inline]] void add(const Vector& p)
  {
    const Four s = along(p - about_);
    low_ = smaller(low_, s);
    high_ = larger(high_, s);
    sum_ = sum_ + s;
  }

  /// Adds the points of another box with the same axes and the same `about`.
  void add(const Lane_box& other)
  {
    low_ = smaller(low_, other.low_);
    high_ = larger(high_, other.high_);
    sum_ = sum_ + other.sum_;
  }

  /// Returns the centre, rounded. Requires an added point.
  Vector centre() const
  {
    const Four middle = (low_ + high_) * 0.5;
    Vector centre;
    for (int k = 0; k < 3; ++k) centre[k] = about_[k] + (across_[k] * middle).sum();
    return centre;
  }

  /// Writes the box into a lane, relative to the node's origin, which is exact in float. `point_error` is an upper
  /// bound of the error of a point's coordinate. Requires an added point.
  ///
  /// With axes a_i that are orthonormal up to a defect d, y = p - c is sum_i s_i a_i with |s_i| <= |a_i . y| + 3 d
  /// max_k |a_k . y| (1 + 4 d). The sums below are of p - b and c - b, b the point `about`. Each has at most 6
  /// roundings in double, far below `few_roundings` of |p - b|_1 + |c - b|_1. |p - b|_1 is at most sqrt(3) (1 + 3 d)
  /// times the sum of |a_i . (p - b)|. If a point has a NaN, so has the sum of all, and the extent.
  void store(Obb8& boxes, int lane, const Vector& node_origin, double point_error) const
  {
    const Vector middle = centre();
    Vector from_about, extent;
    for (int i = 0; i < 3; ++i) {
      boxes.centre[i][lane] = to_float(middle[i] - node_origin[i]);
      from_about[i] = (double(boxes.centre[i][lane]) + node_origin[i]) - about_[i];
      for (int k = 0; k < 3; ++k) boxes.axis[i][k][lane] = to_float(across_[k][i]);
    }
    const Four at = along(from_about);
    double size = from_about.norm_1();
    for (int i = 0; i < 3; ++i) {
      extent[i] = maximum(high_[i] - at[i], at[i] - low_[i]);
      size += 2 * maximum(std::abs(low_[i]), std::abs(high_[i]));
    }
    const double margin = axis_defect_factor * axis_defect * maximum(extent[0], extent[1], extent[2]) +
                          few_roundings * size + axis_norm_1 * point_error + 0 * sum_.sum();
    for (int i = 0; i < 3; ++i)
      boxes.extent[i][lane] = std::nextafter(to_float(extent[i] + margin), std::numeric_limits<float>::infinity());
  }

 private:
  /// Three numbers, one per axis; the fourth is 0.
  struct Four {
    Two_doubles first{}, last{};

    Four() = default;
    Four(double x, double y, double z) : first{x, y}, last{z, 0} {}
    Four(Two_doubles a, Two_doubles b) : first(a), last(b) {}

    double operator[](int i) const { return i < 2 ? first[i] : last[i - 2]; }
    Four operator-() const { return {-first, -last}; }
    Four operator+(const Four& f) const { return {first + f.first, last + f.last}; }
    Four operator*(const Four& f) const { return {first * f.first, last * f.last}; }
    Four operator*(double s) const { return {first * s, last * s}; }
    friend Four smaller(const Four& a, const Four& b)
    {
      return {kernel::smaller(a.first, b.first), kernel::smaller(a.last, b.last)};
    }
    friend Four larger(const Four& a, const Four& b)
    {
      return {kernel::larger(a.first, b.first), kernel::larger(a.last, b.last)};
    }
    double sum() const
    {
      const Two_doubles two = first + last;
      return two[0] + two[1];
    }
  };

  Four along(const Vector& y) const { return across_[0] * y[0] + across_[1] * y[1] + across_[2] * y[2]; }

  Vector about_;
  std::array<Four, 3> across_;  // coordinate k of the three axes
  Four low_{two_times(std::numeric_limits<double>::infinity()), two_times(std::numeric_limits<double>::infinity())},
      high_ = -low_, sum_;
};

/// A lane's box, and the coordinates of points along its axes from its centre.
class Apex_box {
 public:
  Apex_box(const Obb8& boxes, int lane, const Vector& node_origin)
      : boxes_(boxes),
        lane_(lane),
        e1_(boxes.extent[1][lane]),
        e2_(boxes.extent[2][lane]),
        centre_(node_origin + Vector(boxes.centre[0][lane], boxes.centre[1][lane], boxes.centre[2][lane]))
  {}

  double along(int i, const Vector& p) const
  {
    return (p - centre_).dot(Vector(boxes_.axis[i][0][lane_], boxes_.axis[i][1][lane_], boxes_.axis[i][2][lane_]));
  }

  /// True when the triangle, which the box holds, lies where the code says. A code of 0 says nothing: true.
  bool holds(std::span<const Vector, 3> corners, Apex_code code) const
  {
    if (code == 0) return true;
    if (!(e1_ > 0)) return false;
    // The triangle is before the lines from (-e1, -e2) and from (e1, -e2) to the apex. Each line is given by its normal
    // (x, y) and its support.
    const double apex = apex_of(code), tolerance = apex_tolerance * (e1_ + e2_);
    std::array<std::array<double, 2>, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = {along(1, corners[k]), along(2, corners[k])};
    for (const auto& [x, y, reach] : {std::array{-2 * e2_, e1_ * (1 + apex), e1_ * e2_ * (1 - apex)},
                                      std::array{2 * e2_, e1_ * (1 - apex), e1_ * e2_ * (1 + apex)}})
      for (const auto& [along_1, along_2] : at)
        if (!(x * along_1 + y * along_2 <= reach + tolerance * (std::abs(x) + y))) return false;
    return true;
  }

  double e1() const { return e1_; }

 private:
  const Obb8& boxes_;
  int lane_;
  double e1_, e2_;
  Vector centre_;
};

/// Returns the code of the triangle whose box `Lane_box` has written into `lane`. Returns 0 where the triangle does not
/// lie as the code says, which is checked.
inline Apex_code apex_code(const Obb8& boxes, int lane, const Vector& node_origin, std::span<const Vector, 3> corners)
{
  const Apex_box box(boxes, lane, node_origin);
  const Vector* top = &corners[0];
  for (const Vector& p : corners)
    if (box.along(2, p) > box.along(2, *top)) top = &p;
  if (!(box.e1() > 0)) return 0;
  const double apex = std::clamp(box.along(1, *top) / box.e1(), -1.0, 1.0);
  const auto code = Apex_code(apex_steps + 1 + std::lround(apex_steps * apex));
  return box.holds(corners, code) ? code : 0;
}

}  // namespace tetracone::kernel

#endif
