#ifndef TETRACONE_TETRATREE_PAPER_CLASSIFICATION_H
#define TETRACONE_TETRATREE_PAPER_CLASSIFICATION_H

#include "tetracone/kernel/predicate/signs.h"
#include "tetracone/tetratree/paper/tetra_cone.h"

#include <array>

namespace tetracone::tetratree {

/// The paper's test that classified a tetrahedron in a tetra-cone. `no`: none did. `flat`: the tetrahedron is flat.
enum class Classified { no, vertex_in_cone, ray_in_tetrahedron, edge_crosses_border, flat };

/// Returns the test that classifies the tetrahedron S = O A B C of the covering in the tetra-cone T, or `no`. S belongs
/// to T where the closed triangle A B C meets the closed cone (JS08 section 2.2.1, Fig. 6). The function runs the
/// paper's three tests in the paper's order, each by signs of 3x3 determinants:
/// 1. A vertex of A B C is inside T.
/// 2. A ray of T is inside the tetra-cone of S.
/// 3. An edge of A B C meets the border of T. Two edges are enough: a triangle that the first two tests leave undecided
/// meets T, if at all, with at least two of its edges.
///
/// Requires T positively oriented, also where it is placed. A, B and C may have either order.
///
/// Exact kernels: the answer is the geometric one if O is off the plane of A B C. A flat S has no volume, so the rays
/// of T decide nothing about it. It is classified unless a side of T has all of A B C strictly outside. That is never
/// too few, and sometimes too many, which costs a test and changes no answer. (The paper does not mention flat
/// tetrahedra.)
template <class K>
Classified classify(const Cone_points<K>& t, const Point<K>& a, const Point<K>& b, const Point<K>& c)
{
  using kernel::NEGATIVE;
  using kernel::POSITIVE;
  using kernel::ZERO;
  const std::array<const Point<K>*, 3> corner = {&a, &b, &c}, ray = {&t.v1, &t.v2, &t.v3};

  // side[k][i]: the side of corner i against the plane of T opposite ray k, through the rays k+1 and k+2.
  std::array<std::array<Sign, 3>, 3> side;
  for (int k = 0; k < 3; ++k) {
    bool all_outside = true;
    for (int i = 0; i < 3; ++i) {
      side[k][i] = kernel::volume_sign<K>(t.v0, *ray[(k + 1) % 3], *ray[(k + 2) % 3], *corner[i]);
      all_outside = all_outside && side[k][i] == NEGATIVE;
    }
    if (all_outside) return Classified::no;
  }
  for (int i = 0; i < 3; ++i)
    if (side[0][i] != NEGATIVE && side[1][i] != NEGATIVE && side[2][i] != NEGATIVE) return Classified::vertex_in_cone;

  const Sign volume = kernel::volume_sign<K>(t.v0, a, b, c);
  if (volume == ZERO) return Classified::flat;

  // turn[i][k]: the side of ray k against the plane of O and the edge of A B C from corner i to the next.
  std::array<std::array<Sign, 3>, 3> turn;
  for (int k = 0; k < 3; ++k) {
    bool inside = true;
    for (int i = 0; i < 3; ++i) {
      turn[i][k] = kernel::volume_sign<K>(t.v0, *corner[i], *corner[(i + 1) % 3], *ray[k]);
      inside = inside && turn[i][k] * volume != NEGATIVE;
    }
    if (inside) return Classified::ray_in_tetrahedron;
  }

  // The edge from corner i to j crosses the plane through rays m = k+1 and n = k+2 at a point y. Let i be on the
  // negative side. Then y = alpha m + beta n, where alpha has the sign of -[O i j n] and beta that of [O i j m].
  for (int i = 0; i < 2; ++i) {
    const int j = i + 1;
    for (int k = 0; k < 3; ++k) {
      if (side[k][i] == side[k][j] || side[k][i] * side[k][j] == POSITIVE) continue;
      const Sign forward = side[k][i] == NEGATIVE || side[k][j] == POSITIVE ? POSITIVE : NEGATIVE;
      const int m = (k + 1) % 3, n = (k + 2) % 3;
      if (turn[i][m] * forward != NEGATIVE && turn[i][n] * forward != POSITIVE) return Classified::edge_crosses_border;
    }
  }
  return Classified::no;
}

}  // namespace tetracone::tetratree

#endif
