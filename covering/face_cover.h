#ifndef TETRACONE_COVERING_FACE_COVER_H
#define TETRACONE_COVERING_FACE_COVER_H

#include "tetracone/covering/edge_uses.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/kernel/predicate/signs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace tetracone::covering {

/// Decides whether triangles cover a face exactly. The time is linear in triangles and corners, except for sorting the
/// sides. (Faces whose triangles run in both directions take a sweep.)
///
/// A face is the points of its plane about which its loops wind, and the points of its loops. Triangles cover exactly
/// these points if
///
/// - (1) their corners are corners of the face, so that they lie in its plane;
/// - (2) no triangle has its corners on one line;
/// - (3) when pairs of opposite ones are cancelled, the directed sides of the triangles are the directed edges of the
///   loops;
/// - (4) each edge of a loop is a side of a triangle, and a corner that is twice in a row is a triangle's;
/// - (5) two triangles of opposite directions have no area in common.
///
/// Proof. Directed edges add up to the winding number about any point off them, and opposite edges add up to 0. So by
/// (3) the loops wind about a point off all edges as the triangles do. Their number is that of the triangles of one
/// direction that hold the point, less that of the other direction. By (5) only triangles of one direction hold it.
/// Hence the number is 0 exactly where no triangle holds the point.
///
/// The triangles add no point. By (2) each of their points is a limit of inner ones, about which the loops wind. Off
/// the loops, the winding number is constant nearby; so the loops wind about the point, or pass through it.
///
/// The triangles lack no point. Near a point that the loops wind about, all points off the edges are in triangles.
/// These are closed and finitely many, so one of them holds the point. The points of loops are in triangles by (4).
class Face_cover {
 public:
  using Triangle = std::array<Index, 3>;

  /// The polyhedron must outlive this.
  explicit Face_cover(const Polyhedron& polyhedron)
      : polyhedron_(polyhedron), corner_of_(polyhedron.vertices.size(), std::numeric_limits<Index>::max())
  {}

  /// Returns the first flaw of these triangles of face `f`; nothing where they cover exactly the face. Requires a
  /// planar face, and vertices that exist.
  std::optional<std::string> flaw(Index f, std::span<const Triangle> triangles)
  {
    sides_.clear();
    std::vector<Index> repeated;
    for_each_directed_edge(polyhedron_, f, [&](Index a, Index b) {
      corner_of_[a] = f;
      if (a == b) repeated.push_back(a);
      add_side(a, b, false);
    });
    for (const Triangle& t : triangles)
      for (int k = 0; k < 3; ++k) {
        if (corner_of_[t[k]] != f) return name(t) + " has corner " + std::to_string(t[k]) + ", which is not the face's";
        add_side(t[k], t[(k + 1) % 3], true);
      }
    if (const auto flat = find_directions(triangles)) return name(triangles[*flat]) + " has no area";
    std::ranges::sort(sides_, {}, [](const Side& side) { return std::tie(side.low, side.high); });
    for (auto first = sides_.begin(), last = first; first != sides_.end(); first = last) {
      std::ptrdiff_t surplus = 0;
      bool is_of_loop = false, is_of_triangle = false;
      for (; last != sides_.end() && last->low == first->low && last->high == first->high; ++last) {
        surplus += last->forward == last->of_triangle ? 1 : -1;
        (last->of_triangle ? is_of_triangle : is_of_loop) = true;
      }
      if (surplus != 0 || (is_of_loop && !is_of_triangle))
        return "its triangles do not end where its loops do, at the edge of vertices " + std::to_string(first->low) +
               " and " + std::to_string(first->high);
    }
    for (const Index v : repeated)
      if (std::ranges::none_of(triangles, [v](const Triangle& t) { return std::ranges::find(t, v) != t.end(); }))
        return "no triangle has its corner " + std::to_string(v);
    if (is_of_both_directions_ && overlap(triangles)) return "triangles of opposite directions overlap";
    return std::nullopt;
  }

 private:
  using Adaptive = kernel::Adaptive;

  struct Side {
    Index low, high;
    bool forward, of_triangle;
  };

  void add_side(Index a, Index b, bool of_triangle)
  {
    if (a != b) sides_.push_back({std::min(a, b), std::max(a, b), a < b, of_triangle});
  }

  static std::string name(const Triangle& t)
  {
    return "its triangle " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]);
  }

  auto point(Index v) const { return Adaptive::unmoved(polyhedron_.vertices[v]); }

  /// Returns the turn of three corners in the projection of the face's plane.
  kernel::Sign turn(Index a, Index b, Index c) const
  {
    return kernel::normal_sign<Adaptive>(point(a), point(b), point(c), axis_);
  }

  /// Finds each triangle's direction. Returns the number of the first triangle without area; nothing if all have some.
  std::optional<std::size_t> find_directions(std::span<const Triangle> triangles)
  {
    directions_.clear();
    is_of_both_directions_ = false;
    for (const auto& [a, b, c] : triangles) {
      if (directions_.empty()) axis_ = kernel::projection_axis<Adaptive>(point(a), point(b), point(c));
      const kernel::Sign direction = axis_ < 0 ? kernel::ZERO : turn(a, b, c);
      if (direction == kernel::ZERO) return directions_.size();
      is_of_both_directions_ =
          is_of_both_directions_ || direction != (directions_.empty() ? direction : directions_[0]);
      directions_.push_back(direction);
    }
    return std::nullopt;
  }

  /// True when two triangles of opposite directions have area in common, by a sweep along a coordinate of the
  /// projection.
  bool overlap(std::span<const Triangle> triangles) const
  {
    const auto reach = [&](std::size_t t) {
      const auto at = [&](int k) { return polyhedron_.vertices[triangles[t][std::size_t(k)]][(axis_ + 1) % 3]; };
      return std::minmax({at(0), at(1), at(2)});
    };
    std::vector<std::size_t> order(triangles.size()), open;
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, {}, [&](std::size_t t) { return reach(t).first; });
    for (const std::size_t t : order) {
      std::erase_if(open, [&](std::size_t s) { return reach(s).second <= reach(t).first; });
      for (const std::size_t s : open)
        if (directions_[s] != directions_[t] && !is_beyond_side(triangles, s, t) && !is_beyond_side(triangles, t, s))
          return true;
      open.push_back(t);
    }
    return false;
  }

  /// True when no corner of triangle `t` is on the inner side of the line of some side of triangle `s`. One of two
  /// triangles without a common inner point has such a side.
  bool is_beyond_side(std::span<const Triangle> triangles, std::size_t s, std::size_t t) const
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (std::ranges::all_of(triangles[t], [&](Index v) {
            return turn(triangles[s][k], triangles[s][(k + 1) % 3], v) != directions_[s];
          }))
        return true;
    return false;
  }

  const Polyhedron& polyhedron_;
  std::vector<Index> corner_of_;  // of each vertex: the last face that was found to have it
  std::vector<Side> sides_;
  std::vector<kernel::Sign> directions_;
  bool is_of_both_directions_ = false;
  int axis_ = -1;  // along which the face is projected
};

/// A flaw of the triangles of a face.
struct Cover_flaw {
  Index face;
  std::string wrong;
};

/// Returns the first face whose triangles do not cover it exactly. A face without triangles is not looked at. Requires
/// planar faces, and faces and vertices that exist.
inline std::optional<Cover_flaw> cover_flaw(const Polyhedron& polyhedron, std::span<const Face_triangle> triangles)
{
  if (triangles.empty()) return std::nullopt;
  std::vector<std::size_t> end(polyhedron.face_count() + 1, 0);
  for (const Face_triangle& t : triangles) ++end[t.face + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Face_cover::Triangle> by_face(triangles.size());
  for (const Face_triangle& t : triangles) by_face[end[t.face]++] = t.corner;
  Face_cover cover(polyhedron);
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    const std::size_t first = f == 0 ? 0 : end[f - 1];
    if (first == end[f]) continue;
    if (auto wrong = cover.flaw(f, std::span(by_face).subspan(first, end[f] - first)))
      return Cover_flaw{f, std::move(*wrong)};
  }
  return std::nullopt;
}

}  // namespace tetracone::covering

#endif
