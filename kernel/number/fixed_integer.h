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

  /// Returns limb k as a digit of base 2^64. The last digit has the number's sign.
  Int128 digit(int k) const { return k == limbs - 1 ? Int128(std::int64_t(limb[k])) : Int128(limb[k]); }

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

/// Returns the product, which always fits. Row i adds a's digit i times b. Digits are below 2^64, the last of each
/// number and of each row within +-2^63. So a part with one of these, a digit and a carry is within +-2^127: the
/// largest is (2^64 - 1) (2^63 - 1) + (2^63 - 1) + (2^64 - 1) = 2^127 - 1, the least -(2^64 - 1) 2^63 - 2^63 = -2^127.
template <int n, int m>
[[gnu::always_inline]] inline Fixed_integer<n + m> operator*(const Fixed_integer<n>& a, const Fixed_integer<m>& b)
{
  Fixed_integer<n + m> product;
  for (int i = 0; i < n; ++i) {
    Int128 carry = 0;
    for (int j = 0; j < m; ++j) {
      std::uint64_t& digit = product.limb[i + j];
      if (i < n - 1 && j < m - 1) {
        const Uint128 part = Uint128(a.limb[i]) * b.limb[j] + digit + Uint128(carry);
        digit = std::uint64_t(part);
        carry = Int128(part >> 64);
      } else {
        const Int128 before = j == m - 1 ? Int128(std::int64_t(digit)) : Int128(digit);
        const Int128 part = a.digit(i) * b.digit(j) + before + carry;
        digit = std::uint64_t(part);
        carry = part >> 64;
      }
    }
    product.limb[i + m] = std::uint64_t(carry);
  }
  return product;
}

/// integer * 2^exponent, with |integer| < 2^bits.
template <int limbs>
struct Binary_number {
  Fixed_integer<limbs> integer;
  int exponent = 0, bits = 0;  ///< bits: 0 for the number 0

  /// The `bits` of a number that is too wide to be one. Sums of some such do not overflow.
  static constexpr int too_wide = 1 << 26;
};

/// Returns a double, exactly, by an odd integer or 0; infinity and NaN are too wide.
[[gnu::always_inline]] inline Binary_number<1> binary_number(double x)
{
  const auto image = std::bit_cast<std::uint64_t>(x);
  const int biased = int(image >> 52 & 0x7ff);
  std::uint64_t magnitude = image & ((std::uint64_t(1) << 52) - 1);
  if (biased == 0x7ff) return {Fixed_integer<1>(), 0, Binary_number<1>::too_wide};
  if (biased != 0) magnitude |= std::uint64_t(1) << 52;
  if (magnitude == 0) return {};
  const int zeros = std::countr_zero(magnitude);
  magnitude >>= zeros;
  const auto integer = std::int64_t(magnitude);
  return {Fixed_integer<1>(x < 0 ? -integer : integer), (biased == 0 ? 1 : biased) - 1075 + zeros,
          int(std::bit_width(magnitude))};
}

/// Numbers as integers times one power of two: integer[k] * 2^exponent, each below 2^bits.
template <std::size_t count>
struct Fixed_numbers {
  static constexpr int limbs = 2;

  std::array<Fixed_integer<limbs>, count> integer;
  int exponent = 0, bits = 0;  ///< bits: 0 where all are 0, too wide where they do not fit

  /// Returns the numbers, exactly.
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

/// Returns doubles, exactly.
template <std::size_t count>
Fixed_numbers<count> fixed_numbers(const std::array<double, count>& numbers)
{
  std::array<Binary_number<1>, count> binary;
  for (std::size_t k = 0; k < count; ++k) binary[k] = binary_number(numbers[k]);
  return Fixed_numbers<count>::of(binary);
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
  explicit Fixed_map(const std::array<double, 12>& entries) : Fixed_map(binary_numbers(entries)) {}

 private:
  static std::array<Binary_number<1>, 12> binary_numbers(const std::array<double, 12>& entries)
  {
    std::array<Binary_number<1>, 12> binary;
    for (std::size_t k = 0; k < 12; ++k) binary[k] = binary_number(entries[k]);
    return binary;
  }
};

}  // namespace tetracone::kernel

#endif
