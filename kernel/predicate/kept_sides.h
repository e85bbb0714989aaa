#ifndef TETRACONE_KERNEL_PREDICATE_KEPT_SIDES_H
#define TETRACONE_KERNEL_PREDICATE_KEPT_SIDES_H

#include "tetracone/kernel/predicate/triangle_triangle.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetracone::kernel {

/// A cache of `sides<Adaptive>` for points of placed bodies. It mostly asks the stages after the filter once for a
/// plane and a point. Triangles that share a corner ask for one sign again and again where bodies touch. A point's
/// address stands for its image until `clear`.
class Kept_sides {
 public:
  [[gnu::always_inline]] std::array<Sign, 3> operator()(const Corners<Adaptive>& triangle,
                                                        const Corners<Adaptive>& points)
  {
    Some_sides sides = filtered_sides(triangle, points);
    if (sides.decided() < 3) decide(sides, triangle, points);
    return sides.side;
  }

  /// Returns the signs of the first `count` points, which the filter leaves undecided. Requires 0 < count <= 3.
  std::array<Sign, 3> unfiltered(const Corners<Adaptive>& triangle, const Corners<Adaptive>& points, std::size_t count)
  {
    Some_sides sides{{}, {false, count < 2, count < 3}};
    decide(sides, triangle, points);
    return sides.side;
  }

  /// Forgets all signs: points may have moved.
  void clear() { ++now_; }

  /// Returns the number of calls so far in which the filter left a sign undecided.
  std::uint64_t undecided() const { return undecided_; }

  /// Returns the bytes of the cache.
  std::size_t bytes() const { return kept_.capacity() * sizeof(Kept); }

 private:
  using Point = const Adaptive::Point_3*;

  struct Kept {
    Corners<Adaptive> triangle{};
    Point point = nullptr;
    std::uint64_t at = 0;  // the number of clearings before it was kept
    Sign side = ZERO;
  };

  /// The size of the cache. A sign overwrites another one that has the same place by its hash.
  static constexpr std::size_t places = 256;

  [[gnu::noinline]] void decide(Some_sides& sides, const Corners<Adaptive>& triangle, const Corners<Adaptive>& points)
  {
    ++undecided_;
    if (kept_.empty()) kept_.resize(places);
    const auto is_kept = [&](const Kept& kept, Point point) {
      return kept.at == now_ && kept.point == point && kept.triangle == triangle;
    };
    std::array<bool, 3> is_new{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (sides.is_decided[k]) continue;
      const Kept& kept = place(triangle, points[k]);
      is_new[k] = !is_kept(kept, points[k]);
      sides.is_decided[k] = !is_new[k];
      if (!is_new[k]) sides.side[k] = kept.side;
    }
    if (sides.decided() == 3) return;
    detail::decide_others(sides, triangle, points);
    for (std::size_t k = 0; k < 3; ++k)
      if (is_new[k]) place(triangle, points[k]) = {triangle, points[k], now_, sides.side[k]};
  }

  Kept& place(const Corners<Adaptive>& triangle, Point point)
  {
    // A hash: addresses are multiplied by odd numbers without a pattern, so that the upper bits depend on all of them.
    const auto part = [](Point p, std::uint64_t factor) { return reinterpret_cast<std::uintptr_t>(p) * factor; };
    const std::uint64_t mixed = part(triangle[0], 0x9e3779b97f4a7c15) + part(triangle[1], 0xc2b2ae3d27d4eb4f) +
                                part(triangle[2], 0x165667b19e3779f9) + part(point, 0xff51afd7ed558ccd);
    return kept_[mixed >> 56];
  }
  static_assert(places == 1 << 8);

  std::vector<Kept> kept_;  // empty before the first sign
  std::uint64_t now_ = 1, undecided_ = 0;
};

}  // namespace tetracone::kernel

#endif
