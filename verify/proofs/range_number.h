#ifndef TETRACONE_VERIFY_PROOFS_RANGE_NUMBER_H
#define TETRACONE_VERIFY_PROOFS_RANGE_NUMBER_H

#include "tetracone/kernel/number/number.h"

#include <algorithm>
#include <vector>

namespace tetracone::verify::proofs {

using kernel::Rational;

/// An upper bound of a product's underflow: half the least number for each rounded product in it.
struct Double_range {
  static Rational lost_by_product() { return Rational(0x1p-1074) / 2; }
};
struct Float_range {
  static Rational lost_by_product() { return Rational(0x1p-149) / 2; }
};
/// Products of two doubles (kernel/number/double_double.h) lose at most the remainder of the high parts' product, and
/// both mixed ones.
struct Double_double_range {
  static Rational lost_by_product() { return 3 * Double_range::lost_by_product(); }
};

/// Upper bounds of a number's magnitude and of its error by underflow, in exact rationals. Sums lose nothing to gradual
/// underflow. An expression run with these tells whether it overflows within a gate, and whether `underflow_slack`
/// covers its underflow.
template <class Range>
class Range_number {
 public:
  explicit Range_number(double most, const Rational& lost = 0) : most_(abs(Rational(most))), lost_(lost) {}

  friend Range_number operator+(const Range_number& a, const Range_number& b)
  {
    return made(Rational(a.most_ + b.most_), Rational(a.lost_ + b.lost_));
  }
  friend Range_number operator-(const Range_number& a, const Range_number& b) { return a + b; }
  friend Range_number operator-(const Range_number& a) { return a; }
  friend Range_number operator*(const Range_number& a, const Range_number& b)
  {
    return made(Rational(a.most_ * b.most_),
                Rational(a.lost_ * b.most_ + b.lost_ * a.most_ + a.lost_ * b.lost_ + Range::lost_by_product()));
  }
  friend Range_number abs(const Range_number& a) { return a; }
  /// The nearest double of a fraction, whose error below 2^-1022 is that of a product there.
  friend Range_number entry(const Range_number& a) { return {a.most_, Rational(a.lost_ + Range::lost_by_product())}; }

  const Rational& lost() const { return lost_; }

  /// The largest of all numbers that this thread has made since it was set to 0.
  static Rational& largest()
  {
    static thread_local Rational of_all = 0;
    return of_all;
  }

 private:
  Range_number(Rational most, Rational lost) : most_(std::move(most)), lost_(std::move(lost)) {}

  /// Returns a result whose magnitude allows for its rounding, of at most 2^-20.
  static Range_number made(const Rational& most, const Rational& lost)
  {
    const Rational rounded = most * (1 + Rational(0x1p-20));
    largest() = std::max(largest(), rounded);
    return {rounded, lost};
  }

  Rational most_, lost_;
};

/// Upper bounds of the magnitudes of an expression's results, those in between included, and of its underflow.
struct Range_found {
  Rational largest, lost;
};
/// Returns these bounds for inputs of at most these magnitudes.
template <class Range, class Expression>
Range_found range_of(const Expression& expression, const std::vector<double>& magnitudes)
{
  std::vector<Range_number<Range>> in;
  for (const double magnitude : magnitudes) in.emplace_back(magnitude);
  Range_number<Range>::largest() = 0;
  const Rational lost = expression(in).lost();
  return {Range_number<Range>::largest(), lost};
}

}  // namespace tetracone::verify::proofs

#endif
