#ifndef TETRACONE_VERIFY_PROOFS_AXIS_NUMBER_H
#define TETRACONE_VERIFY_PROOFS_AXIS_NUMBER_H

#include <cassert>
#include <vector>

namespace tetracone::verify::proofs {

/// Replaces a vector in the SIMD comparison of boxes: a number or, for a maximum, all numbers that it may be. With
/// `fused`, a product and a sum are rounded once, as processors with FMA do; else twice.
template <class Number, bool fused>
class Axis_number {
 public:
  Axis_number() = default;
  Axis_number(const Number& number) : any_({number}) {}

  /// Returns the number. Requires that this is no maximum of several.
  const Number& one() const
  {
    assert(any_.size() == 1);
    return any_[0];
  }
  /// Returns all numbers that it may be.
  const std::vector<Number>& any() const { return any_; }

  friend Axis_number Add(const Axis_number& a, const Axis_number& b) { return a.one() + b.one(); }
  friend Axis_number Sub(const Axis_number& a, const Axis_number& b) { return a.one() - b.one(); }
  friend Axis_number Mul(const Axis_number& a, const Axis_number& b) { return a.one() * b.one(); }
  friend Axis_number Abs(const Axis_number& a) { return abs(a.one()); }
  friend Axis_number Neg(const Axis_number& a) { return -a.one(); }
  friend Axis_number MulAdd(const Axis_number& a, const Axis_number& b, const Axis_number& c)
  {
    if constexpr (fused) return fused_sum(a.one(), b.one(), c.one(), '+');
    return a.one() * b.one() + c.one();
  }
  friend Axis_number NegMulAdd(const Axis_number& a, const Axis_number& b, const Axis_number& c)
  {
    if constexpr (fused) return fused_sum(a.one(), b.one(), c.one(), '-');
    return c.one() - a.one() * b.one();
  }
  friend Axis_number Max(const Axis_number& a, const Axis_number& b) { return joined(a, b); }

  // A comparison returns its first operands, which the comparison of boxes holds against the slack.
  friend Axis_number Gt(const Axis_number& a, const Axis_number&) { return a; }
  friend Axis_number Or(const Axis_number& a, const Axis_number& b) { return joined(a, b); }
  friend Axis_number Not(const Axis_number& a) { return a; }

 private:
  static Axis_number joined(const Axis_number& a, const Axis_number& b)
  {
    Axis_number both = a;
    both.any_.insert(both.any_.end(), b.any_.begin(), b.any_.end());
    return both;
  }
  std::vector<Number> any_;
};

}  // namespace tetracone::verify::proofs

#endif
