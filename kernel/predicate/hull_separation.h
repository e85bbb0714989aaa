#ifndef TETRACONE_KERNEL_PREDICATE_HULL_SEPARATION_H
#define TETRACONE_KERNEL_PREDICATE_HULL_SEPARATION_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/face_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// Directions that separate convex hulls: searched in double, which may fail, then tested exactly. They are for
/// certificates, so short integers are preferred.
namespace tetracone::kernel {

using Rounded_vector = std::array<double, 3>;

/// Upper bound of the error of a rounded coordinate of an image, relative to the sum of its terms' absolute values. An
/// entry is off by less than 2^-52 of itself. Its product has one rounding and the sums have three: 6 of 8 times 2^-53
/// in all. verify/test/kernel/predicate/hull_separation.cpp compares both bounds with exact images.
inline constexpr double image_rounding = 0x1p-50;
/// Upper bound of what underflow adds to the error, for corners of coordinates up to 1. Four entries and three products
/// are off by at most 2^-1075 each; larger coordinates multiply the entries' part.
inline constexpr double image_underflow = 0x1p-1072;

/// Exact points, and doubles near their products with one common factor, which keeps the doubles finite.
///
/// The points are given, or are the images of points under an affine map. Images are multiplied out when they are asked
/// for, in doubles too: a search needs few of them. One object serves one thread.
class Hull_points {
 public:
  using Rounded_map = std::array<double, 12>;

  Hull_points() = default;
  /// These points.
  explicit Hull_points(std::initializer_list<Exact_vector> points) : size_(points.size()), made_(points) {}
  /// The images of `corners` under a row-major 3x4 matrix. `reach` has an upper bound of each coordinate's absolute
  /// value. The corners must outlive this object.
  Hull_points(std::span<const Rounded_vector> corners, const Rounded_vector& reach,
              const std::array<Exact_number, 12>& map)
      : size_(corners.size()), corners_(corners), reach_(reach), map_(map), place_(corners.size())
  {}

  std::size_t size() const { return size_; }

  /// Returns point v exactly.
  const Exact_vector& exact(std::size_t v) const
  {
    if (!map_) return made_[v];
    if (place_[v] == 0) {
      made_.push_back(image(corners_[v], *map_));
      place_[v] = std::uint32_t(made_.size());
    }
    return made_[place_[v] - 1];
  }

  /// Returns point v times `factor`, in doubles. A coordinate is off by at most `error`, or by 2^-52 of itself if that
  /// is more. Requires rounded points.
  Rounded_vector rounded(std::size_t v) const
  {
    if (!rounded_map_) return rounded_[v];
    const Rounded_vector& x = corners_[v];
    const auto along = [&](std::size_t k) {
      const double* const row = rounded_map_->data() + 4 * k;
      return row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3];
    };
    return {along(0), along(1), along(2)};
  }
  /// Returns an upper bound of the error of images that are multiplied out in doubles; else 0.
  double error() const { return error_; }
  /// Returns an upper bound of the absolute values of rounded coordinates.
  double largest() const { return largest_; }
  /// Returns the factor by which the points were multiplied and rounded last; nothing before.
  const std::optional<Exact_number>& factor() const { return factor_; }
  /// Returns the matrix that rounded points are multiplied out with, if they are: the map times the factor.
  const std::optional<Rounded_map>& rounded_map() const { return rounded_map_; }

  /// Rounds all points, multiplied by a factor, unless that was done last.
  void round(const Exact_number& by)
  {
    if (factor_ && *factor_ == by) return;
    factor_ = by;
    largest_ = error_ = 0;
    if (map_ && round_map()) return;
    rounded_.resize(size_);
    for (std::size_t v = 0; v < size_; ++v)
      for (std::size_t k = 0; k < 3; ++k) {
        rounded_[v][k] = Exact_number(exact(v)[k] * by).to_double();
        largest_ = maximum(largest_, std::abs(rounded_[v][k]));
      }
  }

 private:
  /// Rounds the map. False where terms may overflow, as large entries by small coordinates do.
  bool round_map()
  {
    Rounded_map m;
    for (std::size_t k = 0; k < 12; ++k) m[k] = Exact_number((*map_)[k] * *factor_).to_double();
    double most = 0;
    for (std::size_t k = 0; k < 12; k += 4)
      most = maximum(most, std::abs(m[k]) * reach_[0] + std::abs(m[k + 1]) * reach_[1] +
                               std::abs(m[k + 2]) * reach_[2] + std::abs(m[k + 3]));
    rounded_map_.reset();
    if (!(most < 0x1p1000)) return false;
    rounded_map_ = m;
    largest_ = most * (1 + 0x1p-40);
    error_ = image_rounding * largest_ + image_underflow * maximum(1.0, reach_[0], reach_[1], reach_[2]);
    return true;
  }

  std::size_t size_ = 0;
  std::span<const Rounded_vector> corners_;
  Rounded_vector reach_{};
  std::optional<std::array<Exact_number, 12>> map_;
  mutable std::vector<std::uint32_t> place_;  // of each image in `made_`, from 1; 0 where it is not made
  mutable std::deque<Exact_vector> made_;
  std::optional<Rounded_map> rounded_map_;
  std::vector<Rounded_vector> rounded_;  // without such a map
  std::optional<Exact_number> factor_;   // the points were multiplied by it and rounded
  double error_ = 0, largest_ = 0;
};

/// Rounds two sets of points, multiplied by one power of 2 for which products of a few coordinates are finite. Returns
/// that power. It is b's own where that serves, so that few points are rounded anew.
inline Exact_number round_together(Hull_points& a, Hull_points& b)
{
  Exact_number factor = b.factor().value_or(Exact_number(1));
  // Products of three numbers of this range neither overflow nor vanish. The coordinates of placed doubles need few
  // steps; where all points are 0, no step helps.
  constexpr double least = 0x1p-200, most = 0x1p200, step = 0x1p300;
  for (int k = 0; k < 40; ++k) {
    a.round(factor);
    b.round(factor);
    const double size = maximum(a.largest(), b.largest());
    if (size >= least && size <= most) break;
    factor = factor * Exact_number(size < least ? step : 1 / step);
  }
  return factor;
}

/// A hull of points, and of all points beyond them along `recession` where there is one.
struct Hull {
  const Hull_points* points;
  std::span<const std::uint32_t> corners;  ///< numbers of points, at least one
  const Rounded_vector* recession = nullptr;
};

/// Two hulls, B beyond A.
struct Hull_pair {
  Hull a, b;
};

/// Returns a direction along which each B is beyond its A by more than `distance`, as far as doubles tell. Its product
/// with A's recession is not positive, up to rounding. Returns nothing where the search finds none: no such direction
/// exists, or steps get too small, or 40 steps do not suffice.
///
/// Requires a pair, rounded points, in whose units `distance` is, and one recession for all A. Source: E. G. Gilbert,
/// An iterative procedure for computing the minimum of a quadratic form on a convex set, SIAM J. Control 4 (1966).
inline std::optional<Rounded_vector> direction_between(std::span<const Hull_pair> pairs, double distance)
{
  const auto middle = [](const Hull& hull) {
    Rounded_vector sum{};
    for (const std::uint32_t v : hull.corners)
      for (int k = 0; k < 3; ++k) sum[k] += hull.points->rounded(v)[k];
    for (double& x : sum) x /= double(hull.corners.size());
    return sum;
  };
  // A point of the hull of all B - A: the nearest to the origin on the segment to the last support.
  Rounded_vector z{};
  for (const Hull_pair& pair : pairs) {
    const Rounded_vector way = difference(middle(pair.b), middle(pair.a));
    for (int k = 0; k < 3; ++k) z[k] += way[k] / double(pairs.size());
  }
  constexpr int most_steps = 40;
  for (int step = 0; step < most_steps; ++step) {
    const Rounded_vector* recession = pairs[0].a.recession;
    if (recession) {
      const double along = dot(z, *recession);
      if (along > 0)
        for (int k = 0; k < 3; ++k) z[k] -= along / dot(*recession, *recession) * (*recession)[k];
    }
    const auto support = [&](const Hull& hull, double sign) {
      std::size_t best = hull.corners[0];
      for (const std::uint32_t v : hull.corners)
        if (sign * dot(z, hull.points->rounded(v)) > sign * dot(z, hull.points->rounded(best))) best = v;
      return hull.points->rounded(best);
    };
    std::optional<Rounded_vector> least;
    for (const Hull_pair& pair : pairs) {
      const Rounded_vector v = difference(support(pair.b, -1), support(pair.a, 1));
      if (!least || dot(z, v) < dot(z, *least)) least = v;
    }
    const double length = std::sqrt(dot(z, z));
    if (!(length > distance)) return std::nullopt;
    if (dot(z, *least) > distance * length) return z;
    const Rounded_vector w = difference(*least, z);
    const double share = -dot(z, w) / dot(w, w);
    if (!(share > 0x1p-40)) return std::nullopt;
    for (int k = 0; k < 3; ++k) z[k] += minimum(share, 1.0) * w[k];
  }
  return std::nullopt;
}

/// Returns a multiple of the direction, rounded to integers. The largest has the magnitude 2^bits. Returns 0 for a
/// direction that is 0, infinite or undefined.
inline Exact_vector rounded_to_bits(const Rounded_vector& direction, int bits)
{
  const double largest = maximum(std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2]));
  if (!(largest > 0 && largest < HUGE_VAL)) return {0, 0, 0};
  Exact_vector whole;
  for (int k = 0; k < 3; ++k) whole[k] = Exact_number(std::rint(std::ldexp(direction[k] / largest, bits)));
  return whole;
}

/// Returns a vector near a multiple of the direction, whose product with `recession` is not positive. Nor is the
/// vector's, exactly. Integers of these bits are its components along two directions across the recession, and against
/// it. Returns 0 where the direction has no such components: along the recession alone.
inline Exact_vector rounded_to_bits(const Rounded_vector& direction, int bits, Exact_vector recession)
{
  // Powers of 2 make the axes about as long as 1.
  const auto unit = [](const Exact_vector& axis) {
    double largest = 0;
    for (const Exact_number& x : axis) largest = maximum(largest, std::abs(x.to_double()));
    return scaled(axis, Exact_number(std::ldexp(1.0, -std::ilogb(largest))));
  };
  recession = unit(recession);
  const int k = largest_axis(recession);
  Exact_vector across = {0, 0, 0};
  across[k] = -recession[(k + 1) % 3];
  across[(k + 1) % 3] = recession[k];
  const std::array<Exact_vector, 3> basis = {unit(across), unit(cross(recession, across)), negated(recession)};
  Rounded_vector parts;
  for (int i = 0; i < 3; ++i) {
    Rounded_vector axis;
    for (int c = 0; c < 3; ++c) axis[c] = basis[i][c].to_double();
    parts[i] = dot(direction, axis) / dot(axis, axis);
  }
  parts[2] = maximum(parts[2], 0.0);
  const Exact_vector whole = rounded_to_bits(parts, bits);
  Exact_vector sum = {0, 0, 0};
  for (int i = 0; i < 3; ++i) sum = kernel::sum(sum, scaled(basis[i], whole[i]));
  return sum;
}

/// A requirement for two hulls: they are apart by more than the root of top / bottom, or by just that if `or_equal`.
///
/// With `sweep`, A has been moved by the centre of a box of translations. The rule then asks that the hulls are apart
/// for all translations of the box that are shorter than the root.
struct Gap_rule {
  struct Sweep {
    Exact_vector centre, half;
  };

  Exact_number top = 0, bottom = 1;  ///< of the squared distance, in the exact points' units
  bool or_equal = false;
  double rounded = 0;  ///< near the distance that is asked for, in rounded units
  std::optional<Sweep> sweep = {};

  /// True when a direction m proves that hulls keep the rule: B is beyond A along m by the required distance, or for
  /// all translations of the box. `gap` is the least m . b - m . a of their points.
  bool is_kept(Exact_number gap, const Exact_vector& m) const
  {
    if (sweep) {
      Exact_number left = gap;
      for (std::size_t k = 0; k < 3; ++k) {
        const Exact_number step = m[k] * sweep->half[k];
        left = step.sign() == CGAL::NEGATIVE ? left + step : left - step;
      }
      if (left.sign() == CGAL::POSITIVE) return true;
      gap = gap + dot(m, sweep->centre);
    }
    if (gap.sign() != CGAL::POSITIVE) return false;
    if (top.is_zero()) return true;
    const Exact_number square = gap * gap * bottom, least = top * dot(m, m);
    return or_equal ? square >= least : square > least;
  }
};

/// Returns the face of one loop through the hull's corners. With `has_plane`, the first three corners span its plane.
inline Exact_face exact_face(const Hull& hull, bool has_plane)
{
  Exact_face face;
  const auto at = [&](std::size_t k) { return hull.points->exact(hull.corners[k % hull.corners.size()]); };
  for (std::size_t k = 0; k < hull.corners.size(); ++k) face.edges.push_back({at(k), at(k + 1)});
  if (has_plane) face.plane = {at(0), at(1), at(2)};
  return face;
}

/// Returns a direction m with m . start < h and m . end <= h, where h is the least m . x of a face's corners x. So the
/// segment from start to end meets the face at most at its end. Returns nothing where no candidate is such a direction.
inline std::optional<Exact_vector> direction_of_first_touch(const Exact_face& face, const Exact_vector& start,
                                                            const Exact_vector& end)
{
  const Exact_vector way = difference(end, start);
  std::vector<Exact_vector> candidates = {way};
  const auto add = [&](Exact_vector m) {
    if (dot(m, way).sign() == CGAL::NEGATIVE) m = negated(m);
    candidates.push_back(std::move(m));
  };
  if (face.plane) add(normal_of(*face.plane));
  for (const auto& [p, q] : face.edges) {
    const Exact_vector along = difference(q, p);
    add(difference(scaled(way, dot(along, along)), scaled(along, dot(along, way))));
    if (face.plane) add(cross(normal_of(*face.plane), along));
  }
  for (const Exact_vector& m : candidates) {
    const Exact_number first = dot(m, start), last = dot(m, end);
    if (std::ranges::all_of(face.edges, [&](const auto& edge) {
          const Exact_number at = dot(m, edge[0]);
          return at > first && at >= last;
        }))
      return m;
  }
  return std::nullopt;
}

/// Returns the winding number of a face's loops about a ray, as seen along it. Returns nothing where the ray meets an
/// edge, or not the face's plane beyond its origin. `ray` is the ray as a face: a segment that ends beyond the body.
inline std::optional<int> generic_crossing(const Exact_face& face, const Exact_vector& origin,
                                           const Exact_vector& direction, const Exact_face& ray)
{
  if (!face.plane) return std::nullopt;
  const Exact_vector normal = normal_of(*face.plane);
  const CGAL::Sign side = dot(normal, direction).sign();
  const CGAL::Sign height = dot(normal, difference((*face.plane)[0], origin)).sign();
  if (side == CGAL::ZERO || height != side) return std::nullopt;
  for (const auto& [p, q] : face.edges)
    if (distance_of_faces(ray, Exact_face{{{p, q}, {q, p}}, std::nullopt}).is_zero()) return std::nullopt;
  const Exact_vector up = side == CGAL::POSITIVE ? direction : negated(direction);
  const int winding = detail::winding_about_line(face, origin, up);
  return side == CGAL::POSITIVE ? winding : -winding;
}

}  // namespace tetracone::kernel

#endif
