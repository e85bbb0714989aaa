#ifndef TETRACONE_KERNEL_NUMBER_PRODUCTS_H
#define TETRACONE_KERNEL_NUMBER_PRODUCTS_H

#include <array>
#include <cmath>

/// The expressions of three coordinates that stages, bounds and proofs use alike. The number type is any: doubles,
/// floats, double-double, and the numbers of verify/proofs/, which record the computation. An error bound holds for the
/// order of operations that is written here.
namespace tetracone::kernel {

template <class Number>
std::array<Number, 3> difference(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class Number>
Number dot(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
std::array<Number, 3> cross(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Returns det[b, c, d].
template <class Number>
Number determinant(const std::array<Number, 3>& b, const std::array<Number, 3>& c, const std::array<Number, 3>& d)
{
  return dot(cross(b, c), d);
}

/// Returns the permanent: the terms of det[b, c, d], all taken positive.
template <class Number>
Number permanent(const std::array<Number, 3>& b, const std::array<Number, 3>& c, const std::array<Number, 3>& d)
{
  using std::abs;
  const auto factor = [&](int i, int j) { return abs(b[i] * c[j]) + abs(b[j] * c[i]); };
  return factor(1, 2) * abs(d[0]) + factor(2, 0) * abs(d[1]) + factor(0, 1) * abs(d[2]);
}

/// Returns a component of b x c, from the two other coordinates of each.
template <class Number>
Number cross_component(const Number& bi, const Number& bj, const Number& ci, const Number& cj)
{
  return bi * cj - bj * ci;
}

/// Returns the terms of a placed coordinate, from three entries of a row and the translation.
template <class Number>
std::array<Number, 4> placed_terms(const Number& m0, const Number& m1, const Number& m2, const Number& t,
                                   const std::array<Number, 3>& p)
{
  return {m0 * p[0], m1 * p[1], m2 * p[2], t};
}

/// Return the sum of terms, from the left, and the sum of their magnitudes.
template <class Number>
Number sum(const std::array<Number, 4>& terms)
{
  return ((terms[0] + terms[1]) + terms[2]) + terms[3];
}
template <class Number>
Number sum_of_magnitudes(const std::array<Number, 4>& terms)
{
  using std::abs;
  return ((abs(terms[0]) + abs(terms[1])) + abs(terms[2])) + abs(terms[3]);
}

}  // namespace tetracone::kernel

#endif
