#ifndef TETRACONE_VERIFY_TEST_SUPPORT_AT_ONCE_H
#define TETRACONE_VERIFY_TEST_SUPPORT_AT_ONCE_H

#include <thread>

namespace tetracone::verify {

/// Runs two functions at once, for `covering::Both`: the first in the calling thread, the second in one of its own.
struct At_once {
  template <class One, class Other>
  void operator()(const One& one, const Other& other) const
  {
    std::thread thread(other);
    one();
    thread.join();
  }
};

}  // namespace tetracone::verify

#endif
