#ifndef TETRACONE_TETRATREE_SCENE_LARGE_PAGES_H
#define TETRACONE_TETRATREE_SCENE_LARGE_PAGES_H

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <vector>

namespace tetracone::tetratree {

/// The allocator of long-lived vectors: large ones are on huge pages, if the system has them. A scene's bodies are read
/// in no order, and the processor's translation buffer holds the addresses of few small pages.
template <class T>
struct On_large_pages {
  using value_type = T;

  On_large_pages() = default;
  template <class U>
  On_large_pages(const On_large_pages<U>&)
  {}

  T* allocate(std::size_t count)
  {
    if (count > most / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = count * sizeof(T);
    if (bytes < page) return std::allocator<T>().allocate(count);
    // The memory starts at the first address at which a huge page may begin; the rest is given back.
    const std::size_t room = bytes + page;
    void* const space = ::mmap(nullptr, room, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (space == MAP_FAILED) throw std::bad_alloc();
    char* const begin = static_cast<char*>(space);
    const std::size_t skipped = (page - reinterpret_cast<std::uintptr_t>(begin) % page) % page, kept = mapped(bytes);
    if (skipped > 0) ::munmap(begin, skipped);
    if (room > skipped + kept) ::munmap(begin + skipped + kept, room - skipped - kept);
    ::madvise(begin + skipped, bytes / page * page, MADV_HUGEPAGE);
    return reinterpret_cast<T*>(begin + skipped);
  }
  void deallocate(T* memory, std::size_t count)
  {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < page)
      std::allocator<T>().deallocate(memory, count);
    else
      ::munmap(memory, mapped(bytes));
  }

  friend bool operator==(const On_large_pages&, const On_large_pages&) { return true; }

 private:
  static constexpr std::size_t page = std::size_t(1) << 21, small_page = std::size_t(1) << 12,
                               most = std::numeric_limits<std::ptrdiff_t>::max() - page;

  /// Returns the bytes of an allocation in whole pages.
  static std::size_t mapped(std::size_t bytes) { return (bytes + small_page - 1) / small_page * small_page; }
};

template <class T>
using Large_vector = std::vector<T, On_large_pages<T>>;

}  // namespace tetracone::tetratree

#endif
