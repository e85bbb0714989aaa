#ifndef TETRACONE_VERIFY_FUZZ_FUZZ_TARGETS_H
#define TETRACONE_VERIFY_FUZZ_FUZZ_TARGETS_H

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace tetracone::verify {

// The targets of libFuzzer. Each accepts any bytes, and aborts when the property over it does not hold.

/// A case file is refused, or is written and read again as an equal case.
void fuzz_case(const std::uint8_t* data, std::size_t size);
/// Distances, nearest points and limits are those of all pairs of elements in rationals.
void fuzz_distance(const std::uint8_t* data, std::size_t size);
/// A model file is refused, or checked and repaired.
void fuzz_model(const std::uint8_t* data, std::size_t size);
/// Positions of points and hits of rays are those of all elements in rationals.
void fuzz_points(const std::uint8_t* data, std::size_t size);
/// A file of poses or of points is refused or read.
void fuzz_poses(const std::uint8_t* data, std::size_t size);
/// Answers of both trees are those of all pairs of elements in rationals; no box of a scene separates bodies that meet.
void fuzz_query(const std::uint8_t* data, std::size_t size);
/// A changed saved body is refused, or answers as its vertices and faces do in rationals.
void fuzz_saved_body(const std::uint8_t* data, std::size_t size);
/// Signs of the adaptive kernel are those of rational arithmetic.
void fuzz_signs(const std::uint8_t* data, std::size_t size);

/// Aborts unless the condition holds, which says that two ways of answering agree.
inline void same(bool condition)
{
  if (!condition) std::abort();
}

}  // namespace tetracone::verify

#endif
