#ifndef TETRACONE_KERNEL_CONTACT_RATIONAL_FACE_H
#define TETRACONE_KERNEL_CONTACT_RATIONAL_FACE_H

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"
#include "tetracone/kernel/predicate/face_contact.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace tetracone::kernel {

using Rational_point = std::array<Rational, 3>;  ///< a point or a vector

/// Returns a vertex in rationals.
inline Rational_point exact_point(const Vertex& v) { return {v[0], v[1], v[2]}; }

/// Returns a + share (b - a).
inline Rational_point between(const Rational_point& a, const Rational_point& b, const Rational& share)
{
  return sum(a, scaled(difference(b, a), share));
}

/// Returns the largest magnitude of a coordinate.
inline Rational longest_part(const Rational_point& a) { return abs(a[std::size_t(largest_axis(a))]); }

/// True when x is in the inside of the segment from p to q.
inline bool is_inside_segment(const Rational_point& x, const Rational_point& p, const Rational_point& q)
{
  for (int k = 0; k < 3; ++k) {  // most points are outside of the segment's box, which costs no product to see
    const int at_p = cmp(x[k], p[k]), at_q = cmp(x[k], q[k]);
    if ((at_p == 0) != (at_q == 0) || (at_p != 0 && (at_p > 0) == (at_q > 0))) return false;
  }
  const Rational_point a = difference(p, x), b = difference(q, x);
  return is_zero(cross(a, b)) && sgn(dot(a, b)) < 0;
}

/// A planar face in rationals: its directed edges, and its plane where its corners are not on one line.
class Rational_face {
 public:
  using Edge = std::pair<Rational_point, Rational_point>;

  /// The face of these edges. Requires corners in one plane, and at least one edge.
  explicit Rational_face(std::vector<Edge> edges) : edges_(std::move(edges))
  {
    for (const Edge& edge : edges_) {
      const Rational_point offset = difference(edge.first, origin());
      if (is_zero(along_)) along_ = offset;
      if (is_zero(normal_)) normal_ = cross(along_, offset);
    }
  }

  /// Returns the directed edges, in the order of the constructor.
  const std::vector<Edge>& edges() const { return edges_; }
  /// Returns the first corner.
  const Rational_point& origin() const { return edges_[0].first; }
  /// True when the corners are not on one line.
  bool has_plane() const { return !is_zero(normal_); }
  /// Returns the normal; 0 for a face on one line.
  const Rational_point& normal() const { return normal_; }
  /// Returns a direction in the face; 0 for a point.
  const Rational_point& along() const { return along_; }
  /// Returns the signed distance of a point from the plane, times the length of the normal.
  Rational beyond(const Rational_point& x) const { return dot(normal_, difference(x, origin())); }

  /// Returns the feature of the face that holds a point; `none` for a point that is not in the face.
  Feature locate(const Rational_point& x) const
  {
    Feature at = Feature::none;
    for (const auto& [from, to] : edges_) {
      if (x == from) return Feature::vertex;
      if (is_inside_segment(x, from, to)) at = Feature::edge;
    }
    if (at != Feature::none || !has_plane() || beyond(x) != 0) return at;
    return winding(x, axis()) != 0 ? Feature::interior : Feature::none;
  }

  /// Returns the axis of the normal's largest magnitude: along it the face's projection is not flat.
  int axis() const { return largest_axis(normal_); }

  /// Returns the winding number of the loops about x, both as seen from the far end of axis k: signed crossings of a
  /// ray. Where x is seen on a loop, it counts as moved by an infinitesimal, the same for all faces. A face that is
  /// seen as a line has the winding number 0.
  int winding(const Rational_point& x, int k) const
  {
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    int winding = 0;
    for (const auto& [from, to] : edges_) {
      const bool from_above = from[v] > x[v], to_above = to[v] > x[v];
      if (from_above == to_above) continue;
      const Rational turn = (from[u] - x[u]) * (to[v] - x[v]) - (from[v] - x[v]) * (to[u] - x[u]);
      if (to_above && turn > 0) ++winding;
      if (from_above && turn < 0) --winding;
    }
    return winding;
  }

 private:
  std::vector<Edge> edges_;
  Rational_point along_, normal_;
};

}  // namespace tetracone::kernel

#endif
