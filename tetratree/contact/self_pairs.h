#ifndef TETRACONE_TETRATREE_CONTACT_SELF_PAIRS_H
#define TETRACONE_TETRATREE_CONTACT_SELF_PAIRS_H

#include "tetracone/covering/model.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/predicate/signs.h"
#include "tetracone/tetratree/contact/face_pairs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Pairs of different faces of one body. A pair is improper where the faces share a point that is on no common vertex
/// and on no common edge. These are common by coordinates, not by number. The model must outlive this object.
class Self_pairs {
 public:
  using K = kernel::Adaptive;

  explicit Self_pairs(const covering::Model<K>& model)
      : model_(model), twin_(covering::least_equal_vertices(model.vertices()))
  {}

  /// True when signs of corners prove that the pair is proper; false where they do not.
  ///
  /// If a face lies on one closed side of the other's plane, its corners on the plane span all that it shares with the
  /// plane. If that is a segment for one face, or for both, the common points are in these segments. Faces of one plane
  /// are tried in the same way against the lines of their edges.
  bool is_surely_proper(Index f, Index g) const
  {
    std::optional<Extent> held;
    if (const auto basis = covering().plane_basis(f)) {
      const Along plane = against_plane(g, f, *basis);
      if (!plane.is_across && plane.side == kernel::ZERO) return is_surely_proper_in_plane(f, g, *basis);
      if (!plane.is_across) {
        held = plane.extent;
        if (is_common(*held, f, g)) return true;
      }
    }
    if (const auto basis = covering().plane_basis(g)) {
      const Along plane = against_plane(f, g, *basis);
      if (!plane.is_across && plane.side != kernel::ZERO)
        return is_common(held ? both(*held, plane.extent) : plane.extent, f, g);
    }
    return false;
  }

  /// True when a piece that two faces share is not held by their common vertices and edges.
  bool is_improper(const Found_piece& piece, const Found_contacts& found) const
  {
    const Index f = piece.face_a, g = piece.face_b;
    if (piece.kind == kernel::Piece::polygon) return true;
    if (piece.by_signs.count > 0) {
      // Two triangles share a convex set, which holds their common corners.
      const auto common = std::ranges::count_if(covering().from(f), [&](Index v) { return has_corner(g, twin_[v]); });
      return piece.by_signs.count > common;
    }
    const auto& ends = found.kept[piece.kept][0];
    return !is_held(in_order(ends.front(), ends.back()), f, g);
  }

 private:
  using Point = kernel::Point<K>;
  using Rational_point = kernel::Rational_point;

  /// A segment, a point, or nothing, by vertices of least numbers: twins. Ends are in the order of coordinates.
  struct Extent {
    Index low = covering::none, high = covering::none;  // none: it is empty
  };
  /// The position of a face's corners relative to a plane, or to a line in the face's plane.
  struct Along {
    bool is_across;     // some are on either side
    kernel::Sign side;  // ZERO: all are on it
    Extent extent;      // of the corners on it; they are on one line unless all are on a plane
  };

  const covering::Covering& covering() const { return model_.covering(); }
  Point point(Index v) const { return model_.point(v); }
  bool is_before(Index v, Index w) const { return model_.vertices()[v] < model_.vertices()[w]; }

  /// True when a corner of the face has this twin.
  bool has_corner(Index face, Index twin) const
  {
    return std::ranges::any_of(covering().from(face), [&](Index v) { return twin_[v] == twin; });
  }
  bool has_edge(Index face, Index one, Index other) const
  {
    const auto from = covering().from(face), to = covering().to(face);
    for (std::size_t k = 0; k < from.size(); ++k) {
      const Index a = twin_[from[k]], b = twin_[to[k]];
      if ((a == one && b == other) || (a == other && b == one)) return true;
    }
    return false;
  }

  void widen(Extent& extent, Index twin) const
  {
    if (extent.low == covering::none || is_before(twin, extent.low)) extent.low = twin;
    if (extent.high == covering::none || is_before(extent.high, twin)) extent.high = twin;
  }
  /// Returns the intersection of two extents on one line.
  Extent both(const Extent& a, const Extent& b) const
  {
    if (a.low == covering::none || b.low == covering::none) return {};
    const Extent extent = {is_before(a.low, b.low) ? b.low : a.low, is_before(a.high, b.high) ? a.high : b.high};
    return is_before(extent.high, extent.low) ? Extent{} : extent;
  }
  /// True when an extent is empty, a common vertex or a common edge.
  bool is_common(const Extent& extent, Index f, Index g) const
  {
    const auto [low, high] = extent;
    if (low == covering::none) return true;
    if (low == high) return has_corner(f, low) && has_corner(g, low);
    return has_edge(f, low, high) && has_edge(g, low, high);
  }

  /// Returns the position of a face's corners, by side(corner).
  template <class Side>
  Along along(Index face, const Side& side) const
  {
    Along along{false, kernel::ZERO, {}};
    for (const Index v : covering().from(face)) {
      const kernel::Sign at = side(v);
      if (at == kernel::ZERO)
        widen(along.extent, twin_[v]);
      else if (at == -along.side)
        return {true, at, {}};
      else
        along.side = at;
    }
    return along;
  }

  /// Returns the position of a face relative to the plane of another. Corners that both have need no sign.
  Along against_plane(Index face, Index other, const std::array<Index, 3>& basis) const
  {
    const Point a = point(basis[0]), b = point(basis[1]), c = point(basis[2]);
    return along(face, [&](Index v) {
      return has_corner(other, twin_[v]) ? kernel::ZERO : kernel::volume_sign<K>(a, b, c, point(v));
    });
  }

  /// `is_surely_proper` for faces in the plane of `basis`.
  bool is_surely_proper_in_plane(Index f, Index g, const std::array<Index, 3>& basis) const
  {
    const int axis = kernel::projection_axis<K>(point(basis[0]), point(basis[1]), point(basis[2]));
    return is_parted(f, g, axis) || is_parted(g, f, axis);
  }

  /// True when the line of an edge of `face` proves that the pair is proper.
  bool is_parted(Index face, Index other, int axis) const
  {
    const auto from = covering().from(face), to = covering().to(face);
    for (std::size_t k = 0; k < from.size(); ++k) {
      if (twin_[from[k]] == twin_[to[k]]) continue;
      const Point a = point(from[k]), b = point(to[k]);
      const auto side = [&](Index v) {
        const bool is_end = twin_[v] == twin_[from[k]] || twin_[v] == twin_[to[k]];
        return is_end ? kernel::ZERO : kernel::normal_sign<K>(a, b, point(v), axis);
      };
      const Along of = along(face, side);
      if (of.is_across) continue;
      const Along with = along(other, side);
      const bool are_parted = !with.is_across && (with.side == kernel::ZERO || with.side != of.side);
      if (are_parted && is_common(both(of.extent, with.extent), face, other)) return true;
    }
    return false;
  }

  static std::pair<Rational_point, Rational_point> in_order(const Rational_point& a, const Rational_point& b)
  {
    return a < b ? std::pair(a, b) : std::pair(b, a);
  }

  /// True when the common vertices and edges of two faces hold a point or segment, given by its ends in order.
  bool is_held(const std::pair<Rational_point, Rational_point>& ends, Index f, Index g) const
  {
    const auto exact = [&](Index v) { return kernel::exact_point(model_.vertices()[v]); };
    const auto& [first, last] = ends;
    const auto is_on_line = [&](const Rational_point& a, const Rational_point& b, const Rational_point& x) {
      return kernel::is_zero(kernel::cross(kernel::difference(b, a), kernel::difference(x, a)));
    };
    std::vector<std::pair<Rational_point, Rational_point>> parts;  // of the line that common edges hold
    const auto from = covering().from(f), to = covering().to(f);
    for (std::size_t k = 0; k < from.size(); ++k) {
      const Rational_point a = exact(from[k]);
      if (first == last && a == first && has_corner(g, twin_[from[k]])) return true;
      if (!has_edge(g, twin_[from[k]], twin_[to[k]])) continue;
      const Rational_point b = exact(to[k]);
      const bool holds_line =
          a != b && (first == last || is_on_line(first, last, a)) && is_on_line(a, b, first) && is_on_line(a, b, last);
      if (holds_line) parts.push_back(in_order(a, b));
    }
    std::ranges::sort(parts);
    Rational_point reached = first;
    bool is_begun = false;
    for (const auto& [low, high] : parts) {
      if (reached < low) break;
      if (high < reached) continue;
      reached = high;
      is_begun = true;
    }
    return is_begun && !(reached < last);
  }

  const covering::Model<K>& model_;
  std::vector<Index> twin_;  // the least vertex of these coordinates
};

}  // namespace tetracone::tetratree

#endif
