#ifndef TETRACONE_VERIFY_TEST_THREADS_TBB_TASK_ARENA_H
#define TETRACONE_VERIFY_TEST_THREADS_TBB_TASK_ARENA_H

/// The part of oneTBB that a scene calls, by threads of the standard library. ThreadSanitizer cannot see the ordering
/// inside a library that is not built with it.
namespace tbb {

/// The number of the thread in a `parallel_for`, 0 outside; and the number of threads.
namespace this_task_arena {
inline thread_local int thread_index = 0;
inline int current_thread_index() { return thread_index; }
inline int max_concurrency() { return 4; }
}  // namespace this_task_arena

/// Runs functions in the calling thread.
class task_arena {
 public:
  explicit task_arena(int) {}
  template <class What>
  void execute(const What& what)
  {
    what();
  }
};

}  // namespace tbb

#endif
