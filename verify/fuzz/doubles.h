#ifndef TETRACONE_VERIFY_FUZZ_DOUBLES_H
#define TETRACONE_VERIFY_FUZZ_DOUBLES_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tetracone::verify {

/// Doubles from bytes. The first byte of each selects quarters of small integers, which meet more often, a small
/// integer times a power of 16, or raw bits. That byte replaces NaN and a number of magnitude `limit` or more, except
/// that quarters are never replaced. Bytes after the last one are 0.
class Doubles {
 public:
  Doubles(const std::uint8_t* data, std::size_t size, double limit) : data_(data), size_(size), limit_(limit) {}

  /// True when all bytes are taken.
  bool empty() const { return size_ == 0; }

  /// Takes a double.
  double next()
  {
    const std::uint8_t kind = byte();
    if (kind < 96) return double(std::int8_t(byte())) / 4;
    if (kind < 160) return limited(std::ldexp(double(std::int8_t(byte())), 4 * int(std::int8_t(byte()))), kind);
    std::uint64_t bits = 0;
    for (int k = 0; k < 8; ++k) bits = bits << 8 | byte();
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return limited(x, kind);
  }

  /// Takes a byte.
  std::uint8_t byte()
  {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }

 private:
  double limited(double x, double instead) const { return std::abs(x) < limit_ ? x : instead; }

  const std::uint8_t* data_;
  std::size_t size_;
  double limit_;
};

}  // namespace tetracone::verify

#endif
