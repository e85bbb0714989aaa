#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/distance_solver.h"
#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/query/bvh8_points.h"
#include "tetracone/tetratree/query/point_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetracone {
namespace {

const tetratree::Point_locator& locator_of(const detail::Body_data& data, const char* what = "points inside or outside")
{
  kernel::require_sound_floating_point();
  if (!data.is_closed()) [[unlikely]]
    detail::require_solid(data, "body", what);
  return data.point_locator();
}

std::string coordinate(const std::string& point, std::size_t k) { return point + ": " + "xyz"[k] + " is "; }

/// Returns the point of texts. Throws Error for what is no number.
kernel::Rational_point parsed(const std::array<std::string, 3>& point)
{
  kernel::Rational_point exact;
  for (std::size_t k = 0; k < 3; ++k) exact[k] = kernel::required_number(point[k], coordinate("point", k));
  return exact;
}

/// Throws Error, in the name of `name()`, for a coordinate that is not finite.
template <class Name>
void require_finite(const std::array<double, 3>& point, const Name& name)
{
  for (std::size_t k = 0; k < 3; ++k)
    if (!std::isfinite(point[k])) [[unlikely]]
      throw Error(coordinate(name(), k) + kernel::shortest(point[k]) + "; expected a finite number");
}

/// True when all coordinates are finite. It has no branch for each, since there are many.
bool all_finite(std::span<const std::array<double, 3>> points)
{
  int all = 1;
  for (const auto& p : points)
    for (const double x : p) all &= std::abs(x) <= std::numeric_limits<double>::max();
  return all != 0;
}

/// Signed distances of points of one body. One object serves one thread.
class Signed_distances {
 public:
  /// Throws Error for an open surface.
  explicit Signed_distances(const detail::Body_data& data)
      : data_(data), locator_(locator_of(data, "signed distances")), points_(data.bvh8())
  {}

  Nearest_point operator()(const std::array<double, 3>& x)
  {
    return answer(x, points_.by_enclosures(x), locator_.locate(x));
  }

  std::vector<Nearest_point> of_each(std::span<const std::array<double, 3>> points)
  {
    std::vector<Nearest_point> answers(points.size());
    constexpr std::size_t at_once = 1 << 20,  // bounds the memory of copies
        ahead = 16;                           // the distance, in points, at which places of answers are prefetched
    for (std::size_t first = 0; first < points.size(); first += at_once) {
      const auto asked = points.subspan(first, kernel::minimum(at_once, points.size() - first));
      const std::vector<std::uint32_t> order = tetratree::order_by_cells(asked);
      std::vector<covering::Vertex> sorted;
      sorted.reserve(asked.size());
      for (const std::uint32_t k : order) sorted.push_back(asked[k]);
      std::vector<Location> locations(asked.size());
      locator_.locate(sorted, locations);
      tetratree::Bvh8_points::by_enclosures_of_each(data_.bvh8(), sorted, [&](std::size_t k, const auto& found) {
        if (k + ahead < asked.size()) prefetch(answers[first + order[k + ahead]]);
        answers[first + order[k]] = answer(sorted[k], found, locations[k]);
      });
    }
    return answers;
  }

  Exact_nearest_point exactly(const kernel::Rational_point& x)
  {
    const tetratree::Exact_surface_point found = points_.exactly(x);
    Exact_nearest_point nearest;
    nearest.distance = signed_by(locator_.locate(x), kernel::nearest_root(found.square));
    nearest.holder = detail::holder_in(data_.polyhedron, kernel::Pose(), found.face, found.point);
    if (nearest.holder.kind == Holder::Kind::edge) std::ranges::sort(nearest.holder.number);
    nearest.is_only = found.is_only;
    nearest.squared = kernel::to_string(found.square);
    for (std::size_t k = 0; k < 3; ++k) {
      nearest.point[k] = kernel::nearest_double(found.point[k]);
      nearest.exact_point[k] = kernel::to_string(found.point[k]);
    }
    return nearest;
  }

 private:
  /// Returns the answer for a point, by enclosures if they have decided it.
  Nearest_point answer(const std::array<double, 3>& x, const std::optional<tetratree::Surface_point>& found,
                       Location location)
  {
    if (!found) return exactly(kernel::exact_point(x));
    return {signed_by(location, found->distance), found->point, holder(*found), true};
  }

  static void prefetch(const Nearest_point& place)
  {
    const char* const bytes = reinterpret_cast<const char*>(&place);
    __builtin_prefetch(bytes, 1);
    __builtin_prefetch(bytes + sizeof place - 1, 1);
  }

  static double signed_by(Location location, double distance)
  {
    return location == Location::inside ? -distance : distance;
  }

  static Holder holder(const tetratree::Surface_point& found)
  {
    switch (found.feature) {
      case kernel::Feature::vertex: return {Holder::Kind::vertex, {found.end[0]}};
      case kernel::Feature::edge:
        return {Holder::Kind::edge,
                {kernel::minimum(found.end[0], found.end[1]), kernel::maximum(found.end[0], found.end[1])}};
      default: return {Holder::Kind::face, {found.face}};
    }
  }

  const detail::Body_data& data_;
  const tetratree::Point_locator& locator_;
  tetratree::Bvh8_points points_;
};

}  // namespace

Nearest_point Body::nearest(const std::array<double, 3>& point) const
{
  require_finite(point, [] { return std::string("point"); });
  return Signed_distances(*data_)(point);
}

std::vector<Nearest_point> Body::nearest(std::span<const std::array<double, 3>> points) const
{
  for (std::size_t k = 0; k < points.size(); ++k)
    require_finite(points[k], [k] { return "points[" + std::to_string(k) + "]"; });
  return Signed_distances(*data_).of_each(points);
}

Exact_nearest_point Body::nearest_text(const std::array<std::string, 3>& point) const
{
  const kernel::Rational_point exact = parsed(point);
  return Signed_distances(*data_).exactly(exact);
}

Location Body::inside(const std::array<double, 3>& point) const
{
  require_finite(point, [] { return std::string("point"); });
  return locator_of(*data_).locate(point);
}

std::vector<Location> Body::inside(std::span<const std::array<double, 3>> points) const
{
  const tetratree::Point_locator& locator = locator_of(*data_);
  std::vector<Location> answers(points.size());
  // Few enough that they stay in the cache for the second pass.
  constexpr std::size_t at_a_time = 512;
  for (std::size_t first = 0; first < points.size(); first += at_a_time) {
    const std::size_t count = kernel::minimum(at_a_time, points.size() - first);
    const auto some = points.subspan(first, count);
    if (!all_finite(some)) [[unlikely]]
      for (std::size_t k = 0; k < count; ++k)
        require_finite(some[k], [k, first] { return "points[" + std::to_string(first + k) + "]"; });
    locator.locate(some, std::span(answers).subspan(first, count));
  }
  return answers;
}

Location Body::inside_text(const std::array<std::string, 3>& point) const
{
  const kernel::Rational_point exact = parsed(point);
  return locator_of(*data_).locate(exact);
}

std::size_t Body::inside_bytes() const { return locator_of(*data_).bytes(); }

}  // namespace tetracone
