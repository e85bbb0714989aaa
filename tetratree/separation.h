#ifndef TETRACONE_TETRATREE_SEPARATION_H
#define TETRACONE_TETRATREE_SEPARATION_H

#include "kernel/relative_frame.h"
#include "tetratree/support_table.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetracone::tetratree {

/// The search for a plane between two bodies: JS08 Theorem 2, in whatever direction separates instead of that of one reference tetrahedron, and in
/// constant time a direction. A direction m separates when A lies beyond B along it: min m . a > max m . b, by the support tables.
///
/// The first direction tried leads from B's origin to A's. One that fails is turned to where the bodies' difference comes nearest to 0, as
/// far as the last support points tell (Gilbert, SIAM J. Control 4, 1966). All in B's local units.
class Separation {
 public:
  explicit Separation(Wide_tree& a, Wide_tree& b) : a_(a), b_(b) {}

  /// True when the placed bodies are found to be apart. `into_b` leads from A's units to B's.
  bool operator()(const kernel::Relative_frame& into_b, int steps)
  {
    for (int i = 0; i < 3; ++i) direction_[i] = float(into_b.offset()[i]);
    return from_here(into_b, steps);
  }

  /// The same, begun with the last direction tried.
  bool again(const kernel::Relative_frame& into_b, int steps) { return from_here(into_b, steps); }

  std::size_t bytes() const { return a_.bytes() + b_.bytes(); }

 private:
  using Direction = Support_table::Direction;

  bool from_here(const kernel::Relative_frame& into_b, int steps)
  {
    const auto& offset = into_b.offset();
    float linear[3][3], t[3];
    for (int i = 0; i < 3; ++i) {
      t[i] = float(offset[i]);
      for (int j = 0; j < 3; ++j) linear[i][j] = float(into_b.linear()[i][j]);
    }
    const float spread = norm_of(linear);
    Direction& m = direction_;
    for (int k = 0; k < steps; ++k) {
      Direction back;
      for (int j = 0; j < 3; ++j) back[j] = -(linear[0][j] * m[0] + linear[1][j] * m[1] + linear[2][j] * m[2]);
      const float norm = std::abs(m[0]) + std::abs(m[1]) + std::abs(m[2]), norm_back = std::abs(back[0]) + std::abs(back[1]) + std::abs(back[2]);
      // Also what is undefined ends here.
      if (!(norm > 1e-30f && norm < 1e30f && norm_back > 1e-30f && norm_back < 1e30f)) return false;
      const auto support_a = a_(back), support_b = b_(m);
      const float distance = m[0] * t[0] + m[1] * t[1] + m[2] * t[2];
      // `distance` and `back` are sums of three products, rounded 4 times a term; the terms of `back` sum to at most sqrt(3) times more than
      // it does under a similarity, and to `spread` at any rate.
      const float slack = (Support_table::slack + 8 * 0x1p-24f) * (norm + norm_back) + 8 * 0x1p-24f * (norm * (std::abs(t[0]) + std::abs(t[1]) + std::abs(t[2])) + norm * spread) +
                          2 * norm * float(into_b.error());
      if (distance - support_a.bound - support_b.bound > slack) return true;

      const Direction p = a_.point(support_a), q = b_.point(support_b);
      Direction towards;
      for (int i = 0; i < 3; ++i) towards[i] = linear[i][0] * p[0] + linear[i][1] * p[1] + linear[i][2] * p[2] + t[i] - q[i] - m[i];
      const float square = towards[0] * towards[0] + towards[1] * towards[1] + towards[2] * towards[2];
      const float along = -(m[0] * towards[0] + m[1] * towards[1] + m[2] * towards[2]);
      if (!(along > 0)) return false;
      const float share = std::min(1.0f, along / square);
      for (int i = 0; i < 3; ++i) m[i] += share * towards[i];
    }
    return false;
  }

  /// The sum of all magnitudes: each row and column of the matrix sums to less.
  static float norm_of(const float (&m)[3][3])
  {
    float sum = 0;
    for (const auto& row : m) sum += std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]);
    return sum;
  }

  Support_table a_, b_;
  Direction direction_{};
};

}  // namespace tetracone::tetratree

#endif
