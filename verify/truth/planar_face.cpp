#include "verify/truth/planar_face.h"

#include <array>
#include <utility>
#include <vector>

namespace tetracone::verify {

Planar_face::Planar_face(std::vector<std::vector<Point_3>> loops) : loops_(std::move(loops))
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

bool Planar_face::is_planar() const
{
  if (!base_) return true;
  for (const auto& loop : loops_)
    for (const Point_3& corner : loop)
      if (side(corner) != CGAL::ZERO) return false;
  return true;
}

CGAL::Sign Planar_face::side(const Point_3& p) const
{
  return CGAL::orientation((*base_)[0], (*base_)[1], (*base_)[2], p);
}

Place Planar_face::locate(const Point_3& p) const
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

Planar_face::Point_2 Planar_face::project(const Point_3& p) const
{
  return {p[(dropped_ + 1) % 3], p[(dropped_ + 2) % 3]};
}

Planar_face::Point_3 Planar_face::lift(const Point_2& p) const
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

int Planar_face::winding(const Point_2& p) const
{
  int sum = 0;
  for (const auto& loop : projected_)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point_2& from = loop[k];
      const Point_2& to = loop[(k + 1) % loop.size()];
      // The edges are half open: an end on the ray's line counts as below it, so that a crossing in a corner counts
      // once.
      const bool from_above = from.y() > p.y(), to_above = to.y() > p.y();
      if (from_above == to_above) continue;
      const CGAL::Sign turn = CGAL::orientation(from, to, p);
      if (to_above && turn == CGAL::POSITIVE) ++sum;
      if (from_above && turn == CGAL::NEGATIVE) --sum;
    }
  return sum;
}

void Planar_face::find_base()
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

}  // namespace tetracone::verify
