#ifndef TETRACONE_TETRATREE_FAST_SEPARATING_DIRECTION_H
#define TETRACONE_TETRATREE_FAST_SEPARATING_DIRECTION_H

#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/short_vectors.h"
#include "tetracone/tetratree/fast/support_table.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace tetracone::tetratree {

using kernel::Pose;

/// The search for a plane between two bodies. It generalises JS08 Theorem 2 from the direction of one reference
/// tetrahedron to any direction, at constant time per direction. A direction m separates when B lies beyond A along it:
/// min m . b > max m . a, by the support tables.
///
/// The first direction leads from A's origin to B's. A direction that fails is mirrored in the plane across the
/// difference of the support points. Chung and Wang do so in "Quick collision detection of polytopes in virtual
/// environments", 1996. Points of the tables replace vertices. The search ends where bodies overlap far along the
/// direction.
class Separating_direction {
 public:
  Separating_direction(const Bvh8& a, const Bvh8& b)
      : Separating_direction(a, b, kernel::maximum(a.scale().unit, b.scale().unit))
  {}

  /// True when the placed bodies are found apart, in at most `steps` > 0 directions. With `last_one_first`, the
  /// direction that separated the bodies of the last call is tried before these. Requires that both trees have a root.
  bool operator()(const Pose& pose_a, const Pose& pose_b, int steps, bool last_one_first)
  {
    const Placed placed(a_, b_, pose_a, pose_b, slack_);
    const Floats m = last_one_first && were_apart_ ? last_ : placed.apart;
    const Attempt first = attempt(placed, m);
    if (!first.separates()) return search(Placed(placed), Attempt(first), m, steps, last_one_first);
    last_ = m;
    last_gap_ = {first.gap, first.slack};
    return were_apart_ = true;
  }

  /// True when the moving bodies are found apart in all of the span, by one fixed plane. The last direction found is
  /// tried first, then at most `steps` > 0 others. A direction that separates at each coefficient separates at all
  /// times (see `kernel::Motion_span`). It gives no gap.
  bool operator()(const kernel::Motion_span& span, int steps)
  {
    last_gap_ = {};
    if (were_apart_ && !failing(span, last_)) return true;
    Floats m = Placed(span.at_middle(), span.error()).apart;
    for (; steps > 0; --steps) {
      const std::optional<Failure> failure = failing(span, m);
      were_apart_ = !failure;
      if (were_apart_) last_ = m;
      if (!failure || !failure->tried.is_defined || is_hopeless(failure->placed, failure->tried, m)) return were_apart_;
      m = mirrored(m, failure->tried, failure->placed);
    }
    return false;
  }

  /// Lower bound of the distance of the bodies of the last call, along the direction found; 0 if none was. It is (gap -
  /// slack) / |m|_2, times the larger unit.
  double gap() const
  {
    if (!were_apart_) return 0;
    double square = 0;
    for (int k = 0; k < 3; ++k) square += double(last_[k]) * double(last_[k]);
    const double apart = double(last_gap_[0]) - double(last_gap_[1]);
    const double gap = apart / std::sqrt(square) * larger_unit_ * (1 - 0x1p-40);
    return gap > 0 && gap <= std::numeric_limits<double>::max() ? gap : 0;
  }

  /// Returns the tried direction, from A to B, along which bodies overlap least. Requires a search that found no plane.
  std::array<double, 3> least_overlapping() const
  {
    return {least_overlapping_[0], least_overlapping_[1], least_overlapping_[2]};
  }
  /// True when the overlap along it is small. Has the same requirement.
  bool was_near() const { return was_near_; }

  std::size_t bytes() const { return a_.table.bytes() + b_.table.bytes(); }

  /// Upper bound of the numbers of roundings, each of u of float or of double. They are 4 of directions turned back, 5
  /// of the rounded D (see `Placed`), and 5 of the terms of D in double. Proved in verify/proofs/separation_proofs.h.
  static constexpr double rounding = 6;

  // The expressions, lane by lane, for the proofs.
  template <class Lanes>
  [[gnu::always_inline]] static Lanes turned_back_by(const Lanes& m0, const Lanes& m1, const Lanes& m2,
                                                     const Lanes& row0, const Lanes& row1, const Lanes& row2)
  {
    return m0 * row0 + m1 * row1 + m2 * row2;
  }
  template <class Lanes>
  [[gnu::always_inline]] static Lanes difference_in_parts(const Lanes& b_first, const Lanes& a_first,
                                                          const Lanes& b_last, const Lanes& a_last)
  {
    return (b_first - a_first) + (b_last - a_last);
  }
  template <class Lanes>
  [[gnu::always_inline]] static Lanes lanes_of_gap(const Lanes& m, const Lanes& apart, const Lanes& reach)
  {
    return m * apart - reach;
  }

 private:
  using Floats = kernel::Four_floats;
  using Doubles = kernel::Two_doubles;
  static constexpr float u = kernel::unit_roundoff<float>;

  /// The search ends where the origins are apart by at most this fraction of the reach. Four more steps would have
  /// found a plane in 39 more of 5,600 poses of contour trajectories, and in 73 of 5,600 of circular ones.
  static constexpr float hopeless = 0.85f;

  /// Bodies are near one another where they overlap by less than this fraction of the reach: tables are too wide by
  /// about as much.
  static constexpr float most_overlap_of_near = 0.05f;

  struct Body {
    /// `sign` is the sign of its rows.
    Body(const Bvh8& t, double larger_unit, int sign) : table(t)
    {
      const kernel::Local_scale& units = t.scale();
      const double per_unit = 1 / larger_unit;
      const float unit = float(sign * units.unit * per_unit);
      for (int i = 0; i < 2; ++i) origin[i] = Doubles{units.origin[2 * i], i == 0 ? units.origin[1] : 1} * per_unit;
      scale = Floats{unit, unit, unit, float(sign * per_unit)};
    }
    Doubles origin[2];  // (o, 1)
    Floats scale;       // factor of a pose's rows
    Support_table table;
  };

  Separating_direction(const Bvh8& a, const Bvh8& b, double larger_unit)
      : a_(a, larger_unit, 1), b_(b, larger_unit, -1), larger_unit_(larger_unit)
  {
    double farthest = 0;  // from the model's origin, in local units
    bool is_in_range = true;
    for (const Bvh8* tree : {&a, &b}) {
      const kernel::Local_scale& units = tree->scale();
      for (int i = 0; i < 3; ++i) farthest = kernel::maximum(farthest, std::abs(units.origin[i]) / units.unit);
      is_in_range = is_in_range && units.unit >= 0x1p-60 && units.unit <= 0x1p60;
    }
    if (!is_in_range) return;
    const float of_rows = float(rounding * (u + kernel::unit_roundoff<double> * farthest)),
                of_translation = float(rounding * kernel::unit_roundoff<double>);
    slack_ = Floats{of_rows, of_rows, of_rows, of_translation};
  }

  /// Both poses, in the larger unit of both bodies.
  struct Placed {
    Floats row_a[3], row_b[3];  // unit M, and the translation in lane 3; B's are negated
    Floats apart;               // D, from A's placed origin to B's
    float slack;                // of distances and directions turned back, times |m|_1

    Placed(const Body& a, const Body& b, const Pose& pose_a, const Pose& pose_b, Floats slack_of_rows)
    {
      Doubles part[3];  // D in two parts
      for (int i = 0; i < 3; ++i) {
        const double *from_a = pose_a.entries().data() + 4 * i, *from_b = pose_b.entries().data() + 4 * i;
        const Doubles a_first = kernel::two_from(from_a), a_last = kernel::two_from(from_a + 2);
        const Doubles b_first = kernel::two_from(from_b), b_last = kernel::two_from(from_b + 2);
        part[i] = difference_in_parts(b_first * b.origin[0], a_first * a.origin[0], b_last * b.origin[1],
                                      a_last * a.origin[1]);
        row_a[i] = kernel::rounded(a_first, a_last) * a.scale;
        row_b[i] = kernel::rounded(b_first, b_last) * b.scale;
      }
      const Doubles first =
          __builtin_shufflevector(part[0], part[1], 0, 2) + __builtin_shufflevector(part[0], part[1], 1, 3);
      const Doubles last = part[2] + __builtin_shufflevector(part[2], part[2], 1, 0);
      apart = kernel::first_three(kernel::rounded(first, last));
      const auto both = [this](int i) { return kernel::magnitudes(row_a[i]) + kernel::magnitudes(row_b[i]); };
      slack = kernel::sum_of_lanes((both(0) + (both(1) + both(2))) * slack_of_rows +
                                   kernel::magnitudes(apart) * (float(rounding) * u))[0];
    }

    /// Takes local points as a span of time places them. `error` is as in `kernel::Motion_span`; it far exceeds the
    /// loss by underflow of a rounded number.
    Placed(const kernel::Motion_span::Maps& maps, double error)
    {
      float sum = 0;
      for (int i = 0; i < 3; ++i) {
        const auto &a = maps.row[0][i], &b = maps.row[1][i];
        row_a[i] = Floats{float(a[0]), float(a[1]), float(a[2]), 0};
        row_b[i] = Floats{-float(b[0]), -float(b[1]), -float(b[2]), 0};
        apart[i] = float(maps.offset[i]);
        sum +=
            kernel::sum_of_lanes(kernel::magnitudes(row_a[i]) + kernel::magnitudes(row_b[i]))[0] + std::abs(apart[i]);
      }
      apart[3] = 0;
      slack = float(rounding) * u * sum + float(2 * error);
    }
  };

  /// The result of trying a direction.
  struct Attempt {
    bool is_defined = false;
    Support_table::Place at_a, at_b;
    Floats reach;  // the sum of its lanes
    float gap = 0, slack = 0;

    bool separates() const { return is_defined && gap > slack; }
  };

  /// Tries the direction m, which leads from A to B. An unknown reach is infinite or undefined, and separates nothing.
  ///
  /// The slack beside the tables' has these terms, each times |m|_1. A direction turned back is a sum of three products
  /// of rounded entries. Its error is 4 roundings of the rows, and one of a fraction's entry. The distance is such a
  /// sum of the rounded D: its error is 5 roundings of it. The error of D itself is 5 roundings in double of its terms,
  /// which are translations and at most `farthest` times the rows.
  [[gnu::always_inline]] Attempt attempt(const Placed& placed, Floats m) const
  {
    Attempt tried;
    const auto turned_back = [&](const Floats* row) {
      return kernel::first_three(turned_back_by(kernel::repeated<0>(m), kernel::repeated<1>(m), kernel::repeated<2>(m),
                                                row[0], row[1], row[2]));
    };
    const auto norm = [](Floats v) { return kernel::sum_of_lanes(kernel::magnitudes(v)); };
    const Floats along_a = turned_back(placed.row_a), along_b = turned_back(placed.row_b), norm_a = norm(along_a),
                 norm_b = norm(along_b);
    const float norm_m = norm(m)[0];
    // No product may overflow, and underflow must be far below the slack. An undefined value ends here, too.
    if (!(placed.slack < 1e8f && norm_m < 1e14f && norm_a[0] > 1e-15f && norm_b[0] > 1e-15f)) return tried;
    tried.is_defined = true;
    tried.at_a = Support_table::place(along_a, norm_a);
    tried.at_b = Support_table::place(along_b, norm_b);
    tried.reach = a_.table.reach(tried.at_a) + b_.table.reach(tried.at_b);
    tried.gap = kernel::sum_of_lanes(lanes_of_gap(m, placed.apart, tried.reach))[0];
    tried.slack = Support_table::slack * (norm_a[0] + norm_b[0]) + norm_m * placed.slack;
    return tried;
  }

  /// Continues after a first attempt that did not separate. It is a function of its own, so that the first attempt,
  /// which decides most queries, stays in registers.
  [[gnu::noinline]] bool search(const Placed& placed, Attempt tried, Floats m, int steps, bool last_one_first)
  {
    float least_overlap = std::numeric_limits<float>::infinity();
    const auto separates = [&] {
      tried = with_known_reach(placed, m, tried);
      const float overlap = -tried.gap / kernel::sum_of_lanes(tried.reach)[0];
      if (tried.is_defined && overlap < least_overlap) {
        least_overlap = overlap;
        least_overlapping_ = m;
      }
      return tried.separates();
    };
    if (last_one_first && were_apart_ && !separates()) {
      m = placed.apart;
      tried = attempt(placed, m);
    }
    were_apart_ = separates();
    while (!were_apart_ && --steps > 0 && tried.is_defined && !is_hopeless(placed, tried, m)) {
      m = mirrored(m, tried, placed);
      tried = attempt(placed, m);
      were_apart_ = separates();
    }
    last_ = m;
    last_gap_ = {tried.gap, tried.slack};
    was_near_ = least_overlap < most_overlap_of_near;
    return were_apart_;
  }

  /// True when bodies that a direction does not separate overlap far along it.
  static bool is_hopeless(const Placed& placed, const Attempt& tried, Floats m)
  {
    return !(kernel::sum_of_lanes(m * placed.apart)[0] > hopeless * kernel::sum_of_lanes(tried.reach)[0]);
  }

  /// A position of moving bodies at which a direction does not separate them.
  struct Failure {
    Placed placed;
    Attempt tried;
  };

  /// Returns the first of a span's coefficients at which the direction does not separate, if there is one.
  std::optional<Failure> failing(const kernel::Motion_span& span, Floats m)
  {
    for (std::size_t i = 0; i < span.size(); ++i) {
      const Placed placed(span.coefficient(i), span.error());
      const Attempt tried = with_known_reach(placed, m, attempt(placed, m));
      if (!tried.separates()) return Failure{placed, tried};
    }
    return std::nullopt;
  }

  /// Returns the attempt, made again if a reach was unknown.
  Attempt with_known_reach(const Placed& placed, Floats m, Attempt tried)
  {
    if (!tried.is_defined || (a_.table.knows(tried.at_a) && b_.table.knows(tried.at_b))) return tried;
    a_.table.find(tried.at_a);
    b_.table.find(tried.at_b);
    return attempt(placed, m);
  }

  /// Returns the next direction (Chung and Wang). It is m mirrored at the plane across w, which leads from A's farthest
  /// point along m to B's farthest point against it.
  Floats mirrored(Floats m, const Attempt& tried, const Placed& placed) const
  {
    const Floats p = a_.table.point(tried.at_a), q = b_.table.point(tried.at_b);
    Floats terms[3];  // in the lanes of part i: A's point minus B's, each relative to its own origin
    for (int i = 0; i < 3; ++i) terms[i] = placed.row_a[i] * p + placed.row_b[i] * q;
    // Sums the lanes of x and y at once: neighbours first, then both pairs.
    const Floats even = __builtin_shufflevector(terms[0], terms[1], 0, 4, 2, 6),
                 odd = __builtin_shufflevector(terms[0], terms[1], 1, 5, 3, 7), pairs = even + odd;
    const Floats xy = pairs + __builtin_shufflevector(pairs, pairs, 2, 3, 0, 1);
    const Floats xyz = kernel::first_three(__builtin_shufflevector(xy, kernel::sum_of_lanes(terms[2]), 0, 1, 4, 4));
    const Floats w = placed.apart - xyz;
    return m - 2 * kernel::sum_of_lanes(m * w) / kernel::sum_of_lanes(w * w) * w;
  }

  Body a_, b_;
  Floats slack_ = Floats{} + std::numeric_limits<float>::quiet_NaN();  // of the rows, if units are in range
  Floats last_{};                                                      // the last direction tried
  bool were_apart_ = false;                                            // whether it separated
  Floats least_overlapping_{};
  bool was_near_ = false;
  std::array<float, 2> last_gap_{};  // along it, and its slack
  double larger_unit_;
};

}  // namespace tetracone::tetratree

#endif
