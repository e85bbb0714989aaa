#ifndef TETRACONE_VERIFY_PROOFS_LANES_H
#define TETRACONE_VERIFY_PROOFS_LANES_H

#include <array>
#include <cstddef>

namespace tetracone::verify::proofs {

/// A vector of numbers, like the compiler's vectors of kernel/simd/short_vectors.h: operations act lane by lane.
template <class Number, std::size_t n>
struct Lanes {
  std::array<Number, n> lane;

  const Number& operator[](std::size_t k) const { return lane[k]; }

  friend Lanes operator+(const Lanes& a, const Lanes& b)
  {
    Lanes result = a;
    for (std::size_t k = 0; k < n; ++k) result.lane[k] = a[k] + b[k];
    return result;
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b)
  {
    Lanes result = a;
    for (std::size_t k = 0; k < n; ++k) result.lane[k] = a[k] - b[k];
    return result;
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b)
  {
    Lanes result = a;
    for (std::size_t k = 0; k < n; ++k) result.lane[k] = a[k] * b[k];
    return result;
  }
  friend Lanes magnitudes(const Lanes& a)
  {
    Lanes result = a;
    for (std::size_t k = 0; k < n; ++k) result.lane[k] = abs(a[k]);
    return result;
  }
};

}  // namespace tetracone::verify::proofs

#endif
