#ifndef TETRACONE_VERIFY_TEST_THREADS_TBB_BLOCKED_RANGE_H
#define TETRACONE_VERIFY_TEST_THREADS_TBB_BLOCKED_RANGE_H

#include <cstddef>

namespace tbb {

/// The values from `begin` to `end`, taken `at_least` at a time: oneTBB's class, as `parallel_for` here needs it.
template <class Value>
class blocked_range {
 public:
  blocked_range(Value begin, Value end, std::size_t at_least) : begin_(begin), end_(end), at_least_(at_least) {}
  Value begin() const { return begin_; }
  Value end() const { return end_; }
  std::size_t grainsize() const { return at_least_; }

 private:
  Value begin_, end_;
  std::size_t at_least_;
};

}  // namespace tbb

#endif
