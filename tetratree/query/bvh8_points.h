#ifndef TETRACONE_TETRATREE_QUERY_BVH8_POINTS_H
#define TETRACONE_TETRATREE_QUERY_BVH8_POINTS_H

#include "tetracone/kernel/bound/obb8_point.h"
#include "tetracone/kernel/bound/point_triangle.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/kernel/number/products.h"
#include "tetracone/kernel/predicate/enclosed_distance.h"
#include "tetracone/tetratree/fast/bvh8.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// The only point of a surface nearest to another, in doubles.
struct Surface_point {
  double distance;                ///< the double nearest to the distance
  std::array<double, 3> point;    ///< the doubles nearest to the nearest point
  Index face;                     ///< a face that holds it
  kernel::Feature feature;        ///< the smallest part of the face that holds it
  std::array<Index, 2> end = {};  ///< the vertex, or the ends of the edge
};

/// The point of a surface nearest to another, exactly.
struct Exact_surface_point {
  kernel::Rational square;       ///< the distance squared
  kernel::Rational_point point;  ///< one of the nearest points
  Index face;                    ///< the least face that holds it
  bool is_only;                  ///< it is the only nearest point
};

/// The points of a surface nearest to given points, through a `Bvh8`.
///
/// The descent takes nearer boxes first. Distances of triangles are enclosed in double. Mostly the triangles that may
/// be nearest share the corner or edge that holds the nearest point. Enclosures in double-double then prove that no
/// other point is as near, and which doubles are nearest. Rationals decide where they do not. One object serves one
/// thread. Requires a tree with elements, and sound floating point (`kernel::require_sound_floating_point`).
class Bvh8_points {
 public:
  /// The tree must outlive this object.
  explicit Bvh8_points(const Bvh8& tree) : tree_(&tree), per_unit_(1 / tree.scale().unit) {}

  /// Returns the nearest point if the enclosures decide it. Requires finite coordinates.
  std::optional<Surface_point> by_enclosures(const covering::Vertex& x)
  {
    search(x, 0);
    return settled();
  }

  /// Calls what(k, `by_enclosures` of point k) for each point, in order. Up to 16 points take turns, a step each,
  /// so that memory accesses of some overlap with computations of others. Requires finite coordinates.
  template <class What>
  static void by_enclosures_of_each(const Bvh8& tree, std::span<const covering::Vertex> points, const What& what)
  {
    constexpr std::size_t at_once = 16;
    std::vector<Bvh8_points> searches(kernel::minimum(at_once, points.size()), Bvh8_points(tree));
    for (std::size_t first = 0; first < points.size(); first += at_once) {
      const std::size_t count = kernel::minimum(at_once, points.size() - first);
      for (std::size_t k = 0; k < count; ++k) searches[k].begin(points[first + k], 0);
      for (unsigned under_way = (1u << count) - 1; under_way != 0;)
        for (unsigned left = under_way; left != 0; left &= left - 1) {
          const int k = std::countr_zero(left);
          if (!searches[std::size_t(k)].advance()) under_way &= ~(1u << k);
        }
      for (std::size_t k = 0; k < count; ++k) what(first + k, searches[k].settled());
    }
  }

  /// Returns a lower and an upper bound of the distance, each up to few roundings (`kernel::few_roundings`) of it. They
  /// are 0 and infinite where coordinates are too large to bound. Requires finite coordinates.
  std::array<double, 2> bounds(const covering::Vertex& x)
  {
    search(x, 0);
    double low = std::numeric_limits<double>::infinity();
    for (const Candidate& c : candidates_) low = kernel::minimum(low, c.low);
    return {low * tree_->scale().unit, high_ * tree_->scale().unit};
  }

  /// Returns the nearest point by rationals.
  Exact_surface_point exactly(const kernel::Rational_point& x)
  {
    covering::Vertex rounded;
    double greatest = 0;
    bool is_rounded = false;
    for (std::size_t k = 0; k < 3; ++k) {
      rounded[k] = kernel::nearest_double(x[k]);
      if (!std::isfinite(rounded[k])) rounded[k] = std::copysign(std::numeric_limits<double>::max(), rounded[k]);
      is_rounded = is_rounded || x[k] != kernel::Rational(rounded[k]);
      greatest = kernel::maximum(greatest, std::abs(rounded[k]));
    }
    search(rounded, is_rounded ? greatest * kernel::unit_roundoff<double> + least_double : 0);
    return settled_exactly(x);
  }

 private:
  using Rational = kernel::Rational;
  using Rational_point = kernel::Rational_point;

  /// A node whose boxes are known.
  struct Open {
    /// The squares are to be set.
    Open(Index n, int count) : node(n), left((1u << count) - 1) {}

    Index node;
    unsigned left;  // bits: its boxes that are not yet looked into
    kernel::Lane_squares squares;
  };
  /// What a search does next. The memory for it is being prefetched.
  enum class Step { open, find_corners, compare };
  /// An element that may be the nearest.
  struct Candidate {
    const Element* element;
    double low, nearest;
    unsigned corners;  // of a triangle: those that span the feature that seems nearest
  };

  const covering::Vertex& vertex(Index v) const { return tree_->model().vertices()[v]; }

  /// Returns a vertex relative to the point, in local units. The difference is rounded; the unit is a power of two.
  kernel::Double_vector relative(Index v) const { return kernel::scaled(kernel::difference(vertex(v), x_), per_unit_); }

  /// Collects the elements that may be nearest to the point. Its coordinates have an error of at most `error`.
  void search(const covering::Vertex& x, double error)
  {
    begin(x, error);
    while (advance()) continue;
  }

  /// Begins a search.
  void begin(const covering::Vertex& x, double error)
  {
    x_ = x;
    error_ = error * per_unit_;
    const kernel::Local_scale& scale = tree_->scale();
    double farthest = 0, greatest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      local_[k] = (x[k] - scale.origin[k]) * per_unit_;
      farthest = kernel::maximum(farthest, std::abs(local_[k]));
      greatest = kernel::maximum(greatest, std::abs(x[k]));
    }
    is_bounded_ = scale.is_in_range() && greatest <= 0x1p200 && farthest <= 0x1p200;
    is_local_ = is_bounded_ && farthest <= 0x1p60;
    candidates_.clear();
    high_ = std::numeric_limits<double>::infinity();
    limit_ = std::numeric_limits<float>::infinity();
    open_.clear();
    step_ = Step::open;
    next_ = 0;
  }

  /// Makes a step. False if none is left; then the candidates are all that may be nearest.
  bool advance()
  {
    switch (step_) {
      case Step::open: open_node(next_); break;
      case Step::find_corners:
        for (Index k = 0; k < tree_->leaf_count(leaf_); ++k) prefetch_corners(tree_->element(leaf_, k));
        step_ = Step::compare;
        return true;
      case Step::compare:
        for (Index k = 0; k < tree_->leaf_count(leaf_); ++k) compare(tree_->element(leaf_, k));
        break;
    }
    while (!open_.empty()) {
      Open& top = open_.back();
      const int lane = kernel::nearest_lane(top.squares, top.left, limit_);
      if (lane < 0) {
        open_.pop_back();
        continue;
      }
      top.left &= ~(1u << lane);
      const Box_id box(top.node, lane);
      if (tree_->is_leaf(box)) {
        step_ = Step::find_corners;
        leaf_ = box;
        __builtin_prefetch(&tree_->element(box));
      } else {
        step_ = Step::open;
        next_ = tree_->child(box);
        tree_->prefetch(next_);
      }
      return true;
    }
    std::erase_if(candidates_, [this](const Candidate& c) { return c.low > high_; });
    return false;
  }

  void open_node(Index n)
  {
    const Bvh8_node& node = tree_->node(n);
    Open& opened = open_.emplace_back(n, node.boxes.lane_count);
    if (is_local_)
      kernel::point_squares(node.boxes, local_, opened.squares);
    else
      opened.squares = kernel::zero_squares;
  }

  void prefetch_corners(const Element& element) const
  {
    if (element.is_whole_face()) return;
    for (const Index v : element.corner) __builtin_prefetch(&vertex(v));
  }

  /// Keeps an element that may be the nearest, and lowers the limits by it.
  void compare(const Element& element)
  {
    if (!is_bounded_) {
      candidates_.push_back({&element, 0, 0, 0});
      return;
    }
    kernel::Point_gap gap;
    if (element.is_whole_face()) {
      const double length =
                       kernel::nearest_root(nearest_on(element.face, kernel::exact_point(x_))[0].first) * per_unit_,
                   lost = error_of(length);
      gap = {length - lost, length + lost, length, 0};
    } else {
      const kernel::Double_triangle t = {relative(element.corner[0]), relative(element.corner[1]),
                                         relative(element.corner[2])};
      const double largest = largest_of(t);
      gap = kernel::point_gap(t, error_ + relative_error * largest, largest);
    }
    if (gap.low > high_) return;
    if (gap.high < high_) {
      high_ = gap.high;
      const double far = high_ + 2 * error_ + box_error, square = far * far;
      // The last summand covers underflow, and the numbers of lanes in `squares`.
      if (square < 0x1p100) limit_ = float(square) * kernel::rounded_up + 0x1p-100f;
    }
    candidates_.push_back({&element, gap.low, gap.nearest, gap.corners});
  }

  static double largest_of(const kernel::Double_triangle& t)
  {
    double largest = 0;
    for (const auto& corner : t)
      largest = kernel::maximum(largest, std::abs(corner[0]), std::abs(corner[1]), std::abs(corner[2]));
    return largest;
  }

  /// Upper bound of the error of a distance that is computed from the exact square about `x_`. Three coordinates may
  /// have an error each, and the length may underflow.
  double error_of(double length) const
  {
    return length * 4 * kernel::unit_roundoff<double> + 2 * error_ + least_double * per_unit_;
  }

  /// Returns the nearest point, if enclosures prove that it is on the feature of the nearest candidate and on no other.
  std::optional<Surface_point> settled() const
  {
    if (!is_bounded_) return std::nullopt;
    const Candidate& best = *std::ranges::min_element(candidates_, {}, &Candidate::nearest);
    if (best.element->is_whole_face()) return std::nullopt;
    kernel::Ball_hull feature;  // relative to the point
    std::array<Index, 3> ends{};
    for (std::size_t k = 0; k < 3; ++k)
      if (best.corners >> k & 1) {
        ends[std::size_t(feature.count)] = best.element->corner[k];
        feature.add_difference(vertex(best.element->corner[k]), x_);
      }
    const auto found = kernel::enclosed_distance_of_origin(feature);
    if (!found) return std::nullopt;
    const auto held = holder(*best.element, feature.count, ends);
    if (!held || !are_others_behind(found->direction, ends, feature.count)) return std::nullopt;
    const auto distance = kernel::nearest_over_root(found->height, found->square);
    if (!distance) return std::nullopt;
    Surface_point nearest{*distance, {}, best.element->face, *held, {ends[0], ends[1]}};
    const kernel::Double_double_ball share = found->height / found->square;
    for (std::size_t k = 0; k < 3; ++k) {
      const double first = vertex(ends[0])[k];
      bool is_flat = true;
      for (int i = 1; i < feature.count; ++i) is_flat = is_flat && vertex(ends[std::size_t(i)])[k] == first;
      const auto at = is_flat ? std::optional(first + 0.0)  // -0.0 is 0, as in rationals
                              : (kernel::Double_double_ball(x_[k]) + found->way[k] * share).nearest();
      if (!at) return std::nullopt;
      nearest.point[k] = *at;
    }
    return nearest;
  }

  /// Returns the part of its face that a feature of an element is. Returns nothing for a side of a triangle inside its
  /// face, on which edges may lie.
  std::optional<kernel::Feature> holder(const Element& element, int count, const std::array<Index, 3>& ends) const
  {
    if (count == 1) return kernel::Feature::vertex;
    if (count == 3) return kernel::Feature::interior;
    const covering::Covering& covering = tree_->model().covering();
    const auto from = covering.from(element.face), to = covering.to(element.face);
    for (std::size_t k = 0; k < from.size(); ++k)
      if ((from[k] == ends[0] && to[k] == ends[1]) || (from[k] == ends[1] && to[k] == ends[0]))
        return kernel::Feature::edge;
    return std::nullopt;
  }

  /// True when all corners of candidates except those of the feature are surely beyond the plane through it across the
  /// direction. Then no other point is as near.
  bool are_others_behind(const std::array<double, 3>& direction, const std::array<Index, 3>& ends, int count) const
  {
    const kernel::Double_vector back = kernel::negated(direction), on = relative(ends[0]);
    for (const Candidate& candidate : candidates_) {
      if (candidate.element->is_whole_face()) return false;
      for (const Index v : candidate.element->corner) {
        bool is_of_feature = false;
        for (int k = 0; k < count; ++k) is_of_feature = is_of_feature || vertex(v) == vertex(ends[std::size_t(k)]);
        if (is_of_feature) continue;
        const kernel::Double_vector at = relative(v);
        const double largest = largest_of({at, on, on});
        if (!kernel::is_surely_before(at, on, back, relative_error * largest, largest)) return false;
      }
    }
    return true;
  }

  /// A square of a distance, and a point of this distance.
  using Squares = std::vector<std::pair<Rational, Rational_point>>;

  /// Returns all points of a face that are nearest to x. These are the foot of the perpendicular if the face holds it,
  /// else points of its edges.
  Squares nearest_on(Index f, const Rational_point& x) const
  {
    const covering::Covering& covering = tree_->model().covering();
    const auto exact = [&](Index v) { return kernel::exact_point(vertex(v)); };
    const auto from = covering.from(f), to = covering.to(f);
    std::vector<kernel::Rational_face::Edge> edges;
    for (std::size_t k = 0; k < from.size(); ++k) edges.push_back({exact(from[k]), exact(to[k])});
    const kernel::Rational_face face(std::move(edges));
    Squares nearest;
    const auto add = [&](const Rational_point& point) { add_nearest(nearest, x, point); };
    if (face.has_plane()) {
      const Rational share = face.beyond(x) / kernel::dot(face.normal(), face.normal());
      const Rational_point foot = kernel::difference(x, kernel::scaled(face.normal(), share));
      if (face.locate(foot) != kernel::Feature::none) {
        add(foot);
        return nearest;
      }
    }
    for (const auto& [a, b] : face.edges()) {
      const Rational_point e = kernel::difference(b, a);
      const Rational length = kernel::dot(e, e), at = kernel::dot(e, kernel::difference(x, a));
      add(sgn(at) <= 0 ? a : at >= length ? b : kernel::between(a, b, at / length));
    }
    return nearest;
  }

  /// Adds a point that is as near to x as those that are there; one that is nearer replaces them.
  static void add_nearest(Squares& nearest, const Rational_point& x, const Rational_point& point)
  {
    const Rational_point way = kernel::difference(point, x);
    const Rational square = kernel::dot(way, way);
    if (!nearest.empty() && nearest[0].first < square) return;
    if (!nearest.empty() && square < nearest[0].first) nearest.clear();
    if (std::ranges::none_of(nearest, [&](const auto& known) { return known.second == point; }))
      nearest.push_back({square, point});
  }

  Exact_surface_point settled_exactly(const Rational_point& x) const
  {
    std::vector<Index> faces;
    for (const Candidate& candidate : candidates_) faces.push_back(candidate.element->face);
    std::ranges::sort(faces);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    Squares nearest;
    Index first = 0;
    for (const Index f : faces)
      for (const auto& [square, point] : nearest_on(f, x)) {
        if (nearest.empty() || square < nearest[0].first) first = f;
        add_nearest(nearest, x, point);
      }
    return {nearest[0].first, nearest[0].second, first, nearest.size() == 1};
  }

  /// Upper bound of the relative error of a coordinate of `relative`: twice its rounding. It is counted by hand, as are
  /// the next two (verify/proofs/other_constants.h).
  static constexpr double relative_error = 2 * kernel::unit_roundoff<double>;
  /// Upper bound of what rounding a coordinate loses by underflow.
  static constexpr double least_double = 0x1p-1074;
  /// Upper bound of the distance of a vertex from its box, whose local units are rounded. `point_squares` allows for
  /// the error of `local_`, which is relative.
  static constexpr double box_error = 0x1p-50;

  const Bvh8* tree_;
  double per_unit_;
  covering::Vertex x_{};
  std::array<double, 3> local_{};
  double error_ = 0, high_ = 0;
  float limit_ = 0;
  bool is_bounded_ = false, is_local_ = false;
  std::vector<Open> open_;
  Step step_ = Step::open;
  Index next_ = 0;  // the node that will be opened
  Box_id leaf_;     // whose elements will be compared
  std::vector<Candidate> candidates_;
};

}  // namespace tetracone::tetratree

#endif
