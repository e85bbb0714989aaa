#ifndef TETRACONE_KERNEL_NUMBER_NUMBER_H
#define TETRACONE_KERNEL_NUMBER_NUMBER_H

#include "tetracone/kernel/number/error.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/vertex.h"

#include <gmpxx.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace tetracone::kernel {

/// An exact rational number, GMP's own, in lowest terms. Every finite double is one, and so is a pose's fraction n/d.
using Rational = mpq_class;

namespace detail {

/// True when the magnitude of a decimal number is 1 or more. Requires one that is not 0, as `std::from_chars` reads it.
inline bool is_one_or_more(std::string_view text)
{
  const auto letter = text.find_first_of("eE");
  const std::string_view digits = text.substr(0, letter);
  const auto point = static_cast<long>(digits.substr(0, digits.find('.')).size()),
             first = static_cast<long>(digits.find_first_of("123456789"));
  // The first digit that is not 0 stands for its value times 10^power.
  const long power = first < point ? point - first - 1 : point - first;
  if (letter == std::string_view::npos) return power >= 0;
  std::string_view exponent = text.substr(letter + 1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  long written = 0;
  const auto [rest, error] = std::from_chars(exponent.data(), exponent.data() + exponent.size(), written);
  return error == std::errc::result_out_of_range ? !exponent.starts_with('-') : written >= -power;
}

}  // namespace detail

/// Returns the double nearest to the decimal number that is the whole of `text`: "1e-400" is 0, denormals are kept. One
/// sign may stand before it. Returns nothing when `text` is not a decimal number, or its nearest double is not finite
/// ("nan", "inf", "1e400").
inline std::optional<double> parse_double(std::string_view text)
{
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (rest != end || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // from_chars does not tell at which end. strtod would, but it reads the point of the program's locale.
    if (detail::is_one_or_more(text)) return std::nullopt;
    value = text.starts_with('-') ? -0.0 : 0.0;
  }
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

/// Returns the exact rational of a fraction "n/d" of decimal integers, in lowest terms. n may have a sign. Returns
/// nothing when `text` is no such fraction, or d is 0.
inline std::optional<Rational> parse_fraction(std::string_view text)
{
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto integer = [](std::string_view digits, bool sign_allowed) {
    if (sign_allowed && (digits.starts_with('-') || digits.starts_with('+'))) digits.remove_prefix(1);
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  };
  std::string_view numerator = text.substr(0, slash);
  const std::string_view denominator = text.substr(slash + 1);
  if (!integer(numerator, true) || !integer(denominator, false)) return std::nullopt;
  if (numerator.starts_with('+')) numerator.remove_prefix(1);
  // GMP reads a leading 0 as octal: strip it.
  const auto decimal = [](std::string_view digits) {
    const bool negative = digits.starts_with('-');
    if (negative) digits.remove_prefix(1);
    const auto first = digits.find_first_not_of('0');
    const std::string kept(first == std::string_view::npos ? "0" : digits.substr(first));
    return Rational((negative ? "-" : "") + kept);
  };
  const Rational divisor = decimal(denominator);
  if (divisor == 0) return std::nullopt;
  return Rational(decimal(numerator) / divisor);
}

/// Returns the least integer n such that x times 2^n is an integer; 0 for x = 0. Requires a finite x.
inline int fraction_bits(double x)
{
  if (x == 0) return 0;
  int exponent = 0;
  const auto digits = std::int64_t(std::ldexp(std::frexp(x, &exponent), 53));
  return 53 - exponent - std::countr_zero(std::uint64_t(digits));
}

/// Returns x times 2^bits. Requires a finite x that is 0 or has `bits >= fraction_bits(x)`.
inline mpz_class integer(double x, int bits)
{
  int exponent = 0;
  mpz_class whole = std::ldexp(std::frexp(x, &exponent), 53);
  exponent += bits - 53;
  if (exponent >= 0)
    whole <<= mp_bitcnt_t(exponent);
  else
    whole >>= mp_bitcnt_t(-exponent);
  return whole;
}

/// Returns x times 2^exponent.
inline Rational times_power(const Rational& x, long exponent)
{
  Rational result;
  if (exponent < 0)
    mpq_div_2exp(result.get_mpq_t(), x.get_mpq_t(), mp_bitcnt_t(-exponent));
  else
    mpq_mul_2exp(result.get_mpq_t(), x.get_mpq_t(), mp_bitcnt_t(exponent));
  return result;
}

/// Returns a fraction of few digits that compares with every double (less, equal or greater) as top / bottom does.
/// Requires bottom > 0. They may have a common factor.
///
/// The fraction is scaled by a power of two so that its integer part has 128 or 129 bits. Doubles of its magnitude are
/// then integers. One bit more tells whether the division left a remainder.
inline Rational shortened(const mpz_class& top, const mpz_class& bottom)
{
  const long bits = long(mpz_sizeinbase(top.get_mpz_t(), 2)) - long(mpz_sizeinbase(bottom.get_mpz_t(), 2));
  // Beyond all doubles, and between 0 and the least one, one number stands for all.
  if (bits > 1100 || bits < -1200) {
    const Rational far(mpz_class(mpz_class(1) << 1100), 1);
    return sgn(top) * sgn(bottom) * (bits > 0 ? far : Rational(1 / (far * far)));
  }
  const long k = 128 - bits;
  const auto shifted = [](const mpz_class& x, long by) { return by > 0 ? mpz_class(x << mp_bitcnt_t(by)) : x; };
  mpz_class whole, left;
  mpz_tdiv_qr(whole.get_mpz_t(), left.get_mpz_t(), shifted(top, k).get_mpz_t(), shifted(bottom, -k).get_mpz_t());
  whole = 2 * whole + sgn(left);
  Rational value(shifted(whole, -k - 1), shifted(1, k + 1));
  value.canonicalize();
  return value;
}

/// Fractions of more limbs are shortened before they are compared with doubles: no shortened one has as many.
constexpr std::size_t many_limbs = 64;

/// Returns the double nearest to `value`, ties to even, as IEEE 754 rounds. It is infinite from the magnitude 2^1024 -
/// 2^970 on, which is half a step beyond the largest double. `nearest_root` and `parse_double` round by the same rule.
inline double nearest_double(const Rational& value)
{
  if (mpz_size(value.get_num_mpz_t()) + mpz_size(value.get_den_mpz_t()) > many_limbs)
    return nearest_double(shortened(value.get_num(), value.get_den()));
  // A rational's own conversion may truncate. Its double is at most one step away from the nearest, and the candidates
  // are compared exactly.
  const double start = value.get_d();
  if (!std::isfinite(start)) return start;
  constexpr double largest = std::numeric_limits<double>::max();
  // The tie goes to infinity: the largest double is odd.
  if (std::abs(start) == largest && abs(value) >= Rational(largest) + Rational(0x1p970))
    return std::copysign(HUGE_VAL, start);
  double best = start;
  Rational error = abs(Rational(value - Rational(start)));
  for (const double candidate : {std::nextafter(start, -HUGE_VAL), std::nextafter(start, HUGE_VAL)}) {
    if (!std::isfinite(candidate)) continue;
    const Rational distance = abs(Rational(value - Rational(candidate)));
    const bool even = (std::bit_cast<std::uint64_t>(candidate) & 1) == 0;
    if (distance < error || (distance == error && even)) {
      best = candidate;
      error = distance;
    }
  }
  return best;
}

/// Returns the number that `text` stands for: the nearest double of a decimal, or a fraction "n/d" itself. Returns
/// nothing when it is neither, or its nearest double is not finite. Throws Error where floating point is not sound, by
/// which decimals would be read wrongly.
inline std::optional<Rational> parse_number(std::string_view text)
{
  require_sound_floating_point();
  const auto decimal = parse_double(text);
  const auto number = decimal ? std::optional<Rational>(*decimal) : parse_fraction(text);
  return number && std::isfinite(nearest_double(*number)) ? number : std::nullopt;
}

/// Returns the number that `parse_number` reads. Throws Error where it reads none. The error's line is `before`, up to
/// 40 characters of the text in quotes, `after`, and what was expected.
inline Rational required_number(const std::string& text, const std::string& before, const std::string& after = "")
{
  if (const auto number = parse_number(text)) return *number;
  throw Error(before + "'" + text.substr(0, 40) + "'" + after + "; expected a finite decimal number or a fraction n/d");
}

/// Returns the shortest decimal that reads back as exactly `value`.
inline std::string shortest(double value)
{
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

/// Returns "n/d" in lowest terms, or "n" when the denominator is 1.
inline std::string to_string(const Rational& value) { return value.get_str(); }

/// Returns a text that readers of poses take for exactly `value`. It is its shortest decimal where it is a double, else
/// "n/d", with d = 1 for an integer.
inline std::string exact_text(const Rational& value)
{
  const double nearest = nearest_double(value);
  if (std::isfinite(nearest) && Rational(nearest) == value) return shortest(nearest);
  const std::string fraction = to_string(value);
  return fraction.find('/') == std::string::npos ? fraction + "/1" : fraction;
}

}  // namespace tetracone::kernel

#endif
