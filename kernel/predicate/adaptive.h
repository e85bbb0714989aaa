#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_H

#include "tetracone/kernel/predicate/adaptive_double_double.h"
#include "tetracone/kernel/predicate/adaptive_exact.h"
#include "tetracone/kernel/predicate/adaptive_filter.h"
#include "tetracone/kernel/predicate/adaptive_fixed.h"
#include "tetracone/kernel/predicate/adaptive_grid.h"
#include "tetracone/kernel/predicate/adaptive_points.h"
#include "tetracone/kernel/predicate/adaptive_zero_exits.h"
#include "tetracone/kernel/predicate/stage_counts.h"

#include <CGAL/enum.h>

#include <array>
#include <cstdint>
#include <optional>

namespace tetracone::kernel {

/// The adaptive kernel: exact signs of points under exact motion, at nearly the price of double.
///
/// A sign is decided by the first stage that can:
///   1. filter, in double;
///   2. zero exits;
///   3. grid, in integers of 128 bits;
///   4. fixed, in integers of at most 256 bits;
///   5. double-double;
///   6. exact, in numbers of any size.
/// A sign of a point beyond the magnitude gate, of unknown error, goes from the zero exits straight to the fixed stage.
/// After the zero exits, a volume sign of points under one pose is their vertices' volume sign times sign(det M).
class Adaptive : public Adaptive_filter,
                 public Adaptive_zero_exits,
                 public Adaptive_grid,
                 public Adaptive_double_double,
                 public Adaptive_fixed,
                 public Adaptive_exact {
 public:
  using Stage = Adaptive_stage;

  /// Returns the counts of the calling thread's signs, by the stage that decided: see `Stage_counts`.
  static Stage_counts& decided_by()
  {
    static thread_local Stage_counts counts;
    return counts;
  }
  /// Returns the number of times that the calling thread needed the fixed or the exact stage.
  static std::uint64_t exact_fallbacks()
  {
    const Stage_counts& counts = decided_by();
    return counts[Stage::fixed] + counts[Stage::exact] + counts[Stage::out_of_gate];
  }

  static CGAL::Sign volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    if (const Decision sign = filtered_volume_sign(a, b, c, d)) return counted(Stage::filter, *sign);
    return unfiltered_volume_sign(a, b, c, d);
  }
  static CGAL::Sign normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    if (const Decision sign = filtered_normal_sign(a, b, c, axis)) return counted(Stage::filter, *sign);
    return unfiltered_normal_sign(a, b, c, axis);
  }
  static CGAL::Sign difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    if (const Decision sign = filtered_difference_sign(a, b, axis)) return counted(Stage::filter, *sign);
    return unfiltered_difference_sign(a, b, axis);
  }

  /// Returns the sign of d . (b - a) by the fixed stage, exactly, or undecided. Requires |d[k]| <= `longest_direction`.
  static Decision sign_along(const Point_3& a, const Point_3& b, const std::array<int, 3>& d)
  {
    const Decision sign = fixed_sign_along(a, b, d);
    return sign ? counted(Stage::fixed, *sign) : sign;
  }

  /// Returns `volume_sign` of a, b, c with each of three points, of which the filter leaves two or more undecided. The
  /// fixed stage decides all three at once, and counts them.
  [[gnu::noinline]] static std::array<CGAL::Sign, 3> unfiltered_sides(const Point_3& a, const Point_3& b,
                                                                      const Point_3& c,
                                                                      const std::array<const Point_3*, 3>& d)
  {
    if (const auto signs = fixed_sides(a, b, c, d)) {
      decided_by()[Stage::fixed] += 3;
      return *signs;
    }
    return {unfiltered_volume_sign(a, b, c, *d[0]), unfiltered_volume_sign(a, b, c, *d[1]),
            unfiltered_volume_sign(a, b, c, *d[2])};
  }

  // The signs where the filter is undecided. They are out of line, which keeps the filter's callers small.

  [[gnu::noinline]] static CGAL::Sign unfiltered_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c,
                                                             const Point_3& d)
  {
    const auto zero = [&] { return zero_volume_sign(a, b, c, d); };
    const auto grid = [&] { return int128_volume_sign(a, b, c, d); };
    const auto fixed = [&] { return fixed_volume_sign(a, b, c, d); };
    const auto double_double = [&] { return double_double_volume_sign(a, b, c, d); };
    const auto exact = [&] { return Decision(exact_volume_sign(a, b, c, d)); };
    if (const Decision sign = first_decision(Asked{Stage::zero, zero})) return *sign;
    if (a.pose == b.pose && a.pose == c.pose && a.pose == d.pose && a.pose != nullptr) {
      const CGAL::Sign unplaced =
          volume_sign(unmoved(a.vertex), unmoved(b.vertex), unmoved(c.vertex), unmoved(d.vertex));
      return unplaced * a.pose->determinant_sign();
    }
    return computed_sign(in_gate(a, b, c, d), grid, fixed, double_double, exact);
  }

  [[gnu::noinline]] static CGAL::Sign unfiltered_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c,
                                                             int axis)
  {
    const auto zero = [&] { return zero_normal_sign(a, b, c, axis); };
    const auto grid = [&] { return int128_normal_sign(a, b, c, axis); };
    const auto fixed = [&] { return fixed_normal_sign(a, b, c, axis); };
    const auto double_double = [&] { return double_double_normal_sign(a, b, c, axis); };
    const auto exact = [&] { return Decision(exact_normal_sign(a, b, c, axis)); };
    if (const Decision sign = first_decision(Asked{Stage::zero, zero})) return *sign;
    return computed_sign(in_gate(a, b, c), grid, fixed, double_double, exact);
  }

  [[gnu::noinline]] static CGAL::Sign unfiltered_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    const auto zero = [&] { return identical(a, b) ? Decision(CGAL::ZERO) : std::nullopt; };
    const auto grid = [] { return Decision(); };  // the filter decides the difference of exact images
    const auto fixed = [&] { return fixed_difference_sign(a, b, axis); };
    const auto double_double = [&] { return double_double_difference_sign(a, b, axis); };
    const auto exact = [&] { return Decision(exact_difference_sign(a, b, axis)); };
    if (const Decision sign = first_decision(Asked{Stage::zero, zero})) return *sign;
    return computed_sign(in_gate(a, b), grid, fixed, double_double, exact);
  }

 private:
  /// Returns `sign`, counted for the stage that decided it.
  static CGAL::Sign counted(Stage stage, CGAL::Sign sign)
  {
    ++decided_by()[stage];
    return sign;
  }

  /// A stage, and the function that returns its `Decision`.
  template <class Function>
  struct Asked {
    Stage stage;
    const Function& sign;
  };
  template <class Function>
  Asked(Stage, const Function&) -> Asked<Function>;

  /// Returns the sign by the first stage that decides, which is counted; undecided when none does.
  template <class First, class... Rest>
  [[gnu::always_inline]] static Decision first_decision(const Asked<First>& first, const Rest&... rest)
  {
    if (const Decision sign = first.sign()) return counted(first.stage, *sign);
    if constexpr (sizeof...(rest) > 0) return first_decision(rest...);
    return std::nullopt;
  }

  /// Returns the sign by the stages that compute; beyond the magnitude gate by those that need no bound. `exact` always
  /// decides.
  template <class Grid, class Fixed, class Double_double, class Exact>
  [[gnu::always_inline]] static CGAL::Sign computed_sign(bool in_gate, const Grid& grid, const Fixed& fixed,
                                                         const Double_double& double_double, const Exact& exact)
  {
    if (!in_gate) return *first_decision(Asked{Stage::fixed, fixed}, Asked{Stage::out_of_gate, exact});
    return *first_decision(Asked{Stage::grid, grid}, Asked{Stage::fixed, fixed},
                           Asked{Stage::double_double, double_double}, Asked{Stage::exact, exact});
  }
};

}  // namespace tetracone::kernel

#endif
