#ifndef TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_BODY_H
#define TETRACONE_VERIFY_INTEGER_TRUTH_INTEGER_BODY_H

#include "tetracone/covering/polyhedron.h"
#include "verify/integer_truth/integer_points.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify {

using covering::Index;

/// The turns of a face's loops about a point y, seen along an axis.
struct Turns {
  bool on_loop = false;  ///< y is on a loop
  int winding = 0;       ///< about y, or where y is on a loop, about y moved by (e, e^2), e > 0 and infinitesimal
};

/// A placed polyhedron in integers. Faces are never triangulated, and their loops are asked for turns, not for
/// crossings.
class Integer_body {
 public:
  using Edge = std::pair<Index, Index>;

  /// Requires the images of the polyhedron's vertices as points, and that the polyhedron outlives this.
  Integer_body(const covering::Polyhedron& polyhedron, std::vector<Integer_vector> points)
      : polyhedron_(&polyhedron), points_(std::move(points))
  {
    for (Index f = 0; f < polyhedron.face_count(); ++f)
      for_edges(f, [&](Index from, Index to) { edges_.push_back(std::minmax(from, to)); });
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  const Integer_vector& point(Index v) const { return points_[v]; }
  Index vertex_count() const { return Index(points_.size()); }
  Index face_count() const { return Index(polyhedron_->face_count()); }

  /// Returns the undirected edges of the loops, each once. A loop of one vertex has an edge from that vertex to itself.
  const std::vector<Edge>& edges() const { return edges_; }

  /// Calls what(from, to) for all directed edges of a face.
  template <class What>
  void for_edges(Index f, What&& what) const
  {
    for (std::size_t k = 0; k < polyhedron_->loop_count(f); ++k) {
      const covering::Loop loop = polyhedron_->loop(f, k);
      for (std::size_t i = 0; i < loop.size(); ++i) what(loop[i], loop[i + 1 == loop.size() ? 0 : i + 1]);
    }
  }

  /// Returns the corners of all loops of a face.
  std::vector<Index> corners(Index f) const
  {
    std::vector<Index> corners;
    for_edges(f, [&](Index from, Index) { corners.push_back(from); });
    return corners;
  }

  /// Returns a corner of the face, on its plane.
  const Integer_vector& corner(Index f) const { return points_[polyhedron_->loop(f, 0)[0]]; }

  /// Returns a normal of the face's plane; nothing when all its corners are on one line. It is the area vector of the
  /// loops unless that is zero, as it is for loops that cancel one another.
  std::optional<Integer_vector> normal(Index f) const
  {
    Integer_vector area;
    for_edges(f, [&](Index from, Index to) {
      const Integer_vector n = cross(difference(points_[from], corner(f)), difference(points_[to], corner(f)));
      for (int i = 0; i < 3; ++i) area[i] += n[i];
    });
    if (!is_zero(area)) return area;

    Integer_vector along, n;
    for_edges(f, [&](Index from, Index) {
      const Integer_vector d = difference(points_[from], corner(f));
      if (is_zero(along)) along = d;
      if (is_zero(n)) n = cross(along, d);
    });
    return is_zero(n) ? std::nullopt : std::optional(n);
  }

  /// Returns the turns of the face's loops about y = x / w, w > 0, seen along an axis.
  Turns turns(Index f, int axis, const Integer_vector& x, const Integer& w) const
  {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    return turns(f, [&](Index v) {
      return std::array{Integer(points_[v][i] * w - x[i]), Integer(points_[v][j] * w - x[j])};
    });
  }

  /// Returns the turns of the face's loops in a plane, where `about(v)` is vertex v relative to y. It counts the
  /// quadrants about y that contain their corners. An edge turns by the quadrants between its ends. Between opposite
  /// ones the side of y decides the direction. A coordinate equal to y's counts as less, as if y were moved by (e,
  /// e^2); so does an edge through y.
  template <class About>
  Turns turns(Index f, const About& about) const
  {
    const auto quadrant = [](const std::array<Integer, 2>& d) {
      return sgn(d[1]) > 0 ? (sgn(d[0]) > 0 ? 0 : 1) : (sgn(d[0]) > 0 ? 3 : 2);
    };
    Turns result;
    int quarters = 0;
    for (std::size_t k = 0; k < polyhedron_->loop_count(f); ++k) {
      const covering::Loop loop = polyhedron_->loop(f, k);
      std::array<Integer, 2> from = about(loop.back());
      for (const Index v : loop) {
        std::array<Integer, 2> to = about(v);
        result.on_loop = result.on_loop || (sgn(to[0]) == 0 && sgn(to[1]) == 0);
        const int turn = (quadrant(to) - quadrant(from) + 4) % 4;
        if (turn != 0) {
          int side = sgn(Integer(from[0] * to[1] - from[1] * to[0]));
          if (side == 0) {
            // In different quadrants and on one line with y: on either side of it, or at it.
            result.on_loop = true;
            side = sgn(from[1]) > 0 ? 1 : -1;  // an edge down passes left of the moved y, one up right of it
          }
          quarters += turn == 2 ? 2 * side : turn == 1 ? 1 : -1;
        }
        from = std::move(to);
      }
    }
    result.winding = quarters / 4;
    return result;
  }

  /// Returns one vertex of each part of the surface that edges connect. Loops of a face are separate parts unless they
  /// share a vertex. Every point of a face is connected within it to one of its loops, so no part of the surface is
  /// left out.
  std::vector<Index> part_vertices() const
  {
    std::vector<Index> parent(points_.size());
    std::iota(parent.begin(), parent.end(), Index(0));
    const auto root = [&](Index v) {
      while (parent[v] != v) v = parent[v] = parent[parent[v]];
      return v;
    };
    for (const auto& [from, to] : edges_) parent[root(from)] = root(to);
    std::vector<Index> parts;
    for (const auto& [from, to] : edges_) parts.push_back(root(from));
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    return parts;
  }

 private:
  const covering::Polyhedron* polyhedron_;
  std::vector<Integer_vector> points_;
  std::vector<Edge> edges_;
};

}  // namespace tetracone::verify

#endif
