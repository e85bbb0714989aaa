#ifndef TETRACONE_VERIFY_FUZZ_FUZZ_TARGETS_H
#define TETRACONE_VERIFY_FUZZ_FUZZ_TARGETS_H

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace tetracone::verify {

// The targets of libFuzzer. Each accepts any bytes, and aborts when a required property does not hold.
void fuzz_case(const std::uint8_t* data, std::size_t size);
void fuzz_distance(const std::uint8_t* data, std::size_t size);
void fuzz_model(const std::uint8_t* data, std::size_t size);
void fuzz_points(const std::uint8_t* data, std::size_t size);
void fuzz_poses(const std::uint8_t* data, std::size_t size);
void fuzz_query(const std::uint8_t* data, std::size_t size);
void fuzz_saved_body(const std::uint8_t* data, std::size_t size);
void fuzz_signs(const std::uint8_t* data, std::size_t size);

/// Aborts unless two ways of answering agree.
inline void same(bool condition)
{
  if (!condition) std::abort();
}

}  // namespace tetracone::verify

#endif
