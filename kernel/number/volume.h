#ifndef TETRACONE_KERNEL_NUMBER_VOLUME_H
#define TETRACONE_KERNEL_NUMBER_VOLUME_H

#include "tetracone/kernel/number/number.h"

#include <CGAL/Mpzf.h>
#include <CGAL/determinant.h>

#include <gmp.h>

namespace tetracone::kernel {

/// Returns the number as a rational.
inline Rational rational(const CGAL::Mpzf& number)
{
  mpq_t rational;
  mpq_init(rational);
  number.export_to_mpq_t(rational);
  const Rational result(rational);
  mpq_clear(rational);
  return result;
}

/// Six times a signed volume, summed exactly.
class Volume_sum {
 public:
  /// Adds det[a-o, b-o, c-o].
  void add(const Vertex& o, const Vertex& a, const Vertex& b, const Vertex& c)
  {
    using Number = CGAL::Mpzf;
    const auto d = [&o](const Vertex& v, int k) -> Number { return Number(v[k]) - Number(o[k]); };
    sum_ = sum_ +
           CGAL::determinant<Number>(d(a, 0), d(a, 1), d(a, 2), d(b, 0), d(b, 1), d(b, 2), d(c, 0), d(c, 1), d(c, 2));
  }

  Rational value() const { return rational(sum_); }

 private:
  CGAL::Mpzf sum_ = 0;
};

}  // namespace tetracone::kernel

#endif
