#ifndef TETRACONE_KERNEL_CONTACT_COPLANAR_ARRANGEMENT_H
#define TETRACONE_KERNEL_CONTACT_COPLANAR_ARRANGEMENT_H

#include "tetracone/kernel/contact/plane_slabs.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/predicate/face_contact.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::kernel {

/// A maximal piece of the set that faces p and q share.
struct Rational_piece {
  Piece kind;
  Feature in_p, in_q;
  std::vector<std::vector<Rational_point>> loops;  ///< the border of a polygon; else one loop: a point, or two ends
};

namespace detail {

/// Two faces of one plane, cut into trapezoids: the parts of slabs between edges. Winding numbers are summed from
/// below.
class Coplanar_arrangement {
 public:
  Coplanar_arrangement(const Rational_face& p, const Rational_face& q)
      : faces_{&p, &q}, plane_(p.axis(), std::array{&p.edges(), &q.edges()})
  {
    plane_.for_slabs(
        [this](const Rational& left, const Rational& right, std::span<const Plane_slabs::Crossing> crossings) {
          slabs_.push_back(slab(left, right, crossings));
        });
    parent_.resize(cell_count_);
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
    join_slabs();
  }

  /// Returns the pieces. Polygons are the connected parts of the shared interior; segments and points are in none.
  std::vector<Rational_piece> pieces()
  {
    std::vector<Rational_piece> pieces;
    add_polygons(pieces);
    add_segments(pieces);
    add_points(pieces);
    return pieces;
  }

 private:
  struct Curve {  // lines that coincide within a slab, and whether the cells below and above are shared
    Rational_point left, right;
    Rational y_left, y_right;
    std::array<bool, 2> on{};  // an edge of either face
    bool shared = false, below = false, above = false;
    std::size_t cell_below = 0, cell_above = 0;
  };
  using Slab = std::vector<Curve>;  // from below

  Slab slab(const Rational& left, const Rational& right, std::span<const Plane_slabs::Crossing> crossings)
  {
    Slab curves;
    std::array<int, 2> winding = {0, 0};
    const auto is_in = [&](int face) { return winding[face] != 0; };
    for (std::size_t k = 0; k < crossings.size();) {
      const Plane_slabs::Crossing& first = crossings[k];
      Curve curve{first.line->point(left), first.line->point(right), first.y_left, first.y_right};
      curve.below = is_in(0) && is_in(1);
      curve.cell_below = cell_count_;
      const std::array<bool, 2> was_in = {is_in(0), is_in(1)};
      for (; k < crossings.size() && crossings[k].coincides(first); ++k) {
        curve.on[crossings[k].line->owner] = true;
        winding[crossings[k].line->owner] += crossings[k].line->direction;
      }
      curve.above = is_in(0) && is_in(1);
      curve.shared = (curve.on[0] || was_in[0]) && (curve.on[1] || was_in[1]);
      curve.cell_above = ++cell_count_;
      curves.push_back(std::move(curve));
    }
    ++cell_count_;
    return curves;
  }

  std::size_t root(std::size_t cell)
  {
    while (parent_[cell] != cell) cell = parent_[cell] = parent_[parent_[cell]];
    return cell;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

  /// Joins shared cells that have more than a corner in common: of one slab, or of neighbouring ones.
  void join_slabs()
  {
    for (std::size_t s = 0; s < slabs_.size(); ++s) {
      for (const Curve& curve : slabs_[s])
        if (curve.below && curve.above) join(curve.cell_below, curve.cell_above);
      if (s == 0) continue;
      const Slab &before = slabs_[s - 1], &after = slabs_[s];
      for (std::size_t k = 1; k < before.size(); ++k)
        for (std::size_t l = 1; l < after.size(); ++l)
          if (before[k].below && after[l].below &&
              maximum(before[k - 1].y_right, after[l - 1].y_left) < minimum(before[k].y_right, after[l].y_left))
            join(before[k].cell_below, after[l].cell_below);
    }
  }

  static bool go_on(const Rational_point& a, const Rational_point& b, const Rational_point& c)
  {
    return is_zero(cross(difference(b, a), difference(c, b)));
  }

  using Directed = std::pair<Rational_point, Rational_point>;

  void add_polygons(std::vector<Rational_piece>& pieces)
  {
    std::map<std::size_t, std::vector<Directed>> borders;  // by the part: its border, the part on the left
    for (const Slab& slab : slabs_)
      for (const Curve& curve : slab) {
        if (curve.above && !curve.below) borders[root(curve.cell_above)].push_back({curve.left, curve.right});
        if (curve.below && !curve.above) borders[root(curve.cell_below)].push_back({curve.right, curve.left});
      }
    for (const auto& [part, border] : borders)
      pieces.push_back({Piece::polygon, Feature::interior, Feature::interior, loops(border)});
  }

  static std::vector<std::vector<Rational_point>> loops(const std::vector<Directed>& border)
  {
    std::multimap<Rational_point, Rational_point> next;
    for (const auto& [from, to] : border) next.emplace(from, to);
    std::vector<std::vector<Rational_point>> loops;
    while (!next.empty()) {
      std::vector<Rational_point> loop;
      for (auto step = next.begin(); step != next.end(); step = next.find(loop.back())) {
        if (loop.empty()) loop.push_back(step->first);
        loop.push_back(step->second);
        next.erase(step);
        if (loop.back() == loop.front()) break;
      }
      loop.pop_back();
      loops.push_back(corners(loop));
    }
    return loops;
  }

  /// Returns the loop without the points where the border goes straight on.
  static std::vector<Rational_point> corners(const std::vector<Rational_point>& loop)
  {
    std::vector<Rational_point> corners;
    const std::size_t n = loop.size();
    for (std::size_t k = 0; k < n; ++k)
      if (!go_on(loop[(k + n - 1) % n], loop[k], loop[(k + 1) % n])) corners.push_back(loop[k]);
    return corners;
  }

  void add_segments(std::vector<Rational_piece>& pieces) const
  {
    std::vector<Rational_piece> found;
    std::vector<std::size_t> ending;  // at the border between this slab and the one before it
    for (const Slab& slab : slabs_) {
      std::vector<std::size_t> next_ending;
      for (const Curve& curve : slab) {
        if (!curve.shared || curve.below || curve.above) continue;
        const auto in = [&](int face) { return curve.on[face] ? Feature::edge : Feature::interior; };
        const auto goes_on = std::ranges::find_if(ending, [&](std::size_t k) {
          const auto& ends = found[k].loops[0];
          return ends[1] == curve.left && go_on(ends[0], ends[1], curve.right);
        });
        if (goes_on != ending.end()) {
          Rational_piece& piece = found[*goes_on];
          piece.loops[0][1] = curve.right;
          piece.in_p = maximum(piece.in_p, in(0));
          piece.in_q = maximum(piece.in_q, in(1));
          next_ending.push_back(*goes_on);
        } else {
          next_ending.push_back(found.size());
          found.push_back({Piece::segment, in(0), in(1), {{curve.left, curve.right}}});
        }
      }
      ending = std::move(next_ending);
    }
    for (Rational_piece& piece : found) pieces.push_back(std::move(piece));
  }

  void add_points(std::vector<Rational_piece>& pieces) const
  {
    for (const auto& [at, point] : plane_.nodes()) {
      const Feature in_p = faces_[0]->locate(point), in_q = faces_[1]->locate(point);
      if (in_p != Feature::none && in_q != Feature::none && !is_held(at.first, at.second))
        pieces.push_back({Piece::point, in_p, in_q, {{point}}});
    }
  }

  /// True when a polygon or segment holds the node.
  bool is_held(const Rational& x, const Rational& y) const
  {
    const auto k = std::size_t(std::ranges::lower_bound(plane_.stops(), x) - plane_.stops().begin());
    const auto holds = [&](const Slab& slab, Rational Curve::*border) {
      for (std::size_t c = 0; c < slab.size(); ++c) {
        if (slab[c].shared && slab[c].*border == y) return true;
        if (slab[c].below && slab[c - 1].*border < y && y < slab[c].*border) return true;
      }
      return false;
    };
    return (k > 0 && holds(slabs_[k - 1], &Curve::y_right)) || (k < slabs_.size() && holds(slabs_[k], &Curve::y_left));
  }

  std::array<const Rational_face*, 2> faces_;
  Plane_slabs plane_;
  std::vector<Slab> slabs_;
  std::size_t cell_count_ = 0;
  std::vector<std::size_t> parent_;
};

}  // namespace detail
}  // namespace tetracone::kernel

#endif
