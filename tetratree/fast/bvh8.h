#ifndef TETRACONE_TETRATREE_FAST_BVH8_H
#define TETRACONE_TETRATREE_FAST_BVH8_H

#include "tetracone/covering/model.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/predicate/kernels.h"
#include "tetracone/kernel/bound/oriented_box.h"
#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/tetratree/fast/bvh8_node.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
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
///  - cones are cut where it pays: by a plane through the origin, which leaves two cones, or by one across the direction in which its elements
///    spread most, which parts layers of the surface that lie behind one another (the shells of a cone) and local patches;
///  - the bounding volume is an oriented box, which is tight on a patch of surface where a tetrahedron from the origin is not;
///  - nodes have eight parts, so that one box is compared with eight at once, in float, rounded outward.
/// Faces are triangles, or are given as triangles with the polyhedron; others are leaves as a whole.
///
/// A node's children are made when a query first enters it, or all at once by `make_all`. Not for two threads at a time until then.
class Bvh8 {
 public:
  using Adaptive = kernel::Adaptive;

  /// `triangles`: for each face that has some, triangles that cover exactly the face. Requires planar faces.
  explicit Bvh8(const covering::Polyhedron& polyhedron, std::span<const Face_triangle> triangles = {}) : model_(polyhedron)
  {
    collect_elements(polyhedron, triangles);
    choose_units();
    making_.stamps.resize(polyhedron.vertices.size(), 0);
    order_.resize(elements_.size());
    std::iota(order_.begin(), order_.end(), Index(0));
    for (const Element& element : elements_) making_.centroids.push_back(centroid(element));
    make_root();
  }

  const covering::Model<Adaptive>& model() const { return model_; }
  const kernel::Local_scale& units() const { return units_; }
  bool empty() const { return elements_.empty(); }

  /// How far a coordinate of `local` may be off: one rounding of a difference, of at most 1.
  static constexpr double local_error = 0x1p-52;

  /// A vertex in local units, off by at most `local_error` in a coordinate.
  kernel::Vector local(Index v) const
  {
    const auto& vertex = model_.vertices()[v];
    kernel::Vector p;
    for (int k = 0; k < 3; ++k) p[k] = (0.5 * vertex[k] - 0.5 * units_.origin[k]) * per_half_unit_;
    return p;
  }

  const Bvh8_node* nodes() const { return nodes_.data(); }
  const Bvh8_node& node(Index n) const { return nodes_[n]; }

  /// The node of lane `lane` of node `n`, made now if it has to be. Requires a lane of more than one element. Nodes may move.
  Index child(Index n, int lane)
  {
    if (nodes_[n].child[lane] < 0) {
      const Index made = make_node(nodes_[n].first[lane], Bvh8_node::last_of(nodes_[n].child[lane]));
      nodes_[n].child[lane] = std::int32_t(made);
    }
    return Index(nodes_[n].child[lane]);
  }

  bool is_leaf(Index n, int lane) const { return Bvh8_node::is_leaf(nodes_[n].child[lane]); }
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
    kernel::require_sound_floating_point();
    for (Index n = 0; n < nodes_.size(); ++n)
      for (int lane = 0; lane < nodes_[n].boxes.lane_count; ++lane)
        if (!is_leaf(n, lane)) child(n, lane);
    nodes_.shrink_to_fit();
    making_ = {};
  }

  std::size_t node_count() const { return nodes_.size(); }
  std::size_t element_count() const { return elements_.size(); }

  /// Without the model.
  std::size_t bytes() const
  {
    return nodes_.capacity() * sizeof(Bvh8_node) + elements_.capacity() * sizeof(Element) + order_.capacity() * sizeof(Index) +
           making_.bytes();
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
      const bool is_triangle = polyhedron.is_triangle(f) && model_.covering().plane_basis(f);
      elements_.push_back({f, is_triangle ? std::array{loop[0], loop[1], loop[2]} : std::array{covering::none, covering::none, covering::none}});
    }
    assert(elements_.size() <= Bvh8_node::most_elements);
    elements_.shrink_to_fit();
  }

  /// The unit is a power of two, so that local coordinates are the model's but for the rounding of a difference. Halves, since a
  /// difference of the largest doubles overflows.
  void choose_units()
  {
    units_.origin = model_.lattice().origin;
    double half_reach = 0;
    for (const auto& v : model_.vertices())
      for (int k = 0; k < 3; ++k) half_reach = kernel::maximum(half_reach, std::abs(0.5 * v[k] - 0.5 * units_.origin[k]));
    units_.unit = half_reach > 0 ? std::ldexp(1.0, std::clamp(std::ilogb(half_reach) + 2, -1000, 1023)) : 1;
    per_half_unit_ = 2 / units_.unit;
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
  static Vector vector(const std::array<float, 3>& c) { return {c[0], c[1], c[2]}; }
  Vector centroid_of(Index position) const { return vector(making_.centroids[order_[position]]); }

  /// Elements first .. last of the order, and how far their centroids spread: along the columns of `axes`, the last one the most.
  struct Part {
    Index first, last;
    double size;
    Vector mean;
    kernel::Matrix axes;
  };

  Part part(Index first, Index last)
  {
    making_.gathered.clear();
    for (Index k = first; k < last; ++k) making_.gathered.push_back(centroid_of(k));
    const kernel::Spread spread(making_.gathered);
    return {first, last, last - first > 1 ? kernel::maximum(spread.size(), 1e-300) : 0, spread.mean, spread.principal_axes()};
  }

  /// Planes, one through every point: all across one direction or, of a cone, all through the origin and a line there.
  struct Pencil {
    Vector across;
    std::optional<Vector> along;  // of a cone: into it

    /// Where the point's plane is among them. Of a cone, for points before the origin.
    float place(const Vector& p) const { return float(along ? across.dot(p) / along->dot(p) : across.dot(p)); }
  };

  struct Cut {
    Pencil pencil;
    float place = 0;
    double cost = std::numeric_limits<double>::infinity();
  };

  /// An element as cuts see it: its centroid, and its corners' bounds along the part's axes.
  struct Sample {
    Vector centroid, low, high;
  };

  /// Cuts the part in two, and returns where in the order: the boxes of both are small for what they hold. In the middle where all
  /// elements are in one place.
  Index split(const Part& part)
  {
    const Index count = part.last - part.first, middle = part.first + count / 2;
    if (count == 2) return middle;
    making_.samples.clear();
    const Index step = (count + most_samples - 1) / most_samples;
    for (Index k = part.first; k < part.last; k += step) making_.samples.push_back(sample(order_[k], part.axes));
    Cut best = best_cut({part.axes.col(2), {}});
    if (const auto cones = count > fewest_in_cones ? cones_about(part) : std::nullopt) {
      const Cut into_cones = best_cut(*cones);
      if (into_cones.cost < 1.03 * best.cost) best = into_cones;
    }
    const auto begin = order_.begin() + part.first, end = order_.begin() + part.last;
    const auto cut = std::partition(begin, end, [&](Index e) { return best.pencil.place(vector(making_.centroids[e])) < best.place; });
    return cut == begin || cut == end ? middle : Index(cut - order_.begin());
  }

  Sample sample(Index e, const kernel::Matrix& axes) const
  {
    Sample s{vector(making_.centroids[e]), Vector::Constant(8), Vector::Constant(-8)};
    for_corners(elements_[e], [&](const Vector& p) {
      const Vector along = axes.transpose() * p;
      s.low = s.low.cwiseMin(along), s.high = s.high.cwiseMax(along);
    });
    return s;
  }

  /// Planes through the origin that cut the part where it spreads most, as seen from there; none where the origin is too near.
  std::optional<Pencil> cones_about(const Part& part) const
  {
    constexpr double steep = 0.05;
    const double distance = part.mean.norm();
    if (!(distance > 0)) return {};
    const Vector along = part.mean / distance, spread = part.axes.col(2), across = spread - spread.dot(along) * along;
    if (!(across.norm() > steep)) return {};
    for (const Sample& s : making_.samples)
      if (!(s.centroid.dot(along) > steep * s.centroid.norm())) return {};
    return Pencil{across.normalized(), along};
  }

  /// Of all planes of the pencil between two samples: that of the least surface of the boxes of both sides, along the part's axes, each times the root of
  /// its count. (With the count itself, as for rays, or with lengths in place of surfaces, trees had more boxes to compare.)
  Cut best_cut(const Pencil& pencil)
  {
    const std::vector<Sample>& samples = making_.samples;
    std::vector<double>& costs_after = making_.costs_after;
    auto& order = making_.places;
    order.clear();
    for (std::size_t k = 0; k < samples.size(); ++k) order.push_back({pencil.place(samples[k].centroid), Index(k)});
    std::sort(order.begin(), order.end());
    struct Side {
      Vector low = Vector::Constant(8), high = -low;
      int count = 0;

      double cost_with(const Sample& s)
      {
        low = low.cwiseMin(s.low), high = high.cwiseMax(s.high), ++count;
        const Vector e = high - low;
        return std::sqrt(double(count)) * (e[0] * e[1] + e[1] * e[2] + e[2] * e[0]);
      }
    };
    Side before, after;
    costs_after.resize(samples.size());
    for (std::size_t k = samples.size(); k-- > 1;) costs_after[k] = after.cost_with(samples[order[k].second]);
    Cut best{pencil};
    const std::size_t fewest = samples.size() / 8;  // else elements that all reach everywhere would be cut off one by one
    for (std::size_t k = 1; k < samples.size(); ++k) {
      const double cost = before.cost_with(samples[order[k - 1].second]) + costs_after[k];
      const bool is_even = k >= fewest && k + fewest <= samples.size();
      if (is_even && cost < best.cost && order[k - 1].first < order[k].first) best.cost = cost, best.place = order[k].first;
    }
    return best;
  }

  void make_root()
  {
    if (elements_.empty()) return;
    // One lane that holds everything.
    nodes_.push_back(node_of({part(0, Index(elements_.size()))}));
  }

  Index make_node(Index first, Index last)
  {
    std::vector<Part> parts = {part(first, last)};
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
    return Index(nodes_.size() - 1);
  }

  /// The corners of the part's elements, each once.
  std::vector<Vector> corners_of(const Part& part)
  {
    std::vector<Vector> points;
    ++making_.stamp;
    for (Index k = part.first; k < part.last; ++k)
      for_vertices(elements_[order_[k]], [&](Index v) {
        if (making_.stamps[v] != making_.stamp) making_.stamps[v] = making_.stamp, points.push_back(local(v));
      });
    return points;
  }

  /// A node of one to eight parts.
  Bvh8_node node_of(const std::vector<Part>& parts)
  {
    Bvh8_node node{};
    node.boxes.lane_count = int(parts.size());
    struct Lane {
      kernel::Oriented_box box;
      std::vector<Vector> points;
    };
    std::vector<Lane> all;
    Vector low = Vector::Constant(4), high = -low;
    for (const Part& part : parts) {
      std::vector<Vector> points = corners_of(part);
      const bool triangle = points.size() == 3;
      const auto box = triangle ? kernel::triangle_box(std::span<const Vector, 3>(points.data(), 3)) : kernel::fitted_box(points, fitting_rounds);
      low = low.cwiseMin(box.centre), high = high.cwiseMax(box.centre);
      all.push_back({box, std::move(points)});
    }
    // Exact in float, and so in double.
    Vector origin;
    for (int k = 0; k < 3; ++k) origin[k] = node.boxes.origin[k] = float(0.5 * (low[k] + high[k]));
    double reach = 0;
    for (std::size_t lane = 0; lane < parts.size(); ++lane) {
      node.first[lane] = parts[lane].first;
      const std::vector<Vector>& points = all[lane].points;
      kernel::store_lane(node.boxes, int(lane), all[lane].box, origin, points, local_error);
      const bool is_leaf = parts[lane].last - parts[lane].first == 1;
      node.child[lane] = !is_leaf             ? Bvh8_node::not_made(parts[lane].last)
                         : points.size() == 3 ? Bvh8_node::leaf(kernel::apex_code(node.boxes, int(lane), origin, std::span<const Vector, 3>(points)))
                                              : Bvh8_node::leaf(0);
      double sum = 0, square = 0;
      for (int i = 0; i < 3; ++i) sum += node.boxes.extent[i][lane], square += double(node.boxes.centre[i][lane]) * node.boxes.centre[i][lane];
      reach = kernel::maximum(reach, sum + std::sqrt(square));
    }
    node.boxes.reach = float(reach * 1.0000002);
    return node;
  }

  covering::Model<Adaptive> model_;
  kernel::Local_scale units_;
  double per_half_unit_ = 2;  // of these; a power of two too
  std::vector<Element> elements_;
  std::vector<Index> order_;
  std::vector<Bvh8_node> nodes_;

  /// What only the making of nodes needs.
  struct Making {
    std::vector<std::array<float, 3>> centroids;
    std::vector<std::uint32_t> stamps;  // of vertices: when last gathered
    std::uint32_t stamp = 0;
    std::vector<Vector> gathered;
    std::vector<Sample> samples;
    std::vector<std::pair<float, Index>> places;  // of samples
    std::vector<double> costs_after;

    std::size_t bytes() const { return centroids.capacity() * sizeof(centroids[0]) + stamps.capacity() * sizeof(stamps[0]); }
  };
  Making making_;

  static constexpr Index most_samples = 1024, fewest_in_cones = 64;
  static constexpr int fitting_rounds = 8;
};

}  // namespace tetracone::tetratree

#endif
