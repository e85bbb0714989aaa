#ifndef TETRACONE_TETRATREE_FAST_BVH8_CUTS_H
#define TETRACONE_TETRATREE_FAST_BVH8_CUTS_H

#include "tetracone/kernel/bound/oriented_box.h"
#include "tetracone/tetratree/fast/surface_area_heuristic.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace tetracone::tetratree {

/// A pencil of planes. Either all are perpendicular to `across`; or, for a cone, all go through one line through the
/// origin. Each point is on one of them.
struct Pencil {
  kernel::Vector across;
  std::optional<kernel::Vector> along;  ///< for a cone: the direction into it

  /// Returns the parameter of the point's plane. For a cone it is meaningless unless along . p > 0.
  float place(const kernel::Vector& p) const { return float(along ? across.dot(p) / along->dot(p) : across.dot(p)); }
};

/// A plane of a pencil, and the cost of a cut there.
struct Cut {
  Pencil pencil;
  float place = 0;
  double cost = std::numeric_limits<double>::infinity();
};

/// Finds the best cut of points by a pencil's planes, by the surface area heuristic (`sah_weight`). Points are counted
/// in bins between planes; cuts are tried at the bins' sides.
class Binned_cuts {
 public:
  using Four = Axis_bounds::Four;

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
    side.bounds.add(low, high);
    ++side.points;
  }

  /// Adds the elements of an object with the same pencil and spread.
  void add(const Binned_cuts& other)
  {
    for (std::size_t k = 0; k < count; ++k) bins_[k].add(other.bins_[k]);
  }

  /// Returns the best cut, of infinite cost if there is none. A side must have at least an eighth of the points:
  /// otherwise elements that span the whole part would be cut off one by one.
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
    Axis_bounds bounds;
    int points = 0;

    void add(const Side& other)
    {
      bounds.add(other.bounds);
      points += other.points;
    }
    double cost() const { return points == 0 ? 0 : sah_cost(sah_weight(points), bounds); }
  };

  /// Number of bins.
  static constexpr std::size_t count = 64;

  Pencil pencil_;
  float first_, width_, per_width_;
  std::array<Side, count> bins_;
};

}  // namespace tetracone::tetratree

#endif
