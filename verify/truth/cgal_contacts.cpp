#include "verify/truth/cgal_truth.h"

#include "verify/truth/brute_body.h"
#include "verify/truth/placed_body.h"
#include "verify/truth/shared_shape.h"

#include <CGAL/intersections.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using kernel::Feature;
using kernel::Piece;
using kernel::Rational;
using Shape_point = Exact::Point_3;
using Shape_segment = Exact::Segment_3;

Exact_point form_of(const Shape_point& p) { return {p.x(), p.y(), p.z()}; }

/// One face by its exact image in points, segments and triangles.
struct Contact_face {
  std::vector<std::vector<Shape_point>> elements;  // of one, two or three points
  std::vector<Shape_segment> edges;                // of the loops; one without length is a vertex
  CGAL::Bbox_3 box;

  Contact_face(const covering::Polyhedron& polyhedron, Index f, const kernel::Pose& pose)
  {
    const covering::Polyhedron alone = face_alone(polyhedron, f);
    const Brute_body body(alone);
    const Placed_body placed(body, pose);
    for (const Element& element : body.elements()) {
      elements.emplace_back();
      for (int k = 0; k <= element.dimension; ++k)
        elements.back().push_back(placed.image<Exact>(element.corners[std::size_t(k)]));
    }
    for (std::size_t l = 0; l < alone.loop_count(0); ++l) {
      const auto loop = alone.loop(0, l);
      for (std::size_t k = 0; k < loop.size(); ++k)
        edges.emplace_back(placed.image<Exact>(loop[k]), placed.image<Exact>(loop[(k + 1) % loop.size()]));
    }
    box = placed.whole_box();
  }
};

/// The intersections of elements of two faces: convex parts by their corners, of one, two or more points.
class Parts {
 public:
  std::vector<Shape_point> points;
  std::vector<Shape_segment> segments;
  std::vector<std::vector<Shape_point>> polygons;

  void add(const std::vector<Shape_point>& a, const std::vector<Shape_point>& b)
  {
    if (a.size() > b.size()) return add(b, a);
    if (a.size() == 1 && b.size() == 1) {
      if (a[0] == b[0]) points.push_back(a[0]);
    } else if (a.size() == 1) {
      const bool is_on = b.size() == 2 ? segment(b).has_on(a[0]) : triangle(b).has_on(a[0]);
      if (is_on) points.push_back(a[0]);
    } else if (a.size() == 2) {
      b.size() == 2 ? add_result(CGAL::intersection(segment(a), segment(b)))
                    : add_result(CGAL::intersection(segment(a), triangle(b)));
    } else {
      add_result(CGAL::intersection(triangle(a), triangle(b)));
    }
  }

 private:
  static Shape_segment segment(const std::vector<Shape_point>& p) { return {p[0], p[1]}; }
  static Exact::Triangle_3 triangle(const std::vector<Shape_point>& p) { return {p[0], p[1], p[2]}; }

  template <class Result>
  void add_result(const Result& result)
  {
    if (result) take_shape([this](const auto& shape) { this->take(shape); }, result);
  }
  void take(const Shape_point& p) { points.push_back(p); }
  void take(const Shape_segment& s) { segments.push_back(s); }
  void take(const Exact::Triangle_3& t) { polygons.push_back({t[0], t[1], t[2]}); }
  void take(const std::vector<Shape_point>& polygon) { polygons.push_back(polygon); }
};

/// A part of a segment, by the parameters of its ends in [0, 1].
using Share = std::pair<Rational, Rational>;

/// Returns the part of `whole` that a segment on its line covers; nothing if that is a point or empty.
std::optional<Share> covered(const Shape_segment& whole, const Shape_segment& by)
{
  if (by.is_degenerate() || !CGAL::collinear(whole[0], whole[1], by[0]) || !CGAL::collinear(whole[0], whole[1], by[1]))
    return std::nullopt;
  const auto along = whole.to_vector();
  const Rational length = along.squared_length();
  Rational first = Rational((by[0] - whole[0]) * along) / length, last = Rational((by[1] - whole[0]) * along) / length;
  if (last < first) std::swap(first, last);
  first = std::max(first, Rational(0));
  last = std::min(last, Rational(1));
  return first < last ? std::optional(Share(first, last)) : std::nullopt;
}

/// Returns the parts of a segment that none of these covers.
std::vector<Share> uncovered(std::vector<Share> shares)
{
  std::sort(shares.begin(), shares.end());
  std::vector<Share> left;
  Rational end = 0;
  for (const auto& [first, last] : shares) {
    if (first > end) left.push_back({end, first});
    end = std::max(end, last);
  }
  if (end < 1) left.push_back({end, 1});
  return left;
}

Shape_segment part_of(const Shape_segment& whole, const Share& share)
{
  return {whole[0] + share.first * whole.to_vector(), whole[0] + share.second * whole.to_vector()};
}

Feature holds(const Contact_face& face, const Shape_point& p)
{
  Feature held = Feature::interior;
  for (const Shape_segment& edge : face.edges) {
    if (p == edge[0] || p == edge[1]) return Feature::vertex;
    if (!edge.is_degenerate() && edge.has_on(p)) held = Feature::edge;
  }
  return held;
}

Feature holds(const Contact_face& face, const Shape_segment& s)
{
  std::vector<Share> shares;
  for (const Shape_segment& edge : face.edges)
    if (const auto share = covered(s, edge)) shares.push_back(*share);
  return uncovered(shares).empty() ? Feature::edge : Feature::interior;
}

std::vector<Shape_segment> border_of(const std::vector<Shape_point>& polygon)
{
  std::vector<Shape_segment> border;
  for (std::size_t k = 0; k < polygon.size(); ++k) border.emplace_back(polygon[k], polygon[(k + 1) % polygon.size()]);
  return border;
}

/// Returns the part of `s` in a convex polygon of its plane; nothing if that is a point or empty.
std::optional<Share> covered(const Shape_segment& s, const std::vector<Shape_point>& polygon)
{
  const auto normal = CGAL::cross_product(polygon[1] - polygon[0], polygon[2] - polygon[0]);
  Rational first = 0, last = 1;
  for (const Shape_segment& edge : border_of(polygon)) {
    const auto inward = CGAL::cross_product(normal, edge.to_vector());
    const Rational from = (s[0] - edge[0]) * inward, to = (s[1] - edge[0]) * inward;
    if (from < 0 && to < 0) return std::nullopt;
    if (from < 0 || to < 0) {
      if (from == to) return std::nullopt;
      const Rational at = from / (from - to);
      if (from < 0)
        first = std::max(first, at);
      else
        last = std::min(last, at);
    }
  }
  return first < last ? std::optional(Share(first, last)) : std::nullopt;
}

bool has_on(const std::vector<Shape_point>& polygon, const Shape_point& p)
{
  for (std::size_t k = 2; k < polygon.size(); ++k)
    if (Exact::Triangle_3(polygon[0], polygon[k - 1], polygon[k]).has_on(p)) return true;
  return false;
}

/// Joins the parts of one pair of faces.
class Joined_parts {
 public:
  Joined_parts(const Parts& parts, const Contact_face& a, Index face_a, const Contact_face& b, Index face_b)
      : parts_(parts), a_(a), b_(b), face_a_(face_a), face_b_(face_b)
  {}

  void add_to(Contact_forms& forms) const
  {
    add_polygons(forms);
    std::vector<Shape_segment> whole;
    std::vector<Exact_segment> ends;
    for (const Shape_segment& s : parts_.segments) {
      const Exact_point p = form_of(s[0]), q = form_of(s[1]);
      ends.push_back({std::min(p, q), std::max(p, q)});
    }
    for (const auto& [p, q] : maximal_segments(ends))
      whole.emplace_back(Shape_point(p[0], p[1], p[2]), Shape_point(q[0], q[1], q[2]));
    for (const Shape_segment& s : whole) {
      std::vector<Share> shares;
      for (const auto& polygon : parts_.polygons)
        if (const auto share = covered(s, polygon)) shares.push_back(*share);
      for (const Share& share : uncovered(shares)) {
        const Shape_segment part = part_of(s, share);
        forms.push_back(piece_form(face_a_, face_b_, Piece::segment, holds(a_, part), holds(b_, part),
                                   {{form_of(part[0]), form_of(part[1])}}));
      }
    }
    std::vector<Exact_point> alone;
    for (const Shape_point& p : parts_.points) {
      const bool is_held =
          std::any_of(whole.begin(), whole.end(), [&](const Shape_segment& s) { return s.has_on(p); }) ||
          std::any_of(parts_.polygons.begin(), parts_.polygons.end(),
                      [&](const auto& each) { return has_on(each, p); });
      if (is_held || std::find(alone.begin(), alone.end(), form_of(p)) != alone.end()) continue;
      alone.push_back(form_of(p));
      forms.push_back(piece_form(face_a_, face_b_, Piece::point, holds(a_, p), holds(b_, p), {{form_of(p)}}));
    }
  }

 private:
  /// Joins parts that share more than a point of their borders into one polygon. Its border consists of the points that
  /// no other part shares.
  void add_polygons(Contact_forms& forms) const
  {
    const std::size_t n = parts_.polygons.size();
    std::vector<std::size_t> group(n);
    std::iota(group.begin(), group.end(), std::size_t(0));
    std::map<std::size_t, std::vector<Exact_segment>> borders;
    std::vector<std::vector<Exact_segment>> own(n);
    for (std::size_t k = 0; k < n; ++k)
      for (const Shape_segment& edge : border_of(parts_.polygons[k])) {
        std::vector<Share> shares;
        for (std::size_t l = 0; l < n; ++l) {
          if (l == k) continue;
          for (const Shape_segment& other : border_of(parts_.polygons[l]))
            if (const auto share = covered(edge, other)) {
              shares.push_back(*share);
              const std::size_t from = group[k], to = group[l];
              std::replace(group.begin(), group.end(), from, to);
            }
        }
        for (const Share& share : uncovered(shares)) {
          const Shape_segment part = part_of(edge, share);
          const Exact_point p = form_of(part[0]), q = form_of(part[1]);
          own[k].push_back({std::min(p, q), std::max(p, q)});
        }
      }
    for (std::size_t k = 0; k < n; ++k) {
      auto& border = borders[group[k]];
      border.insert(border.end(), own[k].begin(), own[k].end());
    }
    for (auto& [number, border] : borders)
      forms.push_back({face_a_, face_b_, Piece::polygon, Feature::interior, Feature::interior,
                       maximal_segments(std::move(border))});
  }

  const Parts& parts_;
  const Contact_face &a_, &b_;
  Index face_a_, face_b_;
};

std::vector<Contact_face> contact_faces(const covering::Polyhedron& polyhedron, const kernel::Pose& pose)
{
  std::vector<Contact_face> faces;
  for (Index f = 0; f < polyhedron.face_count(); ++f) faces.emplace_back(polyhedron, f, pose);
  return faces;
}

}  // namespace

Contact_forms contacts(const Object_case& c)
{
  const auto faces_a = contact_faces(*c.a, c.pose_a), faces_b = contact_faces(*c.b, c.pose_b);
  Contact_forms forms;
  for (Index i = 0; i < faces_a.size(); ++i)
    for (Index j = 0; j < faces_b.size(); ++j) {
      if (!CGAL::do_overlap(faces_a[i].box, faces_b[j].box)) continue;
      Parts parts;
      for (const auto& x : faces_a[i].elements)
        for (const auto& y : faces_b[j].elements) parts.add(x, y);
      Joined_parts(parts, faces_a[i], i, faces_b[j], j).add_to(forms);
    }
  std::sort(forms.begin(), forms.end());
  return forms;
}

}  // namespace tetracone::verify
