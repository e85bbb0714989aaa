#include "verify/proofs/all_proofs.h"

#include "tetracone/kernel/bound/origin_offset.h"
#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/products.h"
#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/bound_proofs.h"
#include "verify/proofs/frame_proofs.h"
#include "verify/proofs/obb8_proofs.h"
#include "verify/proofs/separation_proofs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <vector>

namespace tetracone::verify::proofs {

Proved_bounds all_proofs()
{
  Proved_bounds all;
  for (const auto& proofs : {adaptive_proofs, bound_proofs, frame_proofs, obb8_proofs, separation_proofs})
    for (const Proved_bound& bound : proofs()) all.push_back(bound);
  return all;
}

namespace {

using Inputs = std::vector<double>;
using kernel::Double_double;
constexpr double u = kernel::unit_roundoff<double>;

std::array<double, 3> at(const Inputs& in, int first) { return {in[first], in[first + 1], in[first + 2]}; }
std::array<Rational, 3> exactly(const std::array<double, 3>& v)
{
  return {Rational(v[0]), Rational(v[1]), Rational(v[2])};
}

/// |computed - exact| as a share of `scale`.
double share(double computed, const Rational& exact, double scale)
{
  return scale > 0 ? Rational(abs(Rational(Rational(computed) - exact))).get_d() / scale : 0;
}

/// The largest magnitudes of each axis, multiplied.
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

/// High parts, and low parts of at most half their last digit.
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

/// Rows of both bodies times their origins: p and q of A, r and s of B.
double offset(const Inputs& in)
{
  using Pair = Lanes<double, 2>;
  std::vector<double> computed;
  Rational exact = 0;
  double terms = 0;
  for (int k = 0; k < 8; ++k) {
    computed.push_back(in[k] * in[8 + k]);
    exact += (k < 4 ? -1 : 1) * Rational(in[k]) * Rational(in[8 + k]);
    terms += std::abs(computed.back());
  }
  const auto pair_at = [&](int k) { return Pair{{computed[k], computed[k + 1]}}; };
  using Offset = kernel::Origin_offset;
  return share(Offset::sum_of_parts(Offset::difference_in_parts(pair_at(0), pair_at(2), pair_at(4), pair_at(6))), exact,
               terms) /
         u;
}

double compensated(const Inputs& in)
{
  using Offset = kernel::Origin_offset;
  const auto row = [&](int k) { return std::array{in[k], in[k + 1], in[k + 2], in[k + 3]}; };
  const auto sum = Offset::compensated<double>(row(0), at(in, 8), row(4), at(in, 11));
  Rational exact = Rational(in[7]) - Rational(in[3]);
  for (int k = 0; k < 3; ++k)
    exact += Rational(in[4 + k]) * Rational(in[11 + k]) - Rational(in[k]) * Rational(in[8 + k]);
  const Rational parts = Rational(sum.high) + Rational(sum.low);
  return Rational(abs(Rational(parts - exact))).get_d() / sum.magnitude / (u * u);
}

struct Search {
  std::size_t inputs;
  double (*share)(const Inputs&);
};

const std::map<std::string, Search>& searches()
{
  static const std::map<std::string, Search> all = {{"image", {7, image}},
                                                    {"translation", {2, translation}},
                                                    {"volume", {12, volume}},
                                                    {"normal", {6, normal}},
                                                    {"double_double_difference", {4, double_double_difference}},
                                                    {"double_double_volume", {18, double_double_volume}},
                                                    {"double_double_normal", {8, double_double_normal}},
                                                    {"Pose::determinant_rounding", {9, pose_determinant}},
                                                    {"Origin_offset::double_rounding", {16, offset}},
                                                    {"Origin_offset::remainder_rounding", {14, compensated}}};
  return all;
}

}  // namespace

double worst_found(const std::string& name, int steps, unsigned seed)
{
  const auto search = searches().find(name);
  if (search == searches().end()) return -1;
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return double(random() >> 11) * 0x1p-52 - 1; };
  const auto start = [&] {
    Inputs in(search->second.inputs);
    for (double& x : in) x = uniform();
    return in;
  };
  // Near 1 errors are the largest shares of what they are errors of; a step changes one number by ulps or anew.
  Inputs best = start();
  double worst = search->second.share(best), all = worst;
  for (int step = 0, since = 0; step < steps; ++step, ++since) {
    if (since > 2000) {
      best = start();
      worst = search->second.share(best);
      since = 0;
    }
    Inputs next = best;
    for (int change = 0; change < 1 + int(random() % 2); ++change) {
      double& x = next[random() % next.size()];
      switch (random() % 4) {
        case 0: x = uniform(); break;
        case 1: x = std::copysign(1 + uniform() * 0x1p-30, uniform()); break;
        case 2: x *= 1 + uniform() * 0x1p-40; break;
        default: x = std::nextafter(x, random() % 2 == 0 ? 2 : -2);
      }
    }
    const double share = search->second.share(next);
    if (share >= worst) {
      if (share > worst) since = 0;
      worst = share;
      best = next;
      all = std::max(all, worst);
    }
  }
  return all;
}

}  // namespace tetracone::verify::proofs
