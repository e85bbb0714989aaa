#ifndef TETRACONE_TETRATREE_WIDE_TREE_H
#define TETRACONE_TETRATREE_WIDE_TREE_H

#include "covering/model.h"
#include "kernel/kernels.h"
#include "kernel/oriented_box.h"
#include "kernel/relative_frame.h"
#include "tetratree/wide_node.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace tetracone::tetratree {

using covering::Face_triangle;
using covering::Index;

/// What a leaf holds: a triangle, or a whole face that has not been triangulated.
struct Element {
  Index face;
  std::array<Index, 3> corner;  ///< corner[0] == covering::none: the whole face
  bool is_whole_face() const { return corner[0] == covering::none; }
};

/// The fast tree of the adaptive kernel: eight boxes a node, one element a leaf.
///
/// What is kept of the tetra-tree of JS08: a covering with one origin, elements gathered by tetra-cones about it, a bounding volume a
/// cone, and the pairwise descent of two trees. What is different, and why:
///  - an element is in the one cone that holds its centroid, not in all that it meets: nothing is tested twice;
///  - the first two levels are cones (octants, and their four parts); below them a cone's elements are split where they spread most, which is
///    in depth where layers of the surface lie behind one another (the shells of a cone) and across it elsewhere;
///  - the bounding volume is an oriented box, which is tight on a patch of surface where a tetrahedron from the origin is not;
///  - nodes have eight parts, so that one box is compared with eight at once, in float, rounded outward.
/// Faces are triangles, or are given as triangles with the polyhedron; others are leaves as a whole.
///
/// A node's children are made when a query first enters it, or all at once by `make_all`. Not for two threads at a time until then.
class Wide_tree {
 public:
  using Adaptive = kernel::Adaptive;

  /// `triangles`: for each face that has some, triangles that cover exactly the face. Requires planar faces.
  explicit Wide_tree(const covering::Polyhedron& polyhedron, std::span<const Face_triangle> triangles = {}) : model_(polyhedron)
  {
    collect_elements(polyhedron, triangles);
    choose_units();
    order_.resize(elements_.size());
    std::iota(order_.begin(), order_.end(), Index(0));
    for (const Element& element : elements_) centroids_.push_back(centroid(element));
    make_root();
  }

  const covering::Model<Adaptive>& model() const { return model_; }
  const kernel::Local_units& units() const { return units_; }
  bool empty() const { return elements_.empty(); }

  /// A vertex in local units, off by at most 2^-52 in a coordinate.
  kernel::Vector local(Index v) const
  {
    const auto& vertex = model_.vertices()[v];
    kernel::Vector p;
    for (int k = 0; k < 3; ++k) p[k] = (0.5 * vertex[k] - 0.5 * units_.origin[k]) / (0.5 * units_.unit);
    return p;
  }

  const Wide_node* nodes() const { return nodes_.data(); }
  const Wide_node& node(Index n) const { return nodes_[n]; }

  /// The node of lane `lane` of node `n`, made now if it has to be. Requires a lane of more than one element. Nodes may move.
  Index child(Index n, int lane)
  {
    if (nodes_[n].child[lane] < 0) {
      const Index made = make_node(nodes_[n].first[lane], Wide_node::last_of(nodes_[n].child[lane]), depths_[n] + 1);
      nodes_[n].child[lane] = std::int32_t(made);
    }
    return Index(nodes_[n].child[lane]);
  }

  bool is_leaf(Index n, int lane) const { return nodes_[n].child[lane] == Wide_node::leaf; }
  const Element& element(Index n, int lane) const { return elements_[order_[nodes_[n].first[lane]]]; }

  /// Calls what(v) for every corner v of the element.
  template <class What>
  void for_vertices(const Element& element, const What& what) const
  {
    if (element.is_whole_face())
      for (const Index v : model_.covering().from(element.face)) what(v);
    else
      for (const Index v : element.corner) what(v);
  }

  /// Makes every node: from then on nothing changes.
  void make_all()
  {
    for (Index n = 0; n < nodes_.size(); ++n)
      for (int lane = 0; lane < nodes_[n].boxes.lane_count; ++lane)
        if (!is_leaf(n, lane)) child(n, lane);
    nodes_.shrink_to_fit();
    // Only making nodes needs these.
    depths_ = std::vector<std::uint8_t>();
    centroids_ = std::vector<std::array<float, 3>>();
    gathered_ = std::vector<Vector>();
  }

  std::size_t node_count() const { return nodes_.size(); }
  std::size_t element_count() const { return elements_.size(); }

  /// Without the model.
  std::size_t bytes() const
  {
    return nodes_.capacity() * sizeof(Wide_node) + depths_.capacity() + elements_.capacity() * sizeof(Element) + order_.capacity() * sizeof(Index) +
           centroids_.capacity() * sizeof(centroids_[0]);
  }

 private:
  using Vector = kernel::Vector;

  void collect_elements(const covering::Polyhedron& polyhedron, std::span<const Face_triangle> triangles)
  {
    std::vector<bool> has_triangles(polyhedron.face_count(), false);
    for (const Face_triangle& t : triangles) {
      has_triangles[t.face] = true;
      elements_.push_back({t.face, t.corner});
    }
    for (Index f = 0; f < polyhedron.face_count(); ++f) {
      if (has_triangles[f]) continue;
      const auto loop = polyhedron.loop(f, 0);
      const bool is_triangle = polyhedron.is_triangle(f) && model_.covering().spanning(f);
      elements_.push_back({f, is_triangle ? std::array{loop[0], loop[1], loop[2]} : std::array{covering::none, covering::none, covering::none}});
    }
    elements_.shrink_to_fit();
  }

  /// The unit is a power of two, so that local coordinates are the model's but for the rounding of a difference. Halves, since a
  /// difference of the largest doubles overflows.
  void choose_units()
  {
    units_.origin = model_.lattice().origin;
    double half_reach = 0;
    for (const auto& v : model_.vertices())
      for (int k = 0; k < 3; ++k) half_reach = std::max(half_reach, std::abs(0.5 * v[k] - 0.5 * units_.origin[k]));
    units_.unit = half_reach > 0 ? std::ldexp(1.0, std::clamp(std::ilogb(half_reach) + 2, -1000, 1023)) : 1;
  }

  template <class What>
  void for_corners(const Element& element, const What& what) const
  {
    for_vertices(element, [&](Index v) { what(local(v)); });
  }

  std::array<float, 3> centroid(const Element& element) const
  {
    Vector sum = Vector::Zero();
    int count = 0;
    for_corners(element, [&](const Vector& p) { sum += p, ++count; });
    sum /= count;
    return {float(sum[0]), float(sum[1]), float(sum[2])};
  }
  Vector centroid_of(Index position) const
  {
    const auto& c = centroids_[order_[position]];
    return {c[0], c[1], c[2]};
  }

  /// Elements first .. last of the order, and how far they spread.
  struct Part {
    Index first, last;
    double size;
    Vector mean, axis;
  };

  Part part(Index first, Index last)
  {
    gathered_.clear();
    for (Index k = first; k < last; ++k) gathered_.push_back(centroid_of(k));
    const kernel::Spread spread(gathered_);
    Part part{first, last, last - first > 1 ? std::max(spread.size(), 1e-300) : 0, spread.mean, Vector::Unit(0)};
    if (last - first > 1) part.axis = spread.principal();
    return part;
  }

  /// Splits where the part spreads most, at its mean; in the middle of the order where all are on one side.
  Index split(const Part& part)
  {
    const auto begin = order_.begin() + part.first, end = order_.begin() + part.last;
    const auto middle = std::partition(begin, end, [&](Index e) {
      const auto& c = centroids_[e];
      return part.axis.dot(Vector(c[0], c[1], c[2]) - part.mean) < 0;
    });
    if (middle == begin || middle == end) return part.first + (part.last - part.first) / 2;
    return Index(middle - order_.begin());
  }

  /// Sorts the range by cone and returns the ends of the groups that are not empty.
  template <class Cone>
  std::vector<Index> by_cone(Index first, Index last, int cones, const Cone& cone)
  {
    std::vector<Index> ends;
    for (int k = 0; k < cones; ++k) {
      const auto begin = order_.begin() + first, end = order_.begin() + last;
      const auto middle = std::partition(begin, end, [&](Index e) { return cone(centroids_[e]) == k; });
      if (middle == begin) continue;
      first = Index(middle - order_.begin());
      ends.push_back(first);
    }
    return ends;
  }

  static int octant(const std::array<float, 3>& c) { return (c[0] < 0) | (c[1] < 0) << 1 | (c[2] < 0) << 2; }

  /// Of the octant's four parts by the midpoints of its edges: 0, 1, 2 at the axes, 3 in the middle.
  static int quarter(const std::array<float, 3>& c)
  {
    const float sum = std::abs(c[0]) + std::abs(c[1]) + std::abs(c[2]);
    for (int k = 0; k < 3; ++k)
      if (2 * std::abs(c[k]) > sum) return k;
    return 3;
  }

  void make_root()
  {
    if (elements_.empty()) return;
    // One lane that holds everything.
    nodes_.push_back(node_of({part(0, Index(elements_.size()))}));
    depths_.push_back(0);
  }

  Index make_node(Index first, Index last, int depth)
  {
    std::vector<Index> ends = {last};
    if (depth == 1) ends = by_cone(first, last, 8, octant);
    if (depth == 2) ends = by_cone(first, last, 4, quarter);
    std::vector<Part> parts;
    for (const Index end : ends) {
      parts.push_back(part(first, end));
      first = end;
    }
    while (parts.size() < 8) {
      const auto largest = std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.size < b.size; });
      if (largest->last - largest->first < 2) break;
      const Part whole = *largest;
      const Index middle = split(whole);
      *largest = part(whole.first, middle);
      parts.insert(largest + 1, part(middle, whole.last));
    }
    // By a fifth, not twofold: nodes are most of the memory.
    if (nodes_.size() == nodes_.capacity()) nodes_.reserve(nodes_.size() + nodes_.size() / 5 + 8);
    nodes_.push_back(node_of(parts));
    depths_.push_back(std::uint8_t(std::min(depth, 250)));
    return Index(nodes_.size() - 1);
  }

  /// A node of one to eight parts.
  Wide_node node_of(const std::vector<Part>& parts) const
  {
    Wide_node node{};
    node.boxes.lane_count = int(parts.size());
    struct Lane {
      kernel::Oriented_box box;
      std::vector<Vector> points;
    };
    std::vector<Lane> all;
    Vector low = Vector::Constant(4), high = -low;
    for (const Part& part : parts) {
      std::vector<Vector> points;
      for (Index k = part.first; k < part.last; ++k)
        for_corners(elements_[order_[k]], [&](const Vector& p) { points.push_back(p); });
      const bool triangle = points.size() == 3;
      const auto box = triangle ? kernel::triangle_box(std::span<const Vector, 3>(points.data(), 3)) : kernel::fitted_box(points, 5);
      low = low.cwiseMin(box.centre), high = high.cwiseMax(box.centre);
      all.push_back({box, std::move(points)});
    }
    // Exact in float, and so in double.
    Vector origin;
    for (int k = 0; k < 3; ++k) origin[k] = node.boxes.origin[k] = float(0.5 * (low[k] + high[k]));
    double reach = 0;
    for (std::size_t lane = 0; lane < parts.size(); ++lane) {
      node.first[lane] = parts[lane].first;
      node.child[lane] = parts[lane].last - parts[lane].first == 1 ? Wide_node::leaf : Wide_node::not_made(parts[lane].last);
      // A local coordinate is a difference and a power of two: one rounding, of at most 2.
      kernel::store_lane(node.boxes, int(lane), all[lane].box, origin, all[lane].points, 0x1p-52);
      double sum = 0, square = 0;
      for (int i = 0; i < 3; ++i) sum += node.boxes.extent[i][lane], square += double(node.boxes.centre[i][lane]) * node.boxes.centre[i][lane];
      reach = std::max(reach, sum + std::sqrt(square));
    }
    node.boxes.reach = float(reach * 1.0000002);
    return node;
  }

  covering::Model<Adaptive> model_;
  kernel::Local_units units_;
  std::vector<Element> elements_;
  std::vector<Index> order_;
  std::vector<std::array<float, 3>> centroids_;
  std::vector<Wide_node> nodes_;
  std::vector<std::uint8_t> depths_;
  std::vector<Vector> gathered_;
};

}  // namespace tetracone::tetratree

#endif
