#ifndef TETRACONE_KERNEL_NUMBER_FIXED_INTEGER_H
#define TETRACONE_KERNEL_NUMBER_FIXED_INTEGER_H

#include "tetracone/kernel/number/floating_point.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Integers of a fixed width, and doubles as integers times a power of two: exact arithmetic without allocation.
namespace tetracone::kernel {

__extension__ using Int128 = __int128;  // no ISO C++
__extension__ using Uint128 = unsigned __int128;

/// A signed integer of 64 `limbs` bits, in two's complement. Operations do not check for overflow: the caller knows
/// that each result fits. Results of equal width are right whenever they fit, also where an intermediate one does not.
template <int limbs>
struct Fixed_integer {
  std::array<std::uint64_t, limbs> limb{};  ///< least first

  Fixed_integer() = default;
  explicit Fixed_integer(std::int64_t x)
  {
    limb.fill(x < 0 ? ~std::uint64_t(0) : 0);
    limb[0] = std::uint64_t(x);
  }
  /// Widens or narrows: a narrow result must fit.
  template <int from>
  [[gnu::always_inline]] explicit Fixed_integer(const Fixed_integer<from>& x)
  {
    const std::uint64_t sign = x.is_negative() ? ~std::uint64_t(0) : 0;
    for (int k = 0; k < limbs; ++k) limb[k] = k < from ? x.limb[k] : sign;
  }

  bool is_negative() const { return std::int64_t(limb[limbs - 1]) < 0; }

  /// Return the number modulo 2^128, and the number that `x` is in two's complement.
  Uint128 modulo() const requires(limbs >= 2) { return Uint128(limb[1]) << 64 | limb[0]; }
  static Fixed_integer of(Uint128 x) requires(limbs >= 2)
  {
    Fixed_integer number;
    number.limb.fill(Int128(x) < 0 ? ~std::uint64_t(0) : 0);
    number.limb[0] = std::uint64_t(x);
    number.limb[1] = std::uint64_t(x >> 64);
    return number;
  }

  /// Returns -1, 0 or 1.
  int sign() const
  {
    std::uint64_t any = 0;
    for (const std::uint64_t x : limb) any |= x;
    return is_negative() ? -1 : any != 0;
  }

  [[gnu::always_inline]] friend Fixed_integer operator+(const Fixed_integer& a, const Fixed_integer& b)
  {
    if constexpr (limbs == 2) return of(a.modulo() + b.modulo());
    Fixed_integer sum;
    Uint128 carry = 0;
    for (int k = 0; k < limbs; ++k) {
      carry += Uint128(a.limb[k]) + b.limb[k];
      sum.limb[k] = std::uint64_t(carry);
      carry >>= 64;
    }
    return sum;
  }
  [[gnu::always_inline]] friend Fixed_integer operator-(const Fixed_integer& a, const Fixed_integer& b)
  {
    if constexpr (limbs == 2) return of(a.modulo() - b.modulo());
    Fixed_integer difference;
    Uint128 borrow = 0;
    for (int k = 0; k < limbs; ++k) {
      const Uint128 part = Uint128(a.limb[k]) - b.limb[k] - borrow;
      difference.limb[k] = std::uint64_t(part);
      borrow = part >> 64 & 1;
    }
    return difference;
  }
  friend bool operator==(const Fixed_integer&, const Fixed_integer&) = default;

  /// Returns this times 2^shift. Requires 0 <= shift < 64 limbs.
  [[gnu::always_inline]] Fixed_integer operator<<(int shift) const
  {
    if constexpr (limbs == 2) return of(modulo() << shift);
    const int whole = int(unsigned(shift) / 64), part = shift % 64;
    Fixed_integer shifted;
    for (int k = limbs - 1; k >= whole; --k) {
      shifted.limb[k] = limb[k - whole] << part;
      if (part != 0 && k > whole) shifted.limb[k] |= limb[k - whole - 1] >> (64 - part);
    }
    return shifted;
  }
};

/// Returns the product, which always fits. A negative number is its digits, as a number without sign, less a power of
/// two: 2^(64 n) for a, 2^(64 m) for b. The result is the digits' product, less b's digits at limb n where a is
/// negative. Where b is, a's digits at limb m are subtracted. The product of both powers is beyond the last limb.
///
/// A part of the digits' product is a product of two digits, a digit and a carry: at most (2^64 - 1)^2 + 2 (2^64 - 1),
/// which is 2^128 - 1.
template <int n, int m>
[[gnu::always_inline]] inline Fixed_integer<n + m> operator*(const Fixed_integer<n>& a, const Fixed_integer<m>& b)
{
  if constexpr (n == 1 && m == 1)
    return Fixed_integer<2>::of(Uint128(Int128(std::int64_t(a.limb[0])) * std::int64_t(b.limb[0])));
  Fixed_integer<n + m> product;
  for (int i = 0; i < n; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < m; ++j) {
      const Uint128 part = Uint128(a.limb[i]) * b.limb[j] + product.limb[i + j] + carry;
      product.limb[i + j] = std::uint64_t(part);
      carry = std::uint64_t(part >> 64);
    }
    product.limb[i + m] = carry;
  }
  const auto subtract = [&product](const auto& digits, std::size_t at, bool is_asked) {
    const std::uint64_t mask = is_asked ? ~std::uint64_t(0) : 0;
    std::uint64_t borrow = 0;
    for (std::size_t k = 0; k < digits.size(); ++k) {
      const Uint128 part = Uint128(product.limb[at + k]) - (digits[k] & mask) - borrow;
      product.limb[at + k] = std::uint64_t(part);
      borrow = std::uint64_t(part >> 64) & 1;
    }
  };
  subtract(b.limb, n, a.is_negative());
  subtract(a.limb, m, b.is_negative());
  return product;
}

/// integer * 2^exponent, with |integer| < 2^bits.
template <int limbs>
struct Binary_number {
  Fixed_integer<limbs> integer;
  int exponent = 0, bits = 0;  ///< bits: 0 for the number 0

  /// The `bits` of a number that does not fit. Sums of a few such `bits` do not overflow.
  static constexpr int too_wide = 1 << 26;
};

/// Numbers as integers times one power of two: integer[k] * 2^exponent, each below 2^bits.
template <std::size_t count>
struct Fixed_numbers {
  static constexpr int limbs = 2;

  std::array<Fixed_integer<limbs>, count> integer;
  int exponent = 0, bits = 0;  ///< bits: 0 where all are 0, too wide where they do not fit

  /// Returns the numbers, exactly; `bits` is too wide where they do not fit.
  template <int from>
  static Fixed_numbers of(const std::array<Binary_number<from>, count>& numbers)
  {
    Fixed_numbers fixed;
    int lowest = Binary_number<from>::too_wide;
    for (const auto& x : numbers)
      if (x.bits != 0) lowest = minimum(lowest, x.exponent);
    for (std::size_t k = 0; k < count; ++k) {
      const Binary_number<from>& x = numbers[k];
      if (x.bits == 0) continue;
      fixed.bits = maximum(fixed.bits, x.bits + x.exponent - lowest);
      if (fixed.bits >= 64 * limbs) return {{}, 0, Binary_number<from>::too_wide};
      fixed.integer[k] = Fixed_integer<limbs>(x.integer) << (x.exponent - lowest);
    }
    if (fixed.bits != 0) fixed.exponent = lowest;
    return fixed;
  }
};

/// Returns the doubles as integers times one power of two, exactly; `bits` is too wide for infinity and NaN. It does
/// not branch on a number, since zeros are unpredictable among the coordinates of a vertex.
template <std::size_t count>
[[gnu::always_inline]] inline Fixed_numbers<count> fixed_numbers(const std::array<double, count>& numbers)
{
  constexpr int most_exponent = 0x7ff, none = Binary_number<1>::too_wide;
  std::array<std::uint64_t, count> odd;
  std::array<int, count> exponent;  // of the odd part; `none` for 0
  int lowest = none, end = -none, largest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto image = std::bit_cast<std::uint64_t>(numbers[k]);
    const int biased = int(image >> 52 & most_exponent);
    const std::uint64_t implied = std::uint64_t(biased != 0) << 52;
    const std::uint64_t magnitude = (image & ((std::uint64_t(1) << 52) - 1)) | implied;
    const int zeros = std::countr_zero(magnitude), unit = biased + (biased == 0) - 1075;
    odd[k] = magnitude >> (zeros & 63);
    exponent[k] = magnitude == 0 ? none : unit + zeros;
    lowest = minimum(lowest, exponent[k]);
    end = maximum(end, magnitude == 0 ? -none : unit + int(std::bit_width(magnitude)));
    largest = maximum(largest, biased);
  }
  if (lowest == none) return {};
  if (largest == most_exponent || end - lowest >= 64 * Fixed_numbers<count>::limbs) return {{}, 0, none};
  Fixed_numbers<count> fixed;
  fixed.exponent = lowest;
  fixed.bits = end - lowest;
  for (std::size_t k = 0; k < count; ++k) {
    const Uint128 digits = Uint128(odd[k]) << (exponent[k] == none ? 0 : exponent[k] - lowest);
    const Uint128 sign = numbers[k] < 0 ? ~Uint128(0) : 0;
    fixed.integer[k] = Fixed_integer<2>::of((digits ^ sign) - sign);
  }
  return fixed;
}

/// The entries of an affine map as integers: a row-major matrix, and a translation.
struct Fixed_map {
  Fixed_numbers<9> matrix;
  Fixed_numbers<3> translation;

  Fixed_map() = default;
  /// The map of twelve numbers, row-major 3x4.
  template <int from>
  explicit Fixed_map(const std::array<Binary_number<from>, 12>& entries)
  {
    std::array<Binary_number<from>, 9> m;
    std::array<Binary_number<from>, 3> t;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < 3; ++k) m[3 * row + k] = entries[4 * row + k];
      t[row] = entries[4 * row + 3];
    }
    matrix = Fixed_numbers<9>::of(m);
    translation = Fixed_numbers<3>::of(t);
  }
  explicit Fixed_map(const std::array<double, 12>& m)
      : matrix(fixed_numbers<9>({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]})),
        translation(fixed_numbers<3>({m[3], m[7], m[11]}))
  {}
};

}  // namespace tetracone::kernel

#endif
