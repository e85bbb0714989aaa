#ifndef TETRACONE_TETRATREE_DOOR_CHECKSUM_H
#define TETRACONE_TETRATREE_DOOR_CHECKSUM_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace tetracone::detail {

/// A checksum of 64 bits. Word k of each block of 64 bytes goes to lane k, by steps that are one to one. Bytes that
/// differ in one word only always have different sums; other changes go unnoticed with a chance of one in 2^64. It is
/// as fast as memory, and no protection against malice.
class Checksum {
 public:
  /// Adds bytes. A call that ends within a block fills up that block with 0.
  void add(std::span<const std::byte> bytes)
  {
    for (; bytes.size() >= block; bytes = bytes.subspan(block)) add_block(bytes.data());
    if (bytes.empty()) return;
    std::array<std::byte, block> last{};
    std::memcpy(last.data(), bytes.data(), bytes.size());
    add_block(last.data());
  }

  /// Returns the checksum of all bytes so far.
  std::uint64_t value() const
  {
    std::uint64_t sum = 0;
    for (const std::uint64_t lane : lanes_) sum = mixed(sum, lane);
    return sum;
  }

  static constexpr std::size_t block = 64;  ///< bytes of a block

 private:
  /// Mixes a word into a sum; one to one in each while the other is fixed.
  static std::uint64_t mixed(std::uint64_t sum, std::uint64_t word)
  {
    sum = (sum ^ word) * 0x9e3779b97f4a7c15;
    return sum ^ sum >> 32;
  }

  void add_block(const std::byte* bytes)
  {
    std::array<std::uint64_t, block / sizeof(std::uint64_t)> words;
    std::memcpy(words.data(), bytes, block);
    for (std::size_t k = 0; k < words.size(); ++k) lanes_[k] = mixed(lanes_[k], words[k]);
  }

  std::array<std::uint64_t, block / sizeof(std::uint64_t)> lanes_{1, 2, 3, 4, 5, 6, 7, 8};
};

}  // namespace tetracone::detail

#endif
