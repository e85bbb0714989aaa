#ifndef TETRACONE_VERIFY_TEST_SUPPORT_PLACED_BOXES_H
#define TETRACONE_VERIFY_TEST_SUPPORT_PLACED_BOXES_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/oriented_box.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <array>

/// Boxes and bodies, placed at random and exactly.
namespace tetracone::verify::scenes {

/// A random vector with coordinates up to `size`.
inline kernel::Vector vector(Random& random, double size = 1)
{
  return size * kernel::Vector(real(random, -1, 1), real(random, -1, 1), real(random, -1, 1));
}

/// Returns the solution x of m x = v (Cramer's rule).
inline kernel::Vector solved(const kernel::Matrix& m, const kernel::Vector& v)
{
  const kernel::Vector yz = m.col(1).cross(m.col(2)), zx = m.col(2).cross(m.col(0)), xy = m.col(0).cross(m.col(1));
  return kernel::Vector(yz.dot(v), zx.dot(v), xy.dot(v)) / yz.dot(m.col(0));
}

inline void set(kernel::Obb8& boxes, int lane, const kernel::Vector& centre, const kernel::Matrix& axes,
                const kernel::Vector& extent)
{
  for (int i = 0; i < 3; ++i) {
    boxes.centre[i][lane] = float(centre[i]);
    boxes.extent[i][lane] = float(extent[i]);
    for (int k = 0; k < 3; ++k) boxes.axis[i][k][lane] = float(axes(k, i));
  }
}

/// Returns the exact point of a box with these fractions of the extents as coordinates.
inline rationals::Vector point(const kernel::Obb8& boxes, int lane, const std::array<double, 3>& share)
{
  using kernel::Rational;
  rationals::Vector p;
  for (int k = 0; k < 3; ++k) {
    p[k] = Rational(boxes.origin[k]) + Rational(boxes.centre[k][lane]);
    for (int i = 0; i < 3; ++i)
      p[k] += Rational(share[i]) * Rational(boxes.extent[i][lane]) * Rational(boxes.axis[i][k][lane]);
  }
  return p;
}

/// Two bodies, and their local units.
struct Placing {
  kernel::Pose a, b;
  kernel::Local_scale in_a, in_b;

  kernel::Box_map map() const { return {a, in_a, b, in_b}; }

  /// The exact image, in A's local units, of a point in B's local units.
  rationals::Vector image(const rationals::Vector& p) const
  {
    using kernel::Rational;
    rationals::Vector v, column[3];
    for (int k = 0; k < 3; ++k) v[k] = Rational(in_b.origin[k]) + Rational(in_b.unit) * p[k];
    rationals::Vector right = rationals::image(b, v);
    for (int i = 0; i < 3; ++i) {
      right[i] -= a.exact(4 * i + 3);
      for (int j = 0; j < 3; ++j) column[j][i] = a.exact(4 * i + j);
    }
    const Rational whole = rationals::determinant(column[0], column[1], column[2]);
    const Rational x[3] = {rationals::determinant(right, column[1], column[2]),
                           rationals::determinant(column[0], right, column[2]),
                           rationals::determinant(column[0], column[1], right)};
    for (int k = 0; k < 3; ++k) v[k] = (x[k] / whole - Rational(in_a.origin[k])) / Rational(in_a.unit);
    return v;
  }
};

}  // namespace tetracone::verify::scenes

#endif
