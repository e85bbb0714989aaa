#ifndef TETRACONE_TETRATREE_FAST_SUPPORT_TABLE_H
#define TETRACONE_TETRATREE_FAST_SUPPORT_TABLE_H

#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/simd/short_vectors.h"
#include "tetracone/tetratree/fast/bvh8.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// The support function of a body: an upper bound of h(d) = max d . p over its points p, in local units, in constant
/// time.
///
/// h is sublinear. So h(d) is at most a weighted sum of the values at the corners of the lattice cone that holds d. The
/// weights are d's barycentric coordinates in it. The lattice is flat, on the octahedron |x| + |y| + |z| = 1. Its cones
/// are those that JS08 section 2.1 gets by halving edges, four times. The regular hull (section 2.3.3) is made of
/// these; here it is evaluated in the directions that a query needs. A value is computed from the tree's boxes when a
/// table of the tree first asks for it.
class Support_table {
 public:
  /// The position of a direction d in the lattice. Corner 0 is number `first`, 1 the next, 2 and 3 the two beside them
  /// in the next row. Three of them have weights.
  struct Place {
    int first;
    kernel::Four_floats weight;
    kernel::Four_floats sum;  ///< |d|_1, in every lane
    kernel::Four_floats at;   ///< n d / |d|_1
  };

  /// Upper bound of the roundings between values and result, as a fraction of |d|_1. It counts 4 roundings of each
  /// coordinate of the position. It counts those of two coordinates once more, as the error of the third; h moves by no
  /// more, since |p_k| <= 1. It also counts the weights of corners of |h| <= 18/16, products, sums, and the difference
  /// from a distance. Proved in verify/proofs/separation_proofs.h.
  static constexpr float slack = 40 * 0x1p-24f;

  // The expressions, lane by lane, for the proofs: n d / |d|_1; the weight of corner 0; a corner's part of the reach.
  template <class Lanes>
  [[gnu::always_inline]] static Lanes scaled(const Lanes& d, const Lanes& sum)
  {
    return d * (float(n) / sum);
  }
  template <class Lanes>
  [[gnu::always_inline]] static Lanes weight_of_first(const Lanes& second, const Lanes& third)
  {
    return 1.0f - second - third;
  }
  template <class Lanes>
  [[gnu::always_inline]] static Lanes weighted(const Lanes& weight, const Lanes& reach, const Lanes& sum)
  {
    return weight * (reach * sum);
  }

  /// Returns the reach of a box with these axes in direction d, rounded. Extents bound points' coordinates along the
  /// axes, so nothing is added for axes that are not quite orthonormal.
  template <class Number>
  static Number reach_of_box(const std::array<Number, 3>& d, const std::array<Number, 3>& origin,
                             const std::array<Number, 3>& centre, const std::array<std::array<Number, 3>, 3>& axis,
                             const std::array<Number, 3>& extent)
  {
    using kernel::abs, std::abs;
    const auto part = [&](int k) { return d[k] * (origin[k] + centre[k]) + abs(kernel::dot(d, axis[k])) * extent[k]; };
    return part(0) + part(1) + part(2);
  }

  /// The lattice has n steps, and corners one beyond the octant, whose reach is at most 18 / 16.
  static constexpr int n = 16, row = n + 2;
  static_assert(Known_reaches::corners == 8 * row * row);

  /// Upper bound of the error of a reach in double: of a local coordinate, and of its product with a direction. Proved
  /// in verify/proofs/separation_proofs.h.
  static constexpr double reach_rounding = 6 * kernel::unit_roundoff<double>;

  /// Upper bound of the error of a box's reach in float. Proved in verify/proofs/margin_proofs.h.
  static constexpr double box_reach_rounding = 0x1p-17;

  /// `tree` must outlive the table, and its root must be made.
  explicit Support_table(const Bvh8& tree) : tree_(&tree), reach_(Known_reaches::corners, unknown) {}

  /// Returns the position of d. Requires d[3] = 0, and |d|_1, in every lane of `sum`, in 1e-30 .. 1e30. It is
  /// branchless, since the branches would be unpredictable.
  [[gnu::always_inline]] static Place place(kernel::Four_floats d, kernel::Four_floats sum)
  {
    using kernel::Eight_shorts, kernel::Four_floats, kernel::Four_ints;
    const Four_floats at = scaled(d, sum), in_octant = kernel::magnitudes(at);
    const Four_ints whole = __builtin_convertvector(in_octant, Four_ints);
    const Four_floats part = in_octant - __builtin_convertvector(whole, Four_floats);
    // The triangle has corners 0, 1 and 2 or, if a weight would be below 0, corners 3, 1 and 2.
    const Four_floats rest = weight_of_first(kernel::repeated<1>(part), kernel::repeated<2>(part));
    const Four_ints beyond = reinterpret_cast<Four_ints>(rest) & kernel::is_negative(rest);
    constexpr std::int32_t sign_bit = std::numeric_limits<std::int32_t>::min();
    const Four_floats weight = __builtin_shufflevector(rest, part, 0, 5, 6, 7) +
                               reinterpret_cast<Four_floats>(beyond ^ Four_ints{sign_bit, 0, 0, sign_bit});
    // Products of the low halves suffice for numbers up to 16.
    static_assert(std::endian::native == std::endian::little);
    const Four_ints corner =
        reinterpret_cast<Four_ints>(reinterpret_cast<Eight_shorts>(whole) * Eight_shorts{0, 0, 1, 0, row, 0, 0, 0});
    const Four_ints octant = kernel::is_negative(d) & Four_ints{row * row, 2 * row * row, 4 * row * row, 0};
    return {kernel::sum_of_lanes(corner + octant)[0], weight, sum, at};
  }

  /// Returns the position of -d: the corners opposite to d's corners, with the same weights.
  static Place opposite(const Place& p)
  {
    const int octant = p.first / (row * row);
    return {p.first + (7 - 2 * octant) * (row * row), p.weight, p.sum, -p.at};
  }

  /// Returns terms whose sum plus `slack` |d|_1 is an upper bound of h(d). The sum is infinite or undefined if a corner
  /// with a weight is unknown.
  kernel::Four_floats reach(const Place& p) const
  {
    const auto weighs = reinterpret_cast<kernel::Four_ints>(p.weight != 0.0f);
    const auto known = reinterpret_cast<kernel::Four_floats>(reinterpret_cast<kernel::Four_ints>(corners(p)) & weighs);
    return weighted(p.weight, known, p.sum);
  }

  /// True when all three corners of the triangle that holds the direction are known.
  bool knows(const Place& p) const { return kernel::sum_of_lanes(of_triangle(p, corners(p)))[0] < unknown; }

  /// Computes the unknown values at the corners of the triangle that holds the direction.
  void find(const Place& p)
  {
    const int none_of = p.weight[3] > 0 ? 0 : 3;
    for (int corner = 0; corner < 4; ++corner) {
      const int k = p.first + corner % 2 + corner / 2 * row;
      if (corner != none_of && reach_[k] == unknown)
        reach_[k] = tree_->known_reaches().at(std::size_t(first_of(k)), [this, k] { return found(k); });
    }
  }

  /// Returns the point whose products with the three weighted corners equal their values: an estimate of the body's
  /// farthest point. Requires that the corners are known.
  ///
  /// Take a point (x, y, z) with the directions' signs removed. On the face of corners 0, 1 and 2 of its octant it
  /// satisfies h_1 - h_0 = (y - x) / n and h_2 - h_0 = (z - x) / n. On the face of 3, 1 and 2 the differences are those
  /// from 2 to 3 and from 1 to 3.
  kernel::Four_floats point(const Place& p) const
  {
    using kernel::Four_floats, kernel::Four_ints;
    const Four_floats h = of_triangle(p, corners(p));
    const Four_floats below = __builtin_shufflevector(h, h, 0, 1, 2, 0) - kernel::repeated<0>(h),
                      beyond = kernel::repeated<3>(h) - __builtin_shufflevector(h, h, 3, 2, 1, 3);
    const Four_ints is_beyond = kernel::repeated<3>(p.weight) > 0.0f;
    const Four_floats step = kernel::select(is_beyond, beyond, below);
    const Four_floats x = kernel::sum_of_lanes(p.weight * h - kernel::magnitudes(p.at) * step);
    return kernel::with_signs_of(kernel::first_three(x + float(n) * step), p.at);
  }

  std::size_t bytes() const { return reach_.capacity() * sizeof(float); }

  /// Computes the reach of a node's boxes, four at once. The entries of `d` are floats.
  static void find_reach(const kernel::Obb8& boxes, const std::array<float, 3>& d,
                         std::array<float, kernel::lanes>& reach)
  {
    using Lanes = kernel::Four_floats;
    using Row = std::array<Lanes, 3>;
    const auto all = [](const auto& v) { return Row{Lanes{} + v[0], Lanes{} + v[1], Lanes{} + v[2]}; };
    const Row direction = all(d), origin = all(boxes.origin);
    for (std::size_t first = 0; first < kernel::lanes; first += 4) {
      const auto load = [first](const auto& lanes) {
        return Row{kernel::four_from(lanes[0] + first), kernel::four_from(lanes[1] + first),
                   kernel::four_from(lanes[2] + first)};
      };
      const Lanes four =
          reach_of_box(direction, origin, load(boxes.centre),
                       std::array{load(boxes.axis[0]), load(boxes.axis[1]), load(boxes.axis[2])}, load(boxes.extent));
      std::memcpy(&reach[first], &four, sizeof four);
    }
  }

 private:
  static constexpr float unknown = std::numeric_limits<float>::infinity();
  static constexpr Index none = std::numeric_limits<Index>::max();

  kernel::Four_floats corners(const Place& p) const
  {
    double first, second;  // two and two
    std::memcpy(&first, reach_.data() + p.first, sizeof first);
    std::memcpy(&second, reach_.data() + p.first + row, sizeof second);
    return reinterpret_cast<kernel::Four_floats>(kernel::Two_doubles{first, second});
  }

  /// Returns h with 0 for the corner, 0 or 3, that the triangle lacks.
  static kernel::Four_floats of_triangle(const Place& p, kernel::Four_floats h)
  {
    const kernel::Four_ints is_beyond = kernel::repeated<3>(p.weight) > 0.0f;
    return kernel::select(is_beyond, __builtin_shufflevector(h, kernel::Four_floats{}, 4, 1, 2, 3),
                          kernel::first_three(h));
  }

  /// Returns the first number of a corner that belongs to several octants: a coordinate of 0 has no sign. Corner
  /// (n - i - j, i, j) / n of an octant has the number k = (octant row + j) row + i. The last of each row, and the last
  /// rows, are corners beyond the octant; only rounding gives them a weight.
  static int first_of(int k)
  {
    const int j = k / row % row, i = k % row, has_sign = int(n - i - j != 0) | int(i != 0) << 1 | int(j != 0) << 2;
    return (k / (row * row) & has_sign) * (row * row) + k % (row * row);
  }

  static double signed_by(int negative, int k) { return negative ? -double(k) / n : double(k) / n; }

  /// Returns an upper bound of h in the direction of corner k. It visits boxes in the order of the tree, except those
  /// whose reach is not above the best so far. The vertex found last is mostly near, so it is tried first.
  float found(int k)
  {
    const int octant = k / (row * row), j = k / row % row, i = k % row;
    const kernel::Vector d(signed_by(octant & 1, n - i - j), signed_by(octant & 2, i), signed_by(octant & 4, j));
    const std::array<float, 3> in_float = {float(d[0]), float(d[1]), float(d[2])};  // exact
    double best = farthest_ == none ? -4 : d.dot(tree_->local(farthest_));
    const auto look_at = [&](Index v) {
      const double at = d.dot(tree_->local(v));
      if (at <= best) return;
      best = at;
      farthest_ = v;
    };
    std::vector<std::pair<double, Box_id>>& open = open_;
    Index node = 0;
    for (open.clear();; node = tree_->child(open.back().second), open.pop_back()) {
      const std::size_t first = open.size();
      std::array<float, kernel::lanes> reach;
      find_reach(tree_->node(node).boxes, in_float, reach);
      for (int lane = 0; lane < tree_->node(node).boxes.lane_count; ++lane) {
        const double bound = double(reach[std::size_t(lane)]) + box_reach_rounding;
        if (bound <= best) continue;
        const Box_id box(node, lane);
        if (!tree_->is_leaf(box)) {
          open.push_back({bound, box});
          continue;
        }
        for (Index e = 0; e < tree_->leaf_count(box); ++e) tree_->for_vertices(tree_->element(box, e), look_at);
      }
      // The farthest is last, to be opened first.
      std::sort(open.begin() + std::ptrdiff_t(first), open.end());
      while (!open.empty() && open.back().first <= best) open.pop_back();
      if (open.empty()) break;
    }
    return std::nextafter(float(best + reach_rounding), unknown);
  }

  const Bvh8* tree_;
  std::vector<float> reach_;  // upper bounds of h
  std::vector<std::pair<double, Box_id>> open_;
  Index farthest_ = none;  // the vertex found last
};

}  // namespace tetracone::tetratree

#endif
