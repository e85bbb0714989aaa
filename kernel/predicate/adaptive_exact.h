#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_EXACT_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_EXACT_H

#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/adaptive_points.h"

#include <CGAL/Mpzf.h>
#include <CGAL/enum.h>
#include <CGAL/predicates/sign_of_determinant.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

namespace tetracone::kernel {

/// The exact stage: the expression over the exact images, in CGAL::Mpzf. Poses of fractions are multiplied by their
/// denominators. An image is computed once for each point that has a slot, and for others whenever it is needed.
class Adaptive_exact : public Adaptive_points {
 public:
  static CGAL::Sign exact_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    return over_exact_images(
        [](const Exact_image& p, const Exact_image& q, const Exact_image& r, const Exact_image& s) {
          return CGAL::sign_of_determinant<CGAL::Mpzf>(q[0] - p[0], q[1] - p[1], q[2] - p[2],  //
                                                       r[0] - p[0], r[1] - p[1], r[2] - p[2],  //
                                                       s[0] - p[0], s[1] - p[1], s[2] - p[2]);
        },
        a, b, c, d);
  }

  static CGAL::Sign exact_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    return over_exact_images(
        [i, j](const Exact_image& p, const Exact_image& q, const Exact_image& r) {
          return CGAL::sign_of_determinant<CGAL::Mpzf>(q[i] - p[i], q[j] - p[j], r[i] - p[i], r[j] - p[j]);
        },
        a, b, c);
  }

  static CGAL::Sign exact_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    return over_exact_images(
        [axis](const Exact_image& p, const Exact_image& q) { return CGAL::sign(CGAL::Mpzf(p[axis] - q[axis])); }, a, b);
  }

 private:
  /// Returns the exact image times the weight of the pose, in binary fractions. It is kept in the point's slot, where
  /// the point has one.
  static Exact_image exact_image(const Point_3& point)
  {
    if (point.slot != nullptr && *point.slot && (*point.slot)->exact) return *(*point.slot)->exact;
    const Vertex& v = point.vertex;
    using Number = CGAL::Mpzf;
    if (point.pose == nullptr) return {Number(v[0]), Number(v[1]), Number(v[2])};
    if (point.error == 0) return {Number(point.image[0]), Number(point.image[1]), Number(point.image[2])};
    const auto row = [&](int i) -> Number {
      const Pose& m = *point.pose;
      return m.whole(i) * Number(v[0]) + m.whole(i + 1) * Number(v[1]) + m.whole(i + 2) * Number(v[2]) + m.whole(i + 3);
    };
    Exact_image image = {row(0), row(4), row(8)};
    if (point.slot != nullptr) kept(point).exact = std::make_unique<Exact_image>(image);
    return image;
  }

  // Returns `function` of all exact images, each times the product of the poses' weights. This is a positive factor,
  // which changes no sign.
  template <class Function, class... Points>
  static CGAL::Sign over_exact_images(const Function& function, const Points&... points)
  {
    const auto is_weighted = [](const Pose* pose) { return pose != nullptr && pose->is_rational(); };
    std::array<const Pose*, sizeof...(Points)> weighted{};
    std::size_t count = 0;
    const auto collect = [&](const Pose* pose) {
      if (is_weighted(pose) && std::find(weighted.begin(), weighted.begin() + count, pose) == weighted.begin() + count)
        weighted[count++] = pose;
    };
    (collect(points.pose), ...);
    const auto over_all = [&](const Point_3& point) {
      Exact_image image = exact_image(point);
      for (std::size_t k = 0; k < count; ++k)
        if (weighted[k] != point.pose)
          for (CGAL::Mpzf& x : image) x = x * weighted[k]->weight();
      return image;
    };
    return function(over_all(points)...);
  }
};

}  // namespace tetracone::kernel

#endif
