#ifndef TETRACONE_KERNEL_MOTION_MOTION_FORMS_H
#define TETRACONE_KERNEL_MOTION_MOTION_FORMS_H

#include <array>
#include <cstddef>

/// The polynomials in time whose signs tell whether two moving primitives meet, over any number type.
///
/// A polynomial of degree n is a form in s = 1-t and t. Its coefficient k belongs to s^(n-k) t^k. So the first
/// coefficient is its value at t = 0, and the last its value at t = 1. Let a, b, c be the differences from the first of
/// the four points to the others. Three cross products make up all forms: n1 = a x b, n2 = b x c, n3 = c x a. Their
/// components are the orientations of the points projected along an axis. n1 + n2 + n3 gives the orientations of the
/// last three points. n1 . c is the volume, which is zero where the four points are coplanar.
namespace tetracone::kernel {

template <class Number>
using Linear_form = std::array<Number, 2>;
template <class Number>
using Quadratic_form = std::array<Number, 3>;
template <class Number>
using Cubic_form = std::array<Number, 4>;

/// A moving vector: its three coordinates.
template <class Number>
using Linear_vector = std::array<Linear_form<Number>, 3>;

/// Returns the component along an axis of a x b, from the two other coordinates i and j: a_i b_j - a_j b_i.
template <class Number>
Quadratic_form<Number> cross_form(const Linear_form<Number>& ai, const Linear_form<Number>& aj,
                                  const Linear_form<Number>& bi, const Linear_form<Number>& bj)
{
  const auto part = [&](std::size_t p, std::size_t q) { return Number(ai[p] * bj[q] - aj[p] * bi[q]); };
  return {part(0, 0), Number(part(0, 1) + part(1, 0)), part(1, 1)};
}

/// Returns the component along `axis` of a x b.
template <class Number>
Quadratic_form<Number> cross_form(const Linear_vector<Number>& a, const Linear_vector<Number>& b, std::size_t axis)
{
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  return cross_form(a[i], a[j], b[i], b[j]);
}

/// Returns n . c.
template <class Number>
Cubic_form<Number> dot_form(const std::array<Quadratic_form<Number>, 3>& n, const Linear_vector<Number>& c)
{
  const auto dot = [&](std::size_t p, std::size_t q) {
    return Number(n[0][p] * c[0][q] + n[1][p] * c[1][q] + n[2][p] * c[2][q]);
  };
  return {dot(0, 0), Number(dot(0, 1) + dot(1, 0)), Number(dot(1, 1) + dot(2, 0)), dot(2, 1)};
}

}  // namespace tetracone::kernel

#endif
