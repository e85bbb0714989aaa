#ifndef TETRACONE_VERIFY_TRUTH_PLACED_BODY_H
#define TETRACONE_VERIFY_TRUTH_PLACED_BODY_H

#include "tetracone/kernel/number/pose.h"
#include "verify/truth/brute_body.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Interval_nt.h>

#include <array>
#include <concepts>
#include <optional>
#include <vector>

namespace tetracone::verify {

/// The kernel of the filter: every coordinate is an interval that contains the exact one; the user sets the rounding
/// mode.
using Enclosing = CGAL::Simple_cartesian<CGAL::Interval_nt_advanced>;

/// A body at a pose. The image of each point is enclosed in intervals at once, and computed exactly on demand. Not
/// thread-safe, since exact images and boxes are cached.
class Placed_body {
 public:
  /// Requires det M != 0, and the body to outlive this.
  Placed_body(const Brute_body& body, const kernel::Pose& pose);

  const Brute_body& body() const { return *body_; }

  /// Returns the image of point `v` of the body. An Enclosing image requires upward rounding and `is_enclosed()`.
  template <class K>
  const typename K::Point_3& image(Index v) const
  {
    if constexpr (std::same_as<K, Enclosing>) {
      return enclosing_[v];
    } else {
      if (!exact_[v]) exact_[v] = exact_image(body_->points()[v]);
      return *exact_[v];
    }
  }

  /// False when numbers are so large that intervals could overflow; then everything is decided exactly.
  bool is_enclosed() const { return enclosed_; }

  /// Returns the outward-rounded box of the images of `corners`. It is finite: values beyond a quarter of the doubles'
  /// range are moved to its end, in order, so that boxes that meet still do.
  template <class Corners>
  CGAL::Bbox_3 box(const Corners& corners) const
  {
    CGAL::Bbox_3 box;
    for (const Index v : corners) box += point_box(v);
    return box;
  }

  CGAL::Bbox_3 box(const Element& element) const { return box(element.corners); }

  /// Returns the boxes of all elements, in their order, and the box of all of them. Each is computed on demand.
  const std::vector<CGAL::Bbox_3>& element_boxes() const;
  const CGAL::Bbox_3& whole_box() const;

 private:
  Exact::Point_3 exact_image(const Exact::Point_3& p) const;

  void enclose();

  CGAL::Bbox_3 point_box(Index v) const;

  const Brute_body* body_;
  std::array<kernel::Rational, 12> pose_;
  std::vector<Enclosing::Point_3> enclosing_;
  bool enclosed_ = true;
  mutable std::vector<std::optional<Exact::Point_3>> exact_;
  mutable std::vector<CGAL::Bbox_3> element_boxes_;
  mutable std::optional<CGAL::Bbox_3> whole_box_;
};

/// Returns the exact value of a predicate on images of two bodies: `predicate(kernel)` in interval arithmetic or, if
/// that is not certain, in rational arithmetic.
template <class Predicate>
auto decide(const Placed_body& a, const Placed_body& b, Predicate&& predicate)
{
  if (a.is_enclosed() && b.is_enclosed()) {
    const CGAL::Protect_FPU_rounding<true> upward;
    try {
      return predicate(Enclosing());
    } catch (const CGAL::Uncertain_conversion_exception&) {
    }
  }
  return predicate(Exact());
}

}  // namespace tetracone::verify

#endif
