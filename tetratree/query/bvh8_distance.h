#ifndef TETRACONE_TETRATREE_QUERY_BVH8_DISTANCE_H
#define TETRACONE_TETRATREE_QUERY_BVH8_DISTANCE_H

#include "tetracone/covering/inclusion.h"
#include "tetracone/covering/union_find.h"
#include "tetracone/kernel/bound/common_frame.h"
#include "tetracone/kernel/bound/obb8_distance.h"
#include "tetracone/kernel/bound/triangle_distance.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/kernel/predicate/enclosed_distance.h"
#include "tetracone/kernel/predicate/face_distance.h"
#include "tetracone/tetratree/query/bvh8_collision.h"
#include "tetracone/tetratree/query/exact_vertices.h"
#include "tetracone/tetratree/query/pair_queue.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// The nearest points of two placed bodies, exactly.
struct Nearest_pair {
  kernel::Rational square;                               ///< the distance squared
  std::array<std::array<kernel::Rational, 3>, 2> point;  ///< one in each body
  std::array<std::optional<Index>, 2> face;              ///< the face that holds the point; nothing inside the solid
  std::array<kernel::Rational, 3> direction;             ///< from A's point to B's, of any length
};

/// The distance of two placed `Bvh8` over kernel K. Build once, ask for many poses.
///
/// Bodies that collide, which `Bvh8_collision` decides, have distance 0. For others, pairs of boxes are opened, roughly
/// the nearest first. That goes on while their lower bound is not above the least upper bound of a pair of triangles.
/// The first upper bounds come from the pair that was nearest in the last pose, and from the pair that the nearest
/// boxes lead to.
///
/// Distances of triangles are enclosed in double. Almost always one pair is left that may be the nearest; its distance
/// is enclosed in double-double. Exact numbers decide where that does not determine the nearest double or prove that no
/// other pair is nearer, and always for `nearest`. Over a kernel that rounds, the least distance in double is the
/// answer.
///
/// Both trees, and their models, must outlive the query object. The constructor and every query throw
/// kernel::Unsound_floating_point when floating point is not as exact answers need it.
template <class K = kernel::Adaptive>
class Bvh8_distance {
 public:
  /// True when K's signs are exact: the distance of bodies that K finds apart is then the nearest double.
  static constexpr bool is_exact = kernel::Kernel_traits<K>::exact_signs;
  /// False for the kernel that decides every pair of triangles exactly, without bounds in double.
  static constexpr bool is_filtered = !std::is_same_v<K, kernel::Rational_kernel>;

  /// `model_a` and `model_b` are the models of the trees' polyhedra.
  Bvh8_distance(const Bvh8& a, const covering::Model<K>& model_a, const Bvh8& b, const covering::Model<K>& model_b)
      : tree_{&a, &b},
        model_{&model_a, &model_b},
        collision_(a, model_a, b, model_b, Coherence::last_frame),
        exact_{Exact_vertices(a.model().vertices()), Exact_vertices(b.model().vertices())}
  {}

  /// Returns the double nearest to the distance. Requires trees with elements, det M != 0 of both poses, and closed
  /// polyhedra for `Question::solid`.
  double operator()(const Pose& pose_a, const Pose& pose_b, Question question)
  {
    if (collision_.relation(pose_a, pose_b, question) != Relation::apart) return 0;
    place(pose_a, pose_b);
    start_with_last();
    search();
    if constexpr (!is_exact) return std::ldexp(nearest_, frame_->exponent());
    bring_nearest_first();
    last_ = {candidates_.front().a, candidates_.front().b};
    if (const std::optional<double> certain = settle_by_enclosures()) return *certain;
    const Candidate best = settle(kernel::Nearest_points::are_not_asked_for);
    last_ = {best.a, best.b};
    return kernel::nearest_root(kernel::Rational(best.exact->top()), of_space(best.exact->bottom()));
  }

  /// Returns the nearest points, their faces and the exact distance. Which of several nearest pairs is returned depends
  /// on the trees and poses, not on earlier questions. Requires an exact K, and as above.
  Nearest_pair nearest(const Pose& pose_a, const Pose& pose_b, Question question)
  {
    static_assert(is_exact);
    const Relation relation = collision_.relation(pose_a, pose_b, question);
    place(pose_a, pose_b);
    if (relation == Relation::a_in_b || relation == Relation::b_in_a)
      return inside(relation == Relation::a_in_b ? 0 : 1);
    search();
    bring_nearest_first();
    return told(settle(kernel::Nearest_points::are_asked_for));
  }

  /// True when the distance is at most `limit`; false for a tree without elements. K may round. Requires det M != 0 of
  /// both poses, and closed polyhedra for `Question::solid`.
  bool within(const Pose& pose_a, const Pose& pose_b, Question question, const kernel::Rational& limit)
  {
    kernel::require_sound_floating_point();
    if (sgn(limit) < 0 || tree_[0]->empty() || tree_[1]->empty()) return false;
    place(pose_a, pose_b);
    start_with_last();
    const double below = below_limit(limit);
    low_limit_ = below * (1 - limit_rounding) - smallest;
    if (is_within() || collision_.relation(pose_a, pose_b, question) != Relation::apart) return true;
    high_ = kernel::minimum(high_, above_limit(below));
    search();
    return is_nearest_within(limit, below);
  }

  /// Returns the faces of A that have a point at most `limit` from B, in order; none for a negative limit. Requires an
  /// exact K, trees of one element a leaf, and as `within`.
  std::vector<Index> zone(const Pose& pose_a, const Pose& pose_b, Question question, const kernel::Rational& limit)
  {
    static_assert(is_exact);
    kernel::require_sound_floating_point();
    if (sgn(limit) < 0 || tree_[0]->empty() || tree_[1]->empty()) return {};
    place(pose_a, pose_b);
    const double below = below_limit(limit);
    low_limit_ = below * (1 - limit_rounding) - smallest;
    std::vector<bool> is_near(model_[0]->face_count(), false);
    std::vector<Box_id> open = {Box_id()};
    while (!open.empty()) {
      const Box_id box = open.back();
      open.pop_back();
      if (tree_[0]->is_leaf(box)) {
        const Index face = tree_[0]->element(box).face;
        if (is_near[face]) continue;
        candidates_.clear();
        along_ = {};
        high_ = above_limit(below);
        nearest_ = std::numeric_limits<double>::infinity();
        search(box);
        is_near[face] = is_nearest_within(limit, below);
        continue;
      }
      const Index child = tree_[0]->child(box);
      high_ = above_limit(below);
      const kernel::Gap_test parts = gaps_to_root(child);
      for (int lane = 0; lane < tree_[0]->node(child).boxes.lane_count; ++lane)
        if (parts.nearer >> lane & 1) open.push_back({child, lane});
    }
    if (question == Question::solid) add_inside(is_near);
    std::vector<Index> faces;
    for (Index f = 0; f < is_near.size(); ++f)
      if (is_near[f]) faces.push_back(f);
    return faces;
  }

  /// Upper bound of the relative error of a limit in common units: rounded, multiplied and added to. Proved in
  /// verify/proofs/nearest_proofs.h.
  static constexpr double limit_rounding = 4 * kernel::unit_roundoff<double>;
  /// Upper bound of the loss by underflow of a limit or a distance: the least double, times 2^200. Proved in
  /// verify/proofs/nearest_proofs.h.
  static constexpr double smallest = 0x1p-800;
  /// Upper bound of the relative error of a distance that is computed from its exact square. Proved in
  /// verify/proofs/nearest_proofs.h.
  static constexpr double distance_rounding = 8 * kernel::unit_roundoff<double>;
  /// A square up to this gives no lower bound.
  static constexpr double least_square = 0x1p-1000;
  /// Upper bound of its root and of underflow. Proved in verify/proofs/nearest_proofs.h.
  static constexpr double most_unseen = 0x1p-490;

  /// Returns the counts of work since the last `clear_counts`.
  Query_statistics counts() const
  {
    Query_statistics all = collision_.counts();
    return all += counts_;
  }
  void clear_counts()
  {
    collision_.clear_counts();
    counts_ = {};
  }
  /// Returns the bytes that it keeps between questions, except the trees'.
  std::size_t bytes() const { return collision_.bytes(); }

 private:
  /// Element k of a leaf's box.
  struct Leaf_element {
    Box_id box;
    Index k;
  };
  /// A pair of elements that may be the nearest one.
  struct Candidate {
    Leaf_element a, b;
    kernel::Triangle_gap gap;
    std::unique_ptr<kernel::Exact_distance> exact;  // null until it is needed
  };

  /// A placed triangle, cached for the element that last used its slot.
  struct Placed_triangle {
    std::uint64_t place = 0;  // the number of the placement
    Leaf_element leaf{};
    kernel::Edged_triangle at;
  };

  using Opening = Opened_pair<Box_pair>;

  /// Built from single numbers: a read of the whole right after writes of parts would stall on store forwarding.
  static Box_pair part_of(const Opening& opened, const kernel::Eight_gaps& gaps, int lane, bool is_leaf)
  {
    const Box_pair& pair = opened.pair;
    const float magnitude = gaps.size[std::size_t(lane)], size = is_leaf ? -magnitude : magnitude;
    const Box_id box(opened.node, lane);
    const bool first = opened.body == 0;
    return {gaps.low[std::size_t(lane)],
            {first ? size : pair.size[0], first ? pair.size[1] : size},
            {first ? box : pair.box[0], first ? pair.box[1] : box}};
  }

  /// Places both bodies, and forgets the bounds of the last pose.
  void place(const Pose& pose_a, const Pose& pose_b)
  {
    const kernel::Local_scale &in_a = tree_[0]->scale(), &in_b = tree_[1]->scale();
    pose_ = {&pose_a, &pose_b};
    frame_.emplace(pose_a, in_a, pose_b, in_b);
    into_other_[0].emplace(pose_b, in_b, pose_a, in_a);
    into_other_[1].emplace(pose_a, in_a, pose_b, in_b);
    exact_[0].place(pose_a, pose_b);
    exact_[1].place(pose_b, pose_a);
    for (int body = 0; body < 2; ++body) {
      const double stretch = frame_->least_stretch(body);
      // A body that is far smaller than the other gets no lower bound: in float it might round upward.
      stretch_[body] = stretch > 0x1p-60 ? float(stretch) * kernel::distance_shrink : 0;
      size_[body] = float(stretch) > 0 ? float(stretch) : 1;
    }
    ++place_;
    candidates_.clear();
    along_ = {};
    high_ = nearest_ = std::numeric_limits<double>::infinity();
    low_limit_ = -1;
  }

  /// Takes the upper bound of the pair that was nearest in the last pose.
  void start_with_last()
  {
    if (last_) compare(last_->first, last_->second);
    candidates_.clear();
  }

  const Element& element(int body, const Leaf_element& leaf) const { return tree_[body]->element(leaf.box, leaf.k); }

  /// Returns an element's placed triangle, from its slot if it is there.
  const kernel::Edged_triangle& triangle(int body, const Leaf_element& leaf, const Element& element)
  {
    Placed_triangle& slot = triangles_[std::size_t(body)][(leaf.box.number() + leaf.k) % slots];
    if (slot.place != place_ || slot.leaf.box != leaf.box || slot.leaf.k != leaf.k)
      slot = {place_, leaf,
              kernel::Double_triangle{image(body, element.corner[0]), image(body, element.corner[1]),
                                      image(body, element.corner[2])}};
    return slot.at;
  }
  kernel::Double_vector image(int body, Index v) const { return (*frame_)(body, tree_[body]->local(v).at); }

  /// Compares a pair of elements, and keeps it if it may be the nearest.
  void compare(const Leaf_element& a, const Leaf_element& b)
  {
    const Element &of_a = element(0, a), &of_b = element(1, b);
    Candidate pair{a, b, {}, nullptr};
    const bool is_bounded = frame_->position_error() < std::numeric_limits<double>::infinity();
    if (is_filtered && is_bounded && !of_a.is_whole_face() && !of_b.is_whole_face()) {
      ++counts_.triangle_tests;
      const kernel::Edged_triangle &in_a = triangle(0, a, of_a), &in_b = triangle(1, b, of_b);
      if (kernel::least_gap(in_a.corner, in_b.corner, along_, frame_->position_error(), frame_->largest()) > high_)
        return;
      pair.gap = kernel::triangle_gap(in_a, in_b, frame_->position_error(), frame_->largest(), high_);
    } else {
      pair.exact = std::make_unique<kernel::Exact_distance>(distance_of_elements(of_a, of_b));
      const double square = kernel::nearest_double(
          kernel::Rational(kernel::Rational(pair.exact->top()) / of_space(pair.exact->bottom())));
      const double distance = std::ldexp(std::sqrt(square), -frame_->exponent());
      pair.gap.nearest = distance;
      if (square > least_square && distance <= std::numeric_limits<double>::max())
        pair.gap.low = distance * (1 - distance_rounding) - smallest;
      pair.gap.high = distance * (1 + distance_rounding) + std::ldexp(most_unseen, -frame_->exponent());
    }
    if (pair.gap.low > high_) return;
    if (pair.gap.nearest < nearest_) {
      nearest_ = pair.gap.nearest;
      if constexpr (!is_exact) last_ = {a, b};
    }
    if (pair.gap.high < high_) {
      high_ = pair.gap.high;
      along_ = pair.gap.direction;
    }
    if constexpr (is_exact) candidates_.push_back(std::move(pair));
  }

  /// Returns a limit in common units, rounded; `above_limit` returns an upper bound of it.
  double below_limit(const kernel::Rational& limit) const
  {
    return std::ldexp(kernel::nearest_double(limit), -frame_->exponent());
  }
  static double above_limit(double below) { return below * (1 + limit_rounding) + smallest; }

  /// True when the nearest pair that `search` has found is within the limit.
  bool is_nearest_within(const kernel::Rational& limit, double below)
  {
    if (is_within()) return true;
    if constexpr (!is_exact) return nearest_ <= below;
    if (candidates_.empty()) return false;
    bring_nearest_first();
    const Candidate best = settle(kernel::Nearest_points::are_not_asked_for);
    return kernel::Rational(best.exact->top()) <= of_space(best.exact->bottom()) * limit * limit;
  }

  /// Adds the faces of A with a part inside B. The other faces share no point with B's surface, so that connected loops
  /// of them are on one side.
  void add_inside(std::vector<bool>& is_near)
  {
    const covering::Covering& covering = model_[0]->covering();
    covering::Union_find sets(model_[0]->vertices().size());
    const auto for_far_faces = [&](const auto& what) {
      for (Index f = 0; f < is_near.size(); ++f)
        if (!is_near[f]) what(f, covering.from(f), covering.to(f));
    };
    for_far_faces([&](Index, const auto& from, const auto& to) {
      for (std::size_t k = 0; k < from.size(); ++k) sets.join(from[k], to[k]);
    });
    std::array<covering::Placed_model<K>, 2> placed = {covering::Placed_model<K>(*model_[0]),
                                                       covering::Placed_model<K>(*model_[1])};
    for (std::size_t body = 0; body < 2; ++body) placed[body].place(*pose_[body]);
    std::vector<std::optional<bool>> is_inside(model_[0]->vertices().size());
    for_far_faces([&](Index f, const auto& from, const auto&) {
      for (const Index v : from) {
        std::optional<bool>& inside = is_inside[sets.root(v)];
        if (!inside) inside = covering::winding_number<K>(placed[0].point(v), placed[1]) != 0;
        if (*inside) is_near[f] = true;
      }
    });
  }

  /// Returns the gaps between the boxes of a node of A and B's root.
  kernel::Gap_test gaps_to_root(Index node) const
  {
    kernel::Gap_test test{&tree_[0]->node(node).boxes,
                          &*into_other_[1],
                          &tree_[1]->node(0).boxes,
                          0,
                          {stretch_[0], limit(), 0, size_[0]},
                          0,
                          {}};
    kernel::find_gaps(&test, 1);
    return test;
  }

  /// Finds all pairs of an element in a box of A and one of B that may be the nearest. It stops where the upper bound
  /// proves that the limit holds. It opens up to four pairs per round, so that their memory accesses overlap.
  void search(Box_id start = {})
  {
    const kernel::Gap_test of_start = gaps_to_root(start.node());
    const Box_pair root{of_start.gaps.low[std::size_t(start.lane())], {size_of(0, start), size_of(1, {})}, {start, {}}};
    rest_.clear();
    if (root.is_of_leaves())
      compare_leaves(root.box);
    else
      dive(root);
    queue_.clear(root.low, high_);
    for (const Box_pair& pair : rest_)
      if (pair.low <= high_) queue_.push(pair);
    while (!queue_.empty() && !is_within()) {
      std::size_t count = 0;
      while (count < open_.size() && !queue_.empty()) {
        const Box_pair next = queue_.pop();
        if (!(next.low <= high_)) continue;
        if (next.is_of_leaves())
          compare_leaves(next.box);
        else
          choose(count++, next);
      }
      compare_parts(count);
      for (std::size_t k = 0; k < count; ++k)
        for_nearer_parts(k, [this](int, const Box_pair& part) {
          fetch(part);
          queue_.push(part);
        });
    }
  }

  /// Opens pairs down to leaves, and compares the nearest leaves. Each round follows the pairs whose centres are
  /// nearest, since these lie near the surfaces. The other pairs go to `rest_`.
  void dive(const Box_pair& root)
  {
    std::array<Box_pair, kernel::most_gap_tests> best = {root};
    std::array<float, kernel::most_gap_tests> between{};
    std::optional<Box_pair> leaves;
    float between_leaves = std::numeric_limits<float>::infinity();
    for (std::size_t count = 1; count > 0;) {
      for (std::size_t k = 0; k < count; ++k) choose(k, best[k]);
      compare_parts(count);
      const std::size_t opened = std::exchange(count, 0);
      for (std::size_t k = 0; k < opened; ++k)
        for_nearer_parts(k, [&](int lane, const Box_pair& part) {
          const float centres = tests_[k].gaps.between[std::size_t(lane)];
          if (part.is_of_leaves()) {
            const bool is_nearest = centres < between_leaves;
            if (leaves || !is_nearest) rest_.push_back(is_nearest ? *leaves : part);
            if (!is_nearest) return;
            leaves = part;
            between_leaves = centres;
            return;
          }
          fetch(part);
          std::size_t place = count;
          if (count < best.size()) {
            ++count;
          } else if (centres < between.back()) {
            rest_.push_back(best[--place]);
          } else {
            rest_.push_back(part);
            return;
          }
          for (; place > 0 && centres < between[place - 1]; --place) {
            best[place] = best[place - 1];
            between[place] = between[place - 1];
          }
          best[place] = part;
          between[place] = centres;
        });
    }
    if (leaves) compare_leaves(leaves->box);
  }

  /// True when the upper bound proves that the limit holds; an unknown distance is within no limit.
  bool is_within() const { return high_ <= low_limit_ && high_ < std::numeric_limits<double>::infinity(); }

  void compare_leaves(const Box_ids& box)
  {
    for (Index i = 0; i < tree_[0]->leaf_count(box[0]); ++i)
      for (Index j = 0; j < tree_[1]->leaf_count(box[1]); ++j) compare({box[0], i}, {box[1], j});
  }

  /// Returns the signed size of a box, in the unit of sizes.
  float size_of(int body, Box_id box) const
  {
    const float size = tree_[body]->node_of(box).signed_size(box.lane());
    return std::copysign(kernel::box_size(std::abs(size), size_[body]), size);
  }

  /// Returns the body whose box is opened: the larger one.
  static int opened_body(const Box_pair& pair) { return pair.size[0] > pair.size[1] ? 0 : 1; }

  /// Upper bound of the least upper bound, in float.
  float limit() const
  {
    return high_ < 0x1p100 ? float(high_) * kernel::rounded_up + 0x1p-100f : std::numeric_limits<float>::infinity();
  }

  /// Prefetches the node that the pair will need, if it is made.
  void fetch(const Box_pair& pair) const
  {
    if (pair.is_of_leaves()) return;
    const int body = opened_body(pair);
    const Box_id box = pair.box[std::size_t(body)];
    const std::int32_t child = tree_[body]->node_of(box).child_of(box.lane());
    if (child >= 0) tree_[body]->prefetch(Index(child));
  }

  /// Prepares opening `number`, of the larger box of the pair.
  void choose(std::size_t number, const Box_pair& pair)
  {
    const int body = opened_body(pair), other = 1 - body;
    const Bvh8& tree = *tree_[std::size_t(body)];
    const Box_id kept = pair.box[std::size_t(other)];
    const Index node = tree.child(pair.box[std::size_t(body)]);
    open_[number] = {pair, body, node};
    kernel::Gap_test& test = tests_[number];
    test.boxes = &tree.node(node).boxes;
    test.map = &*into_other_[std::size_t(other)];
    test.from = &tree_[std::size_t(other)]->node_of(kept).boxes;
    test.lane = kept.lane();
    test.question = {stretch_[std::size_t(body)], 0, pair.low, size_[std::size_t(body)]};
  }

  /// Tests the parts of the first `count` openings.
  void compare_parts(std::size_t count)
  {
    const float nearest = limit();
    for (std::size_t k = 0; k < count; ++k) {
      tests_[k].question.limit = nearest;
      counts_.box_tests += std::uint64_t(tests_[k].boxes->lane_count);
    }
    counts_.pairs_visited += count;
    kernel::find_gaps(tests_.data(), count);
  }

  /// Calls what(lane, pair of the part and the other box) for the parts that are near enough.
  template <class What>
  void for_nearer_parts(std::size_t number, const What& what) const
  {
    const kernel::Gap_test& test = tests_[number];
    const std::uint32_t leaves = test.boxes->marked;
    for (unsigned nearer = test.nearer; nearer != 0; nearer &= nearer - 1) {
      const int lane = std::countr_zero(nearer);
      what(lane, part_of(open_[number], test.gaps, lane, leaves >> lane & 1));
    }
  }

  /// Returns an element in exact coordinates.
  kernel::Exact_face exact_face(int body, const Element& element)
  {
    kernel::Exact_face face;
    Exact_vertices& at = exact_[body];
    if (!element.is_whole_face()) {
      const std::array t = {at(element.corner[0]), at(element.corner[1]), at(element.corner[2])};
      for (int k = 0; k < 3; ++k) face.edges.push_back({t[k], t[(k + 1) % 3]});
      face.plane = t;
      return face;
    }
    const covering::Covering& covering = tree_[body]->model().covering();
    const auto from = covering.from(element.face), to = covering.to(element.face);
    for (std::size_t k = 0; k < from.size(); ++k) face.edges.push_back({at(from[k]), at(to[k])});
    if (const auto& basis = covering.plane_basis(element.face))
      face.plane = {at((*basis)[0]), at((*basis)[1]), at((*basis)[2])};
    return face;
  }

  kernel::Exact_distance distance_of_elements(const Element& a, const Element& b)
  {
    ++counts_.exact_fallbacks;
    return kernel::distance_of_faces(exact_face(0, a), exact_face(1, b));
  }

  /// Returns the exact images of the corners that span a feature of a triangle.
  std::vector<kernel::Exact_vector> exact_corners(int body, const Element& element, unsigned feature)
  {
    std::vector<kernel::Exact_vector> corners;
    for (std::size_t k = 0; k < 3; ++k)
      if (feature >> k & 1) corners.push_back(exact_[body](element.corner[k]));
    return corners;
  }

  /// Computes the exact distance of a pair, by the features that the enclosure has found if these are right.
  void find_exactly(Candidate& pair, kernel::Nearest_points points)
  {
    if (pair.exact) return;
    const Element &a = element(0, pair.a), &b = element(1, pair.b);
    auto found =
        kernel::distance_of_hulls(exact_corners(0, a, pair.gap.of_a), exact_corners(1, b, pair.gap.of_b), points);
    if (found && !found->is_zero()) {
      pair.exact = std::make_unique<kernel::Exact_distance>(std::move(*found));
      if (is_behind(pair, pair)) return;
    }
    pair.exact = std::make_unique<kernel::Exact_distance>(distance_of_elements(a, b));
    pair.gap.of_a = pair.gap.of_b = 0;
  }

  /// True when the gap of `best` along its direction proves that no point of the pair is nearer to the other body.
  bool is_behind(const Candidate& best, const Candidate& pair)
  {
    if (best.exact->is_zero()) return true;
    kernel::Double_vector n;
    for (std::size_t k = 0; k < 3; ++k) n[k] = best.exact->direction[k].to_double();
    return is_behind(0, best.a, best.gap.of_a, pair.a, n,
                     [&](Index v) { return kernel::dot(best.exact->direction, exact_[0](v)) <= best.exact->low; }) &&
           is_behind(1, best.b, best.gap.of_b, pair.b, kernel::negated(n),
                     [&](Index v) { return kernel::dot(best.exact->direction, exact_[1](v)) >= best.exact->high; });
  }

  /// True when no corner of an element is beyond a feature of the nearest element along n, which is rounded.
  /// `is_exactly(vertex)` decides where doubles cannot. Corners of the feature are as far as it is.
  template <class Is_exactly>
  bool is_behind(int body, const Leaf_element& nearest, unsigned feature, const Leaf_element& leaf,
                 const kernel::Double_vector& n, const Is_exactly& is_exactly)
  {
    const Element &with_feature = element(body, nearest), &asked = element(body, leaf);
    if (feature == 0 || asked.is_whole_face()) {
      bool is = true;
      tree_[body]->for_vertices(asked, [&](Index v) { is = is && is_exactly(v); });
      return is;
    }
    const auto is_of_feature = [&](Index v) {
      for (std::size_t k = 0; k < 3; ++k)
        if ((feature >> k & 1) && with_feature.corner[k] == v) return true;
      return false;
    };
    const kernel::Double_vector on = image(body, with_feature.corner[std::size_t(std::countr_zero(feature))]);
    return std::ranges::all_of(asked.corner, [&](Index v) {
      return is_of_feature(v) ||
             kernel::is_surely_before(image(body, v), on, n, frame_->position_error(), frame_->largest()) ||
             is_exactly(v);
    });
  }

  /// Removes the candidates beyond the upper bound, and moves the nearest one to the front. Ties go to the fewest
  /// corners of B's feature, then A's last element, then B's first, in whatever order candidates were found. Requires a
  /// candidate.
  void bring_nearest_first()
  {
    std::erase_if(candidates_, [this](const Candidate& c) { return c.gap.low > high_; });
    const auto first =
        std::min_element(candidates_.begin(), candidates_.end(), [](const Candidate& x, const Candidate& y) {
          return std::tuple(x.gap.nearest, std::popcount(x.gap.of_b), y.a.box, y.a.k, x.b.box, x.b.k) <
                 std::tuple(y.gap.nearest, std::popcount(y.gap.of_b), x.a.box, x.a.k, y.b.box, y.b.k);
        });
    std::swap(*first, candidates_.front());
  }

  /// Returns enclosures of the corners that span a feature.
  kernel::Ball_hull enclosed_corners(int body, const Element& element, unsigned feature) const
  {
    kernel::Ball_hull hull;
    for (std::size_t k = 0; k < 3; ++k)
      if (feature >> k & 1) hull.add(model_[body]->vertices()[element.corner[k]], *pose_[std::size_t(body)]);
    return hull;
  }

  /// Returns the distance by the features of the first candidate. Returns nothing unless enclosures prove that the
  /// distance is theirs, that no other pair is nearer, and which double is nearest.
  std::optional<double> settle_by_enclosures()
  {
    const Candidate& best = candidates_.front();
    if (best.exact) return std::nullopt;
    const auto found = kernel::enclosed_distance(enclosed_corners(0, element(0, best.a), best.gap.of_a),
                                                 enclosed_corners(1, element(1, best.b), best.gap.of_b));
    if (!found) return std::nullopt;
    const kernel::Double_vector &n = found->direction, back = kernel::negated(n);
    const auto is_exactly = [](Index) { return false; };
    for (const Candidate& pair : candidates_)
      if (!is_behind(0, best.a, best.gap.of_a, pair.a, n, is_exactly) ||
          !is_behind(1, best.b, best.gap.of_b, pair.b, back, is_exactly))
        return std::nullopt;
    return kernel::nearest_over_root(found->height, found->square);
  }

  /// Returns the nearest candidate, with its exact distance. Requires `bring_nearest_first` before.
  Candidate settle(kernel::Nearest_points points)
  {
    Candidate* best = &candidates_.front();
    find_exactly(*best, points);
    for (Candidate& pair : candidates_) {
      if (&pair == best || is_behind(*best, pair)) continue;
      find_exactly(pair, points);
      if (*pair.exact < *best->exact) best = &pair;
    }
    return std::move(*best);
  }

  /// Returns the divisor of a square in space: `bottom`, its divisor in exact coordinates, times the square of their
  /// weight.
  kernel::Rational of_space(const kernel::Exact_number& bottom) const
  {
    const kernel::Exact_number weight = exact_[0].weight();
    return kernel::Rational(bottom * weight * weight);
  }

  /// Returns the answer for a pair with its exact distance.
  Nearest_pair told(const Candidate& pair)
  {
    const kernel::Exact_distance& found = *pair.exact;
    const kernel::Rational weight(exact_[0].weight());
    Nearest_pair nearest;
    nearest.square = kernel::Rational(found.top()) / of_space(found.bottom());
    for (int body = 0; body < 2; ++body) {
      const kernel::Exact_point& on = body == 0 ? found.on_a : found.on_b;
      for (int k = 0; k < 3; ++k)
        nearest.point[body][k] = kernel::Rational(on.at[k]) / (kernel::Rational(on.weight) * weight);
      nearest.face[body] = element(body, body == 0 ? pair.a : pair.b).face;
    }
    for (int k = 0; k < 3; ++k) nearest.direction[k] = kernel::Rational(found.direction[k]);
    return nearest;
  }

  /// Returns a vertex of a shell that lies in the other's solid, for bodies whose surfaces share no point.
  Nearest_pair inside(int held)
  {
    std::array<covering::Placed_model<K>, 2> placed = {covering::Placed_model<K>(*model_[0]),
                                                       covering::Placed_model<K>(*model_[1])};
    for (int body = 0; body < 2; ++body) placed[body].place(*pose_[body]);
    const auto& covering = model_[held]->covering();
    const auto found = std::ranges::find_if(covering.shell_vertices(), [&](Index v) {
      return covering::winding_number<K>(placed[held].point(v), placed[1 - held]) != 0;
    });
    Nearest_pair nearest;
    const kernel::Rational weight(exact_[0].weight());
    for (int k = 0; k < 3; ++k)
      nearest.point[0][k] = nearest.point[1][k] = kernel::Rational(exact_[held](*found)[k]) / weight;
    for (Index f = 0; f < model_[held]->face_count() && !nearest.face[held]; ++f)
      if (std::ranges::count(covering.from(f), *found) > 0) nearest.face[held] = f;
    return nearest;
  }

  std::array<const Bvh8*, 2> tree_;
  std::array<const covering::Model<K>*, 2> model_;
  std::array<const Pose*, 2> pose_{};
  Bvh8_collision<K> collision_;
  std::array<Exact_vertices, 2> exact_;
  std::optional<kernel::Common_frame> frame_;
  std::array<std::optional<kernel::Box_map>, 2> into_other_;
  std::array<float, 2> stretch_{};  // factor of lower bounds, from a body's local units
  std::array<float, 2> size_{};     // factor of sizes, about the same number
  std::vector<Box_pair> rest_;      // pairs that a dive leaves
  Pair_queue<Box_pair, 1> queue_;
  std::array<Opening, kernel::most_gap_tests> open_;
  std::array<kernel::Gap_test, kernel::most_gap_tests> tests_;
  /// Cached triangles per body.
  static constexpr std::size_t slots = 64;
  std::uint64_t place_ = 0;  // the number of the present placement
  std::array<std::array<Placed_triangle, slots>, 2> triangles_;
  std::vector<Candidate> candidates_;
  kernel::Double_vector along_{};  // from A's point to B's, of the pair with the least upper bound
  double high_ = 0;                // least upper bound of the distance
  double nearest_ = 0;             // least computed distance
  double low_limit_ = -1;          // lower bound of the limit; -1 without one
  std::optional<std::pair<Leaf_element, Leaf_element>> last_;  // the nearest pair in the last pose
  Query_statistics counts_;
};

}  // namespace tetracone::tetratree

#endif
