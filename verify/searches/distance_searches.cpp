// Searches of distances of triangles and of signs in cones, and of rays against triangles.

#include "verify/proofs/distance_proofs.h"
#include "verify/proofs/ray_proofs.h"
#include "verify/searches/searches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tetracone::verify::proofs {
namespace {
namespace distance_search {

using detail::u;
using Number = Tracked<double>;

/// The relative error of a length: half the relative error of its square.
double length(const Inputs& in)
{
  const std::array<double, 3> d = detail::at(in, 0);
  const double length = std::sqrt(kernel::dot(d, d));
  const auto exact = detail::exactly(d);
  const Rational square = kernel::dot(exact, exact);
  if (!(length > 0)) return 0;
  return Rational(abs(Rational(Rational(length) * Rational(length) / square - 1))).get_d() / 2 / u;
}

/// The error of a point of a triangle, relative to the largest coordinate; it uses half the root of 3 of the slack.
double point(const Inputs& in)
{
  std::vector<Number> numbers;
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    numbers.emplace_back(in[k]);
    largest = std::max(largest, std::abs(in[k]));
  }
  const double s = std::min(std::abs(in[3]), 1.0);
  numbers.emplace_back(s);
  numbers.emplace_back(std::min(std::abs(in[4]), 1 - s));
  return detail::ratio(detail::coordinate_in_triangle(numbers).error(), largest) * std::sqrt(0.75) / u;
}

/// A model's coordinates, and last those of a point whose norm is at most 4; each has an error of at most
/// `local_error`.
template <std::size_t corners>
std::vector<Number> local_points(const Inputs& in)
{
  std::vector<Number> numbers;
  const std::size_t all = 3 * corners + 3;
  double norm = 0;
  for (std::size_t k = all - 3; k < all; ++k) norm += std::abs(in[k]);
  for (std::size_t k = 0; k < all; ++k) {
    const double x = k < all - 3 ? std::clamp(in[k], -1.0, 1.0) : norm > 0 ? in[k] / norm * 3.99 : 0;
    numbers.emplace_back(
        x, Rational(Rational(x) + Rational(std::clamp(in[all + k], -1.0, 1.0)) * Rational(kernel::local_error)));
  }
  return numbers;
}

double cone(const Inputs& in) { return detail::cone_side(local_points<2>(in)).error() / u; }
double plane(const Inputs& in) { return detail::plane_side(local_points<3>(in)).error() / u; }

}  // namespace distance_search
}  // namespace

Searches distance_searches()
{
  using namespace distance_search;
  return {{"triangle_distance::length_rounding", {3, length}},
          {"triangle_distance::point_rounding", {5, point}},
          {"cone_side_bound", {18, cone}},
          {"plane_side_bound", {24, plane}}};
}

namespace {
namespace ray_search {

using Number = Tracked<double>;
using Vector = std::array<Number, 3>;

/// Corners and the ray's origin, from which differences are taken, and a direction of components of at most 2.
struct Ray_and_triangle {
  Vector to_a, to_b, p, q, direction;
  double farthest = 0, longest = 0;

  explicit Ray_and_triangle(const Inputs& in)
      : to_a(between(in, 0, 9)),
        to_b(between(in, 3, 9)),
        p(between(in, 3, 0)),
        q(between(in, 6, 0)),
        direction{component(in, 0), component(in, 1), component(in, 2)}
  {
    for (std::size_t k = 0; k < 3; ++k) {
      farthest = std::max({farthest, std::abs(to_a[k].computed), std::abs(to_b[k].computed)});
      longest = std::max({longest, std::abs(p[k].computed), std::abs(q[k].computed)});
    }
  }

 private:
  static Vector between(const Inputs& in, int to, int from)
  {
    return kernel::difference(detail::tracked<double>(in, to), detail::tracked<double>(in, from));
  }
  static Number component(const Inputs& in, std::size_t k) { return Number(2 * std::clamp(in[12 + k], -1.0, 1.0)); }
};

double side(const Inputs& in)
{
  const Ray_and_triangle all(in);
  return detail::ratio(kernel::determinant(all.to_a, all.to_b, all.direction).error(), all.farthest * all.farthest) /
         detail::u;
}

/// The error of N plus the error of t D, for the largest t.
double plane(const Inputs& in)
{
  const Ray_and_triangle all(in);
  const double square = all.longest * all.longest;
  return (detail::ratio(kernel::determinant(all.p, all.q, all.to_a).error(), square * all.farthest) +
          detail::ratio(kernel::determinant(all.p, all.q, all.direction).error(), square)) /
         detail::u;
}

/// In double-double, of differences that are exact.
template <bool is_slope>
double wide(const Inputs& in)
{
  using Wide = kernel::Double_double;
  std::array<std::array<Wide, 3>, 3> v;
  std::array<std::array<Rational, 3>, 3> exact;
  double longest = 0, farthest = 0;
  for (std::size_t k = 0; k < 9; ++k) {
    const std::size_t i = k / 3;
    const double far = is_slope && i == 2 ? 2 * std::clamp(in[k], -1.0, 1.0) : in[k],
                 near = is_slope && i == 2 ? 0 : in[9 + k];
    v[i][k % 3] = Wide::sum(far, -near);
    exact[i][k % 3] = Rational(far) - Rational(near);
    double& largest = i == 2 ? farthest : longest;
    largest = std::max(largest, std::abs(v[i][k % 3].high));
  }
  const Wide computed = kernel::determinant(v[0], v[1], v[2]);
  const Rational off =
      Rational(computed.high) + Rational(computed.low) - kernel::determinant(exact[0], exact[1], exact[2]);
  return detail::ratio(Rational(abs(off)).get_d(), longest * longest * (is_slope ? 1 : farthest)) /
         (detail::u * detail::u);
}

}  // namespace ray_search
}  // namespace

Searches ray_searches()
{
  using namespace ray_search;
  return {{"Ray_triangle::side_rounding", {15, side}},
          {"Ray_triangle::plane_rounding", {15, plane}},
          {"Ray_triangle::height_rounding", {18, wide<false>}},
          {"Ray_triangle::slope_rounding", {18, wide<true>}}};
}

}  // namespace tetracone::verify::proofs
