#ifndef TETRACONE_EXPERIMENTS_SUPPORT_HEAP_H
#define TETRACONE_EXPERIMENTS_SUPPORT_HEAP_H

#include <malloc.h>

#include <cstddef>

namespace tetracone::experiments {

/// Returns the bytes of the heap in use.
inline std::size_t heap_bytes()
{
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace tetracone::experiments

#endif
