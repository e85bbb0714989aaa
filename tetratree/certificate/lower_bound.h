#ifndef TETRACONE_TETRATREE_CERTIFICATE_LOWER_BOUND_H
#define TETRACONE_TETRATREE_CERTIFICATE_LOWER_BOUND_H

#include "tetracone/kernel/contact/crossing_polytope.h"
#include "tetracone/kernel/contact/direction_view.h"
#include "tetracone/tetratree/certificate/approach.h"
#include "tetracone/tetratree/certificate/sides.h"
#include "tetracone/tetratree/certificate/ways.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/penetration/depth_search.h"
#include "tetracone/tetratree/penetration/exit_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Lower bounds of how far A must be moved to part two solids. Boxes of translations prove a depth; stretches of the
/// way prove a first exit.
namespace tetracone::tetratree {

/// Returns the poses, with A moved by a vector. Throws No_proof for one beyond the doubles.
inline Placed_pair::Poses moved(Placed_pair::Poses poses, const kernel::Rational_point& by)
{
  poses[0] = shifted(poses[0], by);
  return poses;
}

/// A body by its triangles, and the numbers that a certificate gives them.
class Numbered_triangles {
 public:
  /// `groups` are those of the body. All must outlive this object.
  Numbered_triangles(const detail::Body_data& body, const Group_tree& groups) : body_(&body.by_triangles())
  {
    for (std::size_t n = 0; n < groups.piece_count(); ++n)
      if (!groups.piece(n).is_whole_face()) number_.emplace(in_order(groups.piece(n).corner), n);
  }

  /// Return what searches for exits and depths need of the body.
  Seen_solid seen() const { return {body_->bvh8(), body_->polyhedron, body_->solid_sides()}; }
  Inner_balls balls() const { return {body_->bvh8(), body_->point_locator(), body_->solid_sides().is_simple()}; }

  /// Returns a triangle at a pose.
  kernel::Rational_face face(Index triangle, const kernel::Pose& pose) const
  {
    return covering::rational_face(body_->polyhedron, triangle, pose);
  }

  /// Returns the number of the piece that a triangle is; nothing where the pieces divide its face in another way.
  std::optional<std::size_t> operator()(Index triangle) const
  {
    const covering::Loop loop = body_->polyhedron.loop(triangle, 0);
    const auto found = number_.find(in_order({loop[0], loop[1], loop[2]}));
    return found == number_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  static std::array<Index, 3> in_order(std::array<Index, 3> corner)
  {
    std::ranges::sort(corner);
    return corner;
  }

  const detail::Body_data* body_;
  std::map<std::array<Index, 3>, std::size_t> number_;
};

using Two_bodies = std::array<Numbered_triangles, 2>;

/// Appends the numbers of a piece of A and of one of B, given as triangles. False, without a change of the text, where
/// one has no number.
inline bool add_pieces(std::string& text, const Two_bodies& bodies, const std::array<Index, 2>& faces)
{
  const auto a = bodies[0](faces[0]), b = bodies[1](faces[1]);
  if (!a || !b) return false;
  text += '[' + std::to_string(*a) + ',' + std::to_string(*b) + ']';
  return true;
}

/// Appends the windings of a point inside of both solids. It is the centre of one of the balls of A or of B, or it is
/// near a common point of the surfaces. False where none is found; the text is of no use then.
inline bool add_point_of_both(std::string& text, Placed_pair& pair, const std::array<std::vector<Ball>, 2>& balls)
{
  for (const auto& of_body : balls)
    for (const Ball& ball : of_body) {
      const kernel::Rational_point at = kernel::exact_point(ball.centre);
      const kernel::Exact_vector x = exact(at, kernel::Rational(pair.weight));
      const std::string of = "\"point\":" + strings_of(pair.written(at));
      const auto in_a = winding_row(pair, 0, of, x), in_b = winding_row(pair, 1, of, x);
      if (!in_a || !in_b || in_a->second == 0 || in_b->second == 0) continue;
      add_windings(text, {in_a->first, in_b->first});
      return true;
    }
  std::string unused = "{";
  const auto met = cover_or_meet(unused, pair);
  return met && add_sides(text, pair, *met, {{true, true}});
}

/// Appends windings of points inside of both solids, at any poses of them.
class Points_of_both {
 public:
  /// The bodies must outlive this object.
  explicit Points_of_both(const Two_bodies& bodies) : bodies_(&bodies) {}

  /// Same as `add_point_of_both`, with balls about inner points of both.
  bool operator()(std::string& text, Placed_pair& pair)
  {
    if (inner_.empty()) inner_ = {(*bodies_)[0].balls(), (*bodies_)[1].balls()};
    std::array<std::vector<Ball>, 2> balls;
    for (std::size_t k = 0; k < 2; ++k) {
      inner_[k].see(kernel::rows_of(pair.pose[k]));
      balls[k] = inner_[k].seen();
    }
    return add_point_of_both(text, pair, balls);
  }

 private:
  const Two_bodies* bodies_;
  std::vector<Inner_balls> inner_;  // of both bodies, made where the first point is needed
};

/// Returns a few crossings of triangles just before an exit along a direction, in lengths of it. `at_start` are the
/// bodies as they were given.
inline std::vector<Crossing_before> crossings_before(const Placed_pair& at_start, const Two_bodies& bodies,
                                                     const kernel::Rational_point& along, const kernel::Rational& exit)
{
  constexpr std::size_t most_crossings = 4;
  const kernel::Direction_view view(along);
  Exit_search search(bodies[0].seen(), bodies[1].seen());
  const auto pose = moved(at_start.pose, kernel::scaled(along, exit));
  std::vector<Crossing_before> crossings;
  for (const Exit_search::Stretch& stretch : search.stretches_before(
           view.of(at_start.pose[0]), view.of(at_start.pose[1]), exit * view.height(), most_crossings))
    crossings.push_back({{bodies[0].face((*stretch.faces)[0], pose[0]), bodies[1].face((*stretch.faces)[1], pose[1])},
                         (stretch.to - stretch.from) / view.height()});
  return crossings;
}

/// Appends, as `overlap`, why the interiors share a point for all moves along a direction from 0 to before the first
/// exit. False, without a change of the text, where a part of the way has no proof.
inline bool add_stretches(std::string& text, const Placed_pair& pair, const Two_bodies& bodies,
                          Points_of_both& points_of_both, const kernel::Rational_point& along,
                          const kernel::Rational& first)
{
  constexpr double shortest = 0x1p-16;  // of intervals: a part of the way that needs shorter ones has no proof
  const kernel::Direction_view view(along);
  Exit_search search(bodies[0].seen(), bodies[1].seen());
  const auto poses_at = [&](const kernel::Rational& s) { return moved(pair.pose, kernel::scaled(along, s)); };
  std::vector<std::string> rows;
  const auto add_point = [&](const kernel::Rational& s) {
    Placed_pair there = pair.at(poses_at(s));
    rows.push_back("{\"at\":" + json_text(kernel::to_string(s)));
    if (!points_of_both(rows.back(), there)) return false;
    rows.back() += '}';
    return true;
  };
  // The surfaces may share a point at `to` alone.
  const auto add_free = [&](const kernel::Rational& from, const kernel::Rational& to) {
    const auto start = poses_at(from), end = poses_at(to);
    Moving_pair moving(pair.groups(),
                       {kernel::Body_motion::linear(start[0], end[0]), kernel::Body_motion::linear(start[1], end[1])});
    Motion_cover cover(moving, 1, true, shortest);
    if (!cover()) return false;
    std::string row = "{\"from\":" + json_text(kernel::to_string(from));
    add_key(row, "to");
    row += json_text(kernel::to_string(to));
    add_cover(row, cover.cover());
    rows.push_back(row + '}');
    return true;
  };
  for (const Exit_search::Stretch& stretch :
       search.stretches(view.of(pair.pose[0]), view.of(pair.pose[1]), first * view.height())) {
    const kernel::Rational from = stretch.from / view.height(), to = stretch.to / view.height();
    if (stretch.faces) {
      if (stretch.starts_there && !add_point(from)) return false;
      rows.push_back("{\"pieces\":");
      if (!add_pieces(rows.back(), bodies, *stretch.faces)) return false;
      rows.back() += '}';
    } else if (from == 0) {
      if (!add_point(from) || !add_free(from, to)) return false;
    } else if (!add_free(from, to)) {
      const kernel::Rational middle = (from + to) / 2;
      if (!add_point(from) || !add_free(middle, from) || !add_free(middle, to)) return false;
    }
  }
  add_key(text, "overlap");
  add_list(text, rows, [](const std::string& row) { return row; });
  return true;
}

/// Writes the proof that no translation shorter than a bound parts two solids whose interiors share a point.
class Lower_bound {
 public:
  /// The bodies at their poses, and the same by their triangles. All must outlive this object.
  Lower_bound(Placed_pair& pair, const Two_bodies& bodies) : pair_(&pair), bodies_(&bodies) {}

  /// Appends, as `low`, the proof for a translation that parts the solids. The search ends where the bracket's width is
  /// `relative` times its upper end, or earlier. A proof that gets too long is made again, of fewer boxes. The bound is
  /// exact where the search closes all boxes. False, without a change of the text, where no bound above 0 is proved.
  bool operator()(std::string& text, const kernel::Rational_point& vector, double relative)
  {
    const auto& [a, b] = *bodies_;
    Depth_search search(a.seen(), b.seen(), a.balls(), b.balls());
    const std::array rows = {kernel::rows_of(pair_->pose[0]), kernel::rows_of(pair_->pose[1])};
    for (const bool of_b : {false, true})
      for (Ball ball : search.balls(of_b, rows[of_b])) {
        // A cover that shows the ball to be inside needs room.
        ball.radius *= 1 - 0x1p-20;
        if (proof_.balls[of_b].size() < most_balls) proof_.balls[of_b].push_back(ball);
      }
    for (const std::size_t boxes : {20000, 2000, 200}) {
      const Depth_bracket bracket = search.prove(rows[0], rows[1], vector, {relative, boxes}, proof_);
      if (proof_.nodes.empty() || !(bracket.least > 0)) return false;
      square_ = bracket.is_exact ? bracket.square : kernel::Rational(bracket.least) * bracket.least;
      std::string low = "{\"square\":" + json_text(kernel::to_string(square_));
      if (!add_proof(low)) continue;
      add_key(text, "low");
      text += low + '}';
      return true;
    }
    return false;
  }

 private:
  using Box = kernel::Translation_box;
  using Reason = Depth_proof::Reason;

  /// Appends the boxes, and the balls and the point that they need. False where something has no proof, or is too long.
  bool add_proof(std::string& text)
  {
    used_.clear();
    const double half = proof_.most;
    add_key(text, "half");
    text += json_text(kernel::to_string(kernel::Rational(half)));
    add_key(text, "boxes");
    if (!add_boxes(text, 0, {{0, 0, 0}, {half, half, half}})) return false;
    add_key(text, "balls");
    text += '[';
    for (std::size_t n = 0; n < used_.size(); ++n) {
      if (n > 0) text += ',';
      if (!add_ball(text, used_[n])) return false;
    }
    text += ']';
    return add_point_of_both(text, *pair_, proof_.balls);
  }

  static Box half_of(const Box& box, std::size_t axis, int side)
  {
    Box half = box;
    half.half[axis] /= 2;
    half.centre[axis] += side * half.half[axis];
    return half;
  }

  /// Appends both halves of a box, each by add(half, side).
  template <class Add>
  bool add_halves(std::string& text, const Box& box, std::size_t axis, const Add& add)
  {
    text += std::string("[\"") + "xyz"[axis] + "\",";
    if (!add(half_of(box, axis, -1), 0u)) return false;
    text += ',';
    if (!add(half_of(box, axis, 1), 1u)) return false;
    text += ']';
    return true;
  }

  bool add_boxes(std::string& text, std::uint32_t n, const Box& box)
  {
    const Depth_proof::Node& node = proof_.nodes[n];
    switch (node.reason) {
      case Reason::too_long: text += "\"long\""; return true;
      case Reason::halved:
        return add_halves(text, box, node.of[0],
                          [&](const Box& half, unsigned side) { return add_boxes(text, node.of[1] + side, half); });
      case Reason::crossing: return add_pieces(text, *bodies_, node.of);
      case Reason::balls:
        text += "{\"balls\":[" + std::to_string(number_of({0, node.of[0]})) + ',' +
                std::to_string(number_of({1, node.of[1]})) + "]}";
        return true;
      case Reason::no_contact: return add_cover_of(text, box, most_halvings);
    }
    return false;
  }

  /// Appends the cover of a box of translations. Where no direction separates two pieces for all of them, it halves the
  /// box, at most `halvings` times. False where that does not suffice, or the text gets too long.
  bool add_cover_of(std::string& text, const Box& box, int halvings)
  {
    if (text.size() > most_bytes) return false;
    Placed_pair pair = pair_->at(moved(pair_->pose, kernel::exact_point(box.centre)));
    const kernel::Exact_number& weight = pair.weight;
    kernel::Gap_rule rule{exact(square_.get_num()) * weight * weight, exact(square_.get_den()), true, 0};
    rule.sweep.emplace();
    for (std::size_t k = 0; k < 3; ++k) {
      rule.sweep->centre[k] = kernel::Exact_number(box.centre[k]) * weight;
      rule.sweep->half[k] = kernel::Exact_number(box.half[k]) * weight;
    }
    const double diagonal = std::hypot(box.half[0], box.half[1], box.half[2]);
    rule.rounded = kernel::Exact_number(kernel::Exact_number(diagonal) * pair.weight * pair.rounding).to_double();
    try {
      Pair_cover cover(pair.body[0], pair.body[1], rule);
      if (cover()) {
        text += '{';
        add_cover(text, cover.cover());
        text += '}';
        return true;
      }
    } catch (const No_proof&) {
      return false;
    }
    const auto axis = std::size_t(std::ranges::max_element(box.half) - box.half.begin());
    return halvings > 0 && add_halves(text, box, axis, [&](const Box& half, unsigned) {
             return add_cover_of(text, half, halvings - 1);
           });
  }

  /// A ball of the proof: its body, and its number there.
  using Ball_number = std::pair<std::size_t, std::uint32_t>;

  /// Returns the number of a ball among those that the boxes name.
  std::size_t number_of(const Ball_number& ball)
  {
    const auto number = std::size_t(std::ranges::find(used_, ball) - used_.begin());
    if (number == used_.size()) used_.push_back(ball);
    return number;
  }

  /// Appends a ball: its centre is inside, and all faces are at least its radius away. False where that has no proof.
  bool add_ball(std::string& text, const Ball_number& number)
  {
    const auto& [body, n] = number;
    const Ball& ball = proof_.balls[body][n];
    const kernel::Rational_point at = kernel::exact_point(ball.centre);
    const kernel::Rational weight(pair_->weight);
    const kernel::Exact_vector centre = exact(at, weight);
    const auto row = winding_row(*pair_, int(body), "\"point\":" + strings_of(pair_->written(at)), centre);
    if (!row || row->second == 0) return false;
    const kernel::Exact_number radius = exact(kernel::Rational(ball.radius) * weight);
    const kernel::Gap_rule rule{radius * radius, 1, true, kernel::Exact_number(radius * pair_->rounding).to_double()};
    Probe_cover cover(pair_->body[body], Probe{centre, {}, {}}, rule);
    if (!cover([](Box_id, const kernel::Exact_face&, bool) { return Probe_cover::Met::stops; })) return false;
    text += "{\"winding\":" + row->first;
    add_key(text, "radius");
    text += json_text(kernel::to_string(kernel::Rational(ball.radius)));
    add_cover(text, cover.cover());
    text += '}';
    return true;
  }

  static constexpr std::size_t most_bytes = 1 << 20;  // of a proof's text, above which no further cover is begun
  static constexpr std::size_t most_balls = 16;       // of a body
  static constexpr int most_halvings = 6;             // of a box without contact

  Placed_pair* pair_;
  const Two_bodies* bodies_;
  Depth_proof proof_;
  kernel::Rational square_;
  std::vector<Ball_number> used_;  // the balls that boxes name
};

}  // namespace tetracone::tetratree

#endif
