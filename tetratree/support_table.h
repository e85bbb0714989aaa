#ifndef TETRACONE_TETRATREE_SUPPORT_TABLE_H
#define TETRACONE_TETRATREE_SUPPORT_TABLE_H

#include "tetratree/wide_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// How far a body reaches in any direction: an upper bound of h(d) = max d . p over its points p, in local units, in constant time.
///
/// h is sublinear: with h known in the directions of a lattice, h(d) is at most the sum of the values at the corners of the lattice cone
/// that holds d, with d's barycentric weights in it. The lattice is flat, on the octahedron |x| + |y| + |z| = 1, and its cones are those that JS08
/// section 2.1 gets by halving edges, four times. This is what its regular hull (section 2.3.3) is made of, asked in the directions that a
/// query needs. A value is found when it is first asked for, from the tree's boxes.
class Support_table {
 public:
  /// What is known about a direction of the lattice.
  struct Value {
    float reach;   ///< h is at most this
    Index vertex;  ///< that reaches so far
  };

  /// What the corners of the lattice cone about a direction d tell.
  struct Support {
    float bound;  ///< h(d) is at most bound + `slack` |d|_1
    std::array<float, 3> weight;
    std::array<const Value*, 3> corner;

    /// A vertex that reaches nearly so far.
    Index vertex() const
    {
      const int larger = weight[1] > weight[0] ? 1 : 0;
      return corner[weight[2] > weight[larger] ? 2 : larger]->vertex;
    }
  };

  /// For what is rounded between values and bound: the coordinates in the lattice by 3 roundings of at most n and weights by two more, so the direction by
  /// less than 20 u of |d|_1, which moves h by no more since |p_k| <= 1; three products and sums, 6 u.
  static constexpr float slack = 32 * 0x1p-24f;

  /// `tree` must outlive the table, and its root be made.
  explicit Support_table(Wide_tree& tree) : tree_(&tree), values_(8 * (n + 1) * (n + 1), Value{0, covering::none}) {}

  /// Requires a sum of magnitudes that a float can carry, and is not 0. Without branches that no processor could foretell.
  Support operator()(const std::array<double, 3>& direction)
  {
    const float d[3] = {float(direction[0]), float(direction[1]), float(direction[2])};
    const float sum = std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]), per = n / sum, y = std::abs(d[1]) * per, z = std::abs(d[2]) * per;
    const int octant = (d[0] < 0) | (d[1] < 0) << 1 | (d[2] < 0) << 2;
    const int i = std::min(int(y), n - 1), j = std::min(int(z), n - 1 - i);
    const float u = y - float(i), v = z - float(j), rest = 1 - u - v;
    const int beyond = (rest < 0) & (i + j < n - 1);  // in the other triangle of the lattice's rhombus
    const int first = (octant * (n + 1) + i) * (n + 1) + j;
    const float beside = float(beyond) * rest;
    Support support{0, {std::max(rest - 2 * beside, 0.0f), u + beside, v + beside}, {&value(first + beyond * (n + 2)), &value(first + n + 1), &value(first + 1)}};
    for (int k = 0; k < 3; ++k) support.bound += support.weight[k] * support.corner[k]->reach;
    support.bound *= sum;
    return support;
  }

  std::size_t bytes() const { return values_.capacity() * sizeof(Value); }

 private:
  static constexpr int n = 16;

  /// Of the lattice's point (n - i - j, i, j) / n in an octant, k = (octant (n + 1) + i) (n + 1) + j.
  const Value& value(int k)
  {
    Value& value = values_[k];
    if (value.vertex == covering::none) {
      const int octant = k / ((n + 1) * (n + 1)), i = k / (n + 1) % (n + 1), j = k % (n + 1);
      value = found({signed_by(octant & 1, n - i - j), signed_by(octant & 2, i), signed_by(octant & 4, j)});
    }
    return value;
  }
  static double signed_by(int negative, int k) { return negative ? -double(k) / n : double(k) / n; }

  /// The best reach of a vertex in this direction: boxes in the order of the tree, those left out that reach no farther than what is known.
  Value found(const kernel::Vector& d)
  {
    double best = -4;
    Index at = 0;
    std::vector<std::pair<double, Index>>& open = open_;
    Index node = 0;
    for (open.clear();; node = tree_->child(open.back().second / 8, int(open.back().second % 8)), open.pop_back()) {
      const std::size_t first = open.size();
      for (int lane = 0; lane < tree_->node(node).boxes.lane_count; ++lane) {
        const double bound = box_reach(tree_->node(node).boxes, lane, d);
        if (bound <= best) continue;
        if (!tree_->is_leaf(node, lane)) {
          open.push_back({bound, 8 * node + Index(lane)});
          continue;
        }
        tree_->for_vertices(tree_->element(node, lane), [&](Index v) {
          const double reached = d.dot(tree_->local(v));
          if (reached > best) best = reached, at = v;
        });
      }
      // The farthest last, to be opened first.
      std::sort(open.begin() + std::ptrdiff_t(first), open.end());
      while (!open.empty() && open.back().first <= best) open.pop_back();
      if (open.empty()) break;
    }
    // A local coordinate is off by 2^-52, the product by less than 2^-50.
    return {std::nextafter(float(best + 0x1p-48), 2.0f), at};
  }

  /// As far as the box reaches, and for its float numbers and axes (see `Wide_boxes`) a little farther.
  static double box_reach(const kernel::Wide_boxes& boxes, int lane, const kernel::Vector& d)
  {
    double reach = 0x1p-18;
    for (int k = 0; k < 3; ++k) {
      const double along = d[0] * boxes.axis[k][0][lane] + d[1] * boxes.axis[k][1][lane] + d[2] * boxes.axis[k][2][lane];
      reach += d[k] * (double(boxes.origin[k]) + double(boxes.centre[k][lane])) + std::abs(along) * boxes.extent[k][lane];
    }
    return reach;
  }

  Wide_tree* tree_;
  std::vector<Value> values_;
  std::vector<std::pair<double, Index>> open_;
};

}  // namespace tetracone::tetratree

#endif
