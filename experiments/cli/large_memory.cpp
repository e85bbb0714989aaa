// The program's memory: what is large stands on large pages, since bodies of 10^7 triangles spend else half of their
// time in having small ones made.

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t page = std::size_t(1) << 21, large = 16 * page;

/// On large pages where the system has such; null where there is no memory.
void* large_memory(std::size_t size)
{
  if (size > std::numeric_limits<std::size_t>::max() - page) return nullptr;
  size = (size + page - 1) / page * page;
  void* const memory = std::aligned_alloc(page, size);
  if (memory != nullptr) ::madvise(memory, size, MADV_HUGEPAGE);
  return memory;
}

}  // namespace

void* operator new(std::size_t size)
{
  for (;;) {
    void* const memory = size < large ? std::malloc(size == 0 ? 1 : size) : large_memory(size);
    if (memory != nullptr) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
