#ifndef TETRACONE_KERNEL_CONTACT_PLANE_SLABS_H
#define TETRACONE_KERNEL_CONTACT_PLANE_SLABS_H

#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/floating_point.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::kernel::detail {

/// Segments of one plane, cut into slabs. Coordinates are the plane's, sheared so that no segment has both ends at one
/// x. Slabs lie between the x of neighbouring ends and crossings. Segments cross a slab from left to right in an order
/// that does not change within it.
class Plane_slabs {
 public:
  using Edge = Rational_face::Edge;

  /// A segment, from left to right.
  struct Line {
    int owner;      ///< the number of the list that has it
    int direction;  ///< -1 where the segment's own direction is from right to left, else 1
    Rational_point from, to;
    Rational x0, y0, x1, y1;

    /// Returns the height at x.
    Rational y(const Rational& x) const
    {
      return x == x0 ? y0 : x == x1 ? y1 : Rational(y0 + (x - x0) / (x1 - x0) * (y1 - y0));
    }
    /// True when all of the line is below all of another.
    bool is_below(const Line& other) const { return (y0 < y1 ? y1 : y0) < (other.y0 < other.y1 ? other.y0 : other.y1); }
    /// Returns the point at x, in space.
    Rational_point point(const Rational& x) const
    {
      return x == x0 ? from : x == x1 ? to : between(from, to, (x - x0) / (x1 - x0));
    }
  };

  /// A line in a slab, and its heights at the slab's borders.
  struct Crossing {
    Rational y_left, y_right;
    const Line* line;

    /// True when both are one segment within the slab.
    bool coincides(const Crossing& other) const { return y_left == other.y_left && y_right == other.y_right; }
  };

  /// Cuts a plane by lists of segments. Its normal's component `axis` is not 0. A segment may be a point. Requires,
  /// unless `may_cross`, that segments on different lines share no inner point.
  Plane_slabs(int axis, std::span<const std::vector<Edge>* const> lists, bool may_cross = true) : axis_(axis)
  {
    choose_shear(lists);
    for (std::size_t owner = 0; owner < lists.size(); ++owner)
      for (const Edge& edge : *lists[owner]) add_line(int(owner), edge);
    std::ranges::sort(lines_, {}, &Line::x0);
    for (auto a = lines_.begin(); may_cross && a != lines_.end(); ++a)
      for (auto b = std::next(a); b != lines_.end() && b->x0 < a->x1; ++b) add_crossing(*a, *b);
    for (const auto& [at, point] : nodes_)
      if (stops_.empty() || stops_.back() != at.first) stops_.push_back(at.first);
  }

  /// Returns ends and crossings, by their x and y.
  const std::map<std::pair<Rational, Rational>, Rational_point>& nodes() const { return nodes_; }
  /// Returns the borders of the slabs, from the left.
  const std::vector<Rational>& stops() const { return stops_; }

  /// Calls what(left, right, crossings) for each slab, from the left. Crossings are in order from below.
  template <class What>
  void for_slabs(const What& what) const
  {
    std::vector<Crossing> active;
    auto next = lines_.begin();
    for (std::size_t k = 0; k + 1 < stops_.size(); ++k) {
      const Rational &left = stops_[k], &right = stops_[k + 1];
      std::erase_if(active, [&](const Crossing& c) { return c.line->x1 <= left; });
      for (Crossing& c : active) c.y_left = c.y_right;
      for (; next != lines_.end() && next->x0 <= left; ++next) active.push_back({next->y0, 0, &*next});
      for (Crossing& c : active) c.y_right = c.line->y(right);
      std::ranges::sort(active, [](const Crossing& a, const Crossing& b) {
        return a.y_left != b.y_left ? a.y_left < b.y_left : a.y_right < b.y_right;
      });
      what(left, right, std::span<const Crossing>(active));
    }
  }

 private:
  std::pair<Rational, Rational> seen(const Rational_point& x) const
  {
    const Rational &u = x[(axis_ + 1) % 3], &v = x[(axis_ + 2) % 3];
    return {Rational(u + shear_ * v), v};
  }

  void choose_shear(std::span<const std::vector<Edge>* const> lists)
  {
    const auto is_upright = [this](const Edge& edge) {
      return edge.first != edge.second && seen(edge.first).first == seen(edge.second).first;
    };
    const auto has_upright = [&](const std::vector<Edge>* list) { return std::ranges::any_of(*list, is_upright); };
    for (int k = 1; std::ranges::any_of(lists, has_upright); ++k) shear_ = Rational(1, k);
  }

  void add_line(int owner, const Edge& edge)
  {
    const auto& [from, to] = edge;
    const auto [x0, y0] = add_node(from);
    const auto [x1, y1] = add_node(to);
    if (x0 < x1) lines_.push_back({owner, 1, from, to, x0, y0, x1, y1});
    if (x1 < x0) lines_.push_back({owner, -1, to, from, x1, y1, x0, y0});
  }

  std::pair<Rational, Rational> add_node(const Rational_point& point)
  {
    auto at = seen(point);
    nodes_.insert({at, point});
    return at;
  }

  void add_crossing(const Line& a, const Line& b)
  {
    if (a.is_below(b) || b.is_below(a)) return;
    const Rational &first = a.x0 < b.x0 ? b.x0 : a.x0, &last = b.x1 < a.x1 ? b.x1 : a.x1;
    if (!(first < last)) return;
    const Rational below = a.y(first) - b.y(first), above = a.y(last) - b.y(last);
    if (sgn(below) * sgn(above) < 0) add_node(a.point(first + below / (below - above) * (last - first)));
  }

  int axis_;
  Rational shear_ = 0;
  std::vector<Line> lines_;  // by x0
  std::map<std::pair<Rational, Rational>, Rational_point> nodes_;
  std::vector<Rational> stops_;
};

}  // namespace tetracone::kernel::detail

#endif
