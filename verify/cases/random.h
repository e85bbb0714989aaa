#ifndef TETRACONE_VERIFY_CASES_RANDOM_H
#define TETRACONE_VERIFY_CASES_RANDOM_H

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tetracone::verify {

/// A direction, a position or a rotation's row.
using Vector = std::array<double, 3>;

/// Three orthonormal rows, up to rounding.
using Rotation = std::array<Vector, 3>;

/// The rotation of the quaternion (w, x, y, z), which need not be of length 1. Requires that it is not zero.
inline Rotation rotation(double w, double x, double y, double z)
{
  const double norm = w * w + x * x + y * y + z * z;
  assert(norm > 0);
  const double s = 2 / norm;
  return {{{1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
           {s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)},
           {s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)}}};
}

/// Seeded random numbers: xoshiro256** by Blackman and Vigna, started by splitmix64. It uses only integer arithmetic,
/// +, *, / and square roots, so that a seed gives the same scene on every machine. The standard's distributions and
/// libm do not.
class Random {
 public:
  explicit Random(std::uint64_t seed)
  {
    for (std::uint64_t& word : state_) {
      std::uint64_t z = seed += 0x9e3779b97f4a7c15u;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
      word = z ^ (z >> 31);
    }
  }

  /// 64 random bits.
  std::uint64_t bits()
  {
    const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9, shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  /// Uniform in [0, 1): a multiple of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// Uniform in [-1, 1).
  double symmetric() { return 2 * unit() - 1; }

  /// Uniform in the ball of radius 1.
  Vector in_ball()
  {
    for (;;) {
      const Vector v = {symmetric(), symmetric(), symmetric()};
      if (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] <= 1) return v;
    }
  }

  /// Uniform in the triangle, up to rounding.
  Vector in_triangle(const std::array<Vector, 3>& t)
  {
    double a = unit(), b = unit();
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    Vector p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = t[0][k] + a * (t[1][k] - t[0][k]) + b * (t[2][k] - t[0][k]);
    return p;
  }

  /// Uniform on the sphere of radius 1.
  Vector direction()
  {
    for (;;) {
      const Vector v = in_ball();
      const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      if (length > 0.01) return {v[0] / length, v[1] / length, v[2] / length};
    }
  }

  /// A quaternion (w, x, y, z) of length at most 1 whose rotation is uniform among all rotations.
  std::array<double, 4> quaternion()
  {
    for (;;) {
      const std::array q = {symmetric(), symmetric(), symmetric(), symmetric()};
      const double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
      if (norm <= 1 && norm > 0.01) return q;
    }
  }

 private:
  std::array<std::uint64_t, 4> state_;
};

/// (cos, sin) of `turns` whole turns, with an error of about 1e-15. It sums its own series, since libm's last bits
/// differ between machines. Requires |turns| < 2^31.
inline std::array<double, 2> turn(double turns)
{
  constexpr double whole = 6.283185307179586;
  const double eighths = std::floor(8 * turns + 0.5);
  const double angle = (turns - eighths / 8) * whole;  // at most pi / 8
  const double x = angle * angle;
  double cosine = 1, sine = 1;
  for (int k = 16; k > 0; k -= 2) {
    cosine = 1 - x / ((k - 1) * k) * cosine;
    sine = 1 - x / (k * (k + 1)) * sine;
  }
  sine *= angle;
  constexpr double half = 0.7071067811865476;
  constexpr std::array<std::array<double, 2>, 8> compass = {
      {{1, 0}, {half, half}, {0, 1}, {-half, half}, {-1, 0}, {-half, -half}, {0, -1}, {half, -half}}};
  const auto [c, s] = compass[static_cast<std::int64_t>(eighths) & 7];
  return {c * cosine - s * sine, c * sine + s * cosine};
}

/// The generator for case `index` of a family, given by its number or name. Rounds of the generator's own seeding
/// separate the cases of different seeds, families and indices.
inline Random random_of_case(std::uint64_t seed, std::uint64_t family, std::uint64_t index)
{
  return Random(Random(Random(seed).bits() ^ family).bits() ^ index);
}
inline Random random_of_case(std::uint64_t seed, std::string_view family, std::uint64_t index)
{
  std::uint64_t state = Random(seed).bits();
  for (const char c : family) state = Random(state ^ static_cast<unsigned char>(c)).bits();
  return Random(state ^ index);
}

}  // namespace tetracone::verify

#endif
