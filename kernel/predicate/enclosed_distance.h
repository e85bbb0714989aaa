#ifndef TETRACONE_KERNEL_PREDICATE_ENCLOSED_DISTANCE_H
#define TETRACONE_KERNEL_PREDICATE_ENCLOSED_DISTANCE_H

#include "tetracone/kernel/number/double_double_ball.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"
#include "tetracone/kernel/predicate/adaptive_double_double.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

/// The distance of two features of triangles, enclosed in double-double. It is the answer of face_distance.h where the
/// enclosures decide.
namespace tetracone::kernel {

using Ball_vector = std::array<Double_double_ball, 3>;

/// The enclosed corners, one to three, that span a feature of a triangle.
struct Ball_hull {
  std::array<Ball_vector, 3> corner;
  int count = 0;

  /// Adds the enclosed image of a vertex.
  void add(const Vertex& vertex, const Pose& pose)
  {
    const auto image = Adaptive_double_double::double_double_image(Adaptive_points::placed(vertex, pose));
    for (std::size_t k = 0; k < 3; ++k) corner[std::size_t(count)][k] = {image.coordinate[k], image.error};
    ++count;
  }
};

/// The distance height / sqrt(square), along a direction from A's feature to B's of |direction|^2 = square.
struct Enclosed_distance {
  Double_double_ball height, square;
  std::array<double, 3> direction;  ///< rounded: the errors of all coordinates sum to at most `direction_error` of it
  Ball_vector way;                  ///< the direction, enclosed

  // Upper bounds relative to the sum of the direction's magnitudes.
  static constexpr double most_radii = 0x1p-52,  ///< of the sum of the radii of an accepted direction, which is tested
      direction_error = 0x1p-51;  ///< of all errors of a direction: these radii, and a rounding of each coordinate
                                  ///< (verify/proofs/nearest_proofs.h)
};

namespace detail {

/// Returns a positive multiple of the vector from a point to the line of an edge. Returns nothing unless the nearest
/// point is surely within the edge.
inline std::optional<Ball_vector> way_to_edge(const Ball_vector& x, const Ball_vector& a, const Ball_vector& b)
{
  const Ball_vector e = difference(b, a), r = difference(x, a);
  const Double_double_ball length = dot(e, e), at = dot(r, e);
  if (!at.is_positive() || !(length - at).is_positive()) return std::nullopt;
  return difference(scaled(e, at), scaled(r, length));
}

/// Returns the cross product of two edges; nothing unless the nearest points of their lines are surely within both.
inline std::optional<Ball_vector> way_across_edges(const Ball_vector& a, const Ball_vector& b, const Ball_vector& c,
                                                   const Ball_vector& d)
{
  const Ball_vector e = difference(b, a), f = difference(d, c), r = difference(a, c);
  const Double_double_ball ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), er = dot(e, r), fr = dot(f, r);
  const Double_double_ball weight = ee * ff - ef * ef, s = ef * fr - ff * er, t = ee * fr - ef * er;
  if (!s.is_positive() || !t.is_positive() || !(weight - s).is_positive() || !(weight - t).is_positive())
    return std::nullopt;
  return cross(e, f);
}

/// Returns the normal of a triangle; nothing unless the point is surely over its interior.
inline std::optional<Ball_vector> way_to_triangle(const Ball_vector& x, const std::array<Ball_vector, 3>& t)
{
  const Ball_vector normal = normal_of(t);
  for (std::size_t k = 0; k < 3; ++k)
    if (!dot(normal, cross(difference(t[k], x), difference(t[(k + 1) % 3], x))).is_positive()) return std::nullopt;
  return normal;
}

/// Returns the direction between two hulls, up to a factor of either sign; nothing where the functions above give none.
inline std::optional<Ball_vector> way_between(const Ball_hull& a, const Ball_hull& b)
{
  if (a.count > b.count) return way_between(b, a);
  if (a.count == 1 && b.count == 1) return difference(b.corner[0], a.corner[0]);
  if (a.count == 1 && b.count == 2) return way_to_edge(a.corner[0], b.corner[0], b.corner[1]);
  if (a.count == 2 && b.count == 2) return way_across_edges(a.corner[0], a.corner[1], b.corner[0], b.corner[1]);
  if (a.count == 1 && b.count == 3) return way_to_triangle(a.corner[0], b.corner);
  return std::nullopt;
}

}  // namespace detail

/// Returns the distance of two hulls that `distance_of_hulls` would take. Returns nothing unless the enclosures show
/// that the nearest points of the affine hulls are apart and within both hulls. The direction must be known up to
/// `most_radii`.
inline std::optional<Enclosed_distance> enclosed_distance(const Ball_hull& a, const Ball_hull& b)
{
  auto way = detail::way_between(a, b);
  if (!way) return std::nullopt;
  Enclosed_distance found;
  found.height = dot(*way, difference(b.corner[0], a.corner[0]));
  if (!found.height.is_positive()) {
    found.height = -found.height;
    way = negated(*way);
  }
  if (!found.height.is_positive()) return std::nullopt;
  found.square = dot(*way, *way);
  double off = 0, magnitude = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    found.direction[k] = (*way)[k].middle.high;
    off += (*way)[k].radius;
    magnitude += std::abs(found.direction[k]);
  }
  // The high parts have a relative error of u each, and radii and magnitudes are rounded.
  if (!(off < Enclosed_distance::most_radii * magnitude)) return std::nullopt;
  found.way = *way;
  return found;
}

/// Returns the double nearest to x + way height / square, where that surely lies between the midpoints to both
/// neighbours. Returns nothing elsewhere, and outside 2^-900 to 2^900. Requires that `square` is positive.
inline std::optional<double> nearest_along(double x, const Double_double_ball& way, const Double_double_ball& height,
                                           const Double_double_ball& square)
{
  const double share = height.middle.high / square.middle.high;
  const Double_double rest = height.middle - square.middle * share;
  const double nearest = (Double_double(x) + way.middle * Double_double(share, rest.high / square.middle.high)).high;
  if (!(std::abs(nearest) > 0x1p-900 && std::abs(nearest) < 0x1p900)) return std::nullopt;
  const auto beyond = [&](double neighbour) {
    const Double_double_ball middle(Double_double(nearest, (neighbour - nearest) / 2), 0);
    return (Double_double_ball(x) - middle) * square + way * height;
  };
  if (!beyond(std::nextafter(nearest, -HUGE_VAL)).is_positive() ||
      !(-beyond(std::nextafter(nearest, HUGE_VAL))).is_positive())
    return std::nullopt;
  return nearest;
}

}  // namespace tetracone::kernel

#endif
