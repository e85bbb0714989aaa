#ifndef TETRACONE_VERIFY_TEST_THREADS_TBB_PARALLEL_INVOKE_H
#define TETRACONE_VERIFY_TEST_THREADS_TBB_PARALLEL_INVOKE_H

#include <thread>

namespace tbb {

/// Calls both functions at the same time, the second in a thread of its own.
template <class One, class Other>
void parallel_invoke(const One& one, const Other& other)
{
  std::thread thread(other);
  one();
  thread.join();
}

}  // namespace tbb

#endif
