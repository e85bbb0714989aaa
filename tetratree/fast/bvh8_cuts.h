#ifndef TETRACONE_TETRATREE_FAST_BVH8_CUTS_H
#define TETRACONE_TETRATREE_FAST_BVH8_CUTS_H

#include "tetracone/kernel/bound/oriented_box.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace tetracone::tetratree {

/// A pencil of planes: all across one direction or, for a cone, all through the origin and a line there. Each point has
/// one plane.
struct Pencil {
  kernel::Vector across;
  std::optional<kernel::Vector> along;  ///< for a cone: the direction into it

  /// Returns the parameter of the point's plane. Requires, for a cone, a point before the origin.
  float place(const kernel::Vector& p) const { return float(along ? across.dot(p) / along->dot(p) : across.dot(p)); }
};

/// A plane of a pencil, and the cost of a cut there.
struct Cut {
  Pencil pencil;
  float place = 0;
  double cost = std::numeric_limits<double>::infinity();
};

/// Finds the best cut of points by a pencil's planes. The cost is the sum, over both sides, of the surface of the box
/// along three axes times the root of its count (SAH). With the count itself, as for rays, or with lengths in place of
/// surfaces, trees had more boxes to compare. Points are counted in bins between planes; cuts are tried at the bins'
/// sides.
class Binned_cuts {
 public:
  using Four = kernel::Four_floats;  // along the axes; the fourth is 0

  /// Most points lie within `spread` of `middle`; those beyond go to the outermost bins. Requires spread > 0.
  Binned_cuts(const Pencil& pencil, double middle, double spread)
      : pencil_(pencil), first_(float(middle - spread)), width_(float(2 * spread / count)), per_width_(1 / width_)
  {}

  const Pencil& pencil() const { return pencil_; }

  /// Adds an element whose middle is `p`, between `low` and `high` along the axes.
  [[gnu::always_inline]] void add(const kernel::Vector& p, const Four& low, const Four& high)
  {
    const float bin = (pencil_.place(p) - first_) * per_width_;
    constexpr float last = float(count - 1);
    Side& side = bins_[bin > 0 ? std::size_t(bin < last ? bin : last) : 0];
    side.low = kernel::smaller(side.low, low);
    side.high = kernel::larger(side.high, high);
    ++side.points;
  }

  /// Adds the elements of an object with the same pencil and spread.
  void add(const Binned_cuts& other)
  {
    for (std::size_t k = 0; k < count; ++k) bins_[k].add(other.bins_[k]);
  }

  /// Returns the best cut. A side must have at least an eighth of the points: otherwise elements that span the whole
  /// part would be cut off one by one.
  Cut best() const
  {
    std::array<double, count> cost_after;
    Side after, before;
    for (std::size_t k = count; k-- > 1;) {
      after.add(bins_[k]);
      cost_after[k] = after.cost();
    }
    const int all = after.points + bins_[0].points;
    Cut best{pencil_};
    for (std::size_t k = 1; k < count; ++k) {
      before.add(bins_[k - 1]);
      const bool is_even = 8 * before.points >= all && 8 * (all - before.points) >= all;
      const double cost = before.cost() + cost_after[k];
      if (!(is_even && cost < best.cost)) continue;
      best.cost = cost;
      best.place = first_ + float(k) * width_;
    }
    return best;
  }

 private:
  struct Side {
    Four low = kernel::four_times(std::numeric_limits<float>::infinity()), high = -low;
    int points = 0;

    void add(const Side& other)
    {
      low = kernel::smaller(low, other.low);
      high = kernel::larger(high, other.high);
      points += other.points;
    }
    double cost() const
    {
      if (points == 0) return 0;
      const Four e = high - low;
      return std::sqrt(double(points)) * (e[0] * e[1] + e[1] * e[2] + e[2] * e[0]);
    }
  };

  /// Number of bins.
  static constexpr std::size_t count = 64;

  Pencil pencil_;
  float first_, width_, per_width_;
  std::array<Side, count> bins_;
};

}  // namespace tetracone::tetratree

#endif
