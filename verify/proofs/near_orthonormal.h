#ifndef TETRACONE_VERIFY_PROOFS_NEAR_ORTHONORMAL_H
#define TETRACONE_VERIFY_PROOFS_NEAR_ORTHONORMAL_H

#include "tetracone/kernel/number/number.h"

namespace tetracone::verify::proofs {

using kernel::Rational;

/// Upper bounds of the square roots of 2 and 3.
inline Rational root_2() { return Rational(14142136, 10000000); }
inline Rational root_3() { return Rational(17320509, 10000000); }

/// Returns an upper bound of the distance of the cross product of two axes from the third, or from its opposite.
/// Requires that scalar products of axes differ from those of an orthonormal triple by at most d < 2^-10.
///
/// With E = A^T A - I, |E_ij| <= d and so ||E|| <= 3 d: a_l x a_m = det A A^-T e_i = det A A (I + E)^-1 e_i. There |A|
/// <= 1 + 1.5 d and |(I + E)^-1 e_i - e_i| <= sqrt(3) d / (1 - 3 d). Likewise det^2 = det(I + E) is between 1 - 3 d -
/// 27 d^2 and (1 + d)^3, so that |det| differs from 1 by at most 1.5 d + 20 d^2.
inline Rational cross_defect(const Rational& d)
{
  const Rational determinant = Rational(3, 2) * d + 20 * d * d;
  return (1 + Rational(3, 2) * d) * ((1 + determinant) * root_3() * d / (1 - 3 * d) + determinant);
}

}  // namespace tetracone::verify::proofs

#endif
