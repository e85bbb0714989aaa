#ifndef TETRACONE_KERNEL_NUMBER_POSE_H
#define TETRACONE_KERNEL_NUMBER_POSE_H

#include "tetracone/kernel/number/double_double.h"
#include "tetracone/kernel/number/fixed_integer.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/products.h"

#include <CGAL/Mpzf.h>
#include <CGAL/enum.h>
#include <Eigen/Geometry>

#include <array>
#include <cassert>
#include <cmath>
#include <memory>
#include <utility>

namespace tetracone::kernel {

/// The affine map x -> M x + t that places a model, taken exactly.
///
/// It has twelve numbers, row-major 3x4: row i is (M_i0, M_i1, M_i2, t_i). Every entry stands for exactly the rational
/// that it is. M need not be a rotation (in doubles it almost never is). A map that must be truly rigid has rational
/// entries. The kernel determines how exactly a pose is applied:
/// - float, double, double-eps: the entries are rounded to the kernel's number type and so is every image;
/// - EPICK: the entries are rounded to double, the image is computed and rounded in double, then decided exactly;
/// - EPECK, rational, adaptive: the exact image of the exact entries.
///
/// Requires det M != 0 wherever a pose is used (see `determinant_sign`).
class Pose {
 public:
  /// The identity.
  Pose() : entries_{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0} {}

  /// The map of twelve finite doubles, row-major 3x4.
  explicit Pose(const std::array<double, 12>& entries) : entries_(entries), is_translation_(is_unit(entries)) {}

  /// The map of twelve rationals, row-major 3x4, each with a finite nearest double. Entries that are all doubles give
  /// the same pose as the doubles.
  explicit Pose(const std::array<Rational, 12>& entries)
  {
    bool all_doubles = true;
    for (int k = 0; k < 12; ++k) {
      entries_[k] = nearest_double(entries[k]);
      assert(std::isfinite(entries_[k]));
      all_doubles = all_doubles && Rational(entries_[k]) == entries[k];
    }
    is_translation_ = all_doubles && is_unit(entries_);
    if (all_doubles) return;
    auto fractions = std::make_shared<Fractions>();
    fractions->exact = entries;
    mpz_class common = 1;
    for (int k = 0; k < 12; ++k) {
      fractions->lows[k] = nearest_double(Rational(entries[k] - Rational(entries_[k])));
      common = lcm(common, entries[k].get_den());
    }
    fractions->weight = mpzf(common);
    fractions->binary_weight = binary_number<1>(common);
    std::array<Binary_number<2>, 12> binary;
    for (int k = 0; k < 12; ++k) {
      const mpz_class whole(entries[k].get_num() * (common / entries[k].get_den()));
      fractions->whole[k] = mpzf(whole);
      binary[k] = binary_number<2>(whole);
    }
    fractions->fixed = Fixed_map(binary);
    fractions_ = std::move(fractions);
  }

  /// Returns the map p -> p + (x, y, z).
  static Pose translation(double x, double y, double z)
  {
    return Pose(std::array<double, 12>{1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z});
  }

  /// The map of a matrix of doubles, taken exactly.
  template <int mode, int options>
  static Pose from_eigen(const Eigen::Transform<double, 3, mode, options>& map)
  {
    std::array<double, 12> entries;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) entries[4 * row + column] = map(row, column);
    return Pose(entries);
  }

  /// Returns the map as an Eigen transform, each entry rounded to the nearest double.
  template <class Map = Eigen::Affine3d>
  Map to_eigen() const
  {
    Map map = Map::Identity();
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) map(row, column) = entries_[4 * row + column];
    return map;
  }

  /// Returns a truly rigid map: the rotation of the integer quaternion (w, x, y, z), then the translation t. The
  /// entries are the rationals of R = N / (w^2 + x^2 + y^2 + z^2). Requires 0 < w^2 + x^2 + y^2 + z^2 < 2^63.
  static Pose from_quaternion(int w, int x, int y, int z, const std::array<Rational, 3>& t = {0, 0, 0})
  {
    const long ww = long(w) * w, xx = long(x) * x, yy = long(y) * y, zz = long(z) * z;
    const long norm = ww + xx + yy + zz;
    assert(norm != 0);
    const long xy = long(x) * y, xz = long(x) * z, yz = long(y) * z, wx = long(w) * x, wy = long(w) * y,
               wz = long(w) * z;
    const std::array<long, 9> n = {ww + xx - yy - zz, 2 * (xy - wz), 2 * (xz + wy), 2 * (xy + wz),    ww - xx + yy - zz,
                                   2 * (yz - wx),     2 * (xz - wy), 2 * (yz + wx), ww - xx - yy + zz};
    std::array<Rational, 12> entries;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        entries[4 * row + column] = Rational(n[3 * row + column]) / Rational(norm);
      entries[4 * row + 3] = t[row];
    }
    return Pose(entries);
  }

  /// Returns entry `k` of the row-major 3x4 matrix, rounded to the nearest double; exact unless `is_rational()`.
  double operator[](int k) const { return entries_[k]; }
  /// Returns all twelve entries, rounded likewise.
  const std::array<double, 12>& entries() const { return entries_; }

  /// True when some entry is no double.
  bool is_rational() const { return fractions_ != nullptr; }

  /// Returns entry `k` as a sum of two doubles. It is exact unless `is_rational()`; else its error is at most 2^-106 of
  /// it, or 2^-1074.
  Double_double double_double(int k) const { return {entries_[k], fractions_ ? fractions_->lows[k] : 0}; }

  /// Returns entry `k`, exactly.
  Rational exact(int k) const { return fractions_ ? fractions_->exact[k] : Rational(entries_[k]); }

  /// Returns entry `k` times `weight`, exactly. It is a binary fraction even where the entry is not one.
  CGAL::Mpzf whole(int k) const { return fractions_ ? fractions_->whole[k] : CGAL::Mpzf(entries_[k]); }
  /// Returns the least common denominator of the entries; 1 where all are doubles.
  CGAL::Mpzf weight() const { return fractions_ ? fractions_->weight : CGAL::Mpzf(1); }

  /// Return `whole` of all entries, and `weight`, as integers of a fixed width. Their `bits` tell where they are too
  /// wide. Require `is_rational()`.
  const Fixed_map& fixed_map() const { return fractions_->fixed; }
  const Binary_number<1>& binary_weight() const { return fractions_->binary_weight; }

  /// True when the map moves nothing: every image is the point itself, in every kernel.
  bool is_identity() const { return is_translation_ && entries_[3] == 0 && entries_[7] == 0 && entries_[11] == 0; }

  /// True when M is the identity and all entries of t are doubles. An image is then the sum of the vertex and t.
  bool is_translation() const { return is_translation_; }

  /// Returns the sign of det M, exactly. Zero means that the map is flat and no pose.
  CGAL::Sign determinant_sign() const
  {
    double largest = 0;
    for (int row = 0; row < 3; ++row)
      for (int j = 0; j < 3; ++j) largest = maximum(largest, std::abs(entries_[4 * row + j]));
    const std::array<double, 3> x = {entries_[0], entries_[1], entries_[2]},
                                y = {entries_[4], entries_[5], entries_[6]},
                                z = {entries_[8], entries_[9], entries_[10]};
    const double determinant = kernel::determinant(y, z, x), bound = determinant_bound(permanent(y, z, x));
    if (largest <= magnitude_gate && std::abs(determinant) > bound)
      return determinant > 0 ? CGAL::POSITIVE : CGAL::NEGATIVE;

    const auto row = [this](int i) { return std::array{exact(4 * i), exact(4 * i + 1), exact(4 * i + 2)}; };
    return CGAL::Sign(sgn(kernel::determinant(row(1), row(2), row(0))));
  }

  /// Upper bound of the error of a determinant of entries, relative to its permanent (verify/proofs/adaptive_proofs.h).
  /// 6 products of 3 entries have at most 5 roundings each, and 3 more of entries that are rounded fractions. The
  /// roundings of the permanent itself are included.
  static constexpr double determinant_rounding = 0x1p-49;

  /// Returns an upper bound of the error of a computed determinant, from its computed permanent.
  template <class Number>
  static Number determinant_bound(const Number& permanent)
  {
    return Number(determinant_rounding) * permanent + Number(underflow_slack);
  }

  friend bool operator==(const Pose& a, const Pose& b)
  {
    return a.entries_ == b.entries_ && a.is_rational() == b.is_rational() &&
           (!a.is_rational() || a.fractions_->exact == b.fractions_->exact);
  }

 private:
  struct Fractions {
    std::array<Rational, 12> exact;
    std::array<double, 12> lows{};     // what rounding took from each, rounded
    std::array<CGAL::Mpzf, 12> whole;  // each times the weight
    CGAL::Mpzf weight;
    Fixed_map fixed;
    Binary_number<1> binary_weight;
  };

  static bool is_unit(const std::array<double, 12>& m)
  {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (m[4 * i + j] != (i == j ? 1 : 0)) return false;
    return true;
  }

  static CGAL::Mpzf mpzf(const mpz_class& integer)
  {
    const mpz_srcptr z = integer.get_mpz_t();
    static_assert(GMP_LIMB_BITS == 64 && sizeof(unsigned long) == 8);
    CGAL::Mpzf value = 0;
    for (std::size_t k = mpz_size(z); k-- > 0;)
      value = value * CGAL::Mpzf(0x1p64) + CGAL::Mpzf((unsigned long)(mpz_getlimbn(z, mp_size_t(k))));
    return mpz_sgn(z) < 0 ? -value : value;
  }

  template <int limbs>
  static Binary_number<limbs> binary_number(const mpz_class& integer)
  {
    if (integer == 0) return {};
    const mp_bitcnt_t zeros = mpz_scan1(integer.get_mpz_t(), 0);
    const mpz_class odd = abs(integer) >> zeros;
    const std::size_t bits = mpz_sizeinbase(odd.get_mpz_t(), 2);
    if (bits >= 64 * limbs || zeros > most_zeros) return {{}, 0, Binary_number<limbs>::too_wide};
    Fixed_integer<limbs> value;
    for (int k = 0; k < limbs; ++k) value.limb[k] = mpz_getlimbn(odd.get_mpz_t(), k);
    if (integer < 0) value = Fixed_integer<limbs>() - value;
    return {value, int(zeros), int(bits)};
  }
  static constexpr mp_bitcnt_t most_zeros = 1 << 20;  ///< far below where sums of exponents overflow

  std::array<double, 12> entries_;
  bool is_translation_ = true;
  std::shared_ptr<const Fractions> fractions_;  // null where every entry is a double
};

/// Returns a pose as a row-major 3x4 matrix.
inline std::array<Rational, 12> rows_of(const Pose& pose)
{
  std::array<Rational, 12> rows;
  for (int k = 0; k < 12; ++k) rows[k] = pose.exact(k);
  return rows;
}

}  // namespace tetracone::kernel

#endif
