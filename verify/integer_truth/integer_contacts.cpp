#include "verify/integer_truth/integer_contacts.h"

#include "verify/integer_truth/integer_contact.h"
#include "verify/integer_truth/integer_pair.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tetracone::verify::integer_truth {
namespace {

using kernel::Feature;
using kernel::Piece;

/// A point x / w, w > 0, in units of the bodies' common denominator.
struct Place {
  Integer_vector x;
  Integer w;

  Exact_point exactly(const Integer& denominator) const
  {
    Exact_point p;
    for (int k = 0; k < 3; ++k) {
      p[std::size_t(k)] = mpq_class(x[std::size_t(k)], Integer(w * denominator));
      p[std::size_t(k)].canonicalize();
    }
    return p;
  }
};

/// a + share (b - a).
Place between(const Integer_vector& a, const Integer_vector& b, const mpq_class& share)
{
  const Integer &n = share.get_num(), &d = share.get_den();
  Place place{{}, d};
  for (std::size_t k = 0; k < 3; ++k) place.x[k] = a[k] * (d - n) + b[k] * n;
  return place;
}
Place middle(const Place& a, const Place& b)
{
  Place place{{}, Integer(2 * a.w * b.w)};
  for (std::size_t k = 0; k < 3; ++k) place.x[k] = a.x[k] * b.w + b.x[k] * a.w;
  return place;
}

/// One face of a body, and a normal of its plane.
class Side {
 public:
  Side(const Integer_body& body, Index face) : body_(body), face_(face), normal_(body.normal(face)) {}

  const std::optional<Integer_vector>& normal() const { return normal_; }
  const Integer_vector& corner() const { return body_.corner(face_); }

  template <class What>
  void for_edges(const What& what) const
  {
    body_.for_edges(face_, [&](Index from, Index to) { what(body_.point(from), body_.point(to)); });
  }

  Feature locate(const Place& place) const
  {
    Feature at = Feature::none;
    for_edges([&](const Integer_vector& from, const Integer_vector& to) {
      const Integer_vector a = seen(from, place), b = seen(to, place);
      if (is_zero(a)) at = Feature::vertex;
      if (at == Feature::none && is_zero(cross(a, b)) && sgn(dot(a, b)) < 0) at = Feature::edge;
    });
    if (at != Feature::none || !normal_ || sgn(dot(*normal_, seen(corner(), place))) != 0) return at;
    return body_.turns(face_, projection_axis(*normal_), place.x, place.w).winding != 0 ? Feature::interior
                                                                                        : Feature::none;
  }

  /// True when the face contains the point `place` + e direction + e^2 other of its plane for all small e > 0.
  bool is_beside(const Place& place, const Integer_vector& direction, const Integer_vector& other) const
  {
    return body_
               .turns(face_,
                      [&](Index v) {
                        const Integer_vector d = seen(body_.point(v), place);
                        return std::array{dot(d, direction), dot(d, other)};
                      })
               .winding != 0;
  }

 private:
  static Integer_vector seen(const Integer_vector& p, const Place& from)
  {
    return {Integer(p[0] * from.w - from.x[0]), Integer(p[1] * from.w - from.x[1]), Integer(p[2] * from.w - from.x[2])};
  }

  const Integer_body& body_;
  Index face_;
  std::optional<Integer_vector> normal_;
};

/// A pair of faces that are asked what they share.
class Asked_pair {
 public:
  Asked_pair(const Integer_body& a, Index face_a, const Integer_body& b, Index face_b, const Integer& denominator)
      : sides_{Side(a, face_a), Side(b, face_b)}, face_a_(face_a), face_b_(face_b), denominator_(denominator)
  {}

  void add_to(Contact_forms& forms) const
  {
    const auto &m = sides_[0].normal(), &n = sides_[1].normal();
    if (!m || !n || !is_zero(cross(*m, *n)))
      on_line(forms);
    else if (sgn(dot(*m, difference(sides_[1].corner(), sides_[0].corner()))) == 0)
      in_plane(forms);
  }

 private:
  struct Held {
    Feature in_a, in_b;
  };

  std::optional<Held> shared_at(const Place& place) const
  {
    const Held held{sides_[0].locate(place), sides_[1].locate(place)};
    return held.in_a == Feature::none || held.in_b == Feature::none ? std::nullopt : std::optional(held);
  }

  /// The points where edges of the one meet the other, and points that hold what such an edge shares with it.
  void add_stops(const Side& edges, const Side& face, std::vector<Place>& stops) const
  {
    edges.for_edges([&](const Integer_vector& from, const Integer_vector& to) {
      const auto add = [&](const mpq_class& share) { stops.push_back(between(from, to, share)); };
      const auto height = [&](const Integer_vector& p) {
        return face.normal() ? dot(*face.normal(), difference(p, face.corner())) : Integer(0);
      };
      const Integer h = height(from), k = height(to);
      if (sgn(h) * sgn(k) > 0) return;
      if (sgn(h) != 0 || sgn(k) != 0) {
        mpq_class share(h, Integer(h - k));
        share.canonicalize();
        add(share);
        return;
      }
      add(0);
      add(1);
      face.for_edges([&](const Integer_vector& p, const Integer_vector& q) {
        if (const auto common = shared(from, to, p, q)) {
          add(common->first);
          add(common->last);
        }
      });
    });
  }

  void on_line(Contact_forms& forms) const
  {
    std::vector<Place> all;
    add_stops(sides_[0], sides_[1], all);
    add_stops(sides_[1], sides_[0], all);
    std::vector<std::pair<Exact_point, Place>> stops;
    for (const Place& place : all)
      if (shared_at(place)) stops.push_back({place.exactly(denominator_), place});
    const auto position = [](const auto& stop) -> const Exact_point& { return stop.first; };
    std::ranges::sort(stops, {}, position);
    stops.erase(
        std::unique(stops.begin(), stops.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
        stops.end());
    for (std::size_t k = 0; k < stops.size();) {
      std::size_t last = k;
      Feature in_a = Feature::edge, in_b = Feature::edge;
      for (; last + 1 < stops.size(); ++last) {
        const auto held = shared_at(middle(stops[last].second, stops[last + 1].second));
        if (!held) break;
        in_a = std::max(in_a, held->in_a);
        in_b = std::max(in_b, held->in_b);
      }
      const Held at = *shared_at(stops[k].second);
      forms.push_back(
          last == k ? piece_form(face_a_, face_b_, Piece::point, at.in_a, at.in_b, {{stops[k].first}})
                    : piece_form(face_a_, face_b_, Piece::segment, in_a, in_b, {{stops[k].first, stops[last].first}}));
      k = last + 1;
    }
  }

  void in_plane(Contact_forms& forms) const
  {
    std::vector<Exact_segment> border;
    struct Part {
      Exact_segment segment;
      Held held;
    };
    std::vector<Part> parts;
    std::vector<std::pair<Exact_point, Place>> places;
    for (const Side& side : sides_)
      side.for_edges([&](const Integer_vector& from, const Integer_vector& to) {
        std::set<mpq_class> stops = {0, 1};
        for (const Side& other : sides_)
          other.for_edges([&](const Integer_vector& p, const Integer_vector& q) {
            if (const auto common = shared(from, to, p, q)) stops.insert({common->first, common->last});
          });
        for (const mpq_class& stop : stops) {
          const Place place = between(from, to, stop);
          places.push_back({place.exactly(denominator_), place});
        }
        if (from == to) return;
        const Integer_vector along = difference(to, from), left = cross(*sides_[0].normal(), along),
                             right = difference({}, left);
        for (auto stop = stops.begin(); std::next(stop) != stops.end(); ++stop) {
          const Place first = between(from, to, *stop), last = between(from, to, *std::next(stop)),
                      at = middle(first, last);
          const bool on_left = sides_[0].is_beside(at, left, along) && sides_[1].is_beside(at, left, along),
                     on_right = sides_[0].is_beside(at, right, along) && sides_[1].is_beside(at, right, along);
          Exact_segment segment{first.exactly(denominator_), last.exactly(denominator_)};
          if (segment.second < segment.first) std::swap(segment.first, segment.second);
          if (on_left != on_right) border.push_back(segment);
          if (on_left || on_right) continue;
          if (const auto held = shared_at(at)) parts.push_back({segment, *held});
        }
      });
    if (!border.empty())
      forms.push_back(
          {face_a_, face_b_, Piece::polygon, Feature::interior, Feature::interior, maximal_segments(border)});
    std::vector<Exact_segment> segments;
    for (const Part& part : parts) segments.push_back(part.segment);
    segments = maximal_segments(segments);
    for (const Exact_segment& segment : segments) {
      Held held{Feature::edge, Feature::edge};
      for (const Part& part : parts)
        if (is_on(segment, part.segment.first) && is_on(segment, part.segment.second))
          held = {std::max(held.in_a, part.held.in_a), std::max(held.in_b, part.held.in_b)};
      forms.push_back({face_a_, face_b_, Piece::segment, held.in_a, held.in_b, {segment}});
    }
    add_points(places, border, segments, forms);
  }

  void add_points(std::vector<std::pair<Exact_point, Place>>& places, const std::vector<Exact_segment>& border,
                  const std::vector<Exact_segment>& segments, Contact_forms& forms) const
  {
    std::ranges::sort(places, {}, [](const auto& place) -> const Exact_point& { return place.first; });
    const Exact_point* last = nullptr;
    for (const auto& [point, place] : places) {
      if (last != nullptr && *last == point) continue;
      last = &point;
      const auto held = shared_at(place);
      const auto holds = [&p = point](const Exact_segment& s) { return is_on(s, p); };
      if (!held || std::ranges::any_of(border, holds) || std::ranges::any_of(segments, holds)) continue;
      // Off every border: what is beside it in any one direction is all around it.
      const Integer_vector &n = *sides_[0].normal(), along = any_in_plane(n), across = cross(n, along);
      if (sides_[0].is_beside(place, across, along) && sides_[1].is_beside(place, across, along)) continue;
      forms.push_back(piece_form(face_a_, face_b_, Piece::point, held->in_a, held->in_b, {{point}}));
    }
  }

  static Integer_vector any_in_plane(const Integer_vector& normal)
  {
    const Integer_vector first = cross(normal, {1, 0, 0});
    return is_zero(first) ? cross(normal, {0, 1, 0}) : first;
  }

  static bool is_on(const Exact_segment& s, const Exact_point& p)
  {
    if (p < s.first || s.second < p) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      if ((p[k] - s.first[k]) * (s.second[l] - s.first[l]) != (p[l] - s.first[l]) * (s.second[k] - s.first[k]))
        return false;
    }
    return true;
  }

  std::array<Side, 2> sides_;
  Index face_a_, face_b_;
  const Integer& denominator_;
};

}  // namespace

Contact_forms contacts(const Object_case& c)
{
  const auto [denominator, a, b] = integer_pair(c);
  const auto [boxes_a, boxes_b] = element_boxes(a, b);
  Contact_forms forms;
  for (const auto& [i, j] : meeting_boxes(boxes_a.faces, boxes_b.faces))
    Asked_pair(a, i, b, j, denominator).add_to(forms);
  std::sort(forms.begin(), forms.end());
  return forms;
}

}  // namespace tetracone::verify::integer_truth
