#ifndef TETRACONE_KERNEL_BOUND_BOUND_BOX_H
#define TETRACONE_KERNEL_BOUND_BOUND_BOX_H

#include "tetracone/kernel/bound/bounds.h"
#include "tetracone/kernel/bound/oriented_box.h"

#include <array>
#include <span>
#include <vector>

namespace tetracone::kernel {

/// The corners of an oriented box in the arithmetic of the bounds; bit i of a corner's number is its side along axis i.
template <class B>
using Bound_box = std::array<Bound_point<B>, 8>;

/// Upper bound of |A^T A - I| in each entry, where A holds the axes of a box of `bound_box`.
/// `axis_defect_factor` is proved for it in verify/proofs/margin_proofs.h.
inline constexpr double bound_box_defect = 0x1p-30;

/// Returns a box of little surface that holds all points. Where numbers overflow its corners are not finite, and no
/// test tells it apart from another box. Requires a point.
///
/// The axes are the columns of A, which are orthonormal up to a `bound_box_defect` d. A point c + y is c + A s with
/// |s_i| <= |a_i . y| + `axis_defect_factor` d max_k |a_k . y|. In double, all roundings, also of the corners, are
/// below `few_roundings` times |y|_1 + |c|_1. In float nothing is guaranteed.
template <class B>
Bound_box<B> bound_box(std::span<const Bound_point<B>> points)
{
  std::vector<Vector> all;
  for (const auto& p : points) all.emplace_back(double(p[0]), double(p[1]), double(p[2]));
  constexpr int rounds = 8;
  Oriented_box box = fitted_box(all, rounds);
  if (!(box.axes.orthonormal_defect() < bound_box_defect)) box = Oriented_box(Matrix::identity(), all);
  double size = 0;
  for (const Vector& p : all) size = maximum(size, (p - box.centre).norm_1());
  const double margin = axis_defect_factor * bound_box_defect * maximum(box.extent[0], box.extent[1], box.extent[2]) +
                        few_roundings * (size + box.centre.norm_1()) + underflow_slack;
  Bound_box<B> corners;
  for (int k = 0; k < 8; ++k) {
    Vector corner = box.centre;
    for (int i = 0; i < 3; ++i) corner += (k >> i & 1 ? 1 : -1) * (box.extent[i] + margin) * box.axes.col(i);
    for (int i = 0; i < 3; ++i) corners[k][i] = B(corner[i]);
  }
  return corners;
}

/// True when the two placed boxes are found to share no point. The axes are the normals of their faces and the cross
/// products of their edges. `slack` is `projection_slack`. The answer is sound for any axis, also for one moved by
/// rounding.
template <class B>
bool separated(const Bound_box<B>& a, const Bound_box<B>& b, B slack)
{
  using Edges = std::array<Bound_point<B>, 3>;
  const auto edges_of = [](const Bound_box<B>& box) {
    return Edges{difference(box[1], box[0]), difference(box[2], box[0]), difference(box[4], box[0])};
  };
  const Edges e = edges_of(a), f = edges_of(b);
  const auto separates = [&](const Bound_point<B>& axis) {
    struct Interval {
      B low, high;
    };
    const auto interval = [&](const Bound_box<B>& box) {
      Interval all{dot(axis, box[0]), dot(axis, box[0])};
      for (int k = 1; k < 8; ++k) {
        const B at = dot(axis, box[k]);
        all = {minimum(all.low, at), maximum(all.high, at)};
      }
      return all;
    };
    return separated_along(axis, interval(a), interval(b), slack);
  };
  for (int i = 0; i < 3; ++i)
    if (separates(cross(e[i], e[(i + 1) % 3])) || separates(cross(f[i], f[(i + 1) % 3]))) return true;
  for (const auto& edge_a : e)
    for (const auto& edge_b : f)
      if (separates(cross(edge_a, edge_b))) return true;
  return false;
}

}  // namespace tetracone::kernel

#endif
