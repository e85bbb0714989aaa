#ifndef TETRACONE_VERIFY_CASES_EXACT_MAP_H
#define TETRACONE_VERIFY_CASES_EXACT_MAP_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

/// Vectors and affine maps in rationals, to make cases that are exactly degenerate.
namespace tetracone::verify::object_family {

using Exact_vector = std::array<kernel::Rational, 3>;

inline Exact_vector exact(const kernel::Vertex& v)
{
  return {kernel::Rational(v[0]), kernel::Rational(v[1]), kernel::Rational(v[2])};
}

/// Returns the vertex at exactly `v`; nothing when some coordinate is no double.
inline std::optional<kernel::Vertex> exactly(const Exact_vector& v)
{
  kernel::Vertex vertex;
  for (int i = 0; i < 3; ++i) {
    vertex[i] = kernel::nearest_double(v[i]);
    if (!std::isfinite(vertex[i]) || kernel::Rational(vertex[i]) != v[i]) return std::nullopt;
  }
  return vertex;
}

/// Returns the vertex nearest to `v`; a coordinate beyond the doubles is infinite.
inline kernel::Vertex rounded(const Exact_vector& v)
{
  return {kernel::nearest_double(v[0]), kernel::nearest_double(v[1]), kernel::nearest_double(v[2])};
}

/// Returns a + s b.
inline Exact_vector sum(const Exact_vector& a, const kernel::Rational& s, const Exact_vector& b)
{
  return {kernel::Rational(a[0] + s * b[0]), kernel::Rational(a[1] + s * b[1]), kernel::Rational(a[2] + s * b[2])};
}
inline Exact_vector sum(const Exact_vector& a, const Exact_vector& b) { return sum(a, kernel::Rational(1), b); }
inline Exact_vector difference(const Exact_vector& a, const Exact_vector& b) { return sum(a, kernel::Rational(-1), b); }
inline Exact_vector times(const kernel::Rational& s, const Exact_vector& a)
{
  return {kernel::Rational(s * a[0]), kernel::Rational(s * a[1]), kernel::Rational(s * a[2])};
}
inline kernel::Rational dot(const Exact_vector& a, const Exact_vector& b)
{
  return kernel::Rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}
inline Exact_vector cross(const Exact_vector& a, const Exact_vector& b)
{
  return {kernel::Rational(a[1] * b[2] - a[2] * b[1]), kernel::Rational(a[2] * b[0] - a[0] * b[2]),
          kernel::Rational(a[0] * b[1] - a[1] * b[0])};
}
inline bool is_zero(const Exact_vector& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

/// Returns `a` times the power of two that brings its largest component into [1/2, 1). Requires a vector that is not
/// zero. Its components may be beyond the doubles.
inline Exact_vector scaled_to_one(const Exact_vector& a)
{
  kernel::Rational largest = 0;
  for (const kernel::Rational& x : a) largest = std::max(largest, kernel::Rational(abs(x)));
  const auto bits = [](const mpz_class& n) { return int(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  int exponent = bits(largest.get_num()) - bits(largest.get_den());  // off by one at most
  const auto power = [](int n) -> kernel::Rational {
    const kernel::Rational whole(mpz_class(1) << mp_bitcnt_t(std::abs(n)));
    return n < 0 ? kernel::Rational(1 / whole) : whole;
  };
  if (largest >= power(exponent)) ++exponent;
  return times(power(-exponent), a);
}

/// Returns M v + t.
inline Exact_vector image(const kernel::Pose& pose, const Exact_vector& v)
{
  Exact_vector result;
  for (int i = 0; i < 3; ++i)
    result[i] =
        pose.exact(4 * i) * v[0] + pose.exact(4 * i + 1) * v[1] + pose.exact(4 * i + 2) * v[2] + pose.exact(4 * i + 3);
  return result;
}

/// Returns M v.
inline Exact_vector turned(const kernel::Pose& pose, const Exact_vector& v)
{
  return difference(image(pose, v), {pose.exact(3), pose.exact(7), pose.exact(11)});
}

/// Returns the point that the pose maps to x. Requires det M != 0.
inline Exact_vector preimage(const kernel::Pose& pose, const Exact_vector& x)
{
  if (pose.is_identity()) return x;
  std::array<Exact_vector, 3> column;
  for (int j = 0; j < 3; ++j) column[j] = {pose.exact(j), pose.exact(4 + j), pose.exact(8 + j)};
  const Exact_vector y = difference(x, {pose.exact(3), pose.exact(7), pose.exact(11)});
  const kernel::Rational determinant = dot(column[0], cross(column[1], column[2]));
  const auto coordinate = [&](int j) -> kernel::Rational {
    return dot(y, cross(column[(j + 1) % 3], column[(j + 2) % 3])) / determinant;
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// Returns v M, that is, the row w with w x = v (M x).
inline Exact_vector pulled_back(const kernel::Pose& pose, const Exact_vector& v)
{
  Exact_vector result;
  for (int j = 0; j < 3; ++j) result[j] = v[0] * pose.exact(j) + v[1] * pose.exact(4 + j) + v[2] * pose.exact(8 + j);
  return result;
}

/// Returns the map that applies `first`, then `second`.
inline kernel::Pose composed(const kernel::Pose& second, const kernel::Pose& first)
{
  std::array<kernel::Rational, 12> entries;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) {
      kernel::Rational entry = j == 3 ? second.exact(4 * i + 3) : kernel::Rational(0);
      for (int k = 0; k < 3; ++k) entry += second.exact(4 * i + k) * first.exact(4 * k + j);
      entries[4 * i + j] = entry;
    }
  return kernel::Pose(entries);
}

/// Returns the map that applies `pose`, then the translation by `shift`.
inline kernel::Pose moved(const kernel::Pose& pose, const Exact_vector& shift)
{
  std::array<kernel::Rational, 12> entries;
  for (int k = 0; k < 12; ++k) entries[k] = pose.exact(k);
  for (int i = 0; i < 3; ++i) entries[4 * i + 3] += shift[i];
  return kernel::Pose(entries);
}

/// The map x -> diag(scale) x.
inline kernel::Pose scaling(double x, double y, double z)
{
  return kernel::Pose(std::array<double, 12>{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0});
}
inline kernel::Pose scaling(double s) { return scaling(s, s, s); }

}  // namespace tetracone::verify::object_family

#endif
