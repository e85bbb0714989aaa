#ifndef TETRACONE_KERNEL_MOTION_FIRST_CONTACT_H
#define TETRACONE_KERNEL_MOTION_FIRST_CONTACT_H

#include "tetracone/kernel/motion/motion_exact.h"
#include "tetracone/kernel/motion/motion_filter.h"
#include "tetracone/kernel/motion/moving_pair.h"
#include "tetracone/kernel/motion/odd_double.h"
#include "tetracone/kernel/motion/time_bounds.h"
#include "tetracone/kernel/motion/time_root.h"
#include "tetracone/kernel/number/floating_point.h"

#include <bit>
#include <cstdint>
#include <optional>

namespace tetracone::kernel {

/// Returns the doubles that enclose a time in [0, 1].
inline Time_bounds bounds_about(const Time_root& time)
{
  // Doubles from 0 up are ordered as their bits.
  const std::int64_t least = std::bit_cast<std::int64_t>(0.0), most = std::bit_cast<std::int64_t>(1.0);
  const auto side = [&](std::int64_t bits) {
    const Odd_double x(std::bit_cast<double>(bits));
    // Doubles up to 1 are odd / 2^k with k >= 0.
    return x.odd == 0 ? time.compare(0, 0)
                      : time.compare(Integer(static_cast<long>(x.odd)), static_cast<unsigned>(-x.exponent));
  };
  // The search starts near the time and takes longer and longer steps, until there is a double on either side.
  const double about = time.about();
  std::int64_t lo = about > 0 && about < 1 ? std::bit_cast<std::int64_t>(about) : about > 0 ? most : least, hi = lo;
  const CGAL::Sign first = side(lo);
  for (std::int64_t step = 1; first != CGAL::ZERO; step *= 4) {
    std::int64_t& end = first == CGAL::POSITIVE ? hi : lo;
    end = first == CGAL::POSITIVE ? minimum(most, end + step) : maximum(least, end - step);
    const CGAL::Sign there = side(end);
    if (there == CGAL::ZERO) lo = hi = end;
    if (there != first) break;
    (first == CGAL::POSITIVE ? lo : hi) = end;
  }
  while (hi - lo > 1) {
    const std::int64_t middle = lo + (hi - lo) / 2;
    const CGAL::Sign after = side(middle);
    if (after == CGAL::ZERO)
      lo = hi = middle;
    else
      (after == CGAL::POSITIVE ? lo : hi) = middle;
  }
  return Time_bounds{std::bit_cast<double>(lo), std::bit_cast<double>(hi)};
}

/// True when the closed primitives share a point at some time in [0, 1]. It is exact: doubles decide where they can,
/// integers elsewhere. Requires finite coordinates, and sound floating point (`require_sound_floating_point`).
inline bool meet_in_motion(const Moving_pair& pair)
{
  const Moving_contact filtered = filtered_contact(pair);
  if (filtered != Moving_contact::uncertain) return filtered == Moving_contact::meet;
  Exact_motion exact(pair);
  const Moving_contact rounded = exact.rounded_contact();
  if (rounded != Moving_contact::uncertain) return rounded == Moving_contact::meet;
  return exact.first_contact().has_value();
}

/// Returns the doubles that enclose the first time at which the closed primitives share a point; nothing where they
/// never do. It is exact. It requires what `meet_in_motion` does.
inline std::optional<Time_bounds> first_contact_time(const Moving_pair& pair)
{
  if (filtered_contact(pair) == Moving_contact::apart) return std::nullopt;
  const std::optional<Time_root> first = Exact_motion(pair).first_contact();
  if (!first) return std::nullopt;
  return bounds_about(*first);
}

}  // namespace tetracone::kernel

#endif
