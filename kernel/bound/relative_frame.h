#ifndef TETRACONE_KERNEL_BOUND_RELATIVE_FRAME_H
#define TETRACONE_KERNEL_BOUND_RELATIVE_FRAME_H

#include "tetracone/kernel/bound/bounds.h"
#include "tetracone/kernel/bound/origin_offset.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/number/products.h"

#include <array>
#include <cmath>
#include <limits>

namespace tetracone::kernel {

/// The map from the local units of one placed body to those of another, in double: p -> linear p + offset. `error` is
/// an upper bound of the error of every coordinate of the image of a point with |p_k| <= 1. It is infinite where no
/// bound is known: for a pose that is nearly flat, and numbers near the ends of the doubles' range.
class Relative_frame {
 public:
  using Row = std::array<double, 3>;

  Relative_frame() = default;

  /// The map from B's local units to A's: (M_a^-1 (M_b (o_b + u_b p) + t_b - t_a) - o_a) / u_a.
  Relative_frame(const Pose& a, const Local_scale& in_a, const Pose& b, const Local_scale& in_b)
      : Relative_frame(a, in_a, b, in_b, Origin_offset(a, in_a, b, in_b))
  {}

  /// The map from B's local units to A's, from their known origin offset D.
  Relative_frame(const Pose& a, const Local_scale& in_a, const Pose& b, const Local_scale& in_b, const Origin_offset& d)
  {
    if (!by_transpose(a, in_a, b, in_b, d)) by_inverse(a, in_a, b, in_b);
  }

  /// Returns an upper bound of the error of a coordinate of an image of a point with |p_k| <= 1; infinite where none is
  /// known.
  double error() const { return error_; }

  /// Returns an upper bound of the error of the image of a point whose coordinates have an error of at most `of_point`.
  /// The exact linear part L is within 2 `error` of this one in a row's sum, so |L (p - q)| <= (norm + 2 error)
  /// of_point. The factor 1.01 covers the second term, for of_point below 2^-10, and the rounding here.
  double error(double of_point) const { return second_order * (error_ + of_point * norm(linear_)); }

  static constexpr double u = unit_roundoff<double>;

  static constexpr double similarity_defect = 0x1p-24,  ///< largest distance of a similarity's M^T M / s^2 from I
      most_residual = 0x1p-20;  ///< largest norm of I - X M at which X is taken for the inverse of M

  /// Upper bound of |v|_1 / |v|_2 for the rows v of f M^T, sqrt(3), and of its rounding: verify/proofs/margin_proofs.h.
  static constexpr double root_of_3 = 1.7321;

  /// Factor that covers products of two errors and the rounding of bounds: verify/proofs/frame_proofs.h.
  static constexpr double second_order = 1.01;

  /// Upper bound of the error of the norm of I - f G: roundings of G's entries, also of fractions, and of f
  /// (verify/proofs/frame_proofs.h).
  static constexpr double gram_rounding = 24 * u;

  /// Upper bound of the errors of f M_a^T M_b, of f M_a^T D and of an image by these, relative to the columns' lengths:
  /// verify/proofs/frame_proofs.h.
  static constexpr double transpose_rounding = 16 * u;

  /// Upper bound of the error of an entry of I - X M_a, relative to its terms: verify/proofs/frame_proofs.h.
  static constexpr double residual_rounding = 6 * u;

  /// Upper bound of the errors of X M_b, of X D and of an image by these, relative to norms:
  /// verify/proofs/frame_proofs.h.
  static constexpr double inverse_rounding = 10 * u;

  /// Returns entry (i, j) of P^T Q, P and Q the linear parts of two poses' entries.
  template <class Number>
  static Number product_of_columns(const std::array<Number, 12>& p, const std::array<Number, 12>& q, int i, int j)
  {
    return p[i] * q[j] + p[4 + i] * q[4 + j] + p[8 + i] * q[8 + j];
  }

  /// Returns `first` plus the products of a row and a column, added one by one.
  template <class Number>
  static Number product_sum(const Number& first, const std::array<Number, 3>& row, const std::array<Number, 3>& column)
  {
    return ((first + row[0] * column[0]) + row[1] * column[1]) + row[2] * column[2];
  }

  /// True when linear = scale * (columns orthonormal up to `axis_defect`), with a scale that floats can hold, 2^-60 ..
  /// 2^60.
  bool is_similarity() const { return similarity_; }

  /// Returns the length of the first column: the factor by which a similarity lengthens.
  double scale() const { return scale_; }

  const std::array<Row, 3>& linear() const { return linear_; }
  const Row& offset() const { return offset_; }

  /// Returns the image of a point, rounded.
  template <class Number>
  Row operator()(const std::array<Number, 3>& p) const
  {
    const Row point = {double(p[0]), double(p[1]), double(p[2])};
    const auto row = [&](int i) {
      return sum(placed_terms(linear_[i][0], linear_[i][1], linear_[i][2], offset_[i], point));
    };
    return {row(0), row(1), row(2)};
  }

  /// Returns the image of a vector by the linear part alone.
  template <class Number>
  Row direction(const std::array<Number, 3>& p) const
  {
    const Row v = {double(p[0]), double(p[1]), double(p[2])};
    return {dot(linear_[0], v), dot(linear_[1], v), dot(linear_[2], v)};
  }

 private:
  /// Computes the map where M_a is a similarity up to `similarity_defect`. The inverse is X = f M_a^T with f = 1 / s^2,
  /// rounded, s the length of its first column. Returns false, and changes nothing, where M_a is none or numbers are
  /// near the ends of the range.
  ///
  /// With G = M_a^T M_a, rho = ||I - f G|| is its computed value plus `gram_rounding`. M_a^-1 = X + (I - X M_a) M_a^-1.
  /// So the error of a row of the linear part is rho times its sum, which is below three times the longest column c.
  /// `transpose_rounding` of products |col_i M_a| |col_j M_b| f is added; these are (1 + 2^-23) times a column. Rows of
  /// X sum to at most sqrt(3) / s. When D's error in double is too large, D is summed again in double-double.
  bool by_transpose(const Pose& a, const Local_scale& in_a, const Pose& b, const Local_scale& in_b, Origin_offset d)
  {
    const std::array<double, 12>&m = a.entries(), &n = b.entries();
    const auto [square, defect] = gram(m);
    if (!(defect <= similarity_defect * square && square >= 0x1p-100 && square <= 0x1p100)) return false;
    const double f = 1 / square, per_unit = 1 / in_a.unit, shrink = root_of_3 * std::sqrt(f) * per_unit;
    const double of_columns = f * (in_b.unit * per_unit), of_offset = f * per_unit;
    const double rho = defect * f + gram_rounding;

    if (!(d.error() * shrink <= 0x1p-30)) d = Origin_offset::in_double_double(a, in_a, b, in_b);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) linear_[i][j] = product_of_columns(m, n, i, j) * of_columns;
      offset_[i] = dot(Row{m[i], m[4 + i], m[8 + i]}, Row{d[0], d[1], d[2]}) * of_offset;
    }
    const double longest = decide_similarity(), relative = second_order * rho + transpose_rounding;
    const double error = relative * (3 * longest + shrink * d.largest()) + shrink * d.error();
    // The error by denormal entries of M_b is below 2^-300 then.
    accept(error, maximum(longest, 1 / longest, d.terms()), in_a, in_b);
    return true;
  }

  /// The distance of G = M^T M from s^2 I.
  struct Gram {
    double square;  ///< s^2, its first entry
    double defect;  ///< ||G - s^2 I||, the largest row sum
  };
  static Gram gram(const std::array<double, 12>& m)
  {
    const auto g = [&m](int i, int j) { return product_of_columns(m, m, i, j); };
    const double square = g(0, 0), g01 = std::abs(g(0, 1)), g02 = std::abs(g(0, 2)), g12 = std::abs(g(1, 2));
    const double g11 = std::abs(g(1, 1) - square), g22 = std::abs(g(2, 2) - square);
    const double row = maximum(g01 + g02, g11 + g01 + g12, g22 + g02 + g12);
    return {square, row};
  }

  /// Stores `error`, unless a number near the ends of the range may have overflowed or underflowed. `top` is the
  /// largest number that it was made of.
  void accept(double error, double top, const Local_scale& in_a, const Local_scale& in_b)
  {
    if (top <= 0x1p200 && in_a.is_in_range() && in_b.is_in_range() && error <= std::numeric_limits<double>::max())
      error_ = error * second_order + underflow;
  }

  /// Computes the map by X, the computed inverse of M_a. With rho an upper bound of ||I - X M_a||, M_a^-1 differs from
  /// X by at most rho / (1 - rho) ||X||. Norms are maxima of row sums.
  void by_inverse(const Pose& a, const Local_scale& in_a, const Pose& b, const Local_scale& in_b)
  {
    std::array<Row, 3> inverse;
    if (!invert(a, inverse)) return;
    const double residual = residual_norm(a, inverse);
    if (!(residual < most_residual)) return;
    const double norm_x = norm(inverse), scale = in_b.unit / in_a.unit;
    const Origin_offset d = Origin_offset::in_double_double(a, in_a, b, in_b);
    const double norm_b = compose(inverse, b, d, scale, in_a.unit);

    // Relative errors of the products X M_b and X D: their own roundings, and 2 rho for X.
    const double relative = 2 * residual + inverse_rounding;
    const double error =
        norm_x * (norm_b * scale * relative + (d.largest() * relative + d.error() * second_order) / in_a.unit);
    accept(error, maximum(d.terms(), norm_b, norm_x), in_a, in_b);
    decide_similarity();
  }

  /// Stores the map of X, D and M_b: linear X M_b `scale`, offset X D / `unit`. Returns ||M_b||.
  double compose(const std::array<Row, 3>& x, const Pose& b, const Origin_offset& d, double scale, double unit)
  {
    double norm_b = 0;
    for (int i = 0; i < 3; ++i) {
      norm_b = maximum(norm_b, std::abs(b[4 * i]) + std::abs(b[4 * i + 1]) + std::abs(b[4 * i + 2]));
      for (int j = 0; j < 3; ++j) {
        linear_[i][j] = dot(x[i], Row{b[j], b[4 + j], b[8 + j]}) * scale;
      }
      offset_[i] = dot(x[i], Row{d[0], d[1], d[2]}) / unit;
    }
    return norm_b;
  }

  static bool invert(const Pose& a, std::array<Row, 3>& inverse)
  {
    const auto m = [&a](int i, int j) { return a[4 * i + j]; };
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int k = (i + 1) % 3, l = (i + 2) % 3, n = (j + 1) % 3, o = (j + 2) % 3;
        inverse[j][i] = m(k, n) * m(l, o) - m(k, o) * m(l, n);
      }
    const double determinant = m(0, 0) * inverse[0][0] + m(0, 1) * inverse[1][0] + m(0, 2) * inverse[2][0];
    if (!(std::abs(determinant) > 0x1p-200 && std::abs(determinant) < 0x1p200)) return false;
    for (Row& row : inverse)
      for (double& x : row) x /= determinant;
    return true;
  }

  static double norm(const std::array<Row, 3>& m)
  {
    double norm = 0;
    for (const Row& row : m) norm = maximum(norm, std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]));
    return norm;
  }

  /// Returns an upper bound of ||I - X M_a||: its computed value plus the errors of the computation and of fractions.
  static double residual_norm(const Pose& a, const std::array<Row, 3>& x)
  {
    double norm = 0;
    for (int i = 0; i < 3; ++i) {
      double row = 0;
      for (int j = 0; j < 3; ++j) {
        const Row column = {a[j], a[4 + j], a[8 + j]};
        const Row row_magnitudes = {std::abs(x[i][0]), std::abs(x[i][1]), std::abs(x[i][2])},
                  column_magnitudes = {std::abs(column[0]), std::abs(column[1]), std::abs(column[2])};
        row += std::abs(product_sum(i == j ? -1.0 : 0.0, x[i], column)) +
               residual_rounding * product_sum(1.0, row_magnitudes, column_magnitudes);
      }
      norm = maximum(norm, row);
    }
    return norm;
  }

  /// Returns an upper bound of the length of the longest column. If the map is no similarity, the bound is undefined
  /// where any entry is.
  double decide_similarity()
  {
    const auto column = [this](int i, int j) {
      return linear_[0][i] * linear_[0][j] + linear_[1][i] * linear_[1][j] + linear_[2][i] * linear_[2][j];
    };
    const double square = column(0, 0), second = column(1, 1), third = column(2, 2),
                 tolerance = square * similarity_defect;
    similarity_ = square >= 0x1p-120 && square <= 0x1p120 && std::abs(second - square) <= tolerance &&
                  std::abs(third - square) <= tolerance && std::abs(column(0, 1)) <= tolerance &&
                  std::abs(column(1, 2)) <= tolerance && std::abs(column(0, 2)) <= tolerance;
    scale_ = std::sqrt(square);
    return similarity_ ? scale_ * (1 + 2 * similarity_defect) : std::sqrt(square + second + third);
  }

  /// Upper bound of all underflow, also of the entries of fractions, within `Local_scale::is_in_range`.
  static constexpr double underflow = 0x1p-300;

  std::array<Row, 3> linear_{};
  Row offset_{};
  double error_ = std::numeric_limits<double>::infinity();
  double scale_ = 0;
  bool similarity_ = false;
};

}  // namespace tetracone::kernel

#endif
