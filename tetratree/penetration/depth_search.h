#ifndef TETRACONE_TETRATREE_PENETRATION_DEPTH_SEARCH_H
#define TETRACONE_TETRATREE_PENETRATION_DEPTH_SEARCH_H

#include "tetracone/kernel/bound/view_box.h"
#include "tetracone/kernel/contact/crossing_polytope.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/tetratree/penetration/seen_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// A bracket of the least translation that parts two solids.
struct Depth_bracket {
  kernel::Rational_point vector = {0, 0, 0};  ///< a translation that parts them
  kernel::Rational square = 0;                ///< of its length: an upper bound
  double least = 0;                           ///< lower bound of the length of every one that does
  bool is_exact = true;                       ///< no shorter one parts them
};

/// How narrow a bracket is asked for, and for how much work.
struct Depth_limits {
  double relative = 1e-9;          ///< the bracket's width over its upper end at which the search ends
  std::size_t most_boxes = 20000;  ///< boxes of translations that are looked at
};

/// The least translation of A after which the interiors of A and B share no point.
///
/// Let P be the set of translations after which they do; it is open. Exits along directions give translations that are
/// not in P, the shortest of which is the upper bound. The lower bound comes from boxes of translations, nearest to 0
/// first. A box is done where all of its translations that are shorter than the upper bound are in P:
///
/// - Two pieces, as of `Seen_solid`, cross for all translations inside their `Crossing_polytope`; so these are in P.
/// - Where no two pieces meet for any translation of the box, the surfaces do not meet. So all of its translations are
///   in P, or none is; the relation at the centre tells.
///
/// Any other box is halved. The length of the nearest open box's translations is the lower bound. If none is left, the
/// upper bound is the least. That happens where the shortest translations end at planes that are perpendicular to them:
/// half-spaces are compared exactly with the ball of all shorter translations.
class Depth_search {
 public:
  Depth_search(Seen_solid a, Seen_solid b) : solid_{std::move(a), std::move(b)} {}

  /// What an exit along a direction tells.
  struct Exit {
    kernel::Rational_point vector;                ///< the translation at the first exit
    std::vector<kernel::Rational_point> normals;  ///< of planes in which it lies
  };

  /// Returns the bracket. exit(d) returns the exit along d, and meet(v) tells whether v is in P. `map_a` and `map_b`
  /// are the poses as matrices. Requires that 0 is in P.
  template <class Leave, class Meet>
  Depth_bracket operator()(const std::array<kernel::Rational, 12>& map_a, const std::array<kernel::Rational, 12>& map_b,
                           const Leave& exit, const Meet& meet, const Depth_limits& limits)
  {
    solid_[0].see(map_a);
    solid_[1].see(map_b);
    found_ = {{0, 0, 0}, -1, 0, false};
    tried_.clear();
    for (int k = 0; k < 3; ++k)
      for (const int sign : {1, -1}) {
        kernel::Rational_point axis = {0, 0, 0};
        axis[k] = sign;
        leave(axis, exit);
      }
    boxes_left_ = limits.most_boxes;
    while (search(exit, meet, limits)) {
    }
    found_.least = kernel::minimum(found_.least, kernel::nearest_root(found_.square));
    return found_;
  }

 private:
  using Polytope = kernel::Crossing_polytope;
  using Box = kernel::Translation_box;
  using Near = std::vector<std::uint32_t>;  // numbers of polytopes

  struct Open_box {
    double least;
    unsigned halvings;
    Box box;
    std::shared_ptr<const Near> near;  // all polytopes that may meet the box
  };

  /// What the exact pieces say of an axis.
  struct Exactly {
    Depth_search* search;
    Seen_piece *a, *b;

    kernel::Number_point<kernel::Rational> direction(const kernel::Shift_axis& axis) const
    {
      return kernel::detail::direction(axis, search->solid_[0].exactly(*a), search->solid_[1].exactly(*b));
    }
    bool is_zero(const kernel::Shift_axis& axis) const { return kernel::is_zero(direction(axis)); }

    /// True when the plane of a half-space n . v < limit does not cut the open ball of all shorter translations.
    bool is_outside_ball(const kernel::Shift_axis& axis, int sign) const
    {
      const kernel::detail::Allowed<kernel::Rational> allowed(axis, search->solid_[0].exactly(*a),
                                                              search->solid_[1].exactly(*b));
      const kernel::Rational limit = sign > 0 ? allowed.high : kernel::Rational(-allowed.low);
      const auto n = direction(axis);
      return limit > 0 && limit * limit >= search->found_.square * kernel::dot(n, n);
    }
  };

  /// Asks for the exit along a direction, and along the normals of the planes that it ends at, as long as that is
  /// shorter. True when a shorter translation than all before was found.
  template <class Leave>
  bool leave(kernel::Rational_point direction, const Leave& exit)
  {
    bool is_shorter = false;
    std::vector<kernel::Rational_point> directions = {std::move(direction)};
    while (!directions.empty()) {
      const kernel::Rational_point d = scaled(directions.back());
      directions.pop_back();
      if (!tried_.insert(d).second) continue;
      const Exit found = exit(d);
      const kernel::Rational square = kernel::dot(found.vector, found.vector);
      if (found_.square >= 0 && square >= found_.square) continue;
      found_.square = square;
      found_.vector = found.vector;
      is_shorter = true;
      for (kernel::Rational_point n : found.normals) {
        if (kernel::dot(n, found.vector) < 0)
          for (kernel::Rational& x : n) x = -x;
        directions.push_back(n);
      }
    }
    return is_shorter;
  }

  /// Returns the direction with a largest component of 1 or -1, so that equal ones are equal.
  static kernel::Rational_point scaled(kernel::Rational_point d)
  {
    kernel::Rational largest = 0;
    for (const kernel::Rational& x : d) largest = abs(x) > largest ? kernel::Rational(abs(x)) : largest;
    for (kernel::Rational& x : d) x /= largest;
    return d;
  }

  /// Searches the ball of all translations that are shorter than the known one. Returns true where it has found a
  /// shorter one, and the ball is to be searched anew.
  template <class Leave, class Meet>
  bool search(const Leave& exit, const Meet& meet, const Depth_limits& limits)
  {
    double radius = std::nextafter(kernel::nearest_root(found_.square), HUGE_VAL);
    if (!(radius >= 0x1p-200 && radius <= 0x1p200)) return false;  // beyond what the boxes' numbers can bound
    const double most = std::ldexp(1.0, std::ilogb(radius) + 1);
    polytopes_.clear();
    find_polytopes(radius, most);
    auto all = std::make_shared<Near>(polytopes_.size());
    for (std::uint32_t k = 0; k < all->size(); ++k) (*all)[k] = k;
    std::vector<Open_box> open = {{0, 0, {{0, 0, 0}, {most, most, most}}, std::move(all)}};
    const auto is_later = [](const Open_box& x, const Open_box& y) { return x.least > y.least; };
    while (!open.empty()) {
      std::ranges::pop_heap(open, is_later);
      const Open_box next = std::move(open.back());
      open.pop_back();
      found_.least = kernel::maximum(found_.least, next.least);
      if (next.least >= radius * (1 - limits.relative) || boxes_left_ == 0) return false;
      --boxes_left_;
      auto near = std::make_shared<Near>();
      if (is_done(next, *near, meet)) continue;
      if (next.halvings % halvings_an_exit == 0 && next.least > 0 && leave(centre(next.box), exit)) {
        if (polytopes_.size() <= few_polytopes) return true;
        radius = std::nextafter(kernel::nearest_root(found_.square), HUGE_VAL);
      }
      const auto axis = std::size_t(std::ranges::max_element(next.box.half) - next.box.half.begin());
      for (const int side : {-1, 1}) {
        Open_box part{0, next.halvings + 1, next.box, near};
        part.box.half[axis] /= 2;
        part.box.centre[axis] += side * part.box.half[axis];
        part.least = kernel::maximum(next.least, part.box.least_length());
        if (part.least > radius) continue;
        open.push_back(std::move(part));
        std::ranges::push_heap(open, is_later);
      }
    }
    found_.least = kernel::nearest_root(found_.square);
    found_.is_exact = true;
    return false;
  }

  /// True when all of the box's translations that are shorter than the known one are in P. Else `near` has the
  /// polytopes that may meet the box.
  template <class Meet>
  bool is_done(const Open_box& open, Near& near, const Meet& meet)
  {
    for (const std::uint32_t k : *open.near) {
      if (!polytopes_[k].is_near(open.box)) continue;
      if (polytopes_[k].holds(open.box)) return true;
      if (polytopes_[k].may_meet(open.box)) near.push_back(k);
    }
    return near.empty() && are_all_known_ && meet(centre(open.box));
  }

  static kernel::Rational_point centre(const Box& box)
  {
    return {kernel::Rational(box.centre[0]), kernel::Rational(box.centre[1]), kernel::Rational(box.centre[2])};
  }

  /// Finds the polytopes of all pairs of pieces that have a translation in the ball.
  void find_polytopes(double radius, double most)
  {
    are_all_known_ = true;
    std::vector<Box_ids> pairs = {{Box_id(), Box_id()}};
    while (!pairs.empty()) {
      const Box_ids pair = pairs.back();
      pairs.pop_back();
      if (!solid_[0].box(pair[0]).is_within(solid_[1].box(pair[1]), radius)) continue;
      if (polytopes_.size() >= most_polytopes) {
        are_all_known_ = false;
        return;
      }
      const std::array<bool, 2> is_leaf = {solid_[0].tree().is_leaf(pair[0]), solid_[1].tree().is_leaf(pair[1])};
      if (is_leaf[0] && is_leaf[1]) {
        add_polytopes(pair, radius, most);
        continue;
      }
      const bool opens_b = is_leaf[0] || (!is_leaf[1] && solid_[1].box(pair[1]).size() > solid_[0].box(pair[0]).size());
      const Bvh8& tree = solid_[opens_b].tree();
      const Index node = tree.child(pair[opens_b]);
      for (int lane = 0; lane < tree.node(node).boxes.lane_count; ++lane) {
        pairs.push_back(pair);
        pairs.back()[opens_b] = {node, lane};
      }
    }
  }

  void add_polytopes(const Box_ids& box, double radius, double most)
  {
    const Bvh8 &in_a = solid_[0].tree(), &in_b = solid_[1].tree();
    for (Index i = 0; i < in_a.leaf_count(box[0]); ++i)
      for (Index j = 0; j < in_b.leaf_count(box[1]); ++j)
        for (Seen_piece& a : solid_[0].pieces(in_a.element(box[0], i).face))
          for (Seen_piece& b : solid_[1].pieces(in_b.element(box[1], j).face)) {
            const CGAL::Protect_FPU_rounding<true> upward;
            const Polytope polytope(a.rounded, b.rounded, a.is_bounded && b.is_bounded, radius, most,
                                    Exactly{this, &a, &b});
            if (!polytope.is_beyond()) polytopes_.push_back(polytope);
          }
  }

  /// Boxes between two exits along their centres.
  static constexpr unsigned halvings_an_exit = 6;
  /// Most polytopes that are found anew where a shorter translation was found. New ones leave out the planes that it
  /// lies in.
  static constexpr std::size_t few_polytopes = 10000;
  /// Polytopes that are kept, of some 1 kB each. Without the others the bracket may stay wider.
  static constexpr std::size_t most_polytopes = 300000;

  std::array<Seen_solid, 2> solid_;
  std::vector<Polytope> polytopes_;
  std::set<kernel::Rational_point> tried_;  // directions
  bool are_all_known_ = true;
  Depth_bracket found_;
  std::size_t boxes_left_ = 0;
};

}  // namespace tetracone::tetratree

#endif
