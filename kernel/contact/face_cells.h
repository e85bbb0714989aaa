#ifndef TETRACONE_KERNEL_CONTACT_FACE_CELLS_H
#define TETRACONE_KERNEL_CONTACT_FACE_CELLS_H

#include "tetracone/kernel/contact/plane_slabs.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/floating_point.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tetracone::kernel {

/// A face, cut by segments of its plane into trapezoids, its cells. No segment and no edge meets the inside of a cell.
/// Above and below a cell are the two sides of the plane, along `axis`.
class Face_cells {
 public:
  using Edge = Rational_face::Edge;

  /// Requires a face with a plane. `may_cross` is passed on to `Plane_slabs`.
  Face_cells(const Rational_face& face, const std::vector<Edge>& cuts, bool may_cross = true)
      : axis_(face.axis()), plane_(axis_, std::array{&face.edges(), &cuts}, may_cross)
  {
    plane_.for_slabs(
        [this](const Rational& left, const Rational& right, std::span<const detail::Plane_slabs::Crossing> crossings) {
          add_slab(left, right, crossings);
        });
  }

  Face_cells(const Face_cells&) = delete;

  /// Returns the axis along which a side is above or below: that of the normal's largest magnitude.
  int axis() const { return axis_; }

  /// Returns the number of cells.
  std::size_t size() const { return cells_.size(); }

  /// Returns the corners of a cell, anticlockwise as seen from above. Two may be equal: the cell is a triangle then.
  std::array<Rational_point, 4> corners(std::size_t cell) const
  {
    const auto& [below, above] = cells_[cell];
    return {below.left(), below.right(), above.right(), above.left()};
  }

  /// Returns a point in the inside of a cell.
  Rational_point inner_point(std::size_t cell) const
  {
    const auto p = corners(cell);
    return between(between(p[0], p[2], Rational(1, 2)), between(p[1], p[3], Rational(1, 2)), Rational(1, 2));
  }

  /// True when a closed segment pq of the plane, or a point p == q, meets the closed cell.
  bool meets(std::size_t cell, const Rational_point& p, const Rational_point& q) const
  {
    const auto corner = corners(cell);
    Rational from = 0, to = 1;  // the part of the segment that is left
    for (int k = 0; k < 4; ++k) {
      const Rational_point edge = difference(corner[(k + 1) % 4], corner[k]);
      const Rational at_p = cross(edge, difference(p, corner[k]))[axis_],
                     at_q = cross(edge, difference(q, corner[k]))[axis_];
      if (at_p < 0 && at_q < 0) return false;
      if (at_p < 0) from = maximum(from, Rational(at_p / (at_p - at_q)));
      if (at_q < 0) to = minimum(to, Rational(at_p / (at_p - at_q)));
    }
    return from <= to;
  }

  /// Calls what(p, q, weight) for segments pq of the plane. The sum of weight times the triangle (c, p, q) over them
  /// equals the sum of each cell times its `weights`. That holds for any point c of the plane. Triangles that are
  /// anticlockwise as seen from above count as positive. A segment is as long as the weights beside it allow, so that
  /// its ends have few digits.
  template <class What>
  void for_borders(std::span<const int> weights, const What& what) const
  {
    const auto weight_of = [&](std::size_t cell) { return cell == outside ? 0 : weights[cell]; };
    std::vector<Run> open, now;
    const auto close = [&](const Run& run) { what(run.line->point(run.from), run.line->point(run.to), run.weight); };
    std::size_t k = 0;
    for (std::size_t slab = 0; slab < slab_ends_.size(); ++slab) {
      now.clear();
      for (; k < slab_ends_[slab]; ++k) {
        const Border& border = borders_[k];
        const int weight = weight_of(border.cell_above) - weight_of(border.cell_below);
        if (weight == 0) continue;
        const auto goes_on =
            std::ranges::find_if(open, [&](const Run& run) { return run.line == border.line && run.weight == weight; });
        now.push_back({border.line, plane_.stops()[slab], plane_.stops()[slab + 1], weight});
        if (goes_on == open.end()) continue;
        now.back().from = goes_on->from;
        open.erase(goes_on);
      }
      for (const Run& run : open) close(run);
      open.swap(now);
    }
    for (const Run& run : open) close(run);
  }

 private:
  using Line = detail::Plane_slabs::Line;
  static constexpr std::size_t outside = -1;

  /// A part of a line between two stops.
  struct Part {
    const Line* line;
    const Rational *from, *to;
    Rational_point left() const { return line->point(*from); }
    Rational_point right() const { return line->point(*to); }
  };
  struct Cell {
    Part below, above;
  };
  struct Border {  // between two cells of one slab, here the one below the other within the plane
    const Line* line;
    std::size_t cell_below, cell_above;
  };
  struct Run {  // borders of one line and one weight, each of which begins where the one before ends
    const Line* line;
    Rational from, to;
    int weight;
  };

  void add_slab(const Rational& left, const Rational& right, std::span<const detail::Plane_slabs::Crossing> crossings)
  {
    int winding = 0;
    std::size_t cell_below = outside;
    for (std::size_t k = 0; k < crossings.size();) {
      const detail::Plane_slabs::Crossing& first = crossings[k];
      for (; k < crossings.size() && crossings[k].coincides(first); ++k)
        if (crossings[k].line->owner == 0) winding += crossings[k].line->direction;
      std::size_t cell_above = outside;
      if (winding != 0) {
        cell_above = cells_.size();
        cells_.push_back({{first.line, &left, &right}, {crossings[k].line, &left, &right}});
      }
      borders_.push_back({first.line, cell_below, cell_above});
      cell_below = cell_above;
    }
    slab_ends_.push_back(borders_.size());
  }

  int axis_;
  detail::Plane_slabs plane_;
  std::vector<Cell> cells_;
  std::vector<Border> borders_;         // slab after slab
  std::vector<std::size_t> slab_ends_;  // where the borders of each slab end
};

}  // namespace tetracone::kernel

#endif
