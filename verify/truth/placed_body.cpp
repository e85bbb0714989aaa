#include "verify/truth/placed_body.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace tetracone::verify {

Placed_body::Placed_body(const Brute_body& body, const kernel::Pose& pose) : body_(&body), exact_(body.points().size())
{
  for (int k = 0; k < 12; ++k) pose_[k] = pose.exact(k);
  enclose();
}

const std::vector<CGAL::Bbox_3>& Placed_body::element_boxes() const
{
  if (element_boxes_.empty())
    for (const Element& element : body_->elements()) element_boxes_.push_back(box(element));
  return element_boxes_;
}

const CGAL::Bbox_3& Placed_body::whole_box() const
{
  if (!whole_box_) {
    whole_box_.emplace();
    for (Index v = 0; v < body_->points().size(); ++v) *whole_box_ += point_box(v);
  }
  return *whole_box_;
}

Exact::Point_3 Placed_body::exact_image(const Exact::Point_3& p) const
{
  const auto row = [&](int i) {
    return kernel::Rational(pose_[i] * p.x() + pose_[i + 1] * p.y() + pose_[i + 2] * p.z() + pose_[i + 3]);
  };
  return {row(0), row(4), row(8)};
}

void Placed_body::enclose()
{
  using Interval = CGAL::Interval_nt_advanced;
  std::array<Interval, 12> m;
  for (int k = 0; k < 12; ++k) m[k] = CGAL::to_interval(pose_[k]);
  enclosing_.reserve(body_->bounds().size());
  const CGAL::Protect_FPU_rounding<true> upward;
  for (const Brute_body::Bounds& point : body_->bounds()) {
    const auto row = [&](int i) {
      return m[i] * Interval(point[0]) + m[i + 1] * Interval(point[1]) + m[i + 2] * Interval(point[2]) + m[i + 3];
    };
    enclosing_.emplace_back(row(0), row(4), row(8));
    for (int i = 0; i < 3; ++i) {
      // Products of up to four such coordinates stay finite; a NaN compares false.
      const double limit = 0x1p200;
      enclosed_ = enclosed_ && enclosing_.back()[i].inf() > -limit && enclosing_.back()[i].sup() < limit;
    }
  }
}

CGAL::Bbox_3 Placed_body::point_box(Index v) const
{
  std::array<std::pair<double, double>, 3> bounds;
  for (int i = 0; i < 3; ++i) {
    if (enclosed_) {
      bounds[i] = {enclosing_[v][i].inf(), enclosing_[v][i].sup()};
    } else {
      const double end = std::numeric_limits<double>::max() / 4;
      const auto [low, high] = CGAL::to_interval(image<Exact>(v)[i]);
      bounds[i] = {std::clamp(low, -end, end), std::clamp(high, -end, end)};
    }
  }
  return {bounds[0].first, bounds[1].first, bounds[2].first, bounds[0].second, bounds[1].second, bounds[2].second};
}

}  // namespace tetracone::verify
