#ifndef TETRACONE_TETRATREE_PENETRATION_DEPTH_SEARCH_H
#define TETRACONE_TETRATREE_PENETRATION_DEPTH_SEARCH_H

#include "tetracone/kernel/bound/view_box.h"
#include "tetracone/kernel/contact/crossing_polytope.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/tetratree/penetration/heap.h"
#include "tetracone/tetratree/penetration/inner_balls.h"
#include "tetracone/tetratree/penetration/seen_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// A bracket of the least translation that parts two solids.
struct Depth_bracket {
  kernel::Rational_point vector = {0, 0, 0};  ///< a translation that parts them
  kernel::Rational square = 0;                ///< its squared length, an upper bound of the least squared length
  double least = 0;                           ///< lower bound of the length of every translation that parts them
  bool is_exact = true;                       ///< no shorter translation parts them

  /// True when it is exact, or its width is at most `relative` times its upper end, as far as doubles tell.
  bool is_as_narrow_as(double relative) const
  {
    const double high = kernel::enclosed_root_sum(std::array{square})[1];
    return is_exact || (high < HUGE_VAL && high - least <= relative * high);
  }

  /// Takes the bounds of another bracket of the same translations where they are nearer.
  void narrow(const Depth_bracket& other)
  {
    least = kernel::maximum(least, other.least);
    if (is_exact || !(other.square < square)) return;
    square = other.square;
    vector = other.vector;
  }
};

/// The boxes of a search: why none of them has a translation that parts the solids and is shorter than the lower bound.
/// `Depth_search::prove` fills it.
struct Depth_proof {
  enum class Reason : std::uint8_t {
    too_long,   ///< its translations are no shorter than the lower bound
    halved,     ///< `of` is the axis, and the number of the node of the lower half; the upper half's is the next
    crossing,   ///< `of` are faces of A and of B which go through one another for each of its translations
    balls,      ///< `of` are numbers of balls inside A and inside B, which overlap for each of its translations
    no_contact  ///< the surfaces share no point for any of its translations
  };
  struct Node {
    Reason reason = Reason::too_long;
    std::array<std::uint32_t, 2> of{};  ///< see `Reason`
  };

  double most = 0;                         ///< half the side of the first node's box, a cube about 0
  std::vector<Node> nodes;                 ///< the first one is the cube's; none where nothing is known
  std::array<std::vector<Ball>, 2> balls;  ///< inside of A and of B; the caller gives them
};

/// How narrow a bracket is asked for, and for how much work.
struct Depth_limits {
  double relative = 1e-9;           ///< the bracket's width over its upper end at which the search ends
  std::size_t most_boxes = 100000;  ///< the most boxes of translations that are looked at
};

/// The least translation of A after which the interiors of A and B share no point.
///
/// Let P be the set of translations after which they share one; it is open. Exits along directions give translations
/// that are not in P, the shortest of which is the upper bound. The lower bound comes from boxes of translations,
/// nearest to 0 first. A box is done where the shortest translation that is not in P is not in it:
///
/// - A ball inside A overlaps a ball inside B for all translations of the box. One of the two stands for its body, or
///   is found beside near faces. The other is the largest about the first one's centre (`Inner_balls`). Or a ball
///   inside one body holds a border point of the other, and inner points of that body are arbitrarily near
///   (`Inner_balls::is_border`).
/// - Two pieces, as of `Seen_solid`, cross for all translations inside their `Crossing_polytope`; so these are in P.
/// - No two pieces meet for any translation of the box. The shortest translation that is not in P is on the border of
///   P, since 0 is in P. There the surfaces touch.
///
/// Any other box is halved. The length of the nearest open box's translations is the lower bound. If none is left, the
/// upper bound is the least. That happens where the shortest translations end at planes that are perpendicular to them:
/// half-spaces are compared exactly with the ball of all shorter translations.
///
/// One object serves many poses of two bodies, and one thread.
class Depth_search {
 public:
  /// A and B, and balls inside of them, by trees of the same faces.
  Depth_search(Seen_solid a, Seen_solid b, Inner_balls in_a, Inner_balls in_b)
      : solid_{std::move(a), std::move(b)}, inner_{std::move(in_a), std::move(in_b)}
  {}

  /// What an exit along a direction tells.
  struct Exit {
    kernel::Rational_point vector;                ///< the translation at the first exit
    std::vector<kernel::Rational_point> normals;  ///< of planes in which it lies
  };

  /// Returns the bracket. exit(d) returns the `Exit` along d, and meet(v) tells whether v is in P. `map_a` and `map_b`
  /// are the poses as row-major 3x4 matrices. Requires that 0 is in P.
  template <class Exit_along, class Meet>
  Depth_bracket operator()(const std::array<kernel::Rational, 12>& map_a, const std::array<kernel::Rational, 12>& map_b,
                           const Exit_along& exit, const Meet& meet, const Depth_limits& limits)
  {
    solid_[0].see(map_a);
    solid_[1].see(map_b);
    found_ = {{0, 0, 0}, -1, 0, false};
    tried_.clear();
    corners_.clear();
    for (int k = 0; k < 3; ++k)
      for (const int sign : {1, -1}) {
        kernel::Rational_point axis = {0, 0, 0};
        axis[k] = sign;
        try_exits(axis, exit);
      }
    found_.is_exact = found_.square == 0;
    boxes_left_ = limits.most_boxes;
    first_place_ = 0;
    inner_[0].see(map_a);
    inner_[1].see(map_b);
    search(exit, meet, limits);
    found_.least = kernel::minimum(found_.least, kernel::nearest_root(found_.square));
    return found_;
  }

  /// Returns the bracket whose upper end is `vector`, a translation that is known to part the solids. It fills the
  /// proof of its lower end. The proof uses the balls that `proof` holds, and plain triangles (`Solid_sides`) alone. It
  /// has no nodes where nothing is known. Requires that 0 is in P.
  Depth_bracket prove(const std::array<kernel::Rational, 12>& map_a, const std::array<kernel::Rational, 12>& map_b,
                      const kernel::Rational_point& vector, const Depth_limits& limits, Depth_proof& proof)
  {
    solid_[0].see(map_a);
    solid_[1].see(map_b);
    found_ = {vector, kernel::dot(vector, vector), 0, false};
    radius_ = std::nextafter(kernel::nearest_root(found_.square), HUGE_VAL);
    ++round_;
    boxes_left_ = limits.most_boxes;
    proof_ = &proof;
    proof.nodes.clear();
    search(
        [](const kernel::Rational_point& d) {
          return Exit{d, {}};
        },
        [](const kernel::Rational_point&) { return true; }, limits);
    proof_ = nullptr;
    return found_;
  }

  /// Returns the balls that stand for A, or for B, at a pose. They are valid until the next question.
  const std::vector<Ball>& balls(bool of_b, const std::array<kernel::Rational, 12>& map)
  {
    inner_[of_b].see(map);
    return inner_[of_b].seen();
  }

 private:
  using Reason = Depth_proof::Reason;
  using Polytope = kernel::Crossing_polytope;
  using Box = kernel::Translation_box;

  /// All that may meet for some translations of a box: pairs of boxes that are not opened, and numbers of polytopes.
  struct Near {
    std::vector<Box_ids> pairs;
    std::vector<std::uint32_t> polytopes;
    std::vector<std::pair<bool, Ball>> balls;  // inside A, or inside B: true
  };

  struct Open_box {
    double least;
    unsigned halvings;
    Box box;
    std::shared_ptr<const Near> near;
    std::uint32_t node = 0;  // of the proof
  };

  struct Kept_polytope {
    Polytope polytope;
    Seen_piece *a, *b;
    unsigned round;  // of the ball's radius, for which it was made
  };

  /// What the exact pieces say of an axis.
  struct Exact_axes {
    Depth_search* search;
    Seen_piece *a, *b;

    bool is_zero(const kernel::Shift_axis& axis) const
    {
      const auto [piece_a, piece_b] = pieces();
      return kernel::is_zero(kernel::detail::direction<mpz_class>(axis, *piece_a, *piece_b));
    }

    /// Returns the plane n . v = limit of a half-space n . v < limit.
    std::pair<kernel::Rational_point, kernel::Rational> plane(const kernel::Shift_axis& axis, int sign) const
    {
      const auto [piece_a, piece_b] = pieces();
      const kernel::detail::Allowed<kernel::Rational> allowed(axis, *piece_a, *piece_b);
      const auto n = kernel::detail::direction<mpz_class>(axis, *piece_a, *piece_b);
      const mpz_class both = piece_a->denominator * piece_b->denominator;
      return {{n[0] * both, n[1] * both, n[2] * both}, sign > 0 ? allowed.high : allowed.low};
    }

    std::array<const kernel::Integer_piece*, 2> pieces() const
    {
      return {&search->solid_[0].exactly(*a), &search->solid_[1].exactly(*b)};
    }

    /// True when the plane of a half-space n . v < limit does not cut the open ball of all shorter translations.
    bool is_outside_ball(const kernel::Shift_axis& axis, int sign) const
    {
      const auto [n, at] = plane(axis, sign);
      const kernel::Rational limit = sign * at;
      return limit > 0 && limit * limit >= search->found_.square * kernel::dot(n, n);
    }
  };

  /// Tries the exit along a direction, and along the normals of the planes that it ends at, as long as that is
  /// shorter. A shorter translation than all before sets the ball's radius, an upper bound of its length.
  template <class Exit_along>
  void try_exits(kernel::Rational_point direction, const Exit_along& exit)
  {
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
      radius_ = std::nextafter(kernel::nearest_root(square), HUGE_VAL);
      ++round_;
      for (const kernel::Rational_point& n : found.normals)
        directions.push_back(kernel::dot(n, found.vector) < 0 ? kernel::negated(n) : n);
    }
  }

  /// Returns the direction with a largest component of 1 or -1, so that equal ones are equal.
  static kernel::Rational_point scaled(kernel::Rational_point d)
  {
    const kernel::Rational longest = kernel::longest_part(d);
    for (kernel::Rational& x : d) x /= longest;
    return d;
  }

  /// Searches the ball of all translations that are shorter than the known one.
  template <class Exit_along, class Meet>
  void search(const Exit_along& exit, const Meet& meet, const Depth_limits& limits)
  {
    if (!(radius_ >= 0x1p-200 && radius_ <= 0x1p200)) return;  // beyond what the boxes' numbers can bound
    most_ = std::ldexp(1.0, std::ilogb(radius_) + 1);
    polytopes_.clear();
    by_leaves_.clear();
    auto all = std::make_shared<Near>();
    all->pairs = {{Box_id(), Box_id()}};
    if (proof_) {
      proof_->most = most_;
      proof_->nodes.resize(1);
    } else {
      for (const bool of_b : {false, true})
        for (const Ball& ball : inner_[of_b].seen()) all->balls.push_back({of_b, ball});
    }
    std::vector<Open_box> open = {{0, 0, {{0, 0, 0}, {most_, most_, most_}}, std::move(all)}};
    const auto is_later = [](const Open_box& x, const Open_box& y) { return x.least > y.least; };
    while (!open.empty()) {
      const Open_box next = pop_from(open, is_later);
      found_.least = kernel::maximum(found_.least, next.least);
      const bool is_small = proof_ && next.halvings == most_halvings_of_proof;
      if (next.least >= radius_ * (1 - limits.relative) || boxes_left_ == 0 || is_small) return;
      --boxes_left_;
      auto near = std::make_shared<Near>();
      const Depth_proof::Node closed = closed_by(next, *near);
      if (proof_) proof_->nodes[next.node] = closed;
      if (closed.reason != Reason::halved) continue;
      if (!proof_ && next.halvings % halvings_a_question == 0 && next.least > 0) {
        const kernel::Rational_point v = kernel::exact_point(next.box.centre);
        const bool is_shorter = kernel::dot(v, v) < found_.square, is_in_p = !is_shorter || meet(v);
        if (!is_in_p) try_exits(v, exit);
        if (is_shorter && is_in_p && next.halvings >= halvings_before_balls) find_ball(next.box, *near);
        if (next.halvings >= least_halvings && next.halvings % halvings_a_corner == 0)
          try_corners(next.box, *near, exit, meet);
      }
      const auto axis = std::size_t(std::ranges::max_element(next.box.half) - next.box.half.begin());
      std::uint32_t node = 0;
      if (proof_) {
        node = std::uint32_t(proof_->nodes.size());
        proof_->nodes[next.node].of = {std::uint32_t(axis), node};
        proof_->nodes.resize(node + 2);
      }
      for (const int side : {-1, 1}) {
        Open_box part{0, next.halvings + 1, next.box, near, node + (side > 0)};
        part.box.half[axis] /= 2;
        part.box.centre[axis] += side * part.box.half[axis];
        part.least = kernel::maximum(next.least, part.box.least_length());
        if (part.least > radius_) continue;
        push_to(open, std::move(part), is_later);
      }
    }
    found_.least = kernel::nearest_root(found_.square);
    found_.is_exact = true;
  }

  /// Returns why the shortest translation that is not in P is not in the box. If that is not known, it returns
  /// `halved`, and `near` has what may meet for some translations of the box.
  Depth_proof::Node closed_by(const Open_box& open, Near& near)
  {
    const auto is_held = [&](std::uint32_t k) {
      Polytope& polytope = renewed(k);
      if (polytope.is_beyond() || !polytope.is_near(open.box)) return false;
      if (polytope.holds(open.box)) return true;
      if (polytope.may_meet(open.box)) near.polytopes.push_back(k);
      return false;
    };
    const auto crossing = [this](std::uint32_t k) {
      return Depth_proof::Node{Reason::crossing, {polytopes_[k].a->face, polytopes_[k].b->face}};
    };
    for (const std::uint32_t k : open.near->polytopes)
      if (is_held(k)) return crossing(k);
    if (const auto held = proof_ ? held_by_balls(open.box) : std::nullopt) return *held;
    const double half_diagonal = std::hypot(open.box.half[0], open.box.half[1], open.box.half[2]);
    for (const auto& [of_b, ball] : open.near->balls) {
      double about = 0;
      const double sum = radius_sum(of_b, ball, open.box.centre, about);
      // Outside the other solid, the ball holds a border point of it, and so inner points.
      const bool is_sure = about > 0 || inner_[!of_b].is_border();
      if (is_sure && sum * (1 - kernel::few_roundings) > half_diagonal) return {Reason::balls, {}};
      if (sum + half_diagonal > 0) near.balls.push_back({of_b, ball});
    }
    const double size = pairs_a_box * 2 * (open.box.half[0] + open.box.half[1] + open.box.half[2]);
    pairs_ = open.near->pairs;
    while (!pairs_.empty()) {
      const Box_ids pair = pairs_.back();
      pairs_.pop_back();
      const kernel::View_box &a = solid_[0].box(pair[0]), &b = solid_[1].box(pair[1]);
      if (!a.may_meet(b, open.box.centre, open.box.half)) continue;
      if (a.size() + b.size() < size) {
        near.pairs.push_back(pair);
        continue;
      }
      if (!solid_[0].tree().is_leaf(pair[0]) || !solid_[1].tree().is_leaf(pair[1])) {
        open_pair(
            solid_, pair, [this](const Box_ids& closer, auto&...) { pairs_.push_back(closer); },
            [](Seen_piece&, Seen_piece&) {});
        continue;
      }
      const auto numbers = polytopes_of(pair);
      if (!numbers) near.pairs.push_back(pair);
      for (std::uint32_t k = numbers ? numbers->first : 0; numbers && k < numbers->second; ++k)
        if (is_held(k)) return crossing(k);
    }
    return {near.pairs.empty() && near.polytopes.empty() ? Reason::no_contact : Reason::halved, {}};
  }

  /// Returns two balls of the proof that overlap for each translation of the box.
  std::optional<Depth_proof::Node> held_by_balls(const Box& box) const
  {
    for (std::uint32_t i = 0; i < proof_->balls[0].size(); ++i)
      for (std::uint32_t j = 0; j < proof_->balls[1].size(); ++j) {
        const Ball &a = proof_->balls[0][i], &b = proof_->balls[1][j];
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double between = std::abs(a.centre[k] + box.centre[k] - b.centre[k]) + box.half[k];
          const double magnitude = std::abs(a.centre[k]) + std::abs(b.centre[k]) + std::abs(box.centre[k]);
          const double farthest = between + (magnitude + between) * kernel::few_roundings;
          square += farthest * farthest;
        }
        const double sum = a.radius + b.radius;
        if (square < sum * sum * (1 - kernel::few_roundings)) return Depth_proof::Node{Reason::balls, {i, j}};
      }
    return std::nullopt;
  }

  /// Returns a lower bound of a sum: the radius of a ball inside a body, and the signed distance of its centre in
  /// the other. The latter is written to `about`. A is translated.
  double radius_sum(bool of_b, const Ball& ball, const std::array<double, 3>& translation, double& about)
  {
    std::array<double, 3> at = ball.centre;
    double magnitude = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] += of_b ? -translation[k] : translation[k];
      magnitude += std::abs(ball.centre[k]) + std::abs(translation[k]);
    }
    about = inner_[!of_b].radius_about(at);
    return ball.radius + about - magnitude * kernel::few_roundings;
  }

  /// Adds the largest of some balls of A that overlap B for the box's centre, if there is one. The others stand for
  /// whole bodies, and miss thin overlaps. Where faces of both bodies lie in a plane, no two pieces cross there.
  ///
  /// The balls are beside places where pieces come near one another, on both sides of each piece.
  void find_ball(const Box& box, Near& near)
  {
    const double half_diagonal = std::hypot(box.half[0], box.half[1], box.half[2]);
    const auto unit = [](std::array<double, 3> d) {
      const double length = std::hypot(d[0], d[1], d[2]);
      for (double& x : d) x /= length;
      return d;
    };
    double best = 0;
    std::optional<Ball> found;
    const std::size_t all = near.polytopes.size(), places = kernel::minimum(all, most_places);
    for (std::size_t n = 0; n < places && !(best > enough * half_diagonal); ++n) {
      const Kept_polytope& polytope = polytopes_[near.polytopes[(first_place_ + n * all / places) % all]];
      const kernel::Rounded_piece &a = polytope.a->rounded, &b = polytope.b->rounded;
      std::array<double, 3> place;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto in_order = [k](const auto& x, const auto& y) { return x[k] < y[k]; };
        const auto [low_a, high_a] = std::minmax_element(a.corner.begin(), a.corner.begin() + a.count, in_order);
        const auto [low_b, high_b] = std::minmax_element(b.corner.begin(), b.corner.begin() + b.count, in_order);
        place[k] = (kernel::maximum((*low_a)[k] + box.centre[k], (*low_b)[k]) +
                    kernel::minimum((*high_a)[k] + box.centre[k], (*high_b)[k])) /
                   2;
      }
      const auto normal = [&](const kernel::Rounded_piece& piece) {
        return unit(kernel::cross(kernel::difference(piece.corner[1], piece.corner[0]),
                                  kernel::difference(piece.corner[2], piece.corner[0])));
      };
      const auto of_a = normal(a), of_b = normal(b);
      for (const int side : {0, 1, 2, 3}) {
        std::array<double, 3> way;
        for (std::size_t k = 0; k < 3; ++k) way[k] = (side & 1 ? of_a[k] : -of_a[k]) + (side & 2 ? of_b[k] : -of_b[k]);
        way = unit(way);
        for (int halved = 1; std::ldexp(most_, -halved) > half_diagonal; ++halved) {
          const double step = std::ldexp(most_, -halved);
          Ball ball{};
          std::array<double, 3> in_b;
          for (std::size_t k = 0; k < 3; ++k) {
            in_b[k] = place[k] + step * way[k];
            ball.centre[k] = in_b[k] - box.centre[k];
          }
          const double about = inner_[1].radius_about(in_b);
          if (!(about > 0)) continue;
          ball.radius = inner_[0].radius_about(ball.centre);
          if (!(ball.radius > 0 && ball.radius + about > best)) continue;
          best = ball.radius + about;
          found = ball;
        }
      }
    }
    ++first_place_;
    if (found) near.balls.push_back({false, *found});
  }

  /// A plane at which a polytope ends.
  struct Plane {
    std::array<double, 3> normal;
    double limit;
    Exact_axes axes;
    kernel::Shift_axis axis;
    int sign;
  };

  /// Returns the common point of one to three planes n . v = limit that is nearest to 0. Returns nothing where normals
  /// are not independent.
  template <class N>
  static std::optional<std::array<N, 3>> nearest_to_0(std::span<const std::pair<std::array<N, 3>, N>> planes)
  {
    using kernel::cross, kernel::dot;
    const auto& [n, limit] = planes[0];
    if (planes.size() == 1) return sum_over<N>({limit}, {n}, dot(n, n));
    // The plane through 0 across the line of two planes is the third.
    const auto& [m, second] = planes[1];
    const std::array<N, 3> line = cross(n, m), third = planes.size() == 2 ? line : planes[2].first;
    return sum_over<N>({limit, second, planes.size() == 2 ? N(0) : planes[2].second},
                       {cross(m, third), cross(third, n), line}, dot(line, third));
  }

  /// Returns the sum of vectors times factors, over a divisor; nothing for the divisor 0.
  template <class N>
  static std::optional<std::array<N, 3>> sum_over(const std::vector<N>& factors,
                                                  const std::vector<std::array<N, 3>>& vectors, const N& divisor)
  {
    if (divisor == 0) return std::nullopt;
    std::array<N, 3> sum = {0, 0, 0};
    for (std::size_t i = 0; i < factors.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += factors[i] * vectors[i][k] / divisor;
    return sum;
  }

  /// Tries exits to the corners, edges and faces of polytopes in a box that are nearest to 0.
  template <class Exit_along, class Meet>
  void try_corners(const Box& box, const Near& near, const Exit_along& exit, const Meet& meet)
  {
    std::vector<Plane> planes;
    for (const std::uint32_t k : near.polytopes) {
      const Kept_polytope& kept = polytopes_[k];
      kept.polytope.for_planes(
          box, [&](std::array<double, 3> n, double limit, const kernel::Shift_axis& axis, int sign) {
            const double length = std::hypot(n[0], n[1], n[2]) * (n[0] < 0 || (n[0] == 0 && n[1] < 0) ? -1 : 1);
            for (double& x : n) x /= length;
            limit /= length;
            const bool is_new = planes.size() < most_planes && std::ranges::none_of(planes, [&](const Plane& other) {
                                  double off = std::abs(limit - other.limit) / radius_;
                                  for (std::size_t i = 0; i < 3; ++i) off += std::abs(n[i] - other.normal[i]);
                                  return off < same_plane;
                                });
            if (is_new) planes.push_back({n, limit, Exact_axes{this, kept.a, kept.b}, axis, sign});
          });
    }
    const auto try_planes = [&](std::initializer_list<const Plane*> chosen) {
      std::vector<std::pair<std::array<double, 3>, double>> about;
      for (const Plane* plane : chosen) about.emplace_back(plane->normal, plane->limit);
      const auto v = nearest_to_0<double>(about);
      for (std::size_t k = 0; k < 3; ++k)
        if (!v || !(std::abs((*v)[k] - box.centre[k]) <= 2 * box.half[k])) return;
      std::vector<std::pair<kernel::Rational_point, kernel::Rational>> exact;
      for (const Plane* plane : chosen) exact.push_back(plane->axes.plane(plane->axis, plane->sign));
      const auto corner = nearest_to_0<kernel::Rational>(exact);
      if (!corner || !corners_.insert(*corner).second) return;
      if (kernel::dot(*corner, *corner) < found_.square && !meet(*corner)) try_exits(*corner, exit);
    };
    for (std::size_t i = 0; i < planes.size(); ++i) {
      try_planes({&planes[i]});
      for (std::size_t j = 0; j < i; ++j) {
        try_planes({&planes[i], &planes[j]});
        for (std::size_t k = 0; k < j; ++k) try_planes({&planes[i], &planes[j], &planes[k]});
      }
    }
  }

  /// Returns the numbers of the polytopes of two leaves: from the first to before the last. Nothing where there is no
  /// room for more, or a proof cannot name a face.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> polytopes_of(const Box_ids& box)
  {
    const std::uint64_t leaves = std::uint64_t(box[0].number()) << 32 | box[1].number();
    if (const auto at = by_leaves_.find(leaves); at != by_leaves_.end()) return at->second;
    if (polytopes_.size() >= most_polytopes) return std::nullopt;
    if (proof_ && !(solid_[0].is_plain(box[0]) && solid_[1].is_plain(box[1]))) return std::nullopt;
    const auto first = std::uint32_t(polytopes_.size());
    open_pair(
        solid_, box, [](auto&...) {},
        [this](Seen_piece& a, Seen_piece& b) {
          const Polytope polytope = polytope_of(a, b);
          if (!polytope.is_beyond()) polytopes_.push_back({polytope, &a, &b, round_});
        });
    return by_leaves_[leaves] = {first, std::uint32_t(polytopes_.size())};
  }

  Polytope polytope_of(Seen_piece& a, Seen_piece& b)
  {
    const CGAL::Protect_FPU_rounding<true> upward;
    return Polytope(a.rounded, b.rounded, a.is_bounded && b.is_bounded, radius_, most_, Exact_axes{this, &a, &b});
  }

  /// Returns a polytope, made anew after the ball has shrunk: a new one leaves out the planes that no longer cut it.
  Polytope& renewed(std::uint32_t k)
  {
    Kept_polytope& kept = polytopes_[k];
    if (kept.round != round_) {
      kept.polytope = polytope_of(*kept.a, *kept.b);
      kept.round = round_;
    }
    return kept.polytope;
  }

  /// Halvings of a box between two questions whether its centre is in P.
  static constexpr unsigned halvings_a_question = 3;
  /// Halvings of a box before corners in it are tried.
  static constexpr unsigned least_halvings = 18;
  /// Halvings of a box between two such tries.
  static constexpr unsigned halvings_a_corner = 9;
  /// Halvings of a box before balls are found for it.
  static constexpr unsigned halvings_before_balls = 9;
  /// The most places beside which balls are found, and the overlap, in half diagonals of the box, that is enough.
  static constexpr std::size_t most_places = 12;
  static constexpr double enough = 4;
  /// The most planes whose corners are tried in a box.
  static constexpr std::size_t most_planes = 8;
  /// The most halvings of a box in a proof. Its sides are 2^-32 of the first one's then.
  static constexpr unsigned most_halvings_of_proof = 96;
  /// Planes are taken for one, when corners are sought, if their normals and limits differ by less than this share.
  static constexpr double same_plane = 0x1p-30;
  /// A pair of boxes is opened while their size together is at least this multiple of the box of translations. The
  /// polytopes of smaller ones cannot hold it.
  static constexpr double pairs_a_box = 2;
  /// The most polytopes that are kept, of some 1 kB each. Without the others the bracket may stay wider.
  static constexpr std::size_t most_polytopes = 300000;

  std::array<Seen_solid, 2> solid_;
  std::array<Inner_balls, 2> inner_;
  std::vector<Kept_polytope> polytopes_;
  std::unordered_map<std::uint64_t, std::pair<std::uint32_t, std::uint32_t>> by_leaves_;  // numbers of polytopes
  std::vector<Box_ids> pairs_;                                                            // to be opened
  std::set<kernel::Rational_point> corners_;                                              // that were tried
  std::set<kernel::Rational_point> tried_;                                                // directions
  double radius_ = 0;   // of the ball that is searched: an upper bound of the shortest known translation
  double most_ = 0;     // half the side of the first box
  unsigned round_ = 0;  // how often the radius has been set
  Depth_bracket found_;
  std::size_t boxes_left_ = 0;
  std::size_t first_place_ = 0;   // the number of the polytope that the next search of balls begins with
  Depth_proof* proof_ = nullptr;  // that is filled; null for a bracket alone
};

}  // namespace tetracone::tetratree

#endif
