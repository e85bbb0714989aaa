#include "verify/proofs/distance_proofs.h"
#include "verify/proofs/searches.h"

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

/// Of a length: what its square is off by, halved.
double length(const Inputs& in)
{
  const std::array<double, 3> d = detail::at(in, 0);
  const double length = std::sqrt(kernel::dot(d, d));
  const auto exact = detail::exactly(d);
  const Rational square = kernel::dot(exact, exact);
  if (!(length > 0)) return 0;
  return Rational(abs(Rational(Rational(length) * Rational(length) / square - 1))).get_d() / 2 / u;
}

/// A point of a triangle, a share of the largest coordinate; of the slack it takes half the root of 3.
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

/// A model's coordinates, and last those of a point whose norm is at most 4; each is off by `local_error` at most.
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

}  // namespace tetracone::verify::proofs
