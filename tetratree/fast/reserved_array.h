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

/// An array that grows and never moves: address space for `capacity` elements is reserved at once, memory taken page by
/// page as it is written. One thread at a time may append, while others read what they know to be there.
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
  /// Of so many elements that are there, at the beginning of pages that mmap gave: they become the array's. None may be
  /// appended; where the pages are read only, none may be changed.
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

  /// Returns its number. Requires room.
  std::uint32_t push_back(const T& element)
  {
    const std::uint32_t n = append(1);
    new (data_ + n) T(element);
    return n;
  }

  /// Tells the system that so many will be there at least, in order: it may take memory for them by larger pages.
  void expect(std::size_t count)
  {
    char* const first = reinterpret_cast<char*>(data_);
    const std::size_t bytes = kernel::minimum(count, capacity_) * sizeof(T),
                      skipped = (large_page - std::uintptr_t(first) % large_page) % large_page;
    if (bytes >= skipped + large_page)
      ::madvise(first + skipped, (bytes - skipped) / large_page * large_page, MADV_HUGEPAGE);
  }

  /// Makes place for so many, to be written by the caller, and returns the number of the first. Requires room.
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
