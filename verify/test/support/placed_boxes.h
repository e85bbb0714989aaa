#ifndef TETRACONE_VERIFY_TEST_SUPPORT_PLACED_BOXES_H
#define TETRACONE_VERIFY_TEST_SUPPORT_PLACED_BOXES_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/kernel/bound/oriented_box.h"
#include "verify/test/support/scenes.h"

#include <array>
#include <cmath>
#include <span>

/// Boxes and bodies, placed at random and exactly.
namespace tetracone::verify::scenes {

/// A random vector with coordinates up to `size`.
inline kernel::Vector vector(Random& random, double size = 1)
{
  return size * kernel::Vector(real(random, -1, 1), real(random, -1, 1), real(random, -1, 1));
}

/// Returns the vector of three numbers.
template <class Three>
kernel::Vector vector_of(const Three& x)
{
  return {double(x[0]), double(x[1]), double(x[2])};
}

/// Returns the solution x of m x = v (Cramer's rule).
inline kernel::Vector solved(const kernel::Matrix& m, const kernel::Vector& v)
{
  const kernel::Vector yz = m.col(1).cross(m.col(2)), zx = m.col(2).cross(m.col(0)), xy = m.col(0).cross(m.col(1));
  return kernel::Vector(yz.dot(v), zx.dot(v), xy.dot(v)) / yz.dot(m.col(0));
}

/// Writes a box into a lane, rounded to float; its edges are the columns of `axes`.
inline void set(kernel::Obb8& boxes, int lane, const kernel::Vector& centre, const kernel::Matrix& axes,
                const kernel::Vector& extent)
{
  for (int i = 0; i < 3; ++i) {
    boxes.centre[i][lane] = float(centre[i]);
    boxes.extent[i][lane] = float(extent[i]);
    for (int k = 0; k < 3; ++k) boxes.axis[i][k][lane] = float(axes(k, i));
  }
}

/// Returns random axes of a box, orthonormal up to rounding.
inline kernel::Matrix random_axes(Random& random) { return kernel::detail::axes_from(vector(random), vector(random)); }

/// Returns extents below 1. In about one call of three, one of them is 0, as for a triangle.
inline kernel::Vector random_extents(Random& random)
{
  kernel::Vector e(real(random, 0, 1), real(random, 0, 1), real(random, 0, 1));
  if (random() % 3 == 0) e[int(random() % 3)] = 0;
  return e;
}

/// A box; its edges are columns of length about 1.
struct Solid {
  kernel::Vector centre;
  kernel::Matrix edges;
  kernel::Vector extent;

  /// Rounds all numbers to float.
  void round()
  {
    centre = centre.in_float();
    edges = edges.in_float();
    extent = extent.in_float();
  }
  /// Returns the corner that reaches farthest along the direction.
  kernel::Vector corner(const kernel::Vector& direction) const
  {
    kernel::Vector at = centre;
    for (int i = 0; i < 3; ++i) at += (direction.dot(edges.col(i)) < 0 ? -extent[i] : extent[i]) * edges.col(i);
    return at;
  }
};

/// Writes the box into the lane, and raises the node's reach to an upper bound for it.
inline void set(kernel::Obb8& boxes, int lane, const Solid& s)
{
  set(boxes, lane, s.centre, s.edges, s.extent);
  boxes.reach = kernel::maximum(boxes.reach, float(s.extent.sum() + s.centre.norm()) * 1.000001f);
}

/// Returns the box about a triangle along the triangle's axes.
inline kernel::Oriented_box triangle_box(std::span<const kernel::Vector, 3> corners)
{
  return kernel::Oriented_box(kernel::triangle_axes(corners), corners);
}

/// Writes the box of these axes about the points into a lane.
inline void store_lane(kernel::Obb8& boxes, int lane, const kernel::Matrix& axes, const kernel::Vector& node_origin,
                       std::span<const kernel::Vector> points)
{
  kernel::Lane_box stored(axes, points.front());
  for (const kernel::Vector& p : points) stored.add(p);
  stored.store(boxes, lane, node_origin, 0);
}

/// Returns an edge of a box, of length about 1.
inline std::array<double, 3> axis(const kernel::Obb8& boxes, int lane, int i)
{
  return {boxes.axis[i][0][lane], boxes.axis[i][1][lane], boxes.axis[i][2][lane]};
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

/// The poses of two bodies, and their local units.
struct Placing {
  kernel::Pose a, b;
  kernel::Local_scale in_a, in_b;

  kernel::Box_map map() const { return {a, in_a, b, in_b}; }
  kernel::Relative_frame frame() const { return {a, in_a, b, in_b}; }

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

/// Returns the pose with its matrix times `factor`.
inline Pose scaled(const Pose& pose, double factor)
{
  auto entries = pose.entries();
  for (int k = 0; k < 12; ++k)
    if (k % 4 != 3) entries[k] *= factor;
  return Pose(entries);
}

/// Rounds both poses to doubles, and moves the bodies by `distance` times (1, 2, 3).
inline void move_far(Placing& p, double distance)
{
  for (Pose* const pose : {&p.a, &p.b}) {
    auto entries = pose->entries();
    for (int i = 0; i < 3; ++i) entries[4 * i + 3] += distance * (i + 1);
    *pose = Pose(entries);
  }
}

/// Returns the map that scales each axis.
inline Pose diagonal(double x, double y, double z)
{
  return Pose(std::array<double, 12>{x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0});
}

/// Returns two bodies in random rotations, with local units of different sizes.
inline Placing random_placing(Random& random)
{
  Placing p;
  p.a = rounded(random_rotation(random));
  p.b = random_rotation(random);
  for (kernel::Local_scale* const units : {&p.in_a, &p.in_b})
    *units = {real_vertex(random, 2), std::ldexp(1.0, integer(random, -3, 3))};
  return p;
}

/// Sets all lanes to random boxes of at most this size, with centres within twice the size of the origin.
inline void set_near(kernel::Obb8& boxes, Random& random, double size)
{
  for (int lane = 0; lane < int(kernel::lanes); ++lane)
    set(boxes, lane,
        {vector(random, 2 * size), random_axes(random),
         size * kernel::Vector(real(random, 0, 1), real(random, 0, 1), real(random, 0, 1))});
  boxes.lane_count = int(kernel::lanes);
}

/// Sets a lane to a random box of at most this size. With `apex`, it is a triangle's box, and its apex is chosen too.
/// Sets the node's origin, too.
inline void set_single(kernel::Obb8& boxes, int lane, Random& random, double size, float* apex)
{
  kernel::Vector extent = size * kernel::Vector(real(random, 0, 1), real(random, 0, 1), real(random, 0, 1));
  if (apex) {
    extent[0] = 0;
    *apex = float(real(random, -1, 1));
  }
  for (float& x : boxes.origin) x = float(real(random, -0.25, 0.25));
  set(boxes, lane, vector(random, 0.4), random_axes(random), extent);
}

}  // namespace tetracone::verify::scenes

#endif
