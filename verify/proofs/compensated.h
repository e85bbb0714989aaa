#ifndef TETRACONE_VERIFY_PROOFS_COMPENSATED_H
#define TETRACONE_VERIFY_PROOFS_COMPENSATED_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"

namespace tetracone::verify::proofs {

using kernel::Rational;

/// Upper bound of the coefficient of one input in a number of a compensated sum, in exact rationals. The remainders of
/// sums and products are exact. So the compensated sum differs from the exact one only by the rounding errors in adding
/// remainders, which `lost` counts.
class Remainder_share {
 public:
  explicit Remainder_share(double most = 0) : most_(most) {}

  struct Split;
  friend Split two_sum(const Remainder_share& a, const Remainder_share& b);
  friend Split two_product(const Remainder_share& a, const Remainder_share& b);
  friend Remainder_share operator+(const Remainder_share& a, const Remainder_share& b)
  {
    const Rational sum = a.most_ + b.most_;
    if (b.is_remainder_) lost() += u() * sum;
    return Remainder_share(Rational(sum * (1 + u())), b.is_remainder_);
  }
  friend Remainder_share operator-(const Remainder_share& a) { return a; }
  friend Remainder_share abs(const Remainder_share& a) { return Remainder_share(a.most_, false); }

  /// Upper bound of the rounding errors in adding remainders, by this thread since it was set to 0.
  static Rational& lost()
  {
    static thread_local Rational all = 0;
    return all;
  }

 private:
  Remainder_share(const Rational& most, bool is_remainder) : most_(most), is_remainder_(is_remainder) {}

  static Rational u() { return Rational(kernel::unit_roundoff<double>); }
  static Split split(const Rational& exact);

  Rational most_;
  bool is_remainder_ = false;
};

struct Remainder_share::Split {
  Remainder_share result, remainder;
};

inline Remainder_share::Split Remainder_share::split(const Rational& exact)
{
  return {Remainder_share(Rational(exact * (1 + u())), false), Remainder_share(Rational(exact * u()), true)};
}
inline Remainder_share::Split two_sum(const Remainder_share& a, const Remainder_share& b)
{
  return Remainder_share::split(Rational(a.most_ + b.most_));
}
inline Remainder_share::Split two_product(const Remainder_share& a, const Remainder_share& b)
{
  return Remainder_share::split(Rational(a.most_ * b.most_));
}

}  // namespace tetracone::verify::proofs

#endif
