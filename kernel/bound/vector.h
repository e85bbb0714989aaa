#ifndef TETRACONE_KERNEL_BOUND_VECTOR_H
#define TETRACONE_KERNEL_BOUND_VECTOR_H

#include "tetracone/kernel/number/floating_point.h"

#include <array>
#include <cmath>
#include <cstddef>

/// Points, directions and axes in rounded double. Eigen is not used for these. Each of its expressions is a type that
/// every unit instantiates, which took a third of the time to compile our headers.
namespace tetracone::kernel {

/// Three coordinates; 0 unless given.
struct Vector {
  std::array<double, 3> at{};

  constexpr Vector() = default;
  constexpr Vector(double x, double y, double z) : at{x, y, z} {}

  /// Returns the vector of three equal numbers.
  static constexpr Vector all(double x) { return {x, x, x}; }

  /// Returns the unit vector of axis i.
  static constexpr Vector unit(int i) { return {double(i == 0), double(i == 1), double(i == 2)}; }

  constexpr double operator[](std::size_t i) const { return at[i]; }
  constexpr double& operator[](std::size_t i) { return at[i]; }

  constexpr Vector operator-() const { return {-at[0], -at[1], -at[2]}; }
  constexpr Vector& operator+=(const Vector& v) { return *this = {at[0] + v[0], at[1] + v[1], at[2] + v[2]}; }
  constexpr Vector& operator-=(const Vector& v) { return *this = {at[0] - v[0], at[1] - v[1], at[2] - v[2]}; }
  constexpr Vector& operator*=(double s) { return *this = {at[0] * s, at[1] * s, at[2] * s}; }
  constexpr Vector& operator/=(double s) { return *this = {at[0] / s, at[1] / s, at[2] / s}; }
  friend constexpr Vector operator+(Vector a, const Vector& b) { return a += b; }
  friend constexpr Vector operator-(Vector a, const Vector& b) { return a -= b; }
  friend constexpr Vector operator*(Vector v, double s) { return v *= s; }
  friend constexpr Vector operator*(double s, Vector v) { return v *= s; }
  friend constexpr Vector operator/(Vector v, double s) { return v /= s; }
  friend constexpr bool operator==(const Vector&, const Vector&) = default;

  constexpr double dot(const Vector& v) const { return at[0] * v[0] + at[1] * v[1] + at[2] * v[2]; }
  constexpr Vector cross(const Vector& v) const
  {
    return {at[1] * v[2] - at[2] * v[1], at[2] * v[0] - at[0] * v[2], at[0] * v[1] - at[1] * v[0]};
  }

  constexpr double sum() const { return at[0] + at[1] + at[2]; }
  constexpr double squared_norm() const { return dot(*this); }
  double norm() const { return std::sqrt(squared_norm()); }
  double norm_1() const { return absolute().sum(); }
  double norm_infinity() const { return maximum(std::abs(at[0]), std::abs(at[1]), std::abs(at[2])); }

  /// Returns the vector scaled to length 1, or the vector itself where its square underflows to 0. Requires that the
  /// square does not overflow.
  Vector normalized() const
  {
    const double square = squared_norm();
    return square > 0 ? *this / std::sqrt(square) : *this;
  }

  /// Returns the vector with each coordinate rounded to the nearest float.
  constexpr Vector in_float() const { return {to_float(at[0]), to_float(at[1]), to_float(at[2])}; }

  Vector absolute() const { return {std::abs(at[0]), std::abs(at[1]), std::abs(at[2])}; }
};

/// Return, coordinate by coordinate, the smaller and the larger number. Where either is NaN, a's is returned.
constexpr Vector smaller(const Vector& a, const Vector& b)
{
  return {b[0] < a[0] ? b[0] : a[0], b[1] < a[1] ? b[1] : a[1], b[2] < a[2] ? b[2] : a[2]};
}
constexpr Vector larger(const Vector& a, const Vector& b)
{
  return {a[0] < b[0] ? b[0] : a[0], a[1] < b[1] ? b[1] : a[1], a[2] < b[2] ? b[2] : a[2]};
}

/// Three rows and columns; 0 unless given.
struct Matrix {
  std::array<Vector, 3> columns{};

  static constexpr Matrix identity() { return {{Vector::unit(0), Vector::unit(1), Vector::unit(2)}}; }

  constexpr const Vector& col(std::size_t j) const { return columns[j]; }
  constexpr Vector& col(std::size_t j) { return columns[j]; }
  constexpr double operator()(std::size_t i, std::size_t j) const { return columns[j][i]; }
  constexpr double& operator()(std::size_t i, std::size_t j) { return columns[j][i]; }

  constexpr Matrix transpose() const
  {
    const auto& [x, y, z] = columns;
    return {{Vector(x[0], y[0], z[0]), Vector(x[1], y[1], z[1]), Vector(x[2], y[2], z[2])}};
  }
  constexpr Matrix in_float() const { return {{columns[0].in_float(), columns[1].in_float(), columns[2].in_float()}}; }
  constexpr double trace() const { return columns[0][0] + columns[1][1] + columns[2][2]; }

  constexpr Vector operator*(const Vector& v) const
  {
    return columns[0] * v[0] + columns[1] * v[1] + columns[2] * v[2];
  }
  constexpr Matrix operator*(const Matrix& m) const
  {
    return {{*this * m.columns[0], *this * m.columns[1], *this * m.columns[2]}};
  }
  friend constexpr Matrix operator*(double s, const Matrix& m)
  {
    return {{s * m.columns[0], s * m.columns[1], s * m.columns[2]}};
  }
  friend constexpr Matrix operator-(const Matrix& a, const Matrix& b)
  {
    return {{a.columns[0] - b.columns[0], a.columns[1] - b.columns[1], a.columns[2] - b.columns[2]}};
  }
  friend constexpr bool operator==(const Matrix&, const Matrix&) = default;

  /// Returns the largest magnitude of an entry of A^T A - I; NaN where an entry is NaN.
  double orthonormal_defect() const
  {
    const Matrix defect = transpose() * *this - identity();
    return maximum(defect.col(0).norm_infinity(), defect.col(1).norm_infinity(), defect.col(2).norm_infinity());
  }
};

}  // namespace tetracone::kernel

#endif
