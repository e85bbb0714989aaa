#ifndef TETRACONE_TETRATREE_CERTIFICATE_APPROACH_H
#define TETRACONE_TETRATREE_CERTIFICATE_APPROACH_H

#include "tetracone/kernel/contact/rational_contact.h"
#include "tetracone/tetratree/certificate/ways.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Points inside or outside a solid, each with a free segment to a given point. They prove what is next to that point.
namespace tetracone::tetratree {

/// A placed body, and a point x in space to which segments lead. It appends proofs that points are inside or outside,
/// each with a free segment to x.
class Approach {
 public:
  /// `holder` is the body. The points from which segments lead must be binary fractions once they are multiplied by the
  /// denominators of x and of `more`.
  Approach(const Placed_pair& at, std::size_t holder, const kernel::Rational_point& x,
           const kernel::Rational_point& more = {})
      : pair_(at), holder_(holder), x_(x)
  {
    const mpz_class common = lcm(common_denominator(x), common_denominator(more));
    pair_.body[holder] =
        placed(*pair_.body[holder].groups, pair_.pose[holder], pair_.pose[1 - holder], exact(kernel::Rational(common)));
    by_ = kernel::Rational(common) * kernel::Rational(pair_.weight);
  }

  /// Appends y, and the segment from it to x, which meets the surface at its end x at the earliest. False, without a
  /// change of the text, where y is not on the side that `is_inside` names, or the segment is not free.
  bool operator()(std::string& text, const kernel::Rational_point& y, bool is_inside)
  {
    if (y == x_) return false;
    const kernel::Exact_vector start = exact(y, by_), end = exact(x_, by_);
    const auto row = winding_row(pair_, int(holder_), "\"point\":" + strings_of(pair_.written(y)), start);
    if (!row || (row->second != 0) != is_inside) return false;
    Probe_cover cover(pair_.body[holder_], Probe{start, end, {}});
    const bool is_free = cover([&](Box_id, const kernel::Exact_face& f, bool) {
      const auto m = kernel::direction_of_first_touch(f, start, end);
      if (!m) return Probe_cover::Met::stops;
      cover.search().append(cover.search().add(*m));
      return Probe_cover::Met::is_covered;
    });
    if (!is_free) return false;
    text += "{\"winding\":" + row->first;
    add_cover(text, cover.cover());
    text += '}';
    return true;
  }

 private:
  Placed_pair pair_;
  std::size_t holder_;
  kernel::Rational_point x_;
  kernel::Rational by_;  // x times it has the scale of the body
};

/// Appends a point that is inside of body `holder` or, unless `is_inside`, outside, and a free segment from it to x.
/// With `along`, the segment leads against that direction. False, without a change of the text, where no point that is
/// tried serves.
inline bool add_approach(std::string& text, const Placed_pair& at, std::size_t holder, const kernel::Rational_point& x,
                         bool is_inside, const std::optional<kernel::Rational_point>& along = {})
{
  Random_integers random = at.random;
  const kernel::Rational extent = middle_of(at, holder).second;
  if (extent == 0) return false;
  const int size = binary_exponent(extent), length = along ? binary_exponent(kernel::longest_part(*along)) : 0;
  Approach approach(at, holder, x, along.value_or(kernel::Rational_point{}));
  constexpr int most_points = 192, points_of_a_size = 8;
  for (int n = 0; n < most_points; ++n) {
    kernel::Rational_point y = x;
    const int far = size + 1 - n / points_of_a_size;
    if (along && n % points_of_a_size > 0) continue;
    for (std::size_t c = 0; c < 3; ++c)
      y[c] += along ? kernel::times_power((*along)[c], far - length)
                    : kernel::times_power(kernel::Rational(random(10)), far - 10);
    if (approach(text, y, is_inside)) return true;
  }
  return false;
}

/// Appends a proof that a common point, of the inner body, is not in the interior of the other one. False where none is
/// found; the text is of no use then.
inline bool add_border(std::string& text, const Placed_pair& pair, int inner, const Common_point& met)
{
  const kernel::Rational_point x = rational(met.point, pair.weight);
  add_key(text, "border");
  text += "{\"face\":" + std::to_string(pair.source_faces(met.piece)[std::size_t(inner)]);
  add_key(text, "point");
  text += strings_of(pair.written(x));
  add_key(text, "outside");
  if (!add_approach(text, pair, std::size_t(1 - inner), x, false)) return false;
  text += '}';
  return true;
}

/// Returns a common point, and points from it towards the middles of both pieces and between these. Where faces touch
/// in an area, the common point may be on the area's border. Others are within the area.
inline std::vector<kernel::Rational_point> points_near(const Placed_pair& pair, const Common_point& met)
{
  const kernel::Rational_point x = rational(met.point, pair.weight);
  std::array<kernel::Rational_point, 3> way{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& corners = pair.body[k].groups->group(met.piece[k]).corners;
    const kernel::Rational share(1, std::uint32_t(corners.size()));
    for (const std::uint32_t v : corners) {
      const kernel::Rational_point at = rational(pair.body[k].points.exact(v));
      for (std::size_t c = 0; c < 3; ++c) way[k][c] += share * (at[c] / kernel::Rational(pair.weight) - x[c]);
    }
  }
  for (std::size_t c = 0; c < 3; ++c) way[2][c] = (way[0][c] + way[1][c]) / 2;
  std::vector<kernel::Rational_point> points = {x};
  for (const kernel::Rational& part : {kernel::Rational(1, 2), kernel::Rational(1, 16), kernel::Rational(1, 256)})
    for (const kernel::Rational_point& w : way) points.push_back(kernel::sum(x, kernel::scaled(w, part)));
  return points;
}

/// A face of A and one of B, A at an exit. They go through one another when A is a little way before it, and no farther
/// from it than `length` times the direction.
struct Crossing_before {
  std::array<kernel::Rational_face, 2> face;
  kernel::Rational length;
};

/// Appends the row of `add_just_before`, by two faces that go through one another before the exit. False, without a
/// change of the text, where no points serve.
///
/// The middle of the segment that they share moves on a line while A comes to the exit; x is where that line ends.
/// Points beside the segment, one of the four sides of the two faces, are inside of both bodies. Such a point, and
/// the one to which A takes it, lead to x.
inline bool add_from_crossing(std::string& text, const Placed_pair& pair, const kernel::Rational_point& along,
                              const Crossing_before& crossing)
{
  using kernel::Rational;
  using kernel::Rational_point;
  const auto segment_before = [&](const Rational& step) -> std::optional<kernel::Rational_face::Edge> {
    const Rational_point shift = kernel::scaled(along, step);
    auto edges = crossing.face[0].edges();
    for (auto& [from, to] : edges) {
      from = kernel::difference(from, shift);
      to = kernel::difference(to, shift);
    }
    const auto shared = kernel::face_contact(kernel::Rational_face(std::move(edges)), crossing.face[1]);
    if (shared.size() != 1 || shared[0].kind != kernel::Piece::segment) return std::nullopt;
    return std::pair(shared[0].loops[0][0], shared[0].loops[0][1]);
  };
  const double length = crossing.length.get_d();
  if (!(length > 0x1p-900 && length < 0x1p900)) return false;
  for (const int smaller : {1, 4, 8, 16}) {
    const Rational step = std::ldexp(1.0, std::ilogb(length) - smaller);
    const auto segment = segment_before(step), closer = segment_before(step / 2);
    if (!segment || !closer) continue;
    const Rational half(1, 2);
    const Rational_point q = kernel::between(segment->first, segment->second, half),
                         x = kernel::between(q, kernel::between(closer->first, closer->second, half), 2);
    // Vectors across the segment in both faces, as long as it is.
    const Rational_point way = kernel::difference(segment->second, segment->first);
    std::array<kernel::Rounded_vector, 2> across;
    int inside = 0;  // the side that is inside of both where normals lead outwards; it is tried first
    for (std::size_t k = 0; k < 2; ++k) {
      const Rational_point exact_across = kernel::cross(crossing.face[k].normal(), way);
      if (kernel::dot(crossing.face[1 - k].normal(), exact_across) < 0) inside |= 1 << k;
      const Rational by = kernel::longest_part(way) / kernel::longest_part(exact_across);
      for (std::size_t c = 0; c < 3; ++c) across[k][c] = Rational(exact_across[c] * by).get_d();
    }
    Approach of_a(pair, 0, x, along), of_b(pair, 1, x, along);
    for (const double share : {0x1p-2, 0x1p-5})
      for (const int other : {0, 1, 2, 3}) {
        const int side = inside ^ other;
        const double size = share * kernel::longest_part(way).get_d();
        if (!(size > 0x1p-900)) continue;
        const Rational unit = std::ldexp(1.0, std::ilogb(size) - 10);
        Rational_point in_b, in_a;
        for (std::size_t c = 0; c < 3; ++c) {
          const double aside = share * ((side & 1 ? 1 : -1) * across[0][c] + (side & 2 ? 1 : -1) * across[1][c]);
          in_b[c] = rounded_to(unit, q[c] + Rational(aside));
          in_a[c] = in_b[c] + step * along[c];
        }
        std::string both = "{";
        add_key(both, "point");
        both += strings_of(pair.written(x));
        add_key(both, "in_a");
        if (!of_a(both, in_a, true)) continue;
        add_key(both, "in_b");
        if (!of_b(both, in_b, true)) continue;
        text += both + '}';
        return true;
      }
  }
  return false;
}

/// Appends a proof, as a row of `before`, that the interiors share a point just before A comes to its pose. A moves
/// along a direction, and `crossings` are of the end of its way. False, without a change of the text, where none is
/// found.
inline bool add_just_before(std::string& text, Placed_pair pair, const kernel::Rational_point& along,
                            const std::vector<Crossing_before>& crossings)
{
  for (const Crossing_before& crossing : crossings)
    if (add_from_crossing(text, pair, along, crossing)) return true;
  std::string unused = "{";
  const auto met = cover_or_meet(unused, pair);
  if (!met) return false;
  const std::array<kernel::Rational_point, 2> ahead = {along, kernel::negated(along)};
  for (const kernel::Rational_point& x : points_near(pair, *met))
    for (const std::size_t k : {1, 0}) {  // the body of the segment along the direction
      std::string both = "{";
      add_key(both, "point");
      both += strings_of(pair.written(x));
      add_key(both, k == 0 ? "in_a" : "in_b");
      if (!add_approach(both, pair, k, x, true, ahead[k])) continue;
      add_key(both, k == 0 ? "in_b" : "in_a");
      if (!add_approach(both, pair, 1 - k, x, true)) continue;
      text += both + '}';
      return true;
    }
  return false;
}

}  // namespace tetracone::tetratree

#endif
