#ifndef TETRACONE_KERNEL_CONTACT_RATIONAL_CONTACT_H
#define TETRACONE_KERNEL_CONTACT_RATIONAL_CONTACT_H

#include "tetracone/kernel/contact/coplanar_arrangement.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/floating_point.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::kernel {

namespace detail {

/// An edge of a face, and how far beyond another face's plane its ends are.
struct Seen_edge {
  const Rational_face::Edge* edge;
  Rational start, end;

  /// Returns where the edge goes through the plane. Requires ends on opposite sides.
  Rational_point through() const { return between(edge->first, edge->second, start / (start - end)); }
};

/// Returns the edges of a face, as seen from the plane of another.
inline std::vector<Seen_edge> seen_edges(const Rational_face& face, const Rational_face& plane)
{
  std::vector<Seen_edge> seen;
  for (const Rational_face::Edge& edge : face.edges()) {
    const bool goes_on = !seen.empty() && seen.back().edge->second == edge.first;
    seen.push_back({&edge, goes_on ? seen.back().end : plane.beyond(edge.first), plane.beyond(edge.second)});
  }
  return seen;
}

/// The set that two faces share, when all of it is on one line.
class Line_contact {
 public:
  /// The line is that of both planes, which are not parallel; `direction` is along it. `of_p` are the edges of p as
  /// seen from the plane of q, `of_q` those of q.
  Line_contact(const Rational_face& p, const Rational_face& q, const std::vector<Seen_edge>& of_p,
               const std::vector<Seen_edge>& of_q, const Rational_point& direction)
      : p_(p), q_(q)
  {
    for (const std::vector<Seen_edge>* edges : {&of_p, &of_q})
      for (const Seen_edge& seen : *edges) {
        if (seen.start == 0) stops_.push_back(seen.edge->first);
        if (seen.end == 0) stops_.push_back(seen.edge->second);
        if (sgn(seen.start) * sgn(seen.end) < 0) stops_.push_back(seen.through());
      }
    order_along(direction);
  }

  /// The line goes through `origin` along `direction`, which is not 0.
  Line_contact(const Rational_face& p, const Rational_face& q, const Rational_point& origin,
               const Rational_point& direction)
      : p_(p), q_(q)
  {
    for (const Rational_face* face : {&p_, &q_}) {
      for (const auto& [from, to] : face->edges()) add_meeting(from, to, origin, direction);
      if (const Rational slope = dot(face->normal(), direction); slope != 0)
        stops_.push_back(sum(origin, scaled(direction, Rational(-face->beyond(origin) / slope))));
    }
    order_along(direction);
  }

  /// Returns the pieces in the line's order. Stops are all points of the line where a face or an edge begins or ends.
  std::vector<Rational_piece> operator()() const
  {
    std::vector<Rational_piece> pieces;
    bool open = false;  // the last piece goes on
    for (std::size_t k = 0; k < stops_.size(); ++k) {
      const auto here = shared(stops_[k]);
      if (here && open) {
        pieces.back().loops[0].push_back(stops_[k]);
        widen(pieces.back(), *here);
      } else if (here) {
        pieces.push_back({Piece::point, here->first, here->second, {{stops_[k]}}});
      }
      open = false;
      if (!here || k + 1 == stops_.size()) continue;
      if (const auto beyond = shared(between(stops_[k], stops_[k + 1], Rational(1, 2)))) {
        open = true;
        pieces.back().kind = Piece::segment;
        widen(pieces.back(), *beyond);
      }
    }
    for (Rational_piece& piece : pieces)
      if (auto& ends = piece.loops[0]; ends.size() > 2) ends = {ends.front(), ends.back()};
    return pieces;
  }

 private:
  /// Adds the point where a closed segment meets the line, or both ends of one in it. Seen along the line, the ends of
  /// a crossing segment are on opposite sides.
  void add_meeting(const Rational_point& from, const Rational_point& to, const Rational_point& origin,
                   const Rational_point& direction)
  {
    const Rational_point a = cross(difference(from, origin), direction), b = cross(difference(to, origin), direction);
    if (is_zero(a)) stops_.push_back(from);
    if (is_zero(b)) stops_.push_back(to);
    const Rational apart = dot(a, b);
    if (apart < 0 && is_zero(cross(a, b))) stops_.push_back(between(from, to, dot(a, a) / (dot(a, a) - apart)));
  }

  void order_along(const Rational_point& direction)
  {
    const auto axis =
        std::size_t(std::ranges::find_if(direction, [](const auto& x) { return x != 0; }) - direction.begin());
    std::ranges::sort(stops_, {}, [axis](const Rational_point& x) -> const Rational& { return x[axis]; });
    stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
  }

  /// Returns the features of p and q that hold x; nothing where x is not in both.
  std::optional<std::pair<Feature, Feature>> shared(const Rational_point& x) const
  {
    const Feature of_p = p_.locate(x);
    if (of_p == Feature::none) return std::nullopt;
    const Feature of_q = q_.locate(x);
    if (of_q == Feature::none) return std::nullopt;
    return std::pair(of_p, of_q);
  }

  static void widen(Rational_piece& piece, const std::pair<Feature, Feature>& by)
  {
    // The piece is a segment, so its feature is an edge or a face, never a vertex.
    piece.in_p = maximum(piece.in_p, by.first, Feature::edge);
    piece.in_q = maximum(piece.in_q, by.second, Feature::edge);
  }

  const Rational_face &p_, &q_;
  std::vector<Rational_point> stops_;
};

/// A point where an edge of a face goes through the plane of another.
struct Plane_crossing {
  Rational_point at;
  int of;    // 0: an edge of p, 1: of q
  int turn;  // +1 where the edge comes from the plane's negative side
};

/// Adds the points where edges go through the plane. False where a corner is on the plane.
inline bool add_crossings(const std::vector<Seen_edge>& edges, int of, std::vector<Plane_crossing>& found)
{
  for (const Seen_edge& seen : edges) {
    if (sgn(seen.start) == 0 || sgn(seen.end) == 0) return false;
    if (sgn(seen.start) != sgn(seen.end)) found.push_back({seen.through(), of, sgn(seen.end)});
  }
  return true;
}

/// Returns the segments that the insides of two faces share, in lexicographic order. Returns nothing where a corner on
/// the other's plane, or two crossings at one point, prevent that. It looks at no point twice, unlike `Line_contact`.
inline std::optional<std::vector<Rational_piece>> crossing_pieces(const std::vector<Seen_edge>& of_p,
                                                                  const std::vector<Seen_edge>& of_q)
{
  std::vector<Plane_crossing> on_line;
  std::vector<Rational_piece> pieces;
  if (!add_crossings(of_p, 0, on_line)) return std::nullopt;
  const std::size_t first = on_line.size();
  if (first == 0) return pieces;
  if (!add_crossings(of_q, 1, on_line)) return std::nullopt;
  if (first == on_line.size()) return pieces;
  std::ranges::sort(on_line, [](const Plane_crossing& x, const Plane_crossing& y) { return x.at < y.at; });
  const auto meet = [](const Plane_crossing& x, const Plane_crossing& y) { return x.at == y.at; };
  if (std::ranges::adjacent_find(on_line, meet) != on_line.end()) return std::nullopt;
  std::array<int, 2> winding = {0, 0};
  const Rational_point* start = nullptr;
  for (const Plane_crossing& crossing : on_line) {
    winding[std::size_t(crossing.of)] += crossing.turn;
    const bool is_common = winding[0] != 0 && winding[1] != 0;
    if (!is_common && start)
      pieces.push_back({Piece::segment, Feature::interior, Feature::interior, {{*start, crossing.at}}});
    start = is_common ? start ? start : &crossing.at : nullptr;
  }
  return pieces;
}

}  // namespace detail

/// Returns the set that two closed faces share, in maximal pieces. Polygons, of faces in one plane, come first; then
/// segments and points that no polygon holds. Faces may have holes, cross or touch themselves, and be degenerate.
inline std::vector<Rational_piece> face_contact(const Rational_face& p, const Rational_face& q)
{
  if (!p.has_plane() || !q.has_plane()) {
    const Rational_face& line = p.has_plane() ? q : p;
    // A point has no direction: any will do.
    const Rational_point direction = is_zero(line.along()) ? Rational_point{1, 0, 0} : line.along();
    return detail::Line_contact(p, q, line.origin(), direction)();
  }
  const auto of_p = detail::seen_edges(p, q), of_q = detail::seen_edges(q, p);
  if (auto pieces = detail::crossing_pieces(of_p, of_q)) return *std::move(pieces);
  const Rational_point direction = cross(p.normal(), q.normal());
  if (is_zero(direction)) {
    if (p.beyond(q.origin()) != 0) return {};
    return detail::Coplanar_arrangement(p, q).pieces();
  }
  return detail::Line_contact(p, q, of_p, of_q, direction)();
}

}  // namespace tetracone::kernel

#endif
