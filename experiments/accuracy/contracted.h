#ifndef TETRACONE_EXPERIMENTS_ACCURACY_CONTRACTED_H
#define TETRACONE_EXPERIMENTS_ACCURACY_CONTRACTED_H

#include "tetracone/kernel/predicate/signs.h"

#include <CGAL/Simple_cartesian.h>

#include <cmath>

namespace tetracone::experiments {

/// Double arithmetic of a compiler that contracts products and sums (-ffp-contract=fast with fused multiply-add). Only
/// one product of each sum or difference is rounded before it is added. It is a kernel under study, for pictures;
/// everything except the signs is CGAL::Simple_cartesian<double>.
class Contracted
    : public CGAL::Type_equality_wrapper<CGAL::Cartesian_base_no_ref_count<double, Contracted>, Contracted> {
 public:
  /// a b - c d, contracted: c d is rounded, a b is not.
  static double difference_of_products(double a, double b, double c, double d) { return std::fma(a, b, -(c * d)); }
};

}  // namespace tetracone::experiments

namespace tetracone::kernel {

template <>
struct Kernel_traits<experiments::Contracted> {
  static constexpr bool exact_signs = false, exact_motion = false;
  using Bound = double;
  using Fixed = experiments::Contracted;
};

template <>
inline Sign volume_sign<experiments::Contracted>(const Point<experiments::Contracted>& a,
                                                 const Point<experiments::Contracted>& b,
                                                 const Point<experiments::Contracted>& c,
                                                 const Point<experiments::Contracted>& d)
{
  const auto minor = experiments::Contracted::difference_of_products;
  const double px = b.x() - a.x(), py = b.y() - a.y(), pz = b.z() - a.z();
  const double qx = c.x() - a.x(), qy = c.y() - a.y(), qz = c.z() - a.z();
  const double rx = d.x() - a.x(), ry = d.y() - a.y(), rz = d.z() - a.z();
  return CGAL::sign(
      std::fma(minor(px, qy, qx, py), rz, std::fma(minor(pz, qx, qz, px), ry, minor(py, qz, qy, pz) * rx)));
}

template <>
inline Sign normal_sign<experiments::Contracted>(const Point<experiments::Contracted>& a,
                                                 const Point<experiments::Contracted>& b,
                                                 const Point<experiments::Contracted>& c, int axis)
{
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return CGAL::sign(
      experiments::Contracted::difference_of_products(b[i] - a[i], c[j] - a[j], b[j] - a[j], c[i] - a[i]));
}

}  // namespace tetracone::kernel

#endif
