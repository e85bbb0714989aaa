#ifndef TETRACONE_KERNEL_PREDICATE_SIGNS_H
#define TETRACONE_KERNEL_PREDICATE_SIGNS_H

#include "tetracone/kernel/predicate/kernels.h"

#include <CGAL/enum.h>

#include <array>
#include <cmath>

/// The three signs that decide everything in this library: of a 3x3, a 2x2 and a 1x1 determinant of coordinate
/// differences. Where one is zero, the next tells coplanar, collinear and coincident positions apart.
namespace tetracone::kernel {

using CGAL::NEGATIVE;
using CGAL::POSITIVE;
using CGAL::Sign;
using CGAL::ZERO;

template <class K>
using Point = typename K::Point_3;

/// Returns the sign of det[b-a, c-a, d-a]: POSITIVE when d sees a, b, c counterclockwise from the side that (b-a) x
/// (c-a) points to. It is exact when K has exact signs, and then has the properties below. In the other kernels it is
/// rounded, or ZERO within the tolerance.
/// - (1) sign(b,a,c,d) = -sign(a,b,c,d) for each transposition of two arguments.
/// - (2) It is ZERO when two arguments are equal, or all four lie in one plane.
/// - (3) sign(Ma+t, ...) = sign(det M) sign(a, ...), where K has exact motion too.
template <class K>
Sign volume_sign(const Point<K>& a, const Point<K>& b, const Point<K>& c, const Point<K>& d)
{
  return typename K::Orientation_3()(a, b, c, d);
}

/// Returns the sign of component `axis` (0, 1, 2 = x, y, z) of (b-a) x (c-a): the orientation of the triangle projected
/// along it. (1) It changes with every transposition. (2) It is ZERO on all three axes exactly when a, b, c are
/// collinear or coincide.
template <class K>
Sign normal_sign(const Point<K>& a, const Point<K>& b, const Point<K>& c, int axis)
{
  using Point_2 = typename K::Point_2;
  const auto projected = [axis](const Point<K>& p) {
    return axis == 0 ? Point_2(p.y(), p.z()) : axis == 1 ? Point_2(p.z(), p.x()) : Point_2(p.x(), p.y());
  };
  return typename K::Orientation_2()(projected(a), projected(b), projected(c));
}

/// Returns the sign of a[axis] - b[axis].
template <class K>
Sign difference_sign(const Point<K>& a, const Point<K>& b, int axis)
{
  if (axis == 0) return typename K::Compare_x_3()(a, b);
  if (axis == 1) return typename K::Compare_y_3()(a, b);
  return typename K::Compare_z_3()(a, b);
}

// --- Adaptive --------------------------------------------------------------------------------------------------------

template <>
inline Sign volume_sign<Adaptive>(const Adaptive::Point_3& a, const Adaptive::Point_3& b, const Adaptive::Point_3& c,
                                  const Adaptive::Point_3& d)
{
  return Adaptive::volume_sign(a, b, c, d);
}
template <>
inline Sign normal_sign<Adaptive>(const Adaptive::Point_3& a, const Adaptive::Point_3& b, const Adaptive::Point_3& c,
                                  int axis)
{
  return Adaptive::normal_sign(a, b, c, axis);
}
template <>
inline Sign difference_sign<Adaptive>(const Adaptive::Point_3& a, const Adaptive::Point_3& b, int axis)
{
  return Adaptive::difference_sign(a, b, axis);
}

// --- Tolerant --------------------------------------------------------------------------------------------------------

/// Returns the sign of `value`, or ZERO within the tolerance. `value` is a sum of products whose absolute values sum to
/// `permanent`.
inline Sign tolerant_sign(double value, double permanent)
{
  const Tolerance& tolerance = Tolerant::tolerance();
  if (std::abs(value) <= tolerance.absolute || std::abs(value) <= tolerance.relative * permanent) return ZERO;
  return CGAL::sign(value);
}
template <>
inline Sign volume_sign<Tolerant>(const Tolerant::Point_3& a, const Tolerant::Point_3& b, const Tolerant::Point_3& c,
                                  const Tolerant::Point_3& d)
{
  const auto difference = [&a](const Tolerant::Point_3& p) {
    return std::array<double, 3>{p.x() - a.x(), p.y() - a.y(), p.z() - a.z()};
  };
  const auto p = difference(b), q = difference(c), r = difference(d);
  double value = 0, permanent = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    value += (p[j] * q[k] - p[k] * q[j]) * r[i];
    permanent += (std::abs(p[j] * q[k]) + std::abs(p[k] * q[j])) * std::abs(r[i]);
  }
  return tolerant_sign(value, permanent);
}
template <>
inline Sign normal_sign<Tolerant>(const Tolerant::Point_3& a, const Tolerant::Point_3& b, const Tolerant::Point_3& c,
                                  int axis)
{
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double first = (b[i] - a[i]) * (c[j] - a[j]), second = (b[j] - a[j]) * (c[i] - a[i]);
  return tolerant_sign(first - second, std::abs(first) + std::abs(second));
}
template <>
inline Sign difference_sign<Tolerant>(const Tolerant::Point_3& a, const Tolerant::Point_3& b, int axis)
{
  return tolerant_sign(a[axis] - b[axis], std::abs(a[axis]) + std::abs(b[axis]));
}

// --- what follows from them ------------------------------------------------------------------------------------------

/// True when K finds the coordinates of a and b equal.
template <class K>
bool coincide(const Point<K>& a, const Point<K>& b)
{
  return difference_sign<K>(a, b, 0) == ZERO && difference_sign<K>(a, b, 1) == ZERO &&
         difference_sign<K>(a, b, 2) == ZERO;
}

/// Returns the first axis along which (b-a) x (c-a) is not zero, or -1 when a, b, c are collinear. Projection along
/// that axis keeps the plane of a, b, c a plane.
template <class K>
int projection_axis(const Point<K>& a, const Point<K>& b, const Point<K>& c)
{
  for (int axis = 0; axis < 3; ++axis)
    if (normal_sign<K>(a, b, c, axis) != ZERO) return axis;
  return -1;
}

/// Returns the side of the plane a, b, c on which p lies after p has been moved by (e, e^2, e^3), e > 0 and
/// infinitesimal. It is the first non-zero one of volume_sign(a,b,c,p) and the three components of (b-a) x (c-a). It is
/// ZERO only when a, b, c are collinear. The perturbation is the same for every plane, so the answers of many planes
/// belong to one moved point.
template <class K>
Sign perturbed_side(const Point<K>& a, const Point<K>& b, const Point<K>& c, const Point<K>& p)
{
  const Sign side = volume_sign<K>(a, b, c, p);
  if (side != ZERO) return side;
  for (int axis = 0; axis < 3; ++axis) {
    const Sign component = normal_sign<K>(a, b, c, axis);
    if (component != ZERO) return component;
  }
  return ZERO;
}

}  // namespace tetracone::kernel

#endif
