#ifndef TETRACONE_VERIFY_SEARCHES_SEARCHES_H
#define TETRACONE_VERIFY_SEARCHES_SEARCHES_H

#include "tetracone/kernel/number/floating_point.h"
#include "verify/searches/tracked.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// Searches for the worst error that a constant must cover: hill climbing over the inputs of an expression of the code.
/// Errors are found in rationals.
namespace tetracone::verify::proofs {

using Inputs = std::vector<double>;

/// A search for one constant.
struct Search {
  std::size_t inputs;              ///< their number
  double (*share)(const Inputs&);  ///< returns the error for these inputs, in the constant's unit
};

/// Searches by the names of the constants, as in `Proved_bound::name`.
using Searches = std::map<std::string, Search>;
Searches adaptive_searches();
Searches bound_searches();
Searches frame_searches();
Searches box_searches();
Searches distance_searches();
Searches ray_searches();

/// Returns the worst error that a search of `steps` steps finds for a constant, in its unit; negative where no search
/// exists. Equal seeds find equal errors.
double worst_found(const std::string& name, int steps, unsigned seed);

/// Returns why no search exists for a constant's worst error; empty if one exists, and for an unknown name.
std::string why_not_searched(const std::string& name);

namespace detail {

constexpr double u = kernel::unit_roundoff<double>, u_of_float = kernel::unit_roundoff<float>;

/// Returns the three inputs from `first` on.
inline std::array<double, 3> at(const Inputs& in, int first) { return {in[first], in[first + 1], in[first + 2]}; }
/// Returns the vector in rationals.
inline std::array<Rational, 3> exactly(const std::array<double, 3>& v)
{
  return {Rational(v[0]), Rational(v[1]), Rational(v[2])};
}

/// Returns |computed - exact| / scale, rounded; 0 if the scale is 0.
inline double share(double computed, const Rational& exact, double scale)
{
  return scale > 0 ? Rational(abs(Rational(Rational(computed) - exact))).get_d() / scale : 0;
}

/// Returns the product, over the axes, of the largest magnitude of a coordinate.
template <std::size_t n>
double box(const std::array<std::array<double, 3>, n>& v)
{
  double product = 1;
  for (int k = 0; k < 3; ++k) {
    double largest = 0;
    for (const auto& p : v) largest = std::max(largest, std::abs(p[k]));
    product *= largest;
  }
  return product;
}

/// Returns the n inputs from `first` on, tracked.
template <class Float, std::size_t n = 3>
std::array<Tracked<Float>, n> tracked(const Inputs& in, int first)
{
  return [&]<std::size_t... k>(std::index_sequence<k...>)
  {
    return std::array<Tracked<Float>, n>{Tracked<Float>(in[first + k])...};
  }
  (std::make_index_sequence<n>());
}

/// Returns x as a computed number with an error: its exact value differs by `e` times the unit roundoff.
template <class Float>
Tracked<Float> rounded_once(double x, double e)
{
  const Float computed = Float(x);
  const double most = 1 - kernel::unit_roundoff<Float>;
  return {computed, Rational(Rational(computed) *
                             (1 + Rational(std::clamp(e, -most, most)) * Rational(kernel::unit_roundoff<Float>)))};
}
/// Returns the n inputs from `first` on, with the errors that the n inputs from `errors` on give.
template <class Float, std::size_t n = 3>
std::array<Tracked<Float>, n> rounded_once(const Inputs& in, int first, int errors)
{
  std::array<Tracked<Float>, n> all = tracked<Float, n>(in, first);
  for (std::size_t k = 0; k < n; ++k) all[k] = rounded_once<Float>(in[first + k], in[errors + k]);
  return all;
}

/// Returns the rotation of the quaternion (w, x, y, z) from `first` on, row by row; that of a null quaternion is NaN.
inline std::array<std::array<double, 3>, 3> rotation(const Inputs& in, int first)
{
  const double w = in[first], x = in[first + 1], y = in[first + 2], z = in[first + 3],
               norm = w * w + x * x + y * y + z * z;
  return {{{(w * w + x * x - y * y - z * z) / norm, 2 * (x * y - w * z) / norm, 2 * (x * z + w * y) / norm},
           {2 * (x * y + w * z) / norm, (w * w - x * x + y * y - z * z) / norm, 2 * (y * z - w * x) / norm},
           {2 * (x * z - w * y) / norm, 2 * (y * z + w * x) / norm, (w * w - x * x - y * y + z * z) / norm}}};
}

/// Returns the sum of the magnitudes of the terms of a scalar product.
template <class Float>
double sum_of_terms(const std::array<Tracked<Float>, 3>& a, const std::array<Tracked<Float>, 3>& b)
{
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += std::abs(double(a[k].computed) * double(b[k].computed));
  return sum;
}

/// Returns error / scale; 0 if the scale is 0.
inline double ratio(double error, double scale) { return scale > 0 ? error / scale : 0; }

}  // namespace detail

}  // namespace tetracone::verify::proofs

#endif
