#ifndef TETRACONE_VERIFY_PROOFS_SCENE_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_SCENE_PROOFS_H

#include "tetracone/kernel/bound/obb8.h"
#include "tetracone/tetratree/scene/body_extent.h"
#include "tetracone/tetratree/scene/turned_box.h"
#include "verify/proofs/adaptive_proofs.h"
#include "verify/proofs/near_orthonormal.h"
#include "verify/proofs/proved_bound.h"
#include "verify/proofs/rounding_count.h"
#include "verify/proofs/slices.h"

#include <algorithm>
#include <string>
#include <vector>

/// The constants of tetratree/scene/: boxes of placed and of turned bodies, and of their motions.
namespace tetracone::verify::proofs {

namespace detail {

/// Inputs: a row of a map and its translation, the centre and half the extents of a box.
template <class Number>
tetratree::Placed_coordinate<Number> placed_coordinate(const std::vector<Number>& in)
{
  return {triple(in, 0), in[3], triple(in, 4), triple(in, 7)};
}

/// Entries are rounded: those of a fraction, or differences of two poses.
template <class Number>
tetratree::Placed_coordinate<Number> placed_by_entries(std::vector<Number> in)
{
  for (std::size_t k = 0; k < 4; ++k) in[k] = entry(in[k]);
  return placed_coordinate(in);
}

}  // namespace detail

inline Proved_bounds scene_proofs()
{
  const double u = kernel::unit_roundoff<double>, of_float = kernel::unit_roundoff<float>;
  const Rational once_in_float = 1 + 2 * Rational(of_float);
  const std::string extent = "tetratree/scene/body_extent.h", turned = "tetratree/scene/turned_box.h";
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, const std::string& file, double in_code, const Rational& proved,
                       double unit, double loosest, const std::string& by = "rationals") {
    bounds.push_back({name, file, Rational(in_code), proved, unit, loosest, by});
  };

  std::vector<Slice> terms;
  for (std::size_t k = 0; k < 3; ++k)
    for (const std::size_t factor : {4, 7}) {
      Slice slice(10, 0);
      slice[k] = slice[factor + k] = 1;
      terms.push_back(slice);
    }
  terms.push_back({0, 0, 0, 1, 0, 0, 0, 0, 0, 0});
  const Rounding_count of_terms = detail::placed_by_entries(std::vector<Rounding_count>(10)).terms * Rounding_count();
  const Rational lost = 1 / of_terms.least(Rational(u));
  // The difference with the slack is rounded beyond it, to the double below.
  const auto low = [](const auto& in) {
    const auto x = detail::placed_by_entries(in);
    return x.at - x.reach;
  };
  add("placed_rounding", extent, tetratree::placed_rounding, largest(slice_errors<Relative_64>(low, terms)) * lost, u,
      2.67, "gappa");
  const auto at = [](const auto& in) { return detail::placed_by_entries(in).at; };
  const Rational of_centre = largest(slice_errors<Relative_64>(at, terms)) * lost;
  add("placed_rounding, of motions", extent, tetratree::placed_rounding, of_centre, u, 3.21, "gappa");
  add("placed_rounding, of a turned box's centre", turned, 4 * tetratree::placed_rounding,
      root_3() * of_centre * once_in_float, u, 7.4, "gappa");

  // Points of a box of axes a_j and one of these rounded differ by s_j (a_j - a'_j), and each is off by `of_float` in
  // length; centres likewise. Along axes that are orthonormal but for the least.
  add("turned_rounding", turned, tetratree::turned_rounding, Rational(of_float) * once_in_float, of_float, 16.1);
  add("turned_centre_rounding", turned, tetratree::turned_centre_rounding, Rational(of_float) * once_in_float, of_float,
      4.01);
  add("axis_defect, of turned boxes", turned, kernel::axis_defect,
      Rational(tetratree::most_skewed) + 2 * Rational(of_float) * once_in_float, of_float, 2.67);
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
