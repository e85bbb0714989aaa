#ifndef TETRACONE_VERIFY_SUBJECTS_SPENT_H
#define TETRACONE_VERIFY_SUBJECTS_SPENT_H

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>

namespace tetracone::verify {

/// The nanoseconds of one answer.
struct Spent {
  std::optional<std::uint64_t> making;  ///< until the bodies are ready; nothing if `asking` includes it
  std::uint64_t asking = 0;             ///< from then to the answer
};

/// Calls what(). Returns its result and the nanoseconds that the call took.
template <class What>
auto timed(const What& what)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  auto result = what();
  return std::pair(std::move(result),
                   std::uint64_t(std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count()));
}

}  // namespace tetracone::verify

#endif
