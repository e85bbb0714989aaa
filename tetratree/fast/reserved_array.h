#ifndef TETRACONE_TETRATREE_FAST_RESERVED_ARRAY_H
#define TETRACONE_TETRATREE_FAST_RESERVED_ARRAY_H

#include "tetracone/kernel/number/floating_point.h"

#include <sys/mman.h>

#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>

namespace tetracone::tetratree {

/// An array that grows and never moves. Address space for `capacity` elements is reserved at once; memory is taken page
/// by page as it is written. One thread at a time may append, while others read elements that they know to exist.
template <class T>
class Reserved_array {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  explicit Reserved_array(std::size_t capacity) : capacity_(capacity)
  {
    if (capacity == 0) return;
    void* const space = ::mmap(nullptr, capacity * sizeof(T), PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (space == MAP_FAILED) throw std::bad_alloc();
    data_ = static_cast<T*>(space);
  }
  /// Takes over `count` elements at the beginning of pages that mmap returned. Nothing may be appended; on read-only
  /// pages nothing may be changed.
  Reserved_array(T* pages, std::size_t count) : data_(pages), capacity_(count), size_(std::uint32_t(count)) {}

  Reserved_array(Reserved_array&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), capacity_(other.capacity_), size_(other.size())
  {}

  ~Reserved_array()
  {
    if (data_ != nullptr) ::munmap(data_, capacity_ * sizeof(T));
  }

  T* data() const { return data_; }
  std::uint32_t size() const { return size_.load(std::memory_order_relaxed); }

  /// Appends an element and returns its number. Requires room.
  std::uint32_t push_back(const T& element)
  {
    const std::uint32_t n = append(1);
    new (data_ + n) T(element);
    return n;
  }

  /// Tells the system that at least `count` elements will come, in order, so that it may use larger pages.
  void expect(std::size_t count)
  {
    char* const first = reinterpret_cast<char*>(data_);
    const std::size_t bytes = kernel::minimum(count, capacity_) * sizeof(T),
                      skipped = (large_page - std::uintptr_t(first) % large_page) % large_page;
    if (bytes >= skipped + large_page)
      ::madvise(first + skipped, (bytes - skipped) / large_page * large_page, MADV_HUGEPAGE);
  }

  /// Reserves `count` elements, for the caller to write, and returns the number of the first. Requires room.
  std::uint32_t append(std::size_t count)
  {
    const std::uint32_t n = size();
    assert(n + count <= capacity_);
    size_.store(std::uint32_t(n + count), std::memory_order_relaxed);
    return n;
  }

 private:
  static constexpr std::size_t large_page = std::size_t(1) << 21;

  T* data_ = nullptr;
  std::size_t capacity_;
  std::atomic<std::uint32_t> size_ = 0;
};

}  // namespace tetracone::tetratree

#endif
