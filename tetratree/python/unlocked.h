#ifndef TETRACONE_TETRATREE_PYTHON_UNLOCKED_H
#define TETRACONE_TETRATREE_PYTHON_UNLOCKED_H

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstddef>
#include <mutex>

namespace tetracone::python {

/// A lock that does nothing, for objects that any number of threads may ask at once.
struct No_lock {
  void lock() {}
  void unlock() {}
};
inline No_lock no_lock;

/// Calls each(0) .. each(count - 1) without the interpreter's lock. It holds the lock `own`, and never waits for `own`
/// while it holds the interpreter's. Ctrl-C raises KeyboardInterrupt. It is looked for between chunks of 256 calls, at
/// most ten times a second, and not at all for one call.
template <class Lock, class Each>
void for_each_unlocked(std::size_t count, Lock& own, const Each& each)
{
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t chunk = 256;
  const pybind11::gil_scoped_release unlocked;
  std::unique_lock alone(own);
  if (count == 1) return each(std::size_t(0));  // reading a clock would cost a fraction of a query
  auto looked = Clock::now();
  for (std::size_t begin = 0; begin < count; begin += chunk) {
    for (std::size_t k = begin; k < count && k < begin + chunk; ++k) each(k);
    if (Clock::now() - looked < std::chrono::milliseconds(100)) continue;
    alone.unlock();  // a signal handler may ask the same query
    {
      const pybind11::gil_scoped_acquire locked;
      if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    }
    alone.lock();
    looked = Clock::now();
  }
}

}  // namespace tetracone::python

#endif
