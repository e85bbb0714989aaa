#ifndef TETRACONE_KERNEL_CONTACT_RATIONAL_MAP_H
#define TETRACONE_KERNEL_CONTACT_RATIONAL_MAP_H

#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/number/vertex.h"

#include <array>
#include <cstddef>

namespace tetracone::kernel {

/// A pose in rationals, and its inverse.
class Rational_map {
 public:
  /// Requires det M != 0.
  explicit Rational_map(const Pose& pose = Pose()) : m_(rows_of(pose))
  {
    const auto row = [this](int i) { return Rational_point{m_[4 * i], m_[4 * i + 1], m_[4 * i + 2]}; };
    determinant_ = dot(row(0), cross(row(1), row(2)));
    for (int i = 0; i < 3; ++i) {
      const Rational_point column = cross(row((i + 1) % 3), row((i + 2) % 3));
      for (int k = 0; k < 3; ++k) inverse_[k][i] = column[k] / determinant_;
    }
  }

  /// Returns det M.
  const Rational& determinant() const { return determinant_; }
  /// Returns column k of M, the image of an axis as a direction. Column 3 is t.
  Rational_point column(int k) const { return {m_[k], m_[4 + k], m_[8 + k]}; }

  /// Returns the image of a vertex.
  Rational_point operator()(const Vertex& v) const { return image(v, m_); }

  /// Returns M x + s t: s times the image of x / s.
  Rational_point operator()(const Rational_point& x, const Rational& s) const
  {
    Rational_point image;
    for (int k = 0; k < 3; ++k)
      image[k] = m_[4 * k] * x[0] + m_[4 * k + 1] * x[1] + m_[4 * k + 2] * x[2] + m_[4 * k + 3] * s;
    return image;
  }

  /// Returns row i of the inverse of M.
  const Rational_point& inverse_row(std::size_t i) const { return inverse_[i]; }

  /// Returns the point that is mapped to x.
  Rational_point inverse(const Rational_point& x) const
  {
    const Rational_point from_t = difference(x, column(3));
    return {dot(inverse_[0], from_t), dot(inverse_[1], from_t), dot(inverse_[2], from_t)};
  }

 private:
  std::array<Rational, 12> m_;
  std::array<Rational_point, 3> inverse_;  // rows
  Rational determinant_;
};

}  // namespace tetracone::kernel

#endif
