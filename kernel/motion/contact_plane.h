#ifndef TETRACONE_KERNEL_MOTION_CONTACT_PLANE_H
#define TETRACONE_KERNEL_MOTION_CONTACT_PLANE_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/motion/integer_form.h"
#include "tetracone/kernel/motion/motion_exact.h"
#include "tetracone/kernel/motion/motion_span.h"
#include "tetracone/kernel/motion/moving_pair.h"
#include "tetracone/kernel/motion/odd_double.h"
#include "tetracone/kernel/motion/times_before.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"

#include <array>
#include <climits>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tetracone::kernel {

/// A plane that moves with two features, and separates the points on its two sides until they meet.
///
/// For a vertex and a triangle it contains the triangle. For two edges it contains A's edge and is parallel to B's. Its
/// height over a point x is the volume n . (x - o) of `Exact_motion`, a form in time and affine in x. Two hulls share
/// no point while their heights differ in sign. All vertices of one have heights of one sign then, and no vertex of the
/// other has a height of that sign.
class Contact_plane {
 public:
  /// `body` is the body of the vertex, for kind vertex_face. `corner` has the points of `Moving_pair`, in their bodies'
  /// coordinates. `motion` is over `times`.
  Contact_plane(const Pair_motion& motion, Times_before& times, Moving_kind kind, int body,
                const std::array<Vertex, 4>& corner)
      : times_(&times), low_(kind == Moving_kind::vertex_face ? 1 - body : 0)
  {
    const bool is_face = kind == Moving_kind::vertex_face;
    const std::array<int, 4> of = is_face ? std::array{body, low_, low_, low_} : std::array{0, 0, 1, 1};
    int least = 0;
    for (const Vertex& v : corner) least = Pair_motion::exponent_of(v, least);
    const auto image = [&](std::size_t k) { return motion.image(of[k], corner[k], least); };
    const auto side = [](Form_vector from, const Form_vector& to) {
      for (std::size_t i = 0; i < 3; ++i) from[i] = to[i] - from[i];
      return from;
    };
    const Form_vector o = image(is_face ? 1 : 0), along = side(o, image(is_face ? 2 : 1)),
                      across = is_face ? side(o, image(3)) : side(image(2), image(3));
    Form_vector normal;
    for (std::size_t axis = 0; axis < 3; ++axis) normal[axis] = cross_form(along, across, axis);
    const Integer one = Odd_double(1).over(least);
    for (int b = 0; b < 2; ++b)
      for (int j = 0; j < 4; ++j) {
        Integer_form& sum = height_[b][j];
        for (int i = 0; i < 3; ++i) {
          Integer_form entry = motion.entry(b, 4 * i + j) * one;
          if (j == 3) entry -= o[i];
          const Integer_form product = normal[i] * entry;
          sum = i == 0 ? product : sum + product;
        }
        if (motion.square().size() > 0) sum = quotient(sum, motion.square());
        if (j < 3) is_level_[b][j] = sum.is_zero();
      }
    sense_ = times.sign(height_over(1 - low_, corner[is_face ? 0 : 2]));
  }

  /// True when the plane separates the two features themselves until they meet. Otherwise it answers nothing.
  bool is_defined() const { return sense_ != CGAL::ZERO; }

  /// Prepares `holds` for boxes in the bodies' local units.
  void use_units(const std::array<Motion_units, 2>& units)
  {
    for (int b = 0; b < 2; ++b) {
      const int least = Pair_motion::exponent_of(units[b].origin);
      const Integer_form at_origin = sum_at(b, units[b].origin, least);
      const long unit = std::ilogb(units[b].unit) - long(least);
      long largest = LONG_MIN;
      const auto exponent = [](const Integer& x) { return long(mpz_sizeinbase(x.get_mpz_t(), 2)); };
      for (std::size_t i = 0; i < at_origin.size(); ++i) {
        if (sgn(at_origin[i]) != 0) largest = maximum(largest, exponent(at_origin[i]));
        for (int j = 0; j < 3; ++j)
          if (sgn(height_[b][j][i]) != 0) largest = maximum(largest, exponent(height_[b][j][i]) + unit);
      }
      const auto rounded = [&](const Integer& x, long shift) {
        long own;
        const double digits = mpz_get_d_2exp(&own, x.get_mpz_t());
        const long place = own + shift - largest;
        return digits == 0 || place < -1000 ? 0.0 : std::ldexp(digits, int(place));
      };
      coefficient_[b].clear();
      for (std::size_t i = 0; i < at_origin.size(); ++i) {
        Coefficient c;
        double terms = 0;
        for (int j = 0; j < 3; ++j) {
          c.slope[j] = rounded(height_[b][j][i], unit);
          terms += most_in_box * std::abs(c.slope[j]);
        }
        c.at_origin = rounded(at_origin[i], 0);
        c.error = few_roundings * (terms + std::abs(c.at_origin)) + underflow_slack;
        coefficient_[b].push_back(c);
      }
    }
  }

  /// True when all of a box of a body, in local units, is on the body's side until the features meet. It is decided in
  /// double, by bounds of each coefficient. Never true of a box that touches the plane. Requires `use_units`.
  bool holds(int body, const Moving_box& box) const
  {
    const bool is_positive = (body == low_) != (sense_ == CGAL::POSITIVE);
    for (const Coefficient& c : coefficient_[body]) {
      const auto [least, most] = range_of_box(c.slope, box.centre, box.half_edge);
      if (!(is_positive ? c.at_origin + least > c.error : c.at_origin + most < -c.error)) return false;
    }
    return true;
  }

  /// True when a vertex of a body is on the body's side until the features meet, exactly. For the body whose side is
  /// closed (`low_`) it may also be on the plane, all the time or at the start. False also where this is not known.
  bool holds(int body, const Vertex& v)
  {
    Told& last = last_[body];
    if (!last.is_known || !is_as_high(body, v, last.vertex)) {
      const Integer_form& height = height_over(body, v);
      const bool holds = body != low_ ? times_->sign(height) == sense_
                                      : height.is_zero() || times_->sign_after_start(height) == -sense_;
      last = {v, true, holds};
    }
    return last.holds;
  }

  /// True when `holds` is known to be true without integers: it held the last vertex, which has equal heights.
  bool is_held_as_last(int body, const Vertex& v) const
  {
    return last_[body].is_known && last_[body].holds && is_as_high(body, v, last_[body].vertex);
  }

 private:
  /// Upper bound of the sum of the magnitudes of a local point's coordinates along an axis, also for a box's centre and
  /// half-edges.
  static constexpr double most_in_box = 8;

  /// A coefficient of the height, over a power of two: slope . l + at_origin at a local point l. Each number is
  /// truncated. The roundings of local points, of products and of sums are below 500 u of the terms: see
  /// `Motion_span::find_error`.
  struct Coefficient {
    Vertex slope;
    double at_origin, error;
  };

  /// A vertex, and the answer for it.
  struct Told {
    Vertex vertex;
    bool is_known = false, holds = false;
  };

  /// True when two vertices have equal heights all the time, since they differ at most in coordinates that no height
  /// depends on. An example are vertices of a face that is perpendicular to an axis of its body.
  bool is_as_high(int body, const Vertex& v, const Vertex& w) const
  {
    bool same = true;
    for (int j = 0; j < 3; ++j) same = same && (is_level_[body][j] || v[j] == w[j]);
    return same;
  }

  /// Returns the height over a point times 2^-least, by the form of the plane. Requires least <= exponent_of(v).
  const Integer_form& sum_at(int body, const Vertex& v, int least)
  {
    sum_.clear(height_[body][3].size());
    for (int j = 0; j < 4; ++j) {
      const Odd_double x(j < 3 ? v[j] : 1);
      if (x.odd == 0 || (j < 3 && is_level_[body][j])) continue;
      factor_ = static_cast<long>(x.odd);
      factor_ <<= static_cast<unsigned>(x.exponent - least);
      sum_.add_product(height_[body][j], factor_);
    }
    return sum_;
  }
  const Integer_form& height_over(int body, const Vertex& v) { return sum_at(body, v, Pair_motion::exponent_of(v)); }

  Times_before* times_;
  int low_;                                            // the body whose vertices may be on the plane
  CGAL::Sign sense_ = CGAL::ZERO;                      // the sign of the other body's heights
  std::array<std::array<Integer_form, 4>, 2> height_;  // of either body: x, y, z and 1
  std::array<std::array<bool, 3>, 2> is_level_;        // where height_ is zero
  std::array<Told, 2> last_;
  std::array<std::vector<Coefficient>, 2> coefficient_;
  Integer_form sum_;  // kept, as `factor_`, for its memory
  Integer factor_;
};

}  // namespace tetracone::kernel

#endif
