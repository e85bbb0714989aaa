#ifndef TETRACONE_TETRATREE_MEMORY_ELEMENT_GAP_H
#define TETRACONE_TETRATREE_MEMORY_ELEMENT_GAP_H

#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/bound/triangle_distance.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/fast/bvh8.h"

#include <array>
#include <cmath>

namespace tetracone::tetratree {

/// A lower bound of the distance of two triangles.
struct Element_gap {
  double low = 0;                ///< the bound, in A's local units; 0 if unknown
  kernel::Double_vector axis{};  ///< of length 1, from A to B; if `low` is above 0, they are that far apart along it
};

/// Upper bound of the sum of magnitudes of a row of a similarity, in units of its scale: rows are as long as columns.
/// Proved in verify/proofs/nearest_proofs.h.
inline constexpr double row_of_similarity = 2;

/// Returns the gap of an element of A and one of B, unknown for whole faces. Requires a similarity `frame`, from B's
/// local units to A's.
inline Element_gap element_gap(const Bvh8& tree_a, const Element& a, const Bvh8& tree_b, const Element& b,
                               const kernel::Relative_frame& frame)
{
  if (a.is_whole_face() || b.is_whole_face()) return {};
  kernel::Double_triangle in_a, in_b;
  for (int k = 0; k < 3; ++k) {
    in_a[k] = tree_a.local(a.corner[k]).at;
    in_b[k] = frame(tree_b.local(b.corner[k]).at);
  }
  const auto& offset = frame.offset();
  const double largest = 1 + row_of_similarity * frame.scale() +
                         kernel::maximum(std::abs(offset[0]), std::abs(offset[1]), std::abs(offset[2]));
  const double error = Bvh8_elements::local_error + frame.error(Bvh8_elements::local_error);
  const kernel::Triangle_gap found = kernel::triangle_gap(in_a, in_b, error, largest);
  Element_gap gap{found.low, found.direction};
  for (double& x : gap.axis) x /= found.nearest;
  return gap;
}

}  // namespace tetracone::tetratree

#endif
