#ifndef TETRACONE_VERIFY_TRUTH_PLANAR_FACE_H
#define TETRACONE_VERIFY_TRUTH_PLANAR_FACE_H

#include "tetracone/kernel/number/number.h"

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify {

/// The kernel of the truth: every coordinate a rational, every construction exact.
using Exact = CGAL::Simple_cartesian<kernel::Rational>;

/// The element of a face whose relative interior holds a point.
enum class Place { outside, face, edge, vertex };

/// One face in rational arithmetic: closed loops of points.
/// Its points are the loops themselves and the points of its plane with non-zero winding number about the loops.
class Planar_face {
 public:
  using Point_2 = Exact::Point_2;
  using Point_3 = Exact::Point_3;

  /// Requires at least one loop, no loop empty.
  explicit Planar_face(std::vector<std::vector<Point_3>> loops) : loops_(std::move(loops))
  {
    find_base();
    if (!base_) return;
    const auto [p, q, r] = *base_;
    const Exact::Vector_3 normal = CGAL::cross_product(q - p, r - p);
    for (int axis = 1; axis < 3; ++axis)
      if (abs(normal[axis]) > abs(normal[dropped_])) dropped_ = axis;
    for (const auto& loop : loops_) {
      projected_.emplace_back();
      for (const Point_3& corner : loop) projected_.back().push_back(project(corner));
    }
  }

  const std::vector<std::vector<Point_3>>& loops() const { return loops_; }

  /// Three corners that are not on one line; nothing when all corners are on one line.
  const std::optional<std::array<Point_3, 3>>& base() const { return base_; }

  /// True when all corners are in one plane.
  bool is_planar() const
  {
    if (!base_) return true;
    for (const auto& loop : loops_)
      for (const Point_3& corner : loop)
        if (side(corner) != CGAL::ZERO) return false;
    return true;
  }

  /// The side of the face's plane that holds `p`. Requires a base.
  CGAL::Sign side(const Point_3& p) const { return CGAL::orientation((*base_)[0], (*base_)[1], (*base_)[2], p); }

  /// The element of the face that holds `p`.
  Place locate(const Point_3& p) const
  {
    bool on_edge = false;
    for (const auto& loop : loops_)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Point_3& from = loop[k];
        const Point_3& to = loop[(k + 1) % loop.size()];
        if (p == from) return Place::vertex;
        on_edge = on_edge || (from != to && Exact::Segment_3(from, to).has_on(p));
      }
    if (on_edge) return Place::edge;
    if (!base_ || side(p) != CGAL::ZERO) return Place::outside;
    return winding(project(p)) != 0 ? Place::face : Place::outside;
  }

  /// The point without its coordinate along the largest component of the face's normal. Requires a base.
  Point_2 project(const Point_3& p) const { return {p[(dropped_ + 1) % 3], p[(dropped_ + 2) % 3]}; }

  /// The point of the face's plane whose projection is `p`. Requires a base.
  Point_3 lift(const Point_2& p) const
  {
    const auto& [origin, q, r] = *base_;
    const Exact::Vector_3 normal = CGAL::cross_product(q - origin, r - origin);
    const int first = (dropped_ + 1) % 3, second = (dropped_ + 2) % 3;
    std::array<kernel::Rational, 3> x;
    x[first] = p.x();
    x[second] = p.y();
    x[dropped_] =
        origin[dropped_] -
        (normal[first] * (p.x() - origin[first]) + normal[second] * (p.y() - origin[second])) / normal[dropped_];
    return {x[0], x[1], x[2]};
  }

  /// The winding number of the projected loops about `p`: the signed crossings of the ray from p along the first axis.
  /// Requires a base, and p on no loop.
  int winding(const Point_2& p) const
  {
    int sum = 0;
    for (const auto& loop : projected_)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Point_2& from = loop[k];
        const Point_2& to = loop[(k + 1) % loop.size()];
        // Half open: an end on the ray's line counts as below it, so a crossing in a corner counts once.
        const bool from_above = from.y() > p.y(), to_above = to.y() > p.y();
        if (from_above == to_above) continue;
        const CGAL::Sign turn = CGAL::orientation(from, to, p);
        if (to_above && turn == CGAL::POSITIVE) ++sum;
        if (from_above && turn == CGAL::NEGATIVE) --sum;
      }
    return sum;
  }

 private:
  void find_base()
  {
    const Point_3& first = loops_[0][0];
    const Point_3* second = nullptr;
    for (const auto& loop : loops_)
      for (const Point_3& corner : loop) {
        if (!second) {
          if (corner != first) second = &corner;
        } else if (!CGAL::collinear(first, *second, corner)) {
          base_ = std::array<Point_3, 3>{first, *second, corner};
          return;
        }
      }
  }

  std::vector<std::vector<Point_3>> loops_;
  std::vector<std::vector<Point_2>> projected_;
  std::optional<std::array<Point_3, 3>> base_;
  int dropped_ = 0;
};

}  // namespace tetracone::verify

#endif
