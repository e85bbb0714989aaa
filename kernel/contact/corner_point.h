#ifndef TETRACONE_KERNEL_CONTACT_CORNER_POINT_H
#define TETRACONE_KERNEL_CONTACT_CORNER_POINT_H

#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/triangle_contact.h"

#include <array>
#include <bit>

namespace tetracone::kernel {

/// A point over a number type N. It is exact in rationals, and an enclosure in intervals.
template <class N>
using Number_point = std::array<N, 3>;

namespace detail {

/// Returns the point where edge `edge` of p goes through the plane of q. Requires an edge that is not parallel to it.
template <class N>
Number_point<N> edge_through_plane(const std::array<Number_point<N>, 3>& p, int edge,
                                   const std::array<Number_point<N>, 3>& q)
{
  const Number_point<N>& from = p[edge];
  const auto whole = difference(p[(edge + 1) % 3], from), normal = normal_of(q);
  return sum(from, scaled(whole, N(dot(normal, difference(q[0], from)) / dot(normal, whole))));
}

/// Returns the point where two edges of one plane cross. Requires edges that are not parallel.
template <class N>
Number_point<N> edge_through_edge(const std::array<Number_point<N>, 3>& p, int edge_p,
                                  const std::array<Number_point<N>, 3>& q, int edge_q)
{
  const Number_point<N>&from = p[edge_p], &other = q[edge_q];
  const auto whole = difference(p[(edge_p + 1) % 3], from), beside = difference(q[(edge_q + 1) % 3], other);
  const auto normal = cross(whole, beside);
  return sum(from, scaled(whole, N(dot(cross(difference(other, from), beside), normal) / dot(normal, normal))));
}

}  // namespace detail

/// Returns the point of a corner of the set that triangles p and q share. `corner` names the edges of both that hold
/// it.
template <class N>
Number_point<N> corner_point(const std::array<Number_point<N>, 3>& p, const std::array<Number_point<N>, 3>& q,
                             const Triangle_contact::Corner& corner)
{
  if (std::popcount(corner.on_p) == 2) return p[corner_of(corner.on_p)];
  if (std::popcount(corner.on_q) == 2) return q[corner_of(corner.on_q)];
  const int edge_p = std::countr_zero(corner.on_p), edge_q = std::countr_zero(corner.on_q);
  // Either edge may lie in the other triangle's plane, so the two edges give the point, not a plane.
  if (corner.on_p != 0 && corner.on_q != 0) return detail::edge_through_edge(p, edge_p, q, edge_q);
  return corner.on_p != 0 ? detail::edge_through_plane(p, edge_p, q) : detail::edge_through_plane(q, edge_q, p);
}

}  // namespace tetracone::kernel

#endif
