#ifndef TETRACONE_VERIFY_PROOFS_REFERENCE_PROOFS_H
#define TETRACONE_VERIFY_PROOFS_REFERENCE_PROOFS_H

#include "tetracone/kernel/bound/obb8_gap.h"
#include "tetracone/kernel/bound/obb8_sweep.h"
#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/bound/relative_motion.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/tetratree/memory/bvh8_front.h"
#include "tetracone/tetratree/memory/front_entries.h"
#include "tetracone/tetratree/query/span_reference.h"
#include "verify/proofs/obb8_proofs.h"
#include "verify/proofs/proof.h"

/// The constants of comparisons of moving bodies with a reference. They serve sweeps of boxes past one another, the
/// reference of a span of time, and the front of a pair of bodies.
namespace tetracone::verify::proofs {

/// Returns their proofs; verify/test/verify/proofs/all_proofs.cpp compares each proved bound with the constant in the
/// code. Throws std::runtime_error when Gappa does not prove one.
inline Proved_bounds reference_proofs()
{
  using detail::Kind;
  using Entries = tetratree::Front_entries;
  using Front = tetratree::Bvh8_front;
  using Reference = tetratree::Span_reference;
  const double unit_of_float = kernel::unit_roundoff<float>;
  const Rational u(kernel::unit_roundoff<double>), of_float(kernel::unit_roundoff<float>), defect(kernel::axis_defect),
      similarity(kernel::Relative_frame::similarity_defect), few = 1 + Rational(0x1p-40);
  Proved_bounds bounds;
  const auto add = [&](const std::string& name, const std::string& file, double in_code, const Rational& proved,
                       double unit, double loosest, const std::string& by = "rationals") {
    bounds.push_back({name, file, Rational(in_code), proved, unit, loosest, by});
  };

  // Let s be the centres' distance along an axis, and g the gap. The reach is s - g, and its two sides are the reach
  // plus and minus s. So an error of s counts at most twice, and one of g once. Both errors are those of a gap,
  // relative to M; `slacks_of_sweep` is in units of `gap_rounding`. The reach and its two sums, of at most 3 M, are
  // rounded once each.
  Rational of_gap = 0;
  for (const Kind kind : {Kind::own, Kind::other, Kind::across})
    for (const Rational& share : detail::shares_of(Edges::carried, kind, defect, defect + 3 * of_float * few))
      of_gap = std::max(of_gap, share);
  const std::string of_sweeps = "kernel/bound/obb8_sweep.h";
  add("slacks_of_sweep", of_sweeps, kernel::slacks_of_sweep,
      (3 * of_gap + 3 * 3 * of_float) * few / Rational(kernel::gap_rounding), 1, 1.42, "gappa");

  // A speed below v = `least_speed` is replaced by v. Two cases occur:
  // - If a side of the reach is more than v, the time is beyond the span.
  // - If it is 0, the gap comes from the loss alone. `radius_rounding` leaves a part of the loss that is more than v.
  // No side is between 0 and v. A loss is at least `least_loss`, and sums of floats of such sizes are 0 or a multiple
  // of the last digit of the smaller. The loss includes the span's error over the scale. The largest of a span's
  // numbers is at least 1/2 before it is divided by a binomial, of at most 20. A scale is at most sqrt(3) over a
  // weight.
  const Rational least_loss = Rational(Reference::errors_along) * Rational(kernel::few_roundings) / (2 * 20) / 2,
                 last_digit = least_loss * of_float * of_float,
                 spare = least_loss * Rational(double(kernel::radius_rounding)) / 2;
  add("least_speed, one over it", of_sweeps, 1 / double(kernel::least_speed), 1 / std::min(last_digit, spare), 1, 207);

  // The square of a length loses what three of its squares do. Each coordinate loses what three products do, which
  // count as often as their length: |x|^2 <= (|y| + l)^2 + m. The root of m is below 2^-74.
  using Float = Range_number<Float_range>;
  const Float none(0);
  const Rational of_square = (none * none + none * none + none * none).lost(), root(0x1p-73),
                 of_coordinates = 2 * (none * none + none * none + none * none).lost();
  add("motion_underflow", "kernel/bound/relative_motion.h", kernel::motion_underflow,
      of_square <= root * root ? Rational(root + of_coordinates) : Rational(1), 1, 8193);

  // A stored gap is rounded; taking it off later rounds a product with steps, a sum and a difference.
  add("Front_entries::shrink, taken from 1", "tetratree/memory/front_entries.h", 1 - double(Entries::shrink),
      1 - power((1 - of_float) / (1 + of_float), 1) * power(1 - of_float, 3), unit_of_float, 3.21);

  // M^T M is s^2 (I + E), |E_ij| <= d, s the length of the first column: |M x| >= s (1 - 3 d)^(1/2) |x|. An image of a
  // coordinate's unit less that of the origin is off by twice the map's error in each coordinate. There are three
  // columns, of three coordinates.
  const std::string of_front = "tetratree/memory/bvh8_front.h";
  const Rational of_error = 3 * 2 * Rational(Front::most_error);
  add("Bvh8_front::stretch_loss", of_front, Front::stretch_loss,
      (Rational(3, 2) * similarity * (1 + 8 * similarity) + of_error) * few, unit_of_float, 5.34);
  // The gap is rounded to float after a product, along an axis whose length has an error of 8 roundings.
  add("Bvh8_front::leaf_gap_rounding", of_front, Front::leaf_gap_rounding, (of_float + 10 * u) * few, unit_of_float,
      16.1);

  // A point of the line between two coefficients has the error of a coefficient: at most twice `Motion_span::error`,
  // times |n|_1. Sums and quotients of coefficients, and their norms, have 12 roundings of three placings. Each placing
  // is below twice the span's terms, and the span's error is `few_roundings` times these terms.
  const std::string of_reference = "tetratree/query/span_reference.h";
  add("Span_reference::errors_along", of_reference, Reference::errors_along,
      2 * root_3() * (1 + 3 * defect) + 12 * 3 * 2 * u / Rational(kernel::few_roundings), 1, 1.16);
  // R^-1 - R^T / s^2 = ((I + E)^-1 - I) R^T / s^2, ||E|| <= 3 d.
  add("Span_reference::direction_error", of_reference, Reference::direction_error,
      3 * similarity / (1 - 3 * similarity) * (1 + 3 * similarity) * few, unit_of_float, 10.7);
  add("Span_reference::most_local", of_reference, Reference::most_local, 2 * root_3() * (1 + 3 * defect), 1, 1.16);
  return bounds;
}

}  // namespace tetracone::verify::proofs

#endif
