#include "verify/searches/searches.h"

#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/products.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetracone::verify::proofs {
namespace {
namespace adaptive_search {

using detail::at, detail::exactly, detail::share, detail::box, detail::u;
using kernel::Double_double;

double volume(const Inputs& in)
{
  const auto a = at(in, 0), b = at(in, 3), c = at(in, 6), d = at(in, 9);
  const auto p = kernel::difference(b, a), q = kernel::difference(c, a), r = kernel::difference(d, a);
  const auto from = [&](const std::array<double, 3>& x) { return kernel::difference(exactly(x), exactly(a)); };
  return share(kernel::determinant(p, q, r), kernel::determinant(from(b), from(c), from(d)), box<3>({p, q, r})) / u;
}

double normal(const Inputs& in)
{
  const double bi = in[2] - in[0], bj = in[3] - in[1], ci = in[4] - in[0], cj = in[5] - in[1];
  const auto from = [&](int k) { return Rational(Rational(in[k]) - Rational(in[k % 2])); };
  return share(kernel::cross_component(bi, bj, ci, cj), kernel::cross_component(from(2), from(3), from(4), from(5)),
               std::max(std::abs(bi), std::abs(ci)) * std::max(std::abs(bj), std::abs(cj))) /
         u;
}

double image(const Inputs& in)
{
  const auto terms = kernel::placed_terms(in[0], in[1], in[2], in[3], at(in, 4));
  const Rational x(in[0]), y(in[1]), z(in[2]), t(in[3]);
  return share(kernel::sum(terms), kernel::sum(kernel::placed_terms(x, y, z, t, exactly(at(in, 4)))),
               kernel::sum_of_magnitudes(terms)) /
         u;
}

double translation(const Inputs& in)
{
  return share(in[0] + in[1], Rational(Rational(in[0]) + Rational(in[1])), std::abs(in[0] + in[1])) / u;
}

double pose_determinant(const Inputs& in)
{
  return share(kernel::determinant(at(in, 0), at(in, 3), at(in, 6)),
               kernel::determinant(exactly(at(in, 0)), exactly(at(in, 3)), exactly(at(in, 6))),
               kernel::permanent(at(in, 0), at(in, 3), at(in, 6))) /
         u;
}

/// High parts, and low parts of at most half the high part's last digit.
Double_double pair(const Inputs& in, std::size_t k)
{
  return Double_double::sum(in[k], in[k] * in[k + in.size() / 2] * u / 2);
}
Rational exactly(const Double_double& x) { return Rational(x.high) + Rational(x.low); }

double off(const Double_double& computed, const Rational& exact, double scale)
{
  return scale > 0 ? Rational(abs(Rational(exactly(computed) - exact))).get_d() / scale / (u * u) : 0;
}

double double_double_volume(const Inputs& in)
{
  std::array<std::array<Double_double, 3>, 3> m;
  std::array<std::array<Rational, 3>, 3> exact;
  for (int k = 0; k < 9; ++k) {
    m[k / 3][k % 3] = pair(in, k);
    exact[k / 3][k % 3] = exactly(m[k / 3][k % 3]);
  }
  return off(kernel::determinant(m[0], m[1], m[2]), kernel::determinant(exact[0], exact[1], exact[2]),
             box<3>({at(in, 0), at(in, 3), at(in, 6)}));
}

double double_double_normal(const Inputs& in)
{
  const auto bi = pair(in, 0), bj = pair(in, 1), ci = pair(in, 2), cj = pair(in, 3);
  return off(kernel::cross_component(bi, bj, ci, cj),
             kernel::cross_component(exactly(bi), exactly(bj), exactly(ci), exactly(cj)),
             std::max(std::abs(in[0]), std::abs(in[2])) * std::max(std::abs(in[1]), std::abs(in[3])));
}

double double_double_difference(const Inputs& in)
{
  const auto a = pair(in, 0), b = pair(in, 1), difference = a - b;
  return off(difference, Rational(exactly(a) - exactly(b)), std::abs(difference.high));
}

/// Rounded fractions as entries: each has a relative error of u^2.
double double_double_image(const Inputs& in)
{
  const std::array<double, 3> vertex = at(in, 8);
  std::array<Double_double, 4> terms;
  Rational exact = 0;
  double magnitudes = 0;
  for (int k = 0; k < 4; ++k) {
    const Double_double entry = Double_double::sum(in[k], in[k] * in[4 + k] * u / 2);
    const double factor = k == 0 ? 1 : vertex[k - 1];
    terms[k] = k == 0 ? entry : entry * Double_double(factor);
    exact += exactly(entry) * (1 + Rational(std::clamp(in[11 + k], -1.0, 1.0)) * Rational(u * u)) * Rational(factor);
    magnitudes += std::abs(in[k] * factor);
  }
  return off(kernel::sum(terms), exact, magnitudes);
}

/// The inputs from `first` on as errors of at most `error`.
std::array<Rational, 3> moved(const std::array<double, 3>& v, const Inputs& in, int first, double error)
{
  std::array<Rational, 3> result = exactly(v);
  for (int k = 0; k < 3; ++k) result[k] += Rational(std::clamp(in[first + k], -1.0, 1.0)) * Rational(error);
  return result;
}

double volume_motion(const Inputs& in)
{
  const std::array<std::array<double, 3>, 3> p = {at(in, 0), at(in, 3), at(in, 6)};
  const double error = std::abs(in[18]);
  std::array<double, 3> m{};
  for (const auto& v : p)
    for (int k = 0; k < 3; ++k) m[k] = std::max(m[k], std::abs(v[k]));
  const Rational off =
      kernel::determinant(moved(p[0], in, 9, error), moved(p[1], in, 12, error), moved(p[2], in, 15, error)) -
      kernel::determinant(exactly(p[0]), exactly(p[1]), exactly(p[2]));
  const double y = m[1] + error, z = m[2] + error;
  return share(0, off, error * (y * z + m[0] * z + m[0] * m[1]));
}

double normal_motion(const Inputs& in)
{
  const double error = std::abs(in[8]), mi = std::max(std::abs(in[0]), std::abs(in[2])),
               mj = std::max(std::abs(in[1]), std::abs(in[3]));
  const auto off = [&](int k) {
    return Rational(Rational(in[k]) + Rational(std::clamp(in[4 + k], -1.0, 1.0)) * Rational(error));
  };
  const Rational moved_by = kernel::cross_component(off(0), off(1), off(2), off(3)) -
                            kernel::cross_component(Rational(in[0]), Rational(in[1]), Rational(in[2]), Rational(in[3]));
  return share(0, moved_by, error * (mj + error + mi));
}

/// One point moves by up to `of_a` and the other by up to `of_b`, the given errors.
double difference_motion(const Inputs& in)
{
  const double of_a = std::abs(in[0]), of_b = std::abs(in[1]);
  const Rational off =
      Rational(of_a) * Rational(std::clamp(in[2], -1.0, 1.0)) - Rational(of_b) * Rational(std::clamp(in[3], -1.0, 1.0));
  return share(0, off, of_a + of_b);
}

}  // namespace adaptive_search
}  // namespace

Searches adaptive_searches()
{
  using namespace adaptive_search;
  return {{"image", {7, image}},
          {"translation", {2, translation}},
          {"volume", {12, volume}},
          {"volume_motion", {19, volume_motion}},
          {"volume_motion in double-double", {19, volume_motion}},
          {"normal", {6, normal}},
          {"normal_motion", {9, normal_motion}},
          {"normal_motion in double-double", {9, normal_motion}},
          {"difference_motion", {4, difference_motion}},
          {"difference_motion in double-double", {4, difference_motion}},
          {"double_double_image", {15, double_double_image}},
          {"double_double_difference", {4, double_double_difference}},
          {"double_double_volume", {18, double_double_volume}},
          {"double_double_normal", {8, double_double_normal}},
          {"Pose::determinant_rounding", {9, pose_determinant}}};
}

}  // namespace tetracone::verify::proofs
