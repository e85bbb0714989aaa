#ifndef TETRACONE_EXPERIMENTS_SUPPORT_SHA256_H
#define TETRACONE_EXPERIMENTS_SUPPORT_SHA256_H

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tetracone::experiments {

/// Returns the SHA-256 of the bytes, in 64 hexadecimal digits, as `sha256sum` prints it (FIPS 180-4).
inline std::string sha256(std::string_view bytes)
{
  using Word = std::uint32_t;
  // The constants are the first 32 bits of fractional parts: of the square roots of the first 8 primes, and of the cube
  // roots of the first 64.
  std::array<Word, 8> state{};
  std::array<Word, 64> constants{};
  const auto fraction = [](double x) { return Word((x - std::floor(x)) * 0x1p32); };
  std::size_t count = 0;
  for (int n = 2; count < constants.size(); ++n) {
    bool is_prime = true;
    for (int d = 2; d * d <= n; ++d) is_prime = is_prime && n % d != 0;
    if (!is_prime) continue;
    if (count < state.size()) state[count] = fraction(std::sqrt(double(n)));
    constants[count++] = fraction(std::cbrt(double(n)));
  }

  std::string padded(bytes);
  padded += '\x80';
  padded.append((64 + 56 - padded.size() % 64) % 64, '\0');
  for (int k = 7; k >= 0; --k) padded += char((std::uint64_t(bytes.size()) * 8) >> (8 * k));

  for (std::size_t block = 0; block < padded.size(); block += 64) {
    std::array<Word, 64> w{};
    for (std::size_t k = 0; k < 64; ++k) w[k / 4] = w[k / 4] << 8 | static_cast<unsigned char>(padded[block + k]);
    for (std::size_t t = 16; t < 64; ++t) {
      const Word low = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ (w[t - 15] >> 3);
      const Word high = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ (w[t - 2] >> 10);
      w[t] = w[t - 16] + low + w[t - 7] + high;
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t t = 0; t < 64; ++t) {
      const Word one =
          h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + constants[t] + w[t];
      const Word two = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
      h = g;
      g = f;
      f = e;
      e = d + one;
      d = c;
      c = b;
      b = a;
      a = one + two;
    }
    const std::array<Word, 8> added = {a, b, c, d, e, f, g, h};
    for (std::size_t k = 0; k < 8; ++k) state[k] += added[k];
  }

  std::string digits;
  for (const Word word : state)
    for (int k = 28; k >= 0; k -= 4) digits += "0123456789abcdef"[word >> k & 15];
  return digits;
}

}  // namespace tetracone::experiments

#endif
