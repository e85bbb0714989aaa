#ifndef TETRACONE_KERNEL_MOTION_TIMES_BEFORE_H
#define TETRACONE_KERNEL_MOTION_TIMES_BEFORE_H

#include "tetracone/kernel/motion/integer_form.h"
#include "tetracone/kernel/motion/time_root.h"
#include "tetracone/kernel/number/floating_point.h"

#include <cassert>
#include <optional>
#include <utility>

namespace tetracone::kernel {

/// The times from a dyadic start up to a contact time T, without T, and the signs of forms at all of them.
///
/// Features that land together have forms that vanish at T. Their signs are found here without an algebraic number for
/// each. Forms are given over the times from the start to a dyadic end, which is T or a little later. A form without
/// variations there has one sign (Descartes). Where T is before the end, G is a form whose only root there is T, if one
/// is known. A form divisible by G has one sign before T if the quotient has no variations: then G and the quotient
/// each have one.
class Times_before {
 public:
  /// The times from the start of the cell `from` up to `before`, which must be later. May refine `before`.
  Times_before(const Time_cell& from, Time_root& before)
  {
    const Time_cell cell = before.close_cell();
    k_ = maximum(from.k, cell.k);
    first_ = from.m << (k_ - from.k);
    last_ = (before.is_dyadic() ? cell.m : Integer(cell.m + 1)) << (k_ - cell.k);
    assert(first_ < last_);
    if (before.is_dyadic()) return;
    root_ = over(before.form()).primitive();
    if (root_->variations() != 1) root_.reset();
    const Integer cell_start = cell.m << (k_ - cell.k);
    if (cell_start > first_) {
      s_ = last_ - cell_start;
      t_ = cell_start - first_;
    }
  }

  /// Returns a form or a motion, an `Integer_form` or a `Pair_motion`, over the times from the start to the end as over
  /// 0 to 1.
  template <class Timed>
  Timed over(const Timed& timed) const
  {
    return timed.between(first_, last_, k_);
  }

  /// Returns the sign that a form, given over these times, has at all of them except perhaps the start. Returns zero
  /// where it has none, and where this does not tell.
  CGAL::Sign sign_after_start(const Integer_form& form)
  {
    if (form.variations() == 0) return form.only_sign();
    if (!root_ || !may_have_root(form)) return CGAL::ZERO;
    std::optional<Integer_form> rest = exact_quotient(form, *root_);
    if (!rest) {
      // A common divisor with an odd number of roots has the one root of G, and takes its place.
      Integer_form shared = common_divisor(*root_, form.primitive());
      if (shared.size() < 2 || shared.variations() % 2 == 0) return CGAL::ZERO;
      root_ = std::move(shared);
      rest = exact_quotient(form, *root_);
    }
    if (!rest || rest->variations() != 0) return CGAL::ZERO;
    return static_cast<CGAL::Sign>(rest->only_sign() * root_->only_sign());
  }

  /// Returns the sign that a form has at all of them. Returns zero where it has none, and where this does not tell.
  CGAL::Sign sign(const Integer_form& form) { return sgn(form.at_start()) == 0 ? CGAL::ZERO : sign_after_start(form); }

 private:
  /// False where the form is surely not a product of G and a form without roots up to the end. Such a product changes
  /// its sign in T's cell.
  bool may_have_root(const Integer_form& form) const
  {
    return sgn(t_) == 0 || sgn(form.at(s_, t_)) * sgn(form.at_end()) < 0;
  }

  Integer first_, last_;
  unsigned k_;
  Integer s_, t_;  // T's cell starts at s : t between the start and the end; 0 where it starts no later
  std::optional<Integer_form> root_;  // G; nothing where T is the end, or may not be the only root
};

}  // namespace tetracone::kernel

#endif
