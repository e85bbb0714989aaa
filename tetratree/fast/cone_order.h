#ifndef TETRACONE_TETRATREE_FAST_CONE_ORDER_H
#define TETRACONE_TETRATREE_FAST_CONE_ORDER_H

#include "tetracone/covering/model.h"
#include "tetracone/kernel/bound/oriented_box.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace tetracone::tetratree {

/// Returns the child of a tetra-cone that holds a point (JS08 Definition 4): 0, 1, 2 keep the first, second, third ray,
/// 3 is the middle one. `weights` are the point's coordinates along the cone's rays; they become those along the
/// child's.
inline int child_cone_of(kernel::Vector& weights)
{
  const double half = 0.5 * weights.sum();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (!(weights[i] > half)) continue;
    weights[i] -= weights[j] + weights[k];
    weights[j] *= 2;
    weights[k] *= 2;
    return i;
  }
  weights = kernel::Vector::all(2 * half) - 2 * weights;  // along the midpoints across from each ray
  return 3;
}

/// Sorts elements by the octants or, if one octant holds all, by the children of the smallest tetra-cone that holds all
/// centroids. `centroid(e)` is relative to the cones' origin. Returns where parts begin in `elements`; one part if the
/// centroids lie behind one another.
template <class Centroid>
std::vector<std::size_t> order_by_cones(std::span<covering::Index> elements, const Centroid& centroid)
{
  constexpr int most_levels = 20;
  struct Placed {
    covering::Index element;
    kernel::Vector weights;
    int cone;
  };
  std::vector<Placed> all;
  for (const covering::Index e : elements) {
    const kernel::Vector c = centroid(e);
    all.push_back({e, c.absolute(), int(c[0] < 0) | int(c[1] < 0) << 1 | int(c[2] < 0) << 2});
  }
  const auto is_one_cone = [&] {
    return std::all_of(all.begin(), all.end(), [&](const Placed& p) { return p.cone == all.front().cone; });
  };
  for (int level = 1; level < most_levels && is_one_cone(); ++level)
    for (Placed& p : all) p.cone = child_cone_of(p.weights);
  std::stable_sort(all.begin(), all.end(), [](const Placed& a, const Placed& b) { return a.cone < b.cone; });
  std::vector<std::size_t> begins;
  for (std::size_t k = 0; k < all.size(); ++k) {
    elements[k] = all[k].element;
    if (k == 0 || all[k].cone != all[k - 1].cone) begins.push_back(k);
  }
  return begins;
}

}  // namespace tetracone::tetratree

#endif
