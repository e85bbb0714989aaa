#ifndef TETRACONE_KERNEL_PREDICATE_VERTEX_SEPARATION_H
#define TETRACONE_KERNEL_PREDICATE_VERTEX_SEPARATION_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"
#include "tetracone/kernel/predicate/adaptive.h"
#include "tetracone/kernel/predicate/signs.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

/// A plane between two bodies that nearly touch in vertices. Doubles tell which vertices are so near that they may
/// touch, exact signs whether these are apart.
namespace tetracone::kernel {

/// The vertices of a body with their largest coordinate by magnitude, and the pose that places them.
struct Placed_vertices {
  const std::vector<Vertex>& vertices;
  double largest;
  const Pose& pose;
};

/// Returns the largest magnitude of a coordinate; NaN where one is.
inline double largest_coordinate(const std::vector<Vertex>& vertices)
{
  double largest = 0;
  for (const Vertex& v : vertices) largest = maximum(largest, std::abs(v[0]), std::abs(v[1]), std::abs(v[2]));
  return largest;
}

/// The products of a body's placed vertices with a direction of integers, in double.
class Vertex_reach {
 public:
  /// Upper bound of the error of a product, relative to the sum of its terms' magnitudes. An entry may be a rounded
  /// fraction; a factor has 3 roundings, and a sum 4. The rest covers the bound's own. They are counted by hand
  /// (verify/proofs/other_constants.h).
  static constexpr double rounding = 0x1p-49;

  Vertex_reach(const Placed_vertices& body, const std::array<int, 3>& direction) : vertices_(body.vertices)
  {
    std::array<double, 4> magnitude;
    for (int j = 0; j < 4; ++j) {
      const auto term = [&](int k) { return direction[k] * body.pose[4 * k + j]; };
      factor_[j] = term(0) + term(1) + term(2);
      magnitude[j] = std::abs(term(0)) + std::abs(term(1)) + std::abs(term(2));
    }
    const double terms = (magnitude[0] + magnitude[1] + magnitude[2]) * body.largest + magnitude[3];
    // Beyond the gate, what an underflow loses of a factor could count.
    error_ = body.largest <= magnitude_gate && terms <= magnitude_gate ? rounding * terms + underflow_slack
                                                                       : std::numeric_limits<double>::infinity();
  }

  /// Returns the product of vertex v.
  double operator()(std::size_t v) const
  {
    return sum(placed_terms(factor_[0], factor_[1], factor_[2], factor_[3], vertices_[v]));
  }

  /// Returns an upper bound of the error of each product; infinite where none is known.
  double error() const { return error_; }

  /// Returns the vertex of the largest product, or of the least if `sign` is -1.
  std::size_t farthest(double sign) const
  {
    std::size_t best = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < vertices_.size(); ++v)
      if (const double value = sign * (*this)(v); value > most) {
        most = value;
        best = v;
      }
    return best;
  }

 private:
  const std::vector<Vertex>& vertices_;
  std::array<double, 4> factor_{};
  double error_;
};

/// True when some direction is found along which all vertices of B are strictly beyond those of A; so the bodies share
/// no point. It tries `direction`, which leads from A to B, and up to `steps` - 1 others: a direction along which they
/// overlap is mirrored as in `Separating_direction`. It gives up where more than four vertices of a body come near the
/// plane. Requires vertices of both, and 0 < `steps`.
///
/// `point_a(v)` and `point_b(v)` return the placed vertices.
template <class Point_a, class Point_b>
bool are_parted_by_vertices(std::array<double, 3> direction, const Placed_vertices& a, const Point_a& point_a,
                            const Placed_vertices& b, const Point_b& point_b, int steps)
{
  constexpr double longest = Adaptive_fixed::longest_direction;
  for (; steps > 0; --steps) {
    const double largest = maximum(std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2]));
    if (!(largest >= 0x1p-500 && largest <= 0x1p500)) return false;
    std::array<int, 3> d;
    for (int k = 0; k < 3; ++k) d[k] = int(std::rint(direction[k] / largest * longest));
    const Vertex_reach along_a(a, d), along_b(b, d);
    const std::size_t last_of_a = along_a.farthest(1), first_of_b = along_b.farthest(-1);
    const double end_of_a = along_a(last_of_a), start_of_b = along_b(first_of_b);
    const double slack = 2 * (along_a.error() + along_b.error());
    if (!(slack <= std::numeric_limits<double>::max())) return false;
    if (start_of_b >= end_of_a - slack) {
      // A vertex that is farther than the slack from the other body's last one is apart from all of them.
      constexpr std::size_t most = 4;
      std::array<std::size_t, most> near_a, near_b;
      std::size_t count_a = 0, count_b = 0;
      for (std::size_t v = 0; v < a.vertices.size(); ++v)
        if (!(along_a(v) < start_of_b - slack)) {
          if (count_a == most) return false;
          near_a[count_a++] = v;
        }
      for (std::size_t v = 0; v < b.vertices.size(); ++v)
        if (!(along_b(v) > end_of_a + slack)) {
          if (count_b == most) return false;
          near_b[count_b++] = v;
        }
      for (std::size_t i = 0; i < count_a; ++i)
        for (std::size_t j = 0; j < count_b; ++j)
          if (Adaptive::sign_along(point_a(near_a[i]), point_b(near_b[j]), d) != POSITIVE) return false;
      return true;
    }
    const Vertex way = difference(point_b(first_of_b).image, point_a(last_of_a).image);
    const double factor = 2 * dot(direction, way) / dot(way, way);
    for (int k = 0; k < 3; ++k) direction[k] -= factor * way[k];
  }
  return false;
}

}  // namespace tetracone::kernel

#endif
