#ifndef TETRACONE_TETRATREE_CERTIFICATE_WINDINGS_H
#define TETRACONE_TETRATREE_CERTIFICATE_WINDINGS_H

#include "tetracone/tetratree/certificate/placed_pair.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::tetratree {

/// Returns the winding number of a body about a point, by a ray that meets no edge. Appends the ray, the number and the
/// cover. Returns nothing, without a change of the text, where all rays that are tried meet edges, as from a point of
/// the surface. Throws No_proof where the rays are stopped by a face that has no triangles.
inline std::optional<int> add_winding(std::string& text, Covered_body& body, const kernel::Exact_vector& x,
                                      Random_integers& random)
{
  // The first ray leads away from the body's middle, which few faces of it meet if the point is outside.
  kernel::Hull_points point{x};
  kernel::round_together(point, body.points);
  kernel::Rounded_vector sum{};
  double corners = 0;
  body.hull({}).for_few([&](std::uint32_t v) {
    sum = kernel::sum(sum, body.points.rounded(v));
    ++corners;
  });
  kernel::Rounded_vector way = point.rounded(0);
  for (std::size_t c = 0; c < 3; ++c) way[c] -= sum[c] / corners;
  constexpr int most_rays = 60;
  bool lacks_triangles = false;
  for (int k = 0; k < most_rays; ++k) {
    // Few bits first, since short numbers are cheap to check.
    const int bits = 6 + k / 4;
    kernel::Exact_vector direction = {1, 1, 1};
    if (k == 0 && way != kernel::Rounded_vector{})
      direction = kernel::rounded_to_bits(way, bits);
    else if (k > 0)
      for (kernel::Exact_number& c : direction) c = kernel::Exact_number(random(bits));
    if (direction == kernel::Exact_vector{0, 0, 0}) continue;
    Probe_cover cover(body, Probe{x, {}, direction});
    int winding = 0;
    const bool is_generic = cover([&](Box_id, const kernel::Exact_face& face, bool) {
      const auto count = kernel::generic_crossing(face, x, direction, cover.face());
      if (!count) return Probe_cover::Met::stops;
      winding += *count;
      cover.search().append("\"crossed\"");
      return Probe_cover::Met::is_covered;
    });
    lacks_triangles = lacks_triangles || cover.lacks_triangles();
    if (!is_generic) continue;
    add_key(text, "ray");
    text += strings_of(in_lowest_terms(rational(direction)));
    add_key(text, "winding");
    text += std::to_string(winding);
    add_cover(text, cover.cover());
    return winding;
  }
  if (lacks_triangles) throw No_proof{};
  return std::nullopt;
}

/// A row of `windings` as JSON, and its winding number.
using Winding_row = std::pair<std::string, int>;

/// Returns the row of a point x in body `holder`; nothing where `add_winding` finds nothing. `of` is the point's key
/// and value as JSON.
inline std::optional<Winding_row> winding_row(Placed_pair& pair, int holder, const std::string& of,
                                              const kernel::Exact_vector& x)
{
  std::string row = "{";
  add_key(row, "in");
  row += holder == 0 ? "\"a\"," : "\"b\",";
  row += of;
  const auto number = add_winding(row, pair.body[holder], x, pair.random);
  if (!number) return std::nullopt;
  return Winding_row{row + '}', *number};
}

/// Appends rows as `windings`.
inline void add_windings(std::string& text, const std::vector<std::string>& rows)
{
  add_key(text, "windings");
  add_list(text, rows, [](const std::string& row) { return row; });
}

/// Returns a vertex of each shell.
inline const std::vector<Index>& shell_vertices(const Covered_body& body)
{
  return body.groups->tree().model().covering().shell_vertices();
}

/// Returns the row of a vertex of body k in the other one. Throws Error where no ray serves, as for a vertex on the
/// other surface.
inline Winding_row winding_of_vertex(Placed_pair& pair, int k, Index v)
{
  auto row = winding_row(pair, 1 - k, "\"vertex\":" + std::to_string(v), pair.body[k].points.exact(v));
  if (!row) fail_proof("no ray from a vertex goes through faces alone");
  return *std::move(row);
}

/// Appends the winding number of a vertex of each shell of both bodies. True where all shells of A are inside of B, or
/// all outside, as `a_is_inside` says, and all shells of B by `b_is_inside`. Requires surfaces that share no point.
inline bool add_all_windings(std::string& text, Placed_pair& pair, bool a_is_inside = false, bool b_is_inside = false)
{
  std::vector<std::string> rows;
  bool found = true;
  for (int k = 0; k < 2; ++k)
    for (const Index v : shell_vertices(pair.body[k])) {
      auto [row, number] = winding_of_vertex(pair, k, v);
      found = found && (number != 0) == (k == 0 ? a_is_inside : b_is_inside);
      rows.push_back(std::move(row));
    }
  add_windings(text, rows);
  return found;
}

/// Appends the winding number of a vertex of body k that is inside of the other one. False, without a change of the
/// text, where no shell is. Requires surfaces that share no point.
inline bool add_one_winding(std::string& text, Placed_pair& pair, int k)
{
  for (const Index v : shell_vertices(pair.body[k])) {
    const auto [row, number] = winding_of_vertex(pair, k, v);
    if (number == 0) continue;
    add_windings(text, {row});
    return true;
  }
  return false;
}

}  // namespace tetracone::tetratree

#endif
