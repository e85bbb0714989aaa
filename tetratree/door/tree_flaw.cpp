#include "tetracone/tetratree/door/tree_flaw.h"

#include "tetracone/kernel/bound/oriented_box.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/simd/short_vectors.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace tetracone::detail {
namespace {

using covering::Index;
using kernel::Obb8;
using kernel::Two_doubles;
using kernel::Vector;
using tetratree::Bvh8_elements;
using tetratree::Bvh8_node;

/// Upper bound of coordinates of centres and origins, and of extents, in local units. The proofs of the bounds assume 2
/// (verify/proofs/margin_proofs.h). Boxes of points within the unit cube have less: the root of 3, and roundings.
constexpr double most_coordinate = 2;

/// Upper bound of the fraction of max_k |a_k . y| by which an extent must exceed |a_i . y|. Axes of defect d need 3 d
/// (1 + 4 d). Half a d more covers all roundings here, which are below 2^-46. Stored extents have 4 d.
constexpr double defect_share = 3.5 * kernel::axis_defect;
static_assert(defect_share > 3 * kernel::axis_defect * (1 + 4 * kernel::axis_defect) + 0x1p-46 &&
              defect_share < kernel::axis_defect_factor * kernel::axis_defect);

/// Upper bound of the error of a point along an axis. A local coordinate has an error of 2^-54, since it is a rounded
/// difference below 1. A centre has an error of 2^-53, since it is a rounded sum below 2. Together they move the point
/// by the root of 3 times 3 2^-54 along an axis, which is below 1.5 2^-52. Stored extents have 2 2^-52.
constexpr double position_share = 1.5 * Bvh8_elements::local_error;
static_assert(position_share > 1.7321 * 3 * 0x1p-54 &&
              position_share < kernel::axis_norm_1 * Bvh8_elements::local_error);

/// Upper bound of the depth of a tree, so that functions that recurse from node to node stay within a stack. Cuts that
/// take single elements off are by floats of centroids. An axis has some 150 scales of floats, and a node takes seven.
constexpr int most_depth = 1000;

/// Checks one node after the other, in the order of the file.
class Tree_check {
 public:
  Tree_check(const Bvh8_elements& elements, std::span<const Bvh8_node> nodes) : elements_(elements), nodes_(nodes)
  {
    const Index count = elements.count();
    of_elements_.reserve(count, 3 * std::size_t(count));
    of_blocks_.reserve(count / block + 1, count);
    std::vector<Index> seen_in(elements.model().vertices().size(), std::numeric_limits<Index>::max());
    for (Index e = 0; e < count; ++e) {
      of_elements_.begin();
      if (e % block == 0) of_blocks_.begin();
      elements.for_vertices(elements[e], [&](Index v) {
        const Vector p = elements.local(v);
        of_elements_.add(p);
        if (std::exchange(seen_in[v], e / block) != e / block) of_blocks_.add(p);
      });
    }
    of_elements_.begin();
    of_blocks_.begin();
  }

  std::optional<std::string> flaw()
  {
    open_ = {{0, elements_.count(), 0, -1, 1}};
    for (Index n = 0; n < nodes_.size(); ++n) {
      if (open_.empty()) return "node " + std::to_string(n) + " is below no other";
      const Below below = open_.back();
      open_.pop_back();
      if (below.lane >= 0 && nodes_[below.parent].child[std::size_t(below.lane)] != std::int32_t(n))
        return at(below.parent, below.lane) + " does not lead to node " + std::to_string(n);
      if (auto wrong = flaw_of_node(n, below)) return wrong;
    }
    if (!open_.empty()) return at(open_.back().parent, open_.back().lane) + " leads to no node";
    return std::nullopt;
  }

 private:
  /// A node that is to be checked, with elements first .. last, below a lane of an earlier node.
  struct Below {
    Index first, last, parent;
    int lane;   // -1: of the root
    int depth;  // of the node
  };

  static std::string at(Index n, int lane) { return "lane " + std::to_string(lane) + " of node " + std::to_string(n); }

  static bool is_within(double x, double most) { return std::abs(x) <= most; }

  std::optional<std::string> flaw_of_node(Index n, const Below& below)
  {
    const Bvh8_node& node = nodes_[n];
    const int lanes = node.boxes.lane_count;
    // The root is one lane, and all other nodes have two or more, so there are no more nodes than elements.
    if (n == 0 ? lanes != 1 : lanes < 2 || lanes > int(kernel::lanes))
      return "node " + std::to_string(n) + " has " + std::to_string(lanes) + " lanes";
    if (below.depth > most_depth) return "node " + std::to_string(n) + " is below too many others";
    for (const float x : node.boxes.origin)
      if (!is_within(x, most_coordinate)) return "node " + std::to_string(n) + " has its origin elsewhere";
    if (!is_empty_from(node, lanes)) return "node " + std::to_string(n) + " has more than its lanes";
    for (int lane = lanes; lane-- > 0;) {
      const Index begin = node.first[std::size_t(lane)],
                  end = lane + 1 < lanes ? node.first[std::size_t(lane) + 1] : below.last;
      if (!(begin < end && end <= below.last) || (lane == 0 && begin != below.first))
        return at(n, lane) + " has other elements";
      const std::int32_t child = node.child[std::size_t(lane)];
      if (node.is_leaf(lane) ? end - begin != 1 || child > Bvh8_node::last_leaf : end - begin < 2 || child < 0)
        return at(n, lane) + " is no leaf and no other's parent";
      if (!node.is_leaf(lane)) open_.push_back({begin, end, n, lane, below.depth + 1});
      if (auto wrong = flaw_of_box(n, lane, begin, end)) return wrong;
    }
    return std::nullopt;
  }

  static bool is_empty_from(const Bvh8_node& node, int lanes)
  {
    std::uint32_t any = node.boxes.marked >> lanes;
    for (std::size_t lane = std::size_t(lanes); lane < kernel::lanes; ++lane) {
      for (int i = 0; i < 3; ++i) {
        any |= std::uint32_t(node.boxes.centre[i][lane] != 0) | std::uint32_t(node.boxes.extent[i][lane] != 0);
        for (int k = 0; k < 3; ++k) any |= std::uint32_t(node.boxes.axis[i][k][lane] != 0);
      }
      any |= std::uint32_t(node.child[lane]) | node.first[lane];
    }
    return any == 0;
  }

  std::optional<std::string> flaw_of_box(Index n, int lane, Index first, Index last) const
  {
    const Obb8& boxes = nodes_[n].boxes;
    const auto centre = kernel::centre_of(boxes, lane);
    kernel::Matrix axes;
    double sum = 0, square = 0;
    bool is_bounded = true;
    for (int i = 0; i < 3; ++i) {
      const double c = boxes.centre[i][lane], e = boxes.extent[i][lane];
      for (int k = 0; k < 3; ++k) axes(k, i) = boxes.axis[i][k][lane];
      is_bounded = is_bounded && is_within(c, most_coordinate) && is_within(centre[std::size_t(i)], most_coordinate) &&
                   e >= 0 && e <= most_coordinate;
      sum += e;
      square += c * c;
    }
    // Roundings of the root and of sums are below 2^-50; a stored reach is 2^-23 more.
    const double reach = (sum + std::sqrt(square)) * (1 + 0x1p-50);
    if (!is_bounded || !(reach <= boxes.reach && boxes.reach <= 8 * most_coordinate))
      return at(n, lane) + " has a box of other numbers than boxes have";
    if (!kernel::is_nearly_orthonormal(axes)) return at(n, lane) + " has axes that are not orthonormal";
    const Vector reached = largest(axes, Vector(centre[0], centre[1], centre[2]), first, last);
    const double margin = defect_share * kernel::maximum(reached[0], reached[1], reached[2]) + position_share;
    for (int i = 0; i < 3; ++i)
      if (!(reached[i] + margin <= double(boxes.extent[i][lane])))
        return at(n, lane) + " has a box that does not hold its elements";
    if (nodes_[n].is_leaf(lane) && !has_apex(n, lane, first))
      return at(n, lane) + " has a triangle elsewhere in its box";
    return std::nullopt;
  }

  bool has_apex(Index n, int lane, Index element) const
  {
    const kernel::Apex_code code = Bvh8_node::apex(nodes_[n].child[std::size_t(lane)]);
    if (code == 0) return true;
    const std::size_t begin = of_elements_.begins[element];
    if (of_elements_.begins[element + 1] - begin != 3) return false;
    std::array<Vector, 3> corners;
    for (std::size_t c = 0; c < 3; ++c)
      for (int k = 0; k < 3; ++k) corners[c][k] = of_elements_.at[k][begin + c];
    const auto& origin = nodes_[n].boxes.origin;
    return kernel::Apex_box(nodes_[n].boxes, lane, Vector(origin[0], origin[1], origin[2])).holds(corners, code);
  }

  /// Points in local units, one group after the other: the corners of an element, or of a block of elements.
  struct Points {
    std::vector<std::size_t> begins;  // of each group, and behind the last
    std::array<std::vector<double>, 3> at;

    void reserve(std::size_t groups, std::size_t points)
    {
      begins.reserve(groups + 1);
      for (std::vector<double>& of_axis : at) of_axis.reserve(points);
    }
    void begin() { begins.push_back(at[0].size()); }
    void add(const Vector& p)
    {
      for (int k = 0; k < 3; ++k) at[std::size_t(k)].push_back(p[k]);
    }
  };

  /// Returns max |a_i . (p - c)| over the corners of elements first .. last, for each axis. Requires finite numbers.
  Vector largest(const kernel::Matrix& axes, const Vector& centre, Index first, Index last) const
  {
    Largest most{axes, centre, {}};
    const Index first_block = (first + block - 1) / block, last_block = last / block;
    if (first_block < last_block) {
      most.take(of_elements_, first, first_block * block);
      most.take(of_blocks_, first_block, last_block);
      most.take(of_elements_, last_block * block, last);
    } else {
      most.take(of_elements_, first, last);
    }
    Vector result;
    for (std::size_t i = 0; i < 3; ++i) result[int(i)] = kernel::maximum(most.most[i][0], most.most[i][1]);
    return result;
  }

  /// The largest values so far, by two points at a time.
  struct Largest {
    const kernel::Matrix& axes;
    const Vector& centre;
    std::array<Two_doubles, 3> most;

    /// Adds groups first .. last.
    void take(const Points& points, Index first, Index last)
    {
      std::size_t k = points.begins[first];
      const std::size_t end = points.begins[last];
      const auto& [x, y, z] = points.at;
      for (; k + 2 <= end; k += 2) take({kernel::two_from(&x[k]), kernel::two_from(&y[k]), kernel::two_from(&z[k])});
      if (k < end) take({kernel::two_times(x[k]), kernel::two_times(y[k]), kernel::two_times(z[k])});
    }
    void take(const std::array<Two_doubles, 3>& p)
    {
      const std::array<Two_doubles, 3> y{p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]};
      for (std::size_t i = 0; i < 3; ++i)
        most[i] = kernel::larger(
            most[i], kernel::magnitudes(axes.col(i)[0] * y[0] + axes.col(i)[1] * y[1] + axes.col(i)[2] * y[2]));
    }
  };

  /// The elements of a block. They are near one another and share most corners, so large boxes are asked about each
  /// corner once a block.
  static constexpr Index block = 64;

  const Bvh8_elements& elements_;
  std::span<const Bvh8_node> nodes_;
  std::vector<Below> open_;
  Points of_elements_, of_blocks_;
};

}  // namespace

std::optional<std::string> tree_flaw(const Bvh8_elements& elements, std::span<const Bvh8_node> nodes)
{
  return Tree_check(elements, nodes).flaw();
}

}  // namespace tetracone::detail
