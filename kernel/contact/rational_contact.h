#ifndef TETRACONE_KERNEL_CONTACT_RATIONAL_CONTACT_H
#define TETRACONE_KERNEL_CONTACT_RATIONAL_CONTACT_H

#include "tetracone/kernel/contact/coplanar_arrangement.h"
#include "tetracone/kernel/contact/rational_face.h"
#include "tetracone/kernel/number/floating_point.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::kernel {

namespace detail {

/// The set that two faces share, when all of it is on one line.
class Line_contact {
 public:
  /// The line goes through `origin` along `direction`, which is not 0.
  Line_contact(const Rational_face& p, const Rational_face& q, Rational_point origin, Rational_point direction)
      : p_(p), q_(q), origin_(std::move(origin)), direction_(std::move(direction))
  {
    while (direction_[axis_] == 0) ++axis_;
    for (const Rational_face* face : {&p_, &q_}) {
      for (const auto& [from, to] : face->edges()) add_meeting(from, to);
      if (const Rational slope = dot(face->normal(), direction_); slope != 0)
        stops_.push_back(at(-face->beyond(origin_) / slope));
    }
    const auto before = [this](const Rational_point& a, const Rational_point& b) { return a[axis_] < b[axis_]; };
    std::sort(stops_.begin(), stops_.end(), before);
    stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
  }

  /// Returns the pieces in the line's order. Stops are all points of the line where a face or one of its edges begins
  /// or ends.
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
  Rational_point at(const Rational& t) const
  {
    Rational_point x;
    for (int k = 0; k < 3; ++k) x[k] = origin_[k] + t * direction_[k];
    return x;
  }

  /// Adds the point where a closed segment meets the line, or both ends of one in it. Seen along the line, the ends of
  /// a crossing segment are on opposite sides.
  void add_meeting(const Rational_point& from, const Rational_point& to)
  {
    const Rational_point a = cross(difference(from, origin_), direction_),
                         b = cross(difference(to, origin_), direction_);
    if (is_zero(a)) stops_.push_back(from);
    if (is_zero(b)) stops_.push_back(to);
    const Rational apart = dot(a, b);
    if (apart < 0 && is_zero(cross(a, b))) stops_.push_back(between(from, to, dot(a, a) / (dot(a, a) - apart)));
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
  Rational_point origin_, direction_;
  int axis_ = 0;
  std::vector<Rational_point> stops_;
};

}  // namespace detail

/// Returns the set that two closed faces share, in maximal pieces: polygons where they are in one plane, then segments
/// and points that no polygon holds. Faces may have holes, cross or touch themselves, and be degenerate.
inline std::vector<Rational_piece> face_contact(const Rational_face& p, const Rational_face& q)
{
  if (!p.has_plane() || !q.has_plane()) {
    const Rational_face& line = p.has_plane() ? q : p;
    // A point has no direction: any will do.
    const Rational_point direction = is_zero(line.along()) ? Rational_point{1, 0, 0} : line.along();
    return detail::Line_contact(p, q, line.origin(), direction)();
  }
  const Rational_point direction = cross(p.normal(), q.normal());
  if (is_zero(direction)) {
    if (p.beyond(q.origin()) != 0) return {};
    return detail::Coplanar_arrangement(p, q).pieces();
  }
  // The line's origin is its point nearest to o. `down` leads there from o, in p's plane and across the line.
  const Rational_point down = cross(direction, p.normal());
  const Rational_point& o = p.origin();
  const Rational t = -q.beyond(o) / dot(q.normal(), down);
  Rational_point origin;
  for (int k = 0; k < 3; ++k) origin[k] = o[k] + t * down[k];
  return detail::Line_contact(p, q, origin, direction)();
}

}  // namespace tetracone::kernel

#endif
