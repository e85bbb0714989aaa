#ifndef TETRACONE_TETRATREE_FAST_KNOWN_REACHES_H
#define TETRACONE_TETRATREE_FAST_KNOWN_REACHES_H

#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>

namespace tetracone::tetratree {

/// The support values of a body in the directions of a lattice, as far as its `Support_table`s have asked for them. Any
/// number of threads may use it at once.
class Known_reaches {
 public:
  /// The number of corners of the lattice of a `Support_table`.
  static constexpr std::size_t corners = 8 * 18 * 18;

  /// Returns the value at a corner. Calls find() if it is unknown; two threads may both do so and find the same.
  /// Requires finite values.
  template <class Find>
  float at(std::size_t corner, const Find& find) const
  {
    std::call_once(made_, [this] {
      reaches_ = std::make_unique<Reaches>();
      for (auto& reach : *reaches_) reach.store(unknown, std::memory_order_relaxed);
      bytes_ = sizeof(Reaches);
    });
    std::atomic<float>& known = (*reaches_)[corner];
    if (const float reach = known.load(std::memory_order_relaxed); reach != unknown) return reach;
    const float found = find();
    known.store(found, std::memory_order_relaxed);
    return found;
  }

  std::size_t bytes() const { return bytes_; }

 private:
  static constexpr float unknown = std::numeric_limits<float>::infinity();
  using Reaches = std::array<std::atomic<float>, corners>;

  mutable std::once_flag made_;
  mutable std::unique_ptr<Reaches> reaches_;  // made on first use
  mutable std::atomic<std::size_t> bytes_ = 0;
};

}  // namespace tetracone::tetratree

#endif
