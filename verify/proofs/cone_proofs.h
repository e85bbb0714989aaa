#ifndef TETRACONE_VERIFY_PROOFS_CONE_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_CONE_PROOFS_H

#include "tetracone/kernel/bound/cone_cells.h"
#include "tetracone/kernel/bound/cone_probe.h"
#include "tetracone/kernel/bound/cone_slab.h"
#include "tetracone/tetratree/fast/bvh8_elements.h"
#include "verify/proofs/proof.h"
#include "verify/proofs/rounded_error.h"

/// The constants by which the point locator's cells, slabs and probes discard: kernel/bound/cone_cells.h, cone_slab.h
/// and cone_probe.h.
namespace tetracone::verify::proofs {

namespace detail {

/// Returns the error of a determinant of sheared coordinates of at most B, relative to B + E. It is an upper bound over
/// all B of at most 2.
inline Rational turn_over_slack()
{
  using Probe = kernel::Cone_probe;
  using Float = Rounded_error<float>;
  const Rational E(Probe::sheared_error);
  Rational worst = 0;
  // All B from `low` to `high`, down to B far below E.
  for (Rational high = 2, low; high > 0; high = low) {
    low = high > E / 64 ? Rational(high * 15 / 16) : Rational(0);
    const Float x(high, E);
    worst = std::max(worst, Rational(Probe::turn(x, x, x, x).error / (low + E)));
  }
  return worst;
}

/// Returns D's error for determinants of at most L with error t, and heights of at most Z with error H.
inline Rational error_of_sum_above(const Rational& L, const Rational& t, const Rational& Z, const Rational& H)
{
  using Float = Rounded_error<float, Rounds::by_share>;
  const Float e(L, t), z(Z, H);
  return kernel::Cone_probe::sum_above(e, z, e, z, e, z).error;
}

/// Returns the error of the slope of a plane at a corner of a wide cell. It is computed as in Cone_cells, for a normal
/// with components of at most 8.
inline Rational error_of_slope()
{
  using Cells = kernel::Cone_cells;
  // Steps of the lattice are 1 / n of a direction's. Here n is 1, since errors are relative to the rounded numbers.
  using Double = Rounded_error<double, Rounds::by_share>;
  const Double normal(Rational(8), Rational(kernel::Local_facet::normal_error)), place(Rational(1), Rational(0)),
      step = over_at_least_1(normal - normal);
  const Double middle = Cells::slope_at(normal, step, place, step, place), spread = Cells::half_spread(step, step);
  return (middle + spread).error;
}

}  // namespace detail

/// Returns their proofs, in exact rationals.
inline Proved_bounds cone_proofs()
{
  using Cells = kernel::Cone_cells;
  using Facet = kernel::Local_facet;
  using Probe = kernel::Cone_probe;
  using Slab = kernel::Cone_slab;
  using Count = Rounding_count;
  using Double = Rounded_error<double>;
  using Float = Rounded_error<float>;
  const Rational off(kernel::local_error), more = 1 + Rational(0x1p-40);  // of second order
  const Rational roundoff_of_float(kernel::unit_roundoff<float>);
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, const char* file, double in_code, const Rational& proved,
                       double loosest) {
    bounds.push_back({name, std::string("kernel/bound/") + file, Rational(in_code), proved, 1, loosest, "rationals"});
  };

  // Local coordinates are differences of halves, over half a unit, a power of two: at most 1 for a model, and at most 4
  // for a point. Halves lose their underflow, relative to a unit of at least 2^-1000.
  const Rational of_halves = 2 * Rational(0x1p-1074) / Rational(0x1p-1000);
  bounds.push_back({"Bvh8_elements::local_error", "tetratree/fast/bvh8_elements.h",
                    Rational(tetratree::Bvh8_elements::local_error), 2 * Double::rounding_of(Rational(0.5)) + of_halves,
                    1, 4.01, "rationals"});
  add("local_error", "cone_cells.h", kernel::local_error, 2 * Double::rounding_of(Rational(2)) + of_halves, 2.01);

  // A model's coordinates, and the plane of a triangle.
  const Double of_model(Rational(1), off);
  const std::array<Double, 3> corner = {of_model, of_model, of_model};
  const auto normal = kernel::normal_of(std::array{corner, corner, corner});
  add("Local_facet::normal_error", "cone_cells.h", Facet::normal_error, normal[0].error, 1.61);
  const Double facet_normal(normal[0].most, Rational(Facet::normal_error));
  add("Local_facet::offset_error", "cone_cells.h", Facet::offset_error,
      kernel::dot(std::array{facet_normal, facet_normal, facet_normal}, corner).error, 2);

  // Lattice coordinates are n x / r of a point of norm r >= `core`. Here x has an error, r has three of it, and a
  // quotient and a product are rounded. The third coordinate is n less the other two. No coordinate is above n.
  const Rational n(Cells::most), core(Cells::core);
  const auto on_lattice = [&](const Rational& of_coordinate, const Rational& least_norm) {
    const Count of_coordinates = Cells::on_lattice(Count(), Count(), Count() + Count() + Count());
    const Rational rounded = 1 / of_coordinates.least(Rational(kernel::unit_roundoff<double>)) - 1;
    return Rational(n * 4 * of_coordinate / (least_norm - 3 * of_coordinate) + n * rounded);
  };
  add("Cone_cells::wide_margin", "cone_cells.h", Cells::wide_margin, 2 * on_lattice(off, core), 258);

  // The distance of a cut from the edge is the rounding of its coordinates. Its distance from the clip's border comes
  // from the errors of the function's values at both ends, and from the rounding of the parameter. The values are at
  // most 1 + 3 / 2^9. Five cuts follow one another.
  const Double exact(Rational(1), Rational(0));
  const Rational of_cut = Cells::on_edge(exact, exact, exact).error,
                 of_value = 2 * 4 * Double::rounding_of(Rational(2)) + 2 * Double::rounding_of(Rational(2)),
                 clipped = off + 5 * (of_cut + of_value);
  const Rational of_clipped = on_lattice(clipped, core / 4);
  add("Cone_cells::lattice_margin", "cone_cells.h", Cells::lattice_margin,
      Rational(Cells::wide_margin) + 2 * of_clipped, 3.12);
  add("Cone_cells::widening", "cone_cells.h", Cells::widening, Rational(Cells::wide_margin) + 2 * of_clipped, 1.56);
  // Norms of a model's points are at most 3 where they count.
  add("Cone_cells::near_side", "cone_cells.h", Cells::near_side, 3 * Rational(Cells::widening) * more + n * off, 1.34);
  // The norm of a clipped corner, and of a point, three coordinates each; and a float of at most 4.
  add("Cone_cells::norm_margin", "cone_cells.h", Cells::norm_margin,
      Float::rounding_of(Rational(4)) + 3 * clipped + 3 * off + 4 * Double::rounding_of(Rational(4)), 4.01);

  // The norm r = D / g of a plane in a direction is at most 4 where it counts: r' - r = (D' - D - r (g' - g)) / g'.
  const Rational offset_error(Facet::offset_error);
  const auto error_of_norm = [&](const Rational& largest, const Rational& of_slope, double least_slope) {
    return Rational((offset_error + largest * of_slope) / Rational(least_slope) * more +
                    2 * Double::rounding_of(largest));
  };
  add("Cone_cells::plane_margin", "cone_cells.h", Cells::plane_margin,
      error_of_norm(4, detail::error_of_slope(), Cells::least_slope), 1.44);

  // A height of a slab is a norm times the ascent of a corner, both of directions of norm 1. The corner's wide cell
  // reaches 4 of the lattice's margins beyond the octant. Where a height is at most `highest`, so is the norm times the
  // ascent.
  const Rational in_wide_cell = 1 + 4 * Rational(Cells::lattice_margin);
  const Double direction(in_wide_cell, Rational(0));
  const Rational of_slope =
      kernel::dot(std::array{facet_normal, facet_normal, facet_normal}, std::array{direction, direction, direction})
          .error;
  const Rational of_height = error_of_norm(Slab::highest, of_slope, Slab::least_slope) * in_wide_cell;
  // The normal has |n_k| <= 1 up to its rounding: n / w over |x|_1 <= 4, and d / w, |d| <= 4, are floats. Points and
  // corners have errors, and sums of at most 8 are rounded in double.
  const Rational of_floats = (4 + Rational(Slab::highest)) * roundoff_of_float * more,
                 of_doubles = 2 * 3 * off + 16 * Double::rounding_of(Rational(16));
  add("Cone_slab::margin", "cone_slab.h", Slab::margin, of_height + of_floats + of_doubles, 2.37);

  // A shear is a quotient of coordinates with error `local_error`, over one of at least a third of `core`. It is
  // rounded in double and then in float. It and a corner's coordinates are at most 1.
  const Rational of_quotient = 2 * off / (core / 3 - off) + Double::rounding_of(Rational(1));
  const Float shear = Float::rounded(Rational(1), of_quotient), coordinate = Float::rounded(Rational(1), off),
              sheared = Probe::sheared(coordinate, coordinate, shear);
  add("Cone_probe::sheared_error", "cone_probe.h", Probe::sheared_error, sheared.error, 1.32);

  // The slacks' own rounding, as sums of positive numbers.
  const Rational u(kernel::unit_roundoff<float>);
  const Count count;
  const Rational of_slack = 1 / Probe::turn_slack(count).least(u),
                 of_plane_slack = 1 / Probe::plane_slack(count, count, count).least(u);
  add("Cone_probe::turn_bound, over sheared_error", "cone_probe.h", Probe::turn_bound / Probe::sheared_error,
      detail::turn_over_slack() * of_slack / Rational(Probe::sheared_error), 1.4);

  // Heights above a point of coordinates of at most 4.
  const Float height = Float::rounded(Rational(4), off), above = coordinate - height;
  add("Cone_probe::height_error", "cone_probe.h", Probe::height_error, above.error, 1.24);

  // D's error is linear in L and t, and in Z for each of them. So a bound for Z = 0 and for the largest Z holds for
  // all. One part is the rounding, which L Z bounds; the other comes from t or L, with H. Underflow is small against
  // the least t.
  const Rational H(Probe::height_error), Z = above.most,
                                         least_t = Rational(Probe::turn_bound) * Rational(Probe::sheared_error),
                                         rounded = detail::error_of_sum_above(1, 0, 1, 0) * of_plane_slack;
  Rational factor = 0;
  for (const Rational& z : {Rational(0), Z}) {
    const Rational by_t = detail::error_of_sum_above(0, 1, z, H) / (z + H), by_L = 3 * H * more / H;
    factor = std::max({factor, by_t, by_L});
  }
  factor += detail::error_of_sum_above(0, 0, 0, 0) / (least_t * H);
  add("Cone_probe::plane_factor", "cone_probe.h", Probe::plane_factor, factor * of_plane_slack, 1.34);
  add("Cone_probe::height_rounding", "cone_probe.h", Probe::height_rounding, rounded / Rational(Probe::plane_factor),
      2.01);
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
