#ifndef TETRACONE_TETRATREE_DOOR_CHECKSUM_H
#define TETRACONE_TETRATREE_DOOR_CHECKSUM_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace tetracone::detail {

/// 64 bits that tell bytes from spoiled ones: of blocks of 64 bytes, word k of each goes to lane k, by steps that undo
/// nothing. Bytes that differ in one word alone have different sums, always; others but for one chance in 2^64. As fast
/// as memory; no protection against who means harm.
class Checksum {
 public:
  /// Adds bytes, the last block filled up with 0.
  void add(std::span<const std::byte> bytes)
  {
    for (; bytes.size() >= block; bytes = bytes.subspan(block)) add_block(bytes.data());
    if (bytes.empty()) return;
    std::array<std::byte, block> last{};
    std::memcpy(last.data(), bytes.data(), bytes.size());
    add_block(last.data());
  }

  std::uint64_t value() const
  {
    std::uint64_t sum = 0;
    for (const std::uint64_t lane : lanes_) sum = mixed(sum, lane);
    return sum;
  }

  static constexpr std::size_t block = 64;

 private:
  /// One to one in either, the other fixed.
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
