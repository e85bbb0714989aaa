#ifndef TETRACONE_TETRATREE_PAPER_TETRA_TREE_H
#define TETRACONE_TETRATREE_PAPER_TETRA_TREE_H

#include "tetracone/covering/model.h"
#include "tetracone/kernel/bound/bound_box.h"
#include "tetracone/kernel/bound/bounds.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/tetratree/paper/bounding_tetrahedron.h"
#include "tetracone/tetratree/paper/classification.h"
#include "tetracone/tetratree/paper/config.h"
#include "tetracone/tetratree/paper/regular_hull.h"
#include "tetracone/tetratree/paper/tetra_cone.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace tetracone::tetratree {

using covering::Covering_triangle;
using covering::Index;

/// A node of a tetra-tree: a tetra-cone, the tetrahedra classified in it, and their bounds. The root is no cone but all
/// of space.
template <class B>
struct Node {
  Tetra_cone cone{};
  int level = 0;                               ///< 0: the root; 1: an octant
  kernel::Ball<B> sphere;                      ///< bounding sphere (JS08 Definition 6)
  kernel::Bound_tetrahedron<B> tetrahedron{};  ///< bounding tetrahedron V0 V'1 V'2 V'3 (Definition 5); none in the root
  B volume = 0;                                ///< of the bounding tetrahedron; infinite in the root
  bool is_leaf = true;
  bool has_children = false;                   ///< false in a leaf, and until a query asks for them
  Index first_child = 0, child_count = 0;      ///< cones in which nothing is classified have no node
  std::size_t begin = 0, end = 0;              ///< its tetrahedra
  std::size_t edges_begin = 0, edges_end = 0;  ///< in a leaf: the real edges on them
  std::size_t faces_begin = 0, faces_end = 0;  ///< in a leaf: their faces
};

/// The tetra-tree of a polyhedron over kernel K (JS08 section 2.2, Definition 4): a tree of tetra-cones from one
/// origin, eight octants and then four children each. Every cone has the tetrahedra of the covering that meet it, a
/// bounding tetrahedron and a bounding sphere (section 2.3). The classification uses K's signs. The bounds are in K's
/// bound arithmetic, rounded outward where K has exact signs.
///
/// Departures from the paper: a cone in which nothing is classified has no node. Nodes can be made on demand (see
/// `Config`), and can have oriented boxes (`Config::boxes`). The regular hull is that of all leaves (see
/// `Regular_hull`). A tree with nodes on demand changes during queries: it belongs to one thread.
template <class K>
class Tetra_tree {
 public:
  using B = typename kernel::Kernel_traits<K>::Bound;
  static constexpr bool sound = kernel::Kernel_traits<K>::exact_signs;

  /// Builds the tree. Requires planar faces, and at least one; the polyhedron may have any other defect that `check`
  /// can find.
  explicit Tetra_tree(const covering::Polyhedron& polyhedron, const Config& config = {})
      : model_(polyhedron),
        config_(config),
        origin_(kernel::bound_point<B>(model_.lattice().origin)),
        seen_(model_.vertices().size(), 0),
        edge_seen_(model_.covering().edges().size(), 0),
        face_seen_(model_.face_count(), 0)
  {
    const std::size_t count = triangles().size();
    assert(count > 0);
    if (config_.depth == Config::by_size)
      config_.depth = std::ceil(std::log2(double(kernel::maximum(count, std::size_t{4}))) / 2);
    config_.depth = std::clamp(config_.depth, 0, kernel::max_cone_depth);

    elements_.resize(count);
    for (std::size_t i = 0; i < count; ++i) elements_[i] = i;
    Node<B> root;
    root.end = count;
    const auto points = vertices_of(root);
    root.sphere = bounding_sphere(points);
    add_box(points);
    radius_ = kernel::enclosing_ball<B, sound>(origin_, points).radius;
    root.volume = std::numeric_limits<B>::infinity();
    root.is_leaf = config_.depth == 0;
    if (root.is_leaf) collect_leaf(root);
    nodes_.push_back(root);
    if (!config_.on_demand)
      for (Index n = 0; n < nodes_.size(); ++n) make_children(n);
  }

  const covering::Model<K>& model() const { return model_; }
  const Config& config() const { return config_; }

  static constexpr Index root() { return 0; }
  const Node<B>& node(Index n) const { return nodes_[n]; }
  /// Returns a node's oriented box. Requires `Config::boxes`.
  const kernel::Bound_box<B>& box(Index n) const { return boxes_[n]; }

  /// Returns the number of nodes that exist: all or, on demand, those that queries have made so far.
  std::size_t node_count() const { return nodes_.size(); }

  /// Returns the bytes of the tree, except the model's.
  std::size_t bytes() const
  {
    return nodes_.capacity() * sizeof(Node<B>) + boxes_.capacity() * sizeof(kernel::Bound_box<B>) +
           (elements_.capacity() + edges_.capacity() + faces_.capacity()) * sizeof(Index);
  }

  /// Returns a node that is no leaf with its children, which are made if necessary. Their numbers are first_child ...
  /// first_child + child_count - 1. The reference lasts until more nodes are made.
  const Node<B>& with_children(Index n)
  {
    if (!nodes_[n].has_children) make_children(n);
    return nodes_[n];
  }

  /// Returns the tetrahedra classified in a node, as numbers of triangles of the covering.
  std::span<const Index> elements(const Node<B>& node) const { return part(elements_, node.begin, node.end); }
  /// Returns the real edges classified in a leaf; `faces` returns the faces.
  std::span<const Index> edges(const Node<B>& leaf) const { return part(edges_, leaf.edges_begin, leaf.edges_end); }
  std::span<const Index> faces(const Node<B>& leaf) const { return part(faces_, leaf.faces_begin, leaf.faces_end); }

  /// Upper bound of the magnitude of every coordinate of vertices and bounding tetrahedra: no edge of one is longer
  /// than 4 * sqrt(3) radii.
  B reach() const
  {
    return kernel::maximum(std::abs(origin_[0]), std::abs(origin_[1]), std::abs(origin_[2])) + 8 * radius_;
  }

  const kernel::Bound_point<B>& origin() const { return origin_; }

  /// Returns the regular hull of the tree as it is.
  Regular_hull<B, sound> regular_hull() const
  {
    B longest = -1;
    int level = config_.depth;
    if (!config_.on_demand) {
      level = 1;
      for (const Node<B>& node : nodes_) {
        if (!node.is_leaf || node.level == 0) continue;
        level = kernel::maximum(level, node.level);
        for (int i = 1; i < 4; ++i)
          longest = kernel::maximum(
              longest, std::sqrt(kernel::squared_length(kernel::difference(node.tetrahedron[i], node.tetrahedron[0]))));
      }
    }
    return {origin_, level, longest, radius_};
  }

 private:
  std::span<const Covering_triangle> triangles() const { return model_.covering().triangles(); }

  static std::span<const Index> part(const std::vector<Index>& of, std::size_t begin, std::size_t end)
  {
    return std::span(of).subspan(begin, end - begin);
  }

  // Returns each vertex of the classified tetrahedra once, without the origin.
  std::vector<kernel::Bound_point<B>> vertices_of(const Node<B>& node)
  {
    std::vector<kernel::Bound_point<B>> points;
    ++now_;
    for (std::size_t i = node.begin; i < node.end; ++i)
      for (const Index v : triangles()[elements_[i]].corner) {
        if (seen_[v] == now_) continue;
        seen_[v] = now_;
        points.push_back(kernel::bound_point<B>(model_.vertices()[v]));
      }
    return points;
  }

  kernel::Ball<B> bounding_sphere(const std::vector<kernel::Bound_point<B>>& points) const
  {
    auto centre = kernel::centroid<B>(points);
    if (config_.sphere_centre == Sphere_centre::improved) centre = kernel::improved_centre<B>(centre, points, 24);
    return kernel::enclosing_ball<B, sound>(centre, points);
  }

  void add_box(std::span<const kernel::Bound_point<B>> points)
  {
    if (config_.boxes) boxes_.push_back(kernel::bound_box<B>(points));
  }

  /// Makes the children of node n, unless it is a leaf.
  void make_children(Index n)
  {
    if (nodes_[n].is_leaf) return;
    const Node<B> parent = nodes_[n];
    const Index first = static_cast<Index>(nodes_.size());
    const int count = parent.level == 0 ? 8 : 4;
    for (int k = 0; k < count; ++k) {
      Node<B> child;
      child.cone = parent.level == 0 ? Tetra_cone::octant(k) : parent.cone.child(k);
      child.level = parent.level + 1;
      classify_into(child, parent);
      if (child.begin == child.end) continue;
      bound(child);
      child.is_leaf = child.level == config_.depth || child.end - child.begin <= config_.leaf_size;
      if (child.is_leaf) collect_leaf(child);
      nodes_.push_back(child);
    }
    nodes_[n].has_children = true;
    nodes_[n].first_child = first;
    nodes_[n].child_count = static_cast<Index>(nodes_.size()) - first;
  }

  /// Sets the child's tetrahedra: the parent's tetrahedra that meet its cone.
  void classify_into(Node<B>& child, const Node<B>& parent)
  {
    using Fixed = typename kernel::Kernel_traits<K>::Fixed;
    const Cone_points<Fixed> cone(model_.lattice(), child.cone);
    const auto point = [this](Index v) -> decltype(auto) {
      if constexpr (std::is_same_v<K, Fixed>)
        return (model_.point(v));
      else
        return kernel::point<Fixed>(model_.vertices()[v]);
    };
    child.begin = elements_.size();
    for (std::size_t i = parent.begin; i < parent.end; ++i) {
      const Index element = elements_[i];
      const auto& corner = triangles()[element].corner;
      if (classify<Fixed>(cone, point(corner[0]), point(corner[1]), point(corner[2])) != Classified::no)
        elements_.push_back(element);
    }
    child.end = elements_.size();
  }

  /// Sets the child's bounding volumes.
  void bound(Node<B>& child)
  {
    const auto points = vertices_of(child);
    child.sphere = bounding_sphere(points);
    add_box(points);
    const B radius = kernel::enclosing_ball<B, sound>(origin_, points).radius;
    std::vector<kernel::Bound_point<B>> relative;
    relative.reserve(points.size());
    for (const auto& p : points) relative.push_back(kernel::difference(p, origin_));
    const kernel::Cone_coordinates<B, sound> coordinates(child.cone.ray, B(model_.lattice().step), relative, radius);
    const auto length = bounding_tetrahedron(coordinates, config_);
    child.tetrahedron[0] = origin_;
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis)
        child.tetrahedron[i + 1][axis] =
            origin_[axis] + length[i] * (B(model_.lattice().step) * B(child.cone.ray[i][axis]));
    child.volume = coordinates.volume(length);
  }

  /// Sets a leaf's real edges and faces.
  void collect_leaf(Node<B>& leaf)
  {
    ++now_;
    leaf.edges_begin = edges_.size();
    leaf.faces_begin = faces_.size();
    for (std::size_t i = leaf.begin; i < leaf.end; ++i) {
      const Covering_triangle& triangle = triangles()[elements_[i]];
      for (const Index edge : triangle.edge) {
        if (edge == covering::none || edge_seen_[edge] == now_) continue;
        edge_seen_[edge] = now_;
        edges_.push_back(edge);
      }
      if (face_seen_[triangle.face] == now_) continue;
      face_seen_[triangle.face] = now_;
      faces_.push_back(triangle.face);
    }
    leaf.edges_end = edges_.size();
    leaf.faces_end = faces_.size();
  }

  covering::Model<K> model_;
  Config config_;
  kernel::Bound_point<B> origin_;
  B radius_ = 0;  // of the sphere about the origin that holds every vertex
  std::vector<Node<B>> nodes_;
  std::vector<kernel::Bound_box<B>> boxes_;      // of the nodes, if the config asks for them
  std::vector<Index> elements_, edges_, faces_;  // of all nodes, one after the other

  // Marks of one pass over a node's elements: x is seen when seen_[x] == now_.
  std::uint64_t now_ = 0;
  std::vector<std::uint64_t> seen_, edge_seen_, face_seen_;
};

}  // namespace tetracone::tetratree

#endif
