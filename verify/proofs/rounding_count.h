#ifndef TETRACONE_VERIFY_PROOFS_ROUNDING_COUNT_H
#define TETRACONE_VERIFY_PROOFS_ROUNDING_COUNT_H

#include "verify/proofs/proved_bound.h"

#include <algorithm>
#include <cassert>

namespace tetracone::verify::proofs {

/// A computed number that is not negative, made by sums, products and quotients of such numbers. It is at least (1 -
/// u)^n times the exact one, where n is the number of roundings on the longest path to it. Without quotients by rounded
/// numbers it is also at most (1 + u)^n times the exact one. An expression run with these gives the rounding error of a
/// bound's own computation.
class Rounding_count {
 public:
  explicit Rounding_count(double = 0) {}

  friend Rounding_count operator+(const Rounding_count& a, const Rounding_count& b)
  {
    return Rounding_count::of(std::max(a.count_, b.count_) + 1);
  }
  friend Rounding_count operator*(const Rounding_count& a, const Rounding_count& b)
  {
    return Rounding_count::of(a.count_ + b.count_ + 1);
  }
  /// Requires exact numbers: the difference of rounded ones has no bound of its relative error.
  friend Rounding_count operator-(const Rounding_count& a, const Rounding_count& b)
  {
    assert(a.count_ == 0 && b.count_ == 0);
    return a + b;
  }
  friend Rounding_count operator+(const Rounding_count& a, float) { return a + Rounding_count(); }
  friend Rounding_count operator+(float, const Rounding_count& b) { return Rounding_count() + b; }
  friend Rounding_count operator*(float, const Rounding_count& b) { return Rounding_count() * b; }
  friend Rounding_count operator/(float, const Rounding_count& b) { return Rounding_count() * b; }
  friend Rounding_count operator/(const Rounding_count& a, const Rounding_count& b) { return a * b; }
  friend Rounding_count entry(const Rounding_count& a) { return Rounding_count::of(a.count_ + 1); }
  friend Rounding_count abs(const Rounding_count& a) { return a; }

  int count() const { return count_; }

  /// Returns (1 - u)^n.
  Rational least(const Rational& u) const { return power(Rational(1 - u), count_); }

 private:
  static Rounding_count of(int count)
  {
    Rounding_count made;
    made.count_ = count;
    return made;
  }
  int count_ = 0;
};

}  // namespace tetracone::verify::proofs

#endif
