#ifndef TETRACONE_KERNEL_MOTION_BODY_MOTION_H
#define TETRACONE_KERNEL_MOTION_BODY_MOTION_H

#include "tetracone/kernel/motion/integer_form.h"
#include "tetracone/kernel/motion/motion_exact.h"
#include "tetracone/kernel/motion/odd_double.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/vertex.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace tetracone::kernel {

/// A rigid pose, exactly: x -> q x q* / |q|^2 + t, with a quaternion (w, x, y, z) of any length above 0.
struct Rigid_pose {
  std::array<Rational, 4> quaternion = {1, 0, 0, 0};
  std::array<Rational, 3> translation = {0, 0, 0};
};

/// The motion of a body over t in [0, 1]: x -> (M(t) x + v(t)) / w(t), exactly.
class Body_motion {
 public:
  /// Entry k of the row-major 3x4 matrix (M, v), and w. They are forms with integer coefficients, each with its own
  /// degree. w has no root in [0, 1].
  struct Forms {
    std::array<Integer_form, 12> entry;
    Integer_form weight;
  };

  /// Returns the motion with M(t) = (1-t) M0 + t M1, and the translation likewise: every point moves on a line at
  /// constant speed. Between the ends M(t) may be singular; its image is taken as it is.
  static Body_motion linear(const Pose& from, const Pose& to)
  {
    Body_motion motion;
    motion.ends_ = {from, to};
    return motion;
  }

  /// Returns the motion with q(t) = (1-t) q0 + t q1, not normalised, and the translation likewise: a rotation at every
  /// t. Returns nothing where q(t) = 0 for some t in [0, 1].
  static std::optional<Body_motion> rigid(const Rigid_pose& from, const Rigid_pose& to)
  {
    Integer of_turn = 1, of_shift = 1;
    for (int k = 0; k < 4; ++k) of_turn = lcm(of_turn, lcm(from.quaternion[k].get_den(), to.quaternion[k].get_den()));
    for (int k = 0; k < 3; ++k)
      of_shift = lcm(of_shift, lcm(from.translation[k].get_den(), to.translation[k].get_den()));

    std::array<Integer, 4> q0, q1;
    Integer along = 0;
    for (int k = 0; k < 4; ++k) {
      q0[k] = whole(from.quaternion[k], of_turn);
      q1[k] = whole(to.quaternion[k], of_turn);
      along += q0[k] * q1[k];
    }
    bool turns = false, shifts = false;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) turns = turns || q0[i] * q1[j] != q0[j] * q1[i];
    if (!turns && sgn(along) <= 0) return std::nullopt;

    // A constant rotation is written by its first quaternion alone, and a constant translation by its first one.
    std::array<Integer_form, 4> q;
    for (int k = 0; k < 4; ++k) q[k] = turns ? Integer_form(std::array{q0[k], q1[k]}) : Integer_form(std::array{q0[k]});
    for (int k = 0; k < 3; ++k) shifts = shifts || from.translation[k] != to.translation[k];

    Forms forms;
    const Integer_form ww = q[0] * q[0], xx = q[1] * q[1], yy = q[2] * q[2], zz = q[3] * q[3];
    const auto twice = [&](int i, int j) { return q[i] * q[j] * Integer(2); };
    const Integer_form xy = twice(1, 2), xz = twice(1, 3), yz = twice(2, 3), wx = twice(0, 1), wy = twice(0, 2),
                       wz = twice(0, 3), norm = ww + xx + yy + zz;
    forms.entry = {ww + xx - yy - zz, xy - wz, xz + wy, {},      xy + wz,           ww - xx + yy - zz,
                   yz - wx,           {},      xz - wy, yz + wx, ww - xx - yy + zz, {}};
    forms.weight = norm * of_shift;
    for (int k = 0; k < 12; ++k)
      if (k % 4 != 3) forms.entry[k] *= of_shift;
    for (int k = 0; k < 3; ++k) {
      Integer_form shift;
      shift.push_back(whole(from.translation[k], of_shift));
      if (shifts) shift.push_back(whole(to.translation[k], of_shift));
      forms.entry[4 * k + 3] = norm * shift;
    }
    Body_motion motion;
    motion.rigid_ = std::move(forms);
    motion.rigid_ends_ = {from, to};
    return motion;
  }

  /// Returns the body's pose at a time in [0, 1], exactly. Requires det M(t) != 0 if it is used as a pose.
  Pose at(const Rational& time) const
  {
    if (ends_ && (sgn(time) == 0 || time == 1)) return (*ends_)[std::size_t(sgn(time))];
    const Forms f = forms();
    const auto value = [&](const Integer_form& form) {
      Integer scale;
      mpz_pow_ui(scale.get_mpz_t(), time.get_den_mpz_t(), form.size() - 1);
      Rational quotient(form.at(time.get_den() - time.get_num(), time.get_num()), scale);
      quotient.canonicalize();
      return quotient;
    };
    const Rational divisor = value(f.weight);
    std::array<Rational, 12> entries;
    for (int k = 0; k < 12; ++k) entries[k] = value(f.entry[k]) / divisor;
    return Pose(entries);
  }

  /// Returns the forms. Where the motion is linear, each call makes them anew.
  Forms forms() const { return rigid_ ? *rigid_ : forms_between(*ends_); }

  /// Returns the poses at both ends of a linear motion; nothing for a rigid one.
  const std::optional<std::array<Pose, 2>>& ends() const { return ends_; }

  /// Returns the poses at both ends of a rigid motion. Requires `is_rigid()`.
  const std::array<Rigid_pose, 2>& rigid_ends() const { return rigid_ends_; }

  /// True when M(t) / w(t) is a rotation all the time.
  bool is_rigid() const { return rigid_.has_value(); }

 private:
  Body_motion() = default;

  static Forms forms_between(const std::array<Pose, 2>& ends)
  {
    const auto& [from, to] = ends;
    Integer common = 1;
    for (int k = 0; k < 12; ++k) common = lcm(common, lcm(from.exact(k).get_den(), to.exact(k).get_den()));
    Forms forms;
    for (int k = 0; k < 12; ++k)
      forms.entry[k] = Integer_form(std::array{whole(from.exact(k), common), whole(to.exact(k), common)});
    forms.weight = Integer_form(std::array{common});
    return forms;
  }

  static Integer whole(const Rational& x, const Integer& common)
  {
    return Integer(x.get_num() * (common / x.get_den()));
  }

  std::optional<std::array<Pose, 2>> ends_;  // of a linear motion; else `rigid_`
  std::optional<Forms> rigid_;
  std::array<Rigid_pose, 2> rigid_ends_;
};

/// Two moving bodies in common coordinates. Points are forms of one degree over one divisor, the product of both
/// weights.
///
/// For two rigid motions the degree is at most 5. The volume of four points, of degree 15, has the square of the
/// divisor as a factor, for this reason. In the frame of one body, a plane of it stands still, and the other body's
/// points are of degree 5 over the divisor. For two edges the volume is d . R m' + m . R d' + (d, v, R d'), with
/// directions d and moments m in either body's own frame. It is of degree 5 over the divisor too.
class Pair_motion {
 public:
  Pair_motion(const Body_motion& a, const Body_motion& b)
  {
    const Body_motion::Forms of_a = a.forms(), of_b = b.forms();
    divisor_ = of_a.weight * of_b.weight;
    for (int k = 0; k < 12; ++k) {
      entry_[0][k] = of_a.entry[k] * of_b.weight;
      entry_[1][k] = of_b.entry[k] * of_a.weight;
    }
    size_ = divisor_.size();
    for (const auto& entries : entry_)
      for (const Integer_form& entry : entries) size_ = maximum(size_, entry.size());
    for (auto& entries : entry_)
      for (Integer_form& entry : entries) entry = entry.raised_to(size_);
    divisor_ = divisor_.raised_to(size_);
    if (a.is_rigid() && b.is_rigid()) square_ = (divisor_ * divisor_).primitive();
  }

  /// Returns the number of coefficients of each form.
  std::size_t size() const { return size_; }

  /// Returns the motion from `from`/2^k to `to`/2^k alone, over times from 0 to 1. Requires 0 <= from < to <= 2^k.
  Pair_motion between(const Integer& from, const Integer& to, unsigned k) const
  {
    Pair_motion part = *this;
    for (auto& entries : part.entry_)
      for (Integer_form& entry : entries) entry = entry.between(from, to, k);
    part.divisor_ = divisor_.between(from, to, k);
    if (square_.size() > 0) part.square_ = square_.between(from, to, k).primitive();
    return part;
  }

  /// Returns entry k of the row-major 3x4 matrix that places body 0 or 1, times the divisor.
  const Integer_form& entry(int body, int k) const { return entry_[body][k]; }
  /// Returns the divisor of all entries, the product of both weights.
  const Integer_form& divisor() const { return divisor_; }

  /// Returns the square of the divisor, without common factors of its coefficients. It is a factor of the volume of
  /// four points (see `Exact_motion`). Empty unless both motions are rigid.
  const Integer_form& square() const { return square_; }

  /// Returns the least of `least` and the exponents of the coordinates. A coordinate has the exponent e if it is an odd
  /// multiple of 2^e.
  static int exponent_of(const Vertex& v, int least = 0)
  {
    for (const double x : v) least = minimum(least, Odd_double(x).exponent);
    return least;
  }

  /// Returns a point of a body, times the divisor and 2^-least. Requires least <= exponent_of(v).
  Form_vector image(int body, const Vertex& v, int least) const
  {
    const std::array<Integer, 4> by = {Odd_double(v[0]).over(least), Odd_double(v[1]).over(least),
                                       Odd_double(v[2]).over(least), Odd_double(1).over(least)};
    Form_vector image;
    for (int i = 0; i < 3; ++i) {
      image[i].clear(size_);
      for (int j = 0; j < 4; ++j) image[i].add_product(entry_[body][4 * i + j], by[j]);
    }
    return image;
  }

 private:
  std::size_t size_ = 0;
  std::array<std::array<Integer_form, 12>, 2> entry_;
  Integer_form divisor_, square_;
};

}  // namespace tetracone::kernel

#endif
