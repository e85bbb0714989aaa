#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_POINTS_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_POINTS_H

#include "tetracone/kernel/number/pose.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// Placed points in the integers of GMP, with which the second truth and the distance to degeneracy compute. They use
/// no number type, predicate or construction of CGAL's; poses and vertices are only read.
namespace tetracone::verify {

using Integer = mpz_class;
using Integer_vector = std::array<Integer, 3>;  ///< also a point

inline Integer_vector difference(const Integer_vector& a, const Integer_vector& b)
{
  return {Integer(a[0] - b[0]), Integer(a[1] - b[1]), Integer(a[2] - b[2])};
}
inline Integer dot(const Integer_vector& a, const Integer_vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Integer_vector cross(const Integer_vector& a, const Integer_vector& b)
{
  return {Integer(a[1] * b[2] - a[2] * b[1]), Integer(a[2] * b[0] - a[0] * b[2]), Integer(a[0] * b[1] - a[1] * b[0])};
}
inline bool is_zero(const Integer_vector& a) { return sgn(a[0]) == 0 && sgn(a[1]) == 0 && sgn(a[2]) == 0; }

/// The exact images of points: integers over one common denominator, which is positive.
struct Integer_points {
  std::vector<Integer_vector> points;
  Integer denominator = 1;

  /// Writes the points over `multiple`, a multiple of the denominator.
  void bring_to(const Integer& multiple)
  {
    const Integer factor = multiple / denominator;
    for (Integer_vector& point : points)
      for (Integer& coordinate : point) coordinate *= factor;
    denominator = multiple;
  }
};

/// Returns the images of model points under a pose. The denominator is the least common one of the pose's entries,
/// times a power of two.
inline Integer_points placed(std::span<const kernel::Vertex> vertices, const kernel::Pose& pose)
{
  std::array<mpq_class, 12> entries;
  Integer common = 1;
  for (int k = 0; k < 12; ++k) {
    entries[k] = pose.exact(k);
    common = lcm(common, entries[k].get_den());
  }
  std::array<Integer, 12> m;
  for (int k = 0; k < 12; ++k) m[k] = entries[k].get_num() * (common / entries[k].get_den());

  // A double's denominator is a power of two: coordinates times 2^shift are integers.
  std::vector<std::array<mpq_class, 3>> exact;
  mp_bitcnt_t shift = 0;
  for (const kernel::Vertex& vertex : vertices) {
    exact.push_back({mpq_class(vertex[0]), mpq_class(vertex[1]), mpq_class(vertex[2])});
    for (const mpq_class& coordinate : exact.back()) shift = std::max(shift, mpz_scan1(coordinate.get_den_mpz_t(), 0));
  }

  Integer_points images;
  images.denominator = common << shift;
  for (const auto& coordinates : exact) {
    Integer_vector x;
    for (int i = 0; i < 3; ++i)
      x[i] = coordinates[i].get_num() << (shift - mpz_scan1(coordinates[i].get_den_mpz_t(), 0));
    Integer_vector image;
    for (int i = 0; i < 3; ++i)
      image[i] = m[4 * i] * x[0] + m[4 * i + 1] * x[1] + m[4 * i + 2] * x[2] + (m[4 * i + 3] << shift);
    images.points.push_back(image);
  }
  return images;
}

/// Brings both over one denominator.
inline void bring_together(Integer_points& a, Integer_points& b)
{
  const Integer common = lcm(a.denominator, b.denominator);
  a.bring_to(common);
  b.bring_to(common);
}

}  // namespace tetracone::verify

#endif
