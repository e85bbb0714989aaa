#ifndef TETRACONE_TETRATREE_CERTIFICATE_SIDES_H
#define TETRACONE_TETRATREE_CERTIFICATE_SIDES_H

#include "tetracone/tetratree/certificate/windings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Points of each side of two surfaces: inside of both solids, or of one alone.
namespace tetracone::tetratree {

/// Returns the times at which a segment's line crosses planes of faces near the segment, ascending. The segment goes
/// from `start`, at 0, to `start + way`, at 1.
inline std::vector<kernel::Rational> crossing_times(Placed_pair& pair, const kernel::Exact_vector& start,
                                                    const kernel::Exact_vector& way)
{
  std::vector<kernel::Rational> times;
  for (Covered_body& body : pair.body) {
    Probe_cover cover(body, Probe{start, kernel::sum(start, way), {}});
    cover([&](Box_id, const kernel::Exact_face& face, bool) {
      if (face.plane) {
        const kernel::Exact_vector normal = kernel::normal_of(*face.plane);
        const kernel::Exact_number slope = kernel::dot(normal, way),
                                   height = kernel::dot(normal, kernel::difference((*face.plane)[0], start));
        if (slope.sign() != CGAL::ZERO) times.push_back(kernel::Rational(height) / kernel::Rational(slope));
      }
      return Probe_cover::Met::is_covered;
    });
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Returns a binary fraction near the middle of two numbers, and between them. Requires low < high.
inline kernel::Rational short_middle(const kernel::Rational& low, const kernel::Rational& high)
{
  mpz_class unit = 1;
  while ((high - low) * unit < 4) unit *= 2;
  return rounded_to(kernel::Rational(1, unit), (low + high) / 2);
}

/// Returns a random piece of a body. Pieces of small groups come more often.
inline Box_id any_piece(const Group_tree& groups, Random_integers& random)
{
  constexpr int bits = 16;
  Box_id box;
  while (!groups.is_piece(box)) {
    const std::vector<Box_id> members = groups.members(box);
    box = members[std::size_t(random(bits) + std::ldexp(0.5, bits)) % members.size()];
  }
  return box;
}

/// Returns a random point in the hull of a piece's corners, in the units of rounded points.
inline kernel::Rounded_vector point_in_hull(const Covered_body& body, Box_id piece, Random_integers& random)
{
  kernel::Rounded_vector sum{};
  double weights = 0;
  for (const std::uint32_t v : body.groups->group(piece).corners) {
    const double weight = random(8) + 0x1p8;
    weights += weight;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * body.points.rounded(v)[c];
  }
  for (double& x : sum) x /= weights;
  return sum;
}

/// Whether a point is inside of A, and of B.
using Membership = std::array<bool, 2>;

/// Appends a point for each of `wanted`, if some lines near a common point, or through faces, have one. All points
/// between two crossings of a line are on one side. So points are found within the thinnest overlap. True when all of
/// `wanted` were found; else the text is of no use.
inline bool add_sides(std::string& text, Placed_pair& pair, const Common_point& met, std::vector<Membership> wanted)
{
  constexpr int most_lines = 144,              // lines tried
      lines_of_a_size = 4,                     // lines tried at one distance from the point; the next are nearer
      lines_of_a_round = lines_of_a_size + 2,  // those, and a line through a face of each body
      bits_nearer = 3;                         // log2 of the ratio of one distance to the next
  constexpr std::size_t most_cells = 6;        // points tried on a line, each between two crossings
  // Lengths are in the units of rounded points, which are finite and not 0.
  const kernel::Rational rounding(pair.rounding), weight(met.point.weight);
  const kernel::Exact_number unit = exact(kernel::Rational(1 / rounding));
  kernel::Rounded_vector middle;
  double size = 0;
  for (int c = 0; c < 3; ++c)
    middle[c] = kernel::Rational(kernel::Rational(met.point.at[c]) / weight * rounding).get_d();
  for (const Covered_body& body : pair.body)
    for (std::size_t v = 0; v < body.points.size(); ++v)
      for (std::size_t c = 0; c < 3; ++c) size = kernel::maximum(size, std::abs(body.points.rounded(v)[c] - middle[c]));
  if (size == 0) return false;
  // Binary digits of the common point below `size`. The last lines are 2^-69 of `size` near it, nearer than doubles.
  constexpr int bits_of_common = 140;
  kernel::Exact_vector common;
  for (int c = 0; c < 3; ++c)
    common[c] = exact(rounded_to(kernel::times_power(1 / rounding, std::ilogb(size) - bits_of_common),
                                 kernel::Rational(met.point.at[c]) / weight));
  const auto pieces = pair.faces(met.piece);
  std::vector<std::string> rows;
  const auto try_point = [&](const kernel::Exact_vector& x) {
    const std::string of = "\"point\":" + strings_of(pair.written(rational(kernel::Exact_point{x}, pair.weight)));
    const auto in_a = winding_row(pair, 0, of, x), in_b = winding_row(pair, 1, of, x);
    if (!in_a || !in_b || std::erase(wanted, Membership{in_a->second != 0, in_b->second != 0}) == 0) return;
    rows.push_back(in_a->first);
    rows.push_back(in_b->first);
  };
  for (int n = 0; n < most_lines && !wanted.empty(); ++n) {
    const int round = n / lines_of_a_round, line = n % lines_of_a_round;
    kernel::Exact_vector exact_way = {kernel::Exact_number(pair.random(20)), kernel::Exact_number(pair.random(20)),
                                      kernel::Exact_number(pair.random(20))};
    kernel::Exact_vector from = common;
    kernel::Rounded_vector aside{};
    if (line < lines_of_a_size) {
      // The lines are along the normals of both pieces, or random.
      for (double& x : aside) x = std::ldexp(size, 1 - bits_nearer * round) * pair.random(20) * 0x1p-20;
      if (line < 2 && pieces[std::size_t(line)].plane) exact_way = kernel::normal_of(*pieces[std::size_t(line)].plane);
    } else {
      // The line is along the normal of a face, from a point in the hull of its corners.
      Covered_body& body = pair.body[std::size_t(line - lines_of_a_size)];
      const Box_id piece = any_piece(*body.groups, pair.random);
      if (const auto plane = body.face(piece).plane) exact_way = kernel::normal_of(*plane);
      from = {};
      aside = point_in_hull(body, piece, pair.random);
    }
    kernel::Hull_points way{exact_way}, none;
    kernel::round_together(way, none);
    if (way.rounded(0) == kernel::Rounded_vector{}) continue;
    const kernel::Exact_vector half =
        kernel::scaled(kernel::rounded_to_bits(way.rounded(0), 20),
                       kernel::Exact_number(std::ldexp(1.0, std::ilogb(size) - 17)) * unit);
    kernel::Exact_vector start;
    for (int c = 0; c < 3; ++c) start[c] = from[c] + kernel::Exact_number(aside[c]) * unit - half[c];
    const kernel::Exact_vector all = kernel::scaled(half, kernel::Exact_number(2));
    const auto times = crossing_times(pair, start, all);
    std::vector<kernel::Rational> cells;
    for (std::size_t k = 1; k < times.size(); ++k) cells.push_back(short_middle(times[k - 1], times[k]));
    const auto distance = [](const kernel::Rational& t) { return kernel::Rational(abs(t - kernel::Rational(1, 2))); };
    std::ranges::sort(cells, {}, distance);
    if (cells.size() > most_cells) cells.resize(most_cells);
    for (const kernel::Rational& t : cells)
      if (!wanted.empty()) try_point(kernel::sum(start, kernel::scaled(all, exact(t))));
  }
  add_windings(text, rows);
  return wanted.empty();
}

}  // namespace tetracone::tetratree

#endif
