#ifndef TETRACONE_TETRATREE_CERTIFICATE_APPROACH_H
#define TETRACONE_TETRATREE_CERTIFICATE_APPROACH_H

#include "tetracone/tetratree/certificate/ways.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Points inside or outside a solid, each with a free segment to a given point. They prove what is next to that point.
namespace tetracone::tetratree {

/// Appends a point that is inside of body `holder` or, unless `is_inside`, outside, and a segment from it to x. The
/// segment meets the surface at its end x at the earliest. With `along`, it leads against that direction. False where
/// none of the points that are tried has both.
inline bool add_approach(std::string& text, const Placed_pair& at, std::size_t holder, const kernel::Rational_point& x,
                         bool is_inside, const std::optional<kernel::Rational_point>& along = {})
{
  Placed_pair pair = at;
  const double size = middle_of(pair, holder).second, length = along ? longest_part(*along).get_d() : 1;
  const mpz_class common = along ? lcm(common_denominator(x), common_denominator(*along)) : common_denominator(x);
  pair.body[holder] =
      placed(*pair.body[holder].groups, pair.pose[holder], pair.pose[1 - holder], exact(kernel::Rational(common)));
  const kernel::Rational by = kernel::Rational(common) * kernel::Rational(pair.weight);
  constexpr int most_points = 192, points_of_a_size = 8;
  const auto weighted = [&](const kernel::Rational_point& p) { return exact(p, by); };
  for (int n = 0; n < most_points; ++n) {
    kernel::Rational_point y = x;
    const double far = std::ldexp(size, 1 - n / points_of_a_size);
    if (along && n % points_of_a_size > 0) continue;
    for (std::size_t c = 0; c < 3; ++c)
      y[c] += along ? kernel::Rational(kernel::Rational(std::exp2(std::rint(std::log2(far / length)))) * (*along)[c])
                    : kernel::Rational(far * pair.random(10) * 0x1p-10);
    if (y == x) continue;
    const auto row = winding_row(pair, int(holder), "\"point\":" + strings_of(y), weighted(y));
    if (!row || (row->second != 0) != is_inside) continue;
    Probe_cover cover(pair.body[holder], Probe{weighted(y), weighted(x), {}});
    const bool is_free = cover([&](Box_id, const kernel::Exact_face& f, bool) {
      const auto m = kernel::direction_of_first_touch(f, weighted(y), weighted(x));
      if (!m) return Probe_cover::Met::stops;
      cover.search().append(cover.search().add(*m));
      return Probe_cover::Met::is_covered;
    });
    if (!is_free) continue;
    text += "{\"winding\":" + row->first;
    add_cover(text, cover.cover());
    text += '}';
    return true;
  }
  return false;
}

/// Appends a proof that a point of the inner body is not in the interior of the other one. False where none is found.
inline bool add_border(std::string& text, const Placed_pair& pair, int inner, const Common_point& met)
{
  const kernel::Rational_point x = rational(met.point, pair.weight);
  add_key(text, "border");
  text += "{\"face\":" + std::to_string(pair.source_faces(met.piece)[std::size_t(inner)]);
  add_key(text, "point");
  text += strings_of(x);
  add_key(text, "outside");
  if (!add_approach(text, pair, std::size_t(1 - inner), x, false)) return false;
  text += '}';
  return true;
}

/// Returns a common point, and points from it towards the middles of both pieces. Where faces touch in an area, the
/// common point may be on the area's border. The others are within the area.
inline std::vector<kernel::Rational_point> points_near(const Placed_pair& pair, const Common_point& met)
{
  const kernel::Rational_point x = rational(met.point, pair.weight);
  std::array<kernel::Rational_point, 3> way{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& corners = pair.body[k].groups->group(met.piece[k]).corners;
    const kernel::Rational share(1, std::uint32_t(corners.size()));
    for (const std::uint32_t v : corners) {
      const kernel::Rational_point at = rational(pair.body[k].points.exact[v]);
      for (std::size_t c = 0; c < 3; ++c) way[k][c] += share * (at[c] / kernel::Rational(pair.weight) - x[c]);
    }
  }
  for (std::size_t c = 0; c < 3; ++c) way[2][c] = (way[0][c] + way[1][c]) / 2;
  std::vector<kernel::Rational_point> points = {x};
  for (const kernel::Rational& part : {kernel::Rational(1, 2), kernel::Rational(1, 16), kernel::Rational(1, 256)})
    for (const kernel::Rational_point& w : way)
      points.push_back({x[0] + part * w[0], x[1] + part * w[1], x[2] + part * w[2]});
  return points;
}

/// Appends a proof that the interiors share a point just before A, moved along a direction, comes to its pose.
inline bool add_just_before(std::string& text, Placed_pair pair, const kernel::Rational_point& along)
{
  std::string unused = "{";
  const auto met = cover_or_meet(unused, pair);
  if (!met) return false;
  const std::array<kernel::Rational_point, 2> ahead = {along, {-along[0], -along[1], -along[2]}};
  for (const kernel::Rational_point& x : points_near(pair, *met))
    for (const std::size_t k : {1, 0}) {  // the body of the segment along the direction
      std::string both = text + (text.back() == '[' ? "{" : ",{");
      add_key(both, "point");
      both += strings_of(x);
      add_key(both, k == 0 ? "in_a" : "in_b");
      if (!add_approach(both, pair, k, x, true, ahead[k])) continue;
      add_key(both, k == 0 ? "in_b" : "in_a");
      if (!add_approach(both, pair, 1 - k, x, true)) continue;
      text = both + '}';
      return true;
    }
  return false;
}

}  // namespace tetracone::tetratree

#endif
