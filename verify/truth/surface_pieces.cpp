#include "verify/truth/surface_pieces.h"

#include <CGAL/intersections.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace tetracone::verify {

using kernel::Rational;
using namespace object_family;

namespace {

using Flat_point = std::array<Rational, 2>;
using Flat_line = std::pair<Flat_point, Flat_point>;  // a segment of a plane, its lower end first

Exact::Point_3 point(const Exact_vector& x) { return {x[0], x[1], x[2]}; }

// Calls what(shape) with the element as a shape of CGAL's.
template <class What>
bool with_shape(const Placed_element& element, const What& what)
{
  const auto& [p, q, r] = element.corner;
  switch (element.dimension) {
    case 0: return what(point(p));
    case 1: return what(Exact::Segment_3(point(p), point(q)));
    default: return what(Exact::Triangle_3(point(p), point(q), point(r)));
  }
}

// Twice the signed area of a triangle.
Rational area(const Flat_point& a, const Flat_point& b, const Flat_point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

Rational x_at(const Flat_line& line, const Rational& y)
{
  const auto& [from, to] = line;
  return from[0] + (to[0] - from[0]) * (y - from[1]) / (to[1] - from[1]);
}

// The plane of a triangle, with the two coordinates that are left without the axis.
class Flat_view {
 public:
  explicit Flat_view(const Placed_element& triangle) : origin_(triangle.corner[0]), normal_(triangle.normal)
  {
    for (int k = 1; k < 3; ++k)
      if (abs(normal_[k]) > abs(normal_[axis_])) axis_ = k;
  }

  int axis() const { return axis_; }
  Flat_point project(const Exact_vector& x) const { return {x[(axis_ + 1) % 3], x[(axis_ + 2) % 3]}; }
  Rational height(const Exact_vector& x) const { return dot(normal_, difference(x, origin_)); }

  Exact_vector lift(const Flat_point& p) const
  {
    const int i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
    Exact_vector x;
    x[i] = p[0];
    x[j] = p[1];
    x[axis_] = origin_[axis_] - (normal_[i] * (p[0] - origin_[i]) + normal_[j] * (p[1] - origin_[j])) / normal_[axis_];
    return x;
  }

  // Returns the segments that bound the intersection of the plane and an element. A point is a segment of no length.
  std::vector<Flat_line> trace(const Placed_element& element) const
  {
    std::array<Rational, 3> h;
    std::vector<Exact_vector> on;
    for (int i = 0; i <= element.dimension; ++i) {
      h[i] = height(element.corner[i]);
      if (sgn(h[i]) == 0) on.push_back(element.corner[i]);
    }
    for (int i = 0; i <= element.dimension; ++i)
      for (int j = 0; j < i; ++j)
        if (sgn(h[i]) * sgn(h[j]) < 0)
          on.push_back(
              sum(element.corner[i], Rational(h[i] / (h[i] - h[j])), difference(element.corner[j], element.corner[i])));
    if (on.size() == 1) on.push_back(on[0]);
    std::vector<Flat_line> lines;
    for (std::size_t k = on.size() == 2 ? 1 : 0; k < on.size(); ++k) {
      Flat_line line(project(on[k]), project(on[(k + 1) % on.size()]));
      if (line.second[1] < line.first[1]) std::swap(line.first, line.second);
      lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  Exact_vector origin_, normal_;
  int axis_ = 0;
};

std::vector<Rational> sorted_once(std::vector<Rational> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

// Returns the height at which two segments of a plane cross; nothing when they are parallel or share no point.
std::optional<Rational> crossing_height(const Flat_line& a, const Flat_line& b)
{
  const Rational from = area(a.first, a.second, b.first), to = area(a.first, a.second, b.second);
  if (from == to || sgn(from) * sgn(to) > 0) return std::nullopt;
  if (sgn(area(b.first, b.second, a.first)) * sgn(area(b.first, b.second, a.second)) > 0) return std::nullopt;
  return Rational(b.first[1] + (b.second[1] - b.first[1]) * from / (from - to));
}

// Cuts one triangle into trapezoids between the heights at which something of its plane begins, ends or crosses.
class Cut_triangle {
 public:
  using Surfaces = std::array<std::vector<Placed_element>, 2>;

  Cut_triangle(const Surfaces& surfaces, int body, const Placed_element& triangle)
      : surfaces_(surfaces), body_(body), triangle_(triangle), plane_(triangle)
  {
    for (const auto& surface : surfaces)
      for (const Placed_element& element : surface)
        if (&element != &triangle && element.is_near(triangle))
          for (Flat_line& line : plane_.trace(element))
            if (!is_beside(line)) lines_.push_back(std::move(line));
    edges_ = plane_.trace(triangle);
    lines_.insert(lines_.end(), edges_.begin(), edges_.end());
  }

  void add_pieces(std::vector<Surface_piece>& pieces) const
  {
    const std::vector<Rational> heights = slab_heights();
    for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
      const Rational &low = heights[k], &high = heights[k + 1], middle = (low + high) / 2;
      const auto crosses = [&](const Flat_line& line) { return line.first[1] <= low && line.second[1] >= high; };
      std::vector<Rational> ends;
      for (const Flat_line& edge : edges_)
        if (crosses(edge)) ends.push_back(x_at(edge, middle));
      const auto [left, right] = std::minmax(ends.front(), ends.back());
      std::vector<std::pair<Rational, const Flat_line*>> crossing;
      for (const Flat_line& line : lines_)
        if (crosses(line)) crossing.emplace_back(x_at(line, middle), &line);
      std::erase_if(crossing, [&, l = left, r = right](const auto& c) { return c.first < l || c.first > r; });
      std::sort(crossing.begin(), crossing.end());
      const auto is_same = [](const auto& c, const auto& d) { return c.first == d.first; };
      crossing.erase(std::unique(crossing.begin(), crossing.end(), is_same), crossing.end());
      for (std::size_t i = 0; i + 1 < crossing.size(); ++i)
        pieces.push_back(piece(*crossing[i].second, *crossing[i + 1].second, low, high));
    }
  }

 private:
  // True when a segment of the plane does not enter the triangle's inside, because it is beside one of the edges.
  bool is_beside(const Flat_line& line) const
  {
    std::array<Flat_point, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = plane_.project(triangle_.corner[i]);
    const int turn = sgn(area(p[0], p[1], p[2]));
    for (int i = 0; i < 3; ++i) {
      const auto side = [&](const Flat_point& x) { return turn * sgn(area(p[i], p[(i + 1) % 3], x)); };
      if (side(line.first) <= 0 && side(line.second) <= 0) return true;
    }
    return false;
  }

  std::vector<Rational> slab_heights() const
  {
    std::vector<Rational> heights;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      heights.push_back(lines_[i].first[1]);
      heights.push_back(lines_[i].second[1]);
      for (std::size_t j = 0; j < i; ++j)
        if (const auto height = crossing_height(lines_[i], lines_[j])) heights.push_back(*height);
    }
    Rational low = edges_[0].first[1], high = low;
    for (const Flat_line& edge : edges_) {
      low = std::min(low, edge.first[1]);
      high = std::max(high, edge.second[1]);
    }
    std::erase_if(heights, [&](const Rational& height) { return height < low || height > high; });
    return sorted_once(std::move(heights));
  }

  Surface_piece piece(const Flat_line& left, const Flat_line& right, const Rational& low, const Rational& high) const
  {
    Surface_piece piece;
    piece.body = body_;
    const auto at = [&](const Rational& y, const Rational& share) {
      const Rational from = x_at(left, y);
      return plane_.lift({Rational(from + share * (x_at(right, y) - from)), y});
    };
    piece.corner = {at(low, 0), at(low, 1), at(high, 1), at(high, 0)};
    // Inner points of the piece are tried until no edge is above or below one. A line of the plane has at most three of
    // them, since they lie on a cubic.
    for (int k = 2;; ++k) {
      const Rational share(1, k);
      if (locate(at(low + share * (high - low), share * share), piece)) return piece;
    }
  }

  // Finds what is said of a piece at an inner point; false when an edge is above or below the point.
  bool locate(const Exact_vector& p, Surface_piece& piece) const
  {
    const int axis = plane_.axis();
    piece.is_first = true;
    bool is_before = true;
    for (int body = 0; body < 2; ++body) {
      int above = 0, here = 0;
      piece.is_on[body] = false;
      for (const Placed_element& element : surfaces_[body]) {
        if (&element == &triangle_) is_before = false;
        const std::optional<int> turn = turn_about(p, element, axis);
        if (!turn) return false;
        if (*turn == 0) continue;
        const Rational height = *turn * dot(element.normal, difference(p, element.corner[0]));
        if (sgn(height) < 0) above += *turn * element.winding;
        if (sgn(height) != 0) continue;
        here += *turn * element.winding;
        piece.is_on[body] = true;
        piece.is_first = piece.is_first && !is_before;
      }
      piece.winding[body] = {above + here, above};
    }
    return true;
  }

  // Returns how an element turns about a point, seen against the axis: 1, -1, or 0 where the point is beside it.
  // Returns nothing where the point is on its border.
  static std::optional<int> turn_about(const Exact_vector& p, const Placed_element& element, int axis)
  {
    if (element.dimension < 2) return 0;
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    for (const int k : {i, j})
      if (p[k] < element.low[k] || p[k] > element.high[k]) return 0;
    if (p[axis] > element.high[axis]) return 0;  // below the point
    const auto seen = [&](const Exact_vector& x) { return Flat_point{x[i], x[j]}; };
    bool left = false, right = false, border = false;
    for (int k = 0; k < 3; ++k) {
      const int side = sgn(area(seen(element.corner[k]), seen(element.corner[(k + 1) % 3]), seen(p)));
      left = left || side > 0;
      right = right || side < 0;
      border = border || side == 0;
    }
    if (left && right) return 0;
    if (border) return std::nullopt;
    return left ? 1 : -1;
  }

  const Surfaces& surfaces_;
  int body_;
  const Placed_element& triangle_;
  Flat_view plane_;
  std::vector<Flat_line> lines_, edges_;
};

// Adds the parameters of pq at which it meets the line through a and b. Where that is the line of pq, it adds those of
// the ends of ab.
void add_parameters(const Exact_vector& p, const Exact_vector& q, const Exact_vector& a, const Exact_vector& b,
                    std::vector<Rational>& parameters)
{
  const Exact_vector d = difference(q, p), e = difference(b, a), n = cross(d, e);
  if (!is_zero(n)) {
    if (dot(difference(a, p), n) == 0) parameters.push_back(Rational(dot(cross(difference(a, p), e), n) / dot(n, n)));
    return;
  }
  for (const Exact_vector* end : {&a, &b})
    if (is_zero(cross(difference(*end, p), d))) parameters.push_back(Rational(dot(difference(*end, p), d) / dot(d, d)));
}

}  // namespace

Placed_element::Placed_element(int dimension, int winding, const std::array<Exact_vector, 3>& corner)
    : dimension(dimension),
      winding(winding),
      corner(corner),
      low(corner[0]),
      high(corner[0]),
      normal(cross(difference(corner[1], corner[0]), difference(corner[2], corner[0])))
{
  for (const Exact_vector& x : corner)
    for (int k = 0; k < 3; ++k) {
      if (x[k] < low[k]) low[k] = x[k];
      if (x[k] > high[k]) high[k] = x[k];
    }
}

bool Placed_element::is_near(const Placed_element& other) const
{
  for (int k = 0; k < 3; ++k)
    if (low[k] > other.high[k] || high[k] < other.low[k]) return false;
  return true;
}

bool meet(const Placed_element& x, const Placed_element& y)
{
  return x.is_near(y) && with_shape(x, [&](const auto& shape_x) {
           return with_shape(
               y, [&](const auto& shape_y) { return bool(Exact().do_intersect_3_object()(shape_x, shape_y)); });
         });
}

mpz_class common_denominator(const Placed_body& placed)
{
  mpz_class common = 1;
  for (Index v = 0; v < placed.body().points().size(); ++v)
    for (int k = 0; k < 3; ++k) common = lcm(common, placed.image<Exact>(v)[k].get_den());
  return common;
}

std::vector<Placed_element> placed_elements(const Placed_body& placed, const mpz_class& scale)
{
  std::vector<Placed_element> elements;
  for (const Element& element : placed.body().elements()) {
    std::array<Exact_vector, 3> corner;
    for (int i = 0; i < 3; ++i) {
      const Exact::Point_3& x = placed.image<Exact>(element.corners[i <= element.dimension ? i : 0]);
      corner[i] = times(Rational(scale), {x.x(), x.y(), x.z()});
    }
    elements.emplace_back(element.dimension, element.winding, corner);
  }
  return elements;
}

std::vector<Surface_piece> surface_pieces(const std::array<std::vector<Placed_element>, 2>& surfaces)
{
  std::vector<Surface_piece> pieces;
  for (int body = 0; body < 2; ++body)
    for (const Placed_element& element : surfaces[body])
      if (element.dimension == 2) Cut_triangle(surfaces, body, element).add_pieces(pieces);
  return pieces;
}

bool share_interior(const std::vector<Surface_piece>& pieces)
{
  return std::ranges::any_of(pieces,
                             [](const Surface_piece& piece) { return piece.is_common(0) || piece.is_common(1); });
}

std::vector<Curve_piece> curve_pieces(const std::array<std::vector<Placed_element>, 2>& surfaces)
{
  std::vector<Curve_piece> pieces;
  for (int body = 0; body < 2; ++body)
    for (const Placed_element& element : surfaces[body]) {
      if (element.dimension == 2) continue;
      const auto &p = element.corner[0], &q = element.corner[1];
      if (element.dimension == 0) {
        pieces.push_back({p, p, p, body});
        continue;
      }
      std::vector<Rational> parameters = {0, 1};
      for (const auto& surface : surfaces)
        for (const Placed_element& other : surface) {
          if (!other.is_near(element)) continue;
          for (int k = 0; k < 3; ++k) add_parameters(p, q, other.corner[k], other.corner[(k + 1) % 3], parameters);
          if (other.dimension < 2) continue;
          const Rational from = dot(other.normal, difference(p, other.corner[0])),
                         to = dot(other.normal, difference(q, other.corner[0]));
          if (from != to) parameters.push_back(Rational(from / (from - to)));
        }
      std::erase_if(parameters, [](const Rational& t) { return t < 0 || t > 1; });
      parameters = sorted_once(std::move(parameters));
      const auto at = [&](const Rational& t) { return sum(p, t, difference(q, p)); };
      for (std::size_t k = 0; k + 1 < parameters.size(); ++k)
        pieces.push_back(
            {at(parameters[k]), at(parameters[k + 1]), at(Rational((parameters[k] + parameters[k + 1]) / 2)), body});
    }
  return pieces;
}

}  // namespace tetracone::verify
