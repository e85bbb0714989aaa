#ifndef TETRACONE_KERNEL_NUMBER_PRODUCTS_H
#define TETRACONE_KERNEL_NUMBER_PRODUCTS_H

#include <array>
#include <cmath>
#include <cstddef>

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
std::array<Number, 3> sum(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

template <class Number>
std::array<Number, 3> scaled(const std::array<Number, 3>& a, const Number& by)
{
  return {a[0] * by, a[1] * by, a[2] * by};
}

template <class Number>
std::array<Number, 3> negated(const std::array<Number, 3>& a)
{
  return {-a[0], -a[1], -a[2]};
}

template <class Number>
bool is_zero(const std::array<Number, 3>& a)
{
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

/// Returns the axis of the coordinate of largest magnitude, the first of equals.
template <class Number>
int largest_axis(const std::array<Number, 3>& a)
{
  using std::abs;
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (abs(a[k]) > abs(a[axis])) axis = k;
  return axis;
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

/// Returns the normal (b - a) x (c - a) of a triangle a b c. Its length is twice the area.
template <class Number>
std::array<Number, 3> normal_of(const std::array<std::array<Number, 3>, 3>& triangle)
{
  return cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
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

/// Returns the image of a point under an affine map, a row-major 3x4 matrix. It is computed in the numbers of the map.
template <class Number, class Coordinate>
std::array<Number, 3> image(const std::array<Coordinate, 3>& point, const std::array<Number, 12>& m)
{
  const std::array<Number, 3> p = {Number(point[0]), Number(point[1]), Number(point[2])};
  const auto row = [&](std::size_t i) { return Number(m[i] * p[0] + m[i + 1] * p[1] + m[i + 2] * p[2] + m[i + 3]); };
  return {row(0), row(4), row(8)};
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
