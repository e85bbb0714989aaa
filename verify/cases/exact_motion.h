#ifndef TETRACONE_VERIFY_CASES_EXACT_MOTION_H
#define TETRACONE_VERIFY_CASES_EXACT_MOTION_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "verify/cases/exact_map.h"
#include "verify/cases/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

/// Exact changes of points and poses, which return nothing when the result is no double.
namespace tetracone::verify {

/// Returns a number from 0 to `count` - 1. Requires count > 0.
inline std::size_t one_of(Random& random, std::size_t count) { return random.bits() % count; }

/// Returns a + b.
inline std::optional<double> exact_sum(double a, double b)
{
  // Knuth's two-sum gives the rounding error of the sum. Its intermediate exponents do not exceed the operands' and the
  // sum's.
  const double sum = a + b;
  if (!std::isfinite(sum)) return std::nullopt;
  const double part = sum - a, lost = (a - (sum - part)) + (b - part);
  return lost == 0 ? std::optional(sum) : std::nullopt;
}

/// Returns x * 2^exponent.
inline std::optional<double> exact_scaled(double x, int exponent)
{
  const double scaled = std::ldexp(x, exponent);
  return std::isfinite(scaled) && std::ldexp(scaled, -exponent) == x ? std::optional(scaled) : std::nullopt;
}

/// Returns (a + b) / 2.
inline std::optional<double> exact_middle(double a, double b)
{
  const auto sum = exact_sum(a, b);
  return sum ? exact_scaled(*sum, -1) : std::nullopt;
}

/// Returns the vertex with coordinates change(0), change(1), change(2); nothing when one of these is nothing.
template <class Change>
std::optional<kernel::Vertex> each_coordinate(const Change& change)
{
  kernel::Vertex result;
  for (int k = 0; k < 3; ++k) {
    const std::optional<double> coordinate = change(k);
    if (!coordinate) return std::nullopt;
    result[k] = *coordinate;
  }
  return result;
}

/// Returns the sum, the multiple by 2^exponent, or the middle of vertices, coordinate by coordinate.
inline std::optional<kernel::Vertex> exact_sum(const kernel::Vertex& a, const kernel::Vertex& b)
{
  return each_coordinate([&](int k) { return exact_sum(a[k], b[k]); });
}
inline std::optional<kernel::Vertex> exact_scaled(const kernel::Vertex& v, int exponent)
{
  return each_coordinate([&](int k) { return exact_scaled(v[k], exponent); });
}
inline std::optional<kernel::Vertex> exact_middle(const kernel::Vertex& a, const kernel::Vertex& b)
{
  return each_coordinate([&](int k) { return exact_middle(a[k], b[k]); });
}

/// One of the 48 maps x -> (sign[0] x[axis[0]], sign[1] x[axis[1]], sign[2] x[axis[2]]): exact on any double.
struct Signed_permutation {
  std::array<int, 3> axis{0, 1, 2}, sign{1, 1, 1};

  /// Returns one at random, each as likely as another.
  static Signed_permutation any(Random& random)
  {
    Signed_permutation p;
    std::swap(p.axis[0], p.axis[one_of(random, 3)]);
    std::swap(p.axis[1], p.axis[1 + one_of(random, 2)]);
    for (int& s : p.sign) s = one_of(random, 2) == 0 ? 1 : -1;
    return p;
  }

  bool is_identity() const { return axis == std::array{0, 1, 2} && sign == std::array{1, 1, 1}; }

  /// Returns the determinant of its matrix, 1 or -1.
  int determinant() const
  {
    const bool cyclic = (axis[1] - axis[0] + 3) % 3 == 1;
    return (cyclic ? 1 : -1) * sign[0] * sign[1] * sign[2];
  }

  kernel::Vertex operator()(const kernel::Vertex& v) const
  {
    return {sign[0] * v[axis[0]], sign[1] * v[axis[1]], sign[2] * v[axis[2]]};
  }
};

/// The twelve entries of a pose as rationals.
using Entries = std::array<kernel::Rational, 12>;
inline Entries entries_of(const kernel::Pose& pose)
{
  Entries entries;
  for (int k = 0; k < 12; ++k) entries[k] = pose.exact(k);
  return entries;
}

/// Returns the pose with these entries; nothing when one is beyond the doubles' range, or when fractions are not
/// allowed and one is no double.
inline std::optional<kernel::Pose> exact_pose(const Entries& entries, bool fractions_allowed)
{
  for (const kernel::Rational& entry : entries)
    if (!std::isfinite(kernel::nearest_double(entry))) return std::nullopt;
  const kernel::Pose pose(entries);
  return pose.is_rational() && !fractions_allowed ? std::nullopt : std::optional(pose);
}

/// Returns the map that applies the pose, then the permutation.
inline kernel::Pose turned(const Signed_permutation& p, const kernel::Pose& pose)
{
  const Entries m = entries_of(pose);
  Entries result;
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < 4; ++k) result[4 * row + k] = p.sign[row] * m[4 * p.axis[row] + k];
  return kernel::Pose(result);
}

/// Returns the pose that maps p(x) to the image of x under `pose`.
inline kernel::Pose turned_back(const kernel::Pose& pose, const Signed_permutation& p)
{
  const Entries m = entries_of(pose);
  Entries result = m;
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < 3; ++k) result[4 * row + k] = p.sign[k] * m[4 * row + p.axis[k]];
  return kernel::Pose(result);
}

/// Returns the map that applies the pose, then the translation by `d`. A pose of doubles stays one.
inline std::optional<kernel::Pose> translated(const kernel::Pose& pose, const std::array<kernel::Rational, 3>& d)
{
  Entries m = entries_of(pose);
  for (int row = 0; row < 3; ++row) m[4 * row + 3] += d[row];
  return exact_pose(m, pose.is_rational());
}

/// Returns the pose that maps x + d to the image of x under `pose`. A pose of doubles stays one.
inline std::optional<kernel::Pose> translated_back(const kernel::Pose& pose, const kernel::Vertex& d)
{
  std::array<kernel::Rational, 3> shift;
  for (int row = 0; row < 3; ++row) {
    shift[row] = 0;
    for (int k = 0; k < 3; ++k) shift[row] -= pose.exact(4 * row + k) * kernel::Rational(d[k]);
  }
  return translated(pose, shift);
}

/// Returns the inverse of `pose`, applied after `first`; nothing if it needs fractions and neither of the two has any.
inline std::optional<kernel::Pose> seen_from(const kernel::Pose& pose, const kernel::Pose& first)
{
  using namespace object_family;
  const Exact_vector origin = preimage(pose, image(first, {0, 0, 0}));
  Entries result;
  for (int k = 0; k < 3; ++k) {
    const Exact_vector axis = difference(preimage(pose, image(first, {k == 0, k == 1, k == 2})), origin);
    for (int row = 0; row < 3; ++row) result[4 * row + k] = axis[row];
    result[4 * k + 3] = origin[k];
  }
  return exact_pose(result, pose.is_rational() || first.is_rational());
}

/// Returns the pose with its translation times 2^exponent. It maps 2^exponent x to 2^exponent times the image of x. A
/// pose of doubles stays one. Returns nothing when 2^exponent is no double.
inline std::optional<kernel::Pose> scaled(const kernel::Pose& pose, int exponent)
{
  const double power = std::ldexp(1.0, exponent);
  if (power == 0 || !std::isfinite(power)) return std::nullopt;
  Entries m = entries_of(pose);
  for (int row = 0; row < 3; ++row) m[4 * row + 3] *= kernel::Rational(power);
  return exact_pose(m, pose.is_rational());
}

/// Returns the image of a point; nothing when it is no vertex of doubles.
inline std::optional<kernel::Vertex> exact_image(const kernel::Pose& pose, const kernel::Vertex& v)
{
  return object_family::exactly(object_family::image(pose, object_family::exact(v)));
}

/// Returns the largest absolute coordinate.
inline double magnitude(const kernel::Vertex& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

/// Returns the spacing of the doubles at x, at least the smallest denormal.
inline double ulp(double x)
{
  const int exponent = x == 0 ? -1022 : std::max(std::ilogb(x), -1022);
  return std::ldexp(1.0, exponent - 52);
}

}  // namespace tetracone::verify

#endif
