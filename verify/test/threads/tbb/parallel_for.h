#ifndef TETRACONE_VERIFY_TEST_THREADS_TBB_PARALLEL_FOR_H
#define TETRACONE_VERIFY_TEST_THREADS_TBB_PARALLEL_FOR_H

#include "verify/test/threads/tbb/blocked_range.h"
#include "verify/test/threads/tbb/task_arena.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace tbb {

/// Calls what(part) for parts of the range of its grain size, the last one perhaps smaller, in as many threads as an
/// arena has.
template <class Range, class What>
void parallel_for(const Range& range, const What& what)
{
  std::atomic<std::size_t> next = range.begin();
  std::vector<std::thread> threads;
  for (int index = 0; index < this_task_arena::max_concurrency(); ++index)
    threads.emplace_back([&, index] {
      this_task_arena::thread_index = index;
      for (std::size_t begin; (begin = next.fetch_add(range.grainsize())) < range.end();)
        what(Range(begin, std::min(begin + range.grainsize(), range.end()), range.grainsize()));
    });
  for (std::thread& thread : threads) thread.join();
}

}  // namespace tbb

#endif
