#ifndef TETRACONE_TETRATREE_CERTIFICATE_WAYS_H
#define TETRACONE_TETRATREE_CERTIFICATE_WAYS_H

#include "tetracone/tetratree/certificate/motion_cover.h"
#include "tetracone/tetratree/certificate/windings.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Ways of a body to its pose, which show that the interiors of solids that touch share no point.
namespace tetracone::tetratree {

/// Appends a cover over the motion on lines from `start` to the poses of `pair`, and the windings at its start. The
/// cover leaves out the last time, at which the surfaces may touch. `inside` is the body whose shells are inside of the
/// other one; -1 where all are outside. False where either is not so; the text is of no use then.
inline bool leads_free(std::string& text, const Placed_pair::Poses& start, const Placed_pair& pair, int inside)
{
  constexpr double shortest = 0x1p-16;  // of intervals: a way that needs shorter ones is given up
  Moving_pair moving(pair.groups(), {kernel::Body_motion::linear(start[0], pair.pose[0]),
                                     kernel::Body_motion::linear(start[1], pair.pose[1])});
  Motion_cover cover(moving, 1, true, shortest);
  if (!cover()) return false;
  add_cover(text, cover.cover());
  return add_all_windings(text, moving.at(0), inside == 0, inside == 1);
}

/// Returns a point near the mean of the corners of placed body k, and a length like the body's, 0 for a point.
/// Throws No_proof where no double is near them.
inline std::pair<kernel::Rational_point, double> middle_of(const Placed_pair& pair, std::size_t k)
{
  const auto& corners = pair.body[k].groups->group({}).corners;
  const kernel::Hull_points& points = pair.body[k].points;
  kernel::Rounded_vector middle{};
  double size = 0;
  for (const std::uint32_t v : corners)
    for (std::size_t c = 0; c < 3; ++c) middle[c] += points.rounded(v)[c] / double(corners.size());
  for (const std::uint32_t v : corners)
    for (std::size_t c = 0; c < 3; ++c) size = kernel::maximum(size, std::abs(points.rounded(v)[c] - middle[c]));
  const kernel::Rational scale = kernel::Rational(pair.weight) * kernel::Rational(pair.rounding);
  const auto unscaled = [&](double x) {
    const double near = kernel::nearest_double(kernel::Rational(kernel::Rational(x) / scale));
    if (!std::isfinite(near)) throw No_proof{};
    return near;
  };
  for (double& x : middle) x = unscaled(x);
  return {kernel::exact_point(middle), unscaled(size)};
}

/// True when m is a direction along which hull a ends where hull b begins, or before.
inline bool leads_between(const kernel::Exact_vector& m, const Group_hull& a, const Group_hull& b)
{
  return m != kernel::Exact_vector{0, 0, 0} && !(extent_of(a, m, 1) > extent_of(b, m, -1));
}

/// A body and a pose near its own.
using Start = std::pair<std::size_t, kernel::Pose>;

/// Returns poses from which a body may come to its own: smaller, larger if it holds the other body, or aside. `inside`
/// is as for `leads_free`. `met` is a point that the bodies share at their poses.
inline std::vector<Start> starts_of_ways(Placed_pair& pair, int inside, const Common_point& met)
{
  std::vector<Start> starts;
  const auto add = [&](std::size_t k, const kernel::Rational& factor, const kernel::Rational_point& shift) {
    std::array<kernel::Rational, 12> entries;
    for (std::size_t e = 0; e < 12; ++e) {
      entries[e] = factor * pair.pose[k].exact(int(e));
      if (e % 4 == 3) entries[e] += shift[e / 4];
      const kernel::Rational as_written = e % 4 == 3 ? entries[e] + pair.origin[e / 4] : entries[e];
      if (!std::isfinite(kernel::nearest_double(as_written))) return;
    }
    starts.emplace_back(k, kernel::Pose(entries));
  };
  double size = HUGE_VAL;
  for (const double share : {0.5, 0x1p-4})
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [middle, length] = middle_of(pair, k);
      size = kernel::minimum(size, length);
      const kernel::Rational factor = inside == int(1 - k) ? 1 + share : 1 - share;
      add(k, factor, kernel::scaled(middle, kernel::Rational(1 - factor)));
    }
  for (const kernel::Exact_vector& m : parting_directions(pair.faces(met.piece))) {
    if (!leads_between(m, pair.body[0].hull(met.piece[0]), pair.body[1].hull(met.piece[1]))) continue;
    kernel::Rational_point aside = in_lowest_terms(rational(m));
    const kernel::Rational longest = kernel::longest_part(aside);
    for (kernel::Rational& x : aside) x *= -kernel::Rational(size / 16) / longest;
    add(0, 1, aside);
  }
  return starts;
}

/// Appends a way of one body to its pose, if one of a few is free: the surfaces share no point before its end. `inside`
/// and `met` are as for `starts_of_ways`. False, without a change of the text, where none is free.
inline bool add_way(std::string& text, Placed_pair& pair, int inside, const Common_point& met)
{
  for (const auto& [mover, from] : starts_of_ways(pair, inside, met)) {
    Placed_pair::Poses start = pair.pose;
    start[mover] = from;
    std::string row = text + "{\"of\":\"" + (mover == 0 ? 'a' : 'b') + '"';
    add_pose(row, "pose", pair.written(from));
    if (!leads_free(row, start, pair, inside)) continue;
    text = row + '}';
    return true;
  }
  return false;
}

/// Appends a proof that the interiors share no point: a plane between the bodies, or a way of one without contact.
/// `met` is a common point; where the surfaces share none, the way of a body that stays is free. False where no proof
/// is found; the text is of no use then.
inline bool add_parted(std::string& text, Placed_pair& pair, const std::optional<Common_point>& met)
{
  if (met)
    for (const kernel::Exact_vector& m : parting_directions(pair.faces(met->piece))) {
      if (!leads_between(m, pair.body[0].hull({}), pair.body[1].hull({}))) continue;
      add_key(text, "plane");
      text += strings_of(in_lowest_terms(rational(m)));
      return true;
    }
  add_key(text, "way");
  if (met) return add_way(text, pair, -1, *met);
  text += "{\"of\":\"a\"";
  add_pose(text, "pose", pair.written(pair.pose[0]));
  if (!leads_free(text, pair.pose, pair, -1)) return false;
  text += '}';
  return true;
}

}  // namespace tetracone::tetratree

#endif
