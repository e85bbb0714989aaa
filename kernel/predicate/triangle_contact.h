#ifndef TETRACONE_KERNEL_PREDICATE_TRIANGLE_CONTACT_H
#define TETRACONE_KERNEL_PREDICATE_TRIANGLE_CONTACT_H

#include "tetracone/kernel/predicate/triangle_triangle.h"

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace tetracone::kernel {

/// The edges of a triangle that hold a point, as bits: edge k goes from corner k to the next. Two bits: their corner.
using Edge_set = std::uint8_t;

/// Returns the edges at corner k.
constexpr Edge_set edges_at(int k) { return Edge_set(1 << k | 1 << (k + 2) % 3); }

/// Returns the corner at which two edges meet. Requires two edges.
constexpr int corner_of(Edge_set edges) { return edges == edges_at(0) ? 0 : edges == edges_at(1) ? 1 : 2; }

/// The convex set that two triangles share, by the edges of either that hold its corners. A corner is a vertex of one,
/// or the crossing of two edges. Else it is the point where an edge of one goes through the interior of the other.
struct Triangle_contact {
  /// A corner of the set, by the edges that hold it; 0 for a triangle whose interior holds it.
  struct Corner {
    Edge_set on_p = 0, on_q = 0;
  };
  std::uint8_t count = 0;           ///< of corners: 0 apart, 1 a point, 2 a segment, from 3 a polygon
  std::array<Corner, 6> corners{};  ///< in order along the border

  void add(Corner corner) { corners[count++] = corner; }
};

/// True where an edge of one triangle goes through the interior of the other.
constexpr bool is_crossing(const Triangle_contact::Corner& corner)
{
  return std::popcount(unsigned(corner.on_p)) + std::popcount(unsigned(corner.on_q)) == 1;
}

namespace detail {

/// A triangle, turned so that corner 0 is alone on its side of the other triangle's plane.
struct Turned {
  std::array<int, 3> corner{};  // the numbers that the corners had before
  bool flips = false;           // alone on the negative side: the other triangle is turned over

  explicit Turned(const std::array<Sign, 3>& side)
  {
    for (int k = 0; k < 3; ++k) {
      const Sign first = side[k], second = side[(k + 1) % 3], third = side[(k + 2) % 3];
      if (first != ZERO ? second == first || third == first : second != third || second == ZERO) continue;
      corner = {k, (k + 1) % 3, (k + 2) % 3};
      flips = (first != ZERO ? first : -second) == NEGATIVE;
      return;
    }
  }
  /// Returns the edges that hold the end of the interval on the edge from corner 0 to i.
  Edge_set end(int i, const std::array<Sign, 3>& side) const
  {
    if (side[corner[0]] == ZERO) return edges_at(corner[0]);
    return side[corner[i]] == ZERO ? edges_at(corner[i]) : Edge_set(edges_at(corner[0]) & edges_at(corner[i]));
  }
  /// Returns the edge in the other's plane, if there is one: it holds the whole interval.
  Edge_set whole(const std::array<Sign, 3>& side) const
  {
    const bool on_line = side[corner[1]] == ZERO && side[corner[2]] == ZERO;
    return on_line ? Edge_set(edges_at(corner[1]) & edges_at(corner[2])) : 0;
  }
};

/// Finds the set that two triangles in different planes share, when each meets the other's plane.
///
/// After Guigue and Devillers: p0 and q0 are each alone on the positive side of the other's plane. Edge p0 pi meets the
/// common line in ai, and edge q0 qj in bj. The triangles' intervals there are [a2, a1] and [b1, b2], and
/// volume_sign(p0, pi, q0, qj) is the sign of bj - ai. sign_of(corner of p, corner of p, corner of q, corner of q)
/// returns it.
template <class Sign_of>
Triangle_contact crossing_contact(const std::array<Sign, 3>& side_p, const std::array<Sign, 3>& side_q,
                                  const Sign_of& sign_of)
{
  Turned at_p(side_p), at_q(side_q);
  if (at_p.flips) std::swap(at_q.corner[1], at_q.corner[2]);
  if (at_q.flips) std::swap(at_p.corner[1], at_p.corner[2]);
  const auto order = [&](int i, int j) {
    return sign_of(at_p.corner[0], at_p.corner[i], at_q.corner[0], at_q.corner[j]);
  };
  const Sign b1_a1 = order(1, 1);
  if (b1_a1 == POSITIVE) return {};
  const Sign b2_a2 = order(2, 2);
  if (b2_a2 == NEGATIVE) return {};

  const Edge_set a1 = at_p.end(1, side_p), a2 = at_p.end(2, side_p), b1 = at_q.end(1, side_q), b2 = at_q.end(2, side_q),
                 whole_p = at_p.whole(side_p), whole_q = at_q.whole(side_q);
  Triangle_contact contact;
  // Ends that meet: the intervals touch there, or one of them is a point.
  if (b1_a1 == ZERO) {
    contact.add({a1, b1});
    return contact;
  }
  if (b2_a2 == ZERO) {
    contact.add({a2, b2});
    return contact;
  }
  const bool p_is_point = side_p[at_p.corner[0]] == ZERO, q_is_point = side_q[at_q.corner[0]] == ZERO;
  // Here a2 < b2 and b1 < a1. The start is the larger of a2 and b1, the end the smaller of a1 and b2.
  const Sign b1_a2 = p_is_point ? b1_a1 : q_is_point ? b2_a2 : order(2, 1);
  contact.add(b1_a2 == ZERO       ? Triangle_contact::Corner{a2, b1}
              : b1_a2 == POSITIVE ? Triangle_contact::Corner{whole_p, b1}
                                  : Triangle_contact::Corner{a2, whole_q});
  if (p_is_point || q_is_point) return contact;
  const Sign b2_a1 = order(1, 2);
  contact.add(b2_a1 == ZERO       ? Triangle_contact::Corner{a1, b2}
              : b2_a1 == POSITIVE ? Triangle_contact::Corner{a1, whole_q}
                                  : Triangle_contact::Corner{whole_p, b2});
  return contact;
}

/// The contact of two triangles in one plane. The set's corners are the corners of either in the other, and the points
/// where edges cross. The signs of the projection along `axis` decide all of them.
template <class K>
class Coplanar_contact {
 public:
  Coplanar_contact(const Corners<K>& p, const Corners<K>& q, int axis) : p_(p), q_(q)
  {
    const Sign turn_p = normal_sign<K>(*p[0], *p[1], *p[2], axis), turn_q = normal_sign<K>(*q[0], *q[1], *q[2], axis);
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l) {
        side_of_p_[k][l] = normal_sign<K>(*q[l], *q[(l + 1) % 3], *p[k], axis) * turn_q;
        side_of_q_[k][l] = normal_sign<K>(*p[l], *p[(l + 1) % 3], *q[k], axis) * turn_p;
      }
  }

  Triangle_contact operator()() const
  {
    Triangle_contact contact;
    for (int k = 0; k < 3; ++k)
      if (is_inside(side_of_p_[k])) contact.add({edges_at(k), edges_through(side_of_p_[k])});
    for (int k = 0; k < 3; ++k)
      if (const Edge_set on_p = edges_through(side_of_q_[k]); is_inside(side_of_q_[k]) && std::popcount(on_p) < 2)
        contact.add({on_p, edges_at(k)});
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l)
        if (side_of_p_[k][l] * side_of_p_[(k + 1) % 3][l] == NEGATIVE &&
            side_of_q_[l][k] * side_of_q_[(l + 1) % 3][k] == NEGATIVE)
          contact.add({Edge_set(1 << k), Edge_set(1 << l)});
    if (contact.count > 2) put_in_order(contact);
    return contact;
  }

 private:
  using Sides = std::array<Sign, 3>;  // of a point against the edges of a triangle: POSITIVE inside

  static bool is_inside(const Sides& side) { return side[0] != NEGATIVE && side[1] != NEGATIVE && side[2] != NEGATIVE; }
  static Edge_set edges_through(const Sides& side)
  {
    return Edge_set((side[0] == ZERO) | (side[1] == ZERO) << 1 | (side[2] == ZERO) << 2);
  }

  /// Puts the corners in order along the border, each after the one with which it shares an edge. An edge holds at most
  /// two corners, since no three are on one line.
  static void put_in_order(Triangle_contact& contact)
  {
    auto& corners = contact.corners;
    for (int k = 1; k + 1 < contact.count; ++k)
      for (int l = k; l < contact.count; ++l)
        if ((corners[k - 1].on_p & corners[l].on_p) || (corners[k - 1].on_q & corners[l].on_q)) {
          std::swap(corners[k], corners[l]);
          break;
        }
  }

  const Corners<K>&p_, &q_;
  std::array<Sides, 3> side_of_p_, side_of_q_;  // of corner k against edge l
};

}  // namespace detail

/// Returns the set that two closed triangles share, by signs alone. It is exact when K's signs of these points are.
/// Requires that neither is degenerate. `sides_of(triangle, points)` returns the same as `sides<K>(triangle, points)`.
template <class K, class Sides_of>
Triangle_contact triangle_contact(const Corners<K>& p, const Corners<K>& q, const Sides_of& sides_of)
{
  const auto side_q = sides_of(p, q);
  if (all_strictly_beside(side_q)) return {};
  const auto side_p = sides_of(q, p);
  if (all_strictly_beside(side_p)) return {};
  if (side_q[0] == ZERO && side_q[1] == ZERO && side_q[2] == ZERO) {
    const int axis = projection_axis<K>(*p[0], *p[1], *p[2]);
    return detail::Coplanar_contact<K>(p, q, axis)();
  }
  return detail::crossing_contact(
      side_p, side_q, [&](int p0, int pi, int q0, int qj) { return volume_sign<K>(*p[p0], *p[pi], *q[q0], *q[qj]); });
}

/// Decides the sides by `sides<K>`.
template <class K>
Triangle_contact triangle_contact(const Corners<K>& p, const Corners<K>& q)
{
  return triangle_contact<K>(p, q, sides<K>);
}

}  // namespace tetracone::kernel

#endif
