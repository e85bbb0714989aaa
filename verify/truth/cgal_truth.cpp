#include "verify/truth/cgal_truth.h"

#include "verify/truth/edge_face.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tetracone::verify {

namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

bool meet(const CGAL::Bbox_3& a, const CGAL::Bbox_3& b) { return CGAL::do_overlap(a, b); }

CGAL::Bbox_3 hull(const std::vector<Box>& boxes)
{
  CGAL::Bbox_3 hull;
  for (const Box& box : boxes) hull += box.bbox();
  return hull;
}

// Calls report(i, j) for all pairs of boxes a[i], b[j] that meet. Boxes are closed: touching counts.
template <class Report>
void for_pairs(std::vector<Box> a, std::vector<Box> b, Report&& report)
{
  const CGAL::Bbox_3 all_a = hull(a), all_b = hull(b);
  std::erase_if(a, [&](const Box& box) { return !meet(box.bbox(), all_b); });
  std::erase_if(b, [&](const Box& box) { return !meet(box.bbox(), all_a); });
  CGAL::box_intersection_d(a.begin(), a.end(), b.begin(), b.end(),
                           [&](const Box& x, const Box& y) { report(x.info(), y.info()); });
}

// Returns the boxes of the elements that meet `near`.
std::vector<Box> element_boxes(const Placed_body& placed, const CGAL::Bbox_3& near)
{
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < placed.element_boxes().size(); ++i)
    if (meet(placed.element_boxes()[i], near)) boxes.emplace_back(placed.element_boxes()[i], i);
  return boxes;
}

// Calls what(shape) with the image of the element as a point, segment or triangle of K.
template <class K, class What>
auto with_shape(const Placed_body& placed, const Element& element, What&& what)
{
  const auto corner = [&](int i) { return placed.template image<K>(element.corners[i]); };
  switch (element.dimension) {
    case 0: return what(corner(0));
    case 1: return what(typename K::Segment_3(corner(0), corner(1)));
    default: return what(typename K::Triangle_3(corner(0), corner(1), corner(2)));
  }
}

// Returns how a ray from p through q meets the triangle: 0 not, +-1 through its inside, along or against its normal.
// Returns nothing when it may go through its border or in its plane. Requires p not on the triangle.
template <class K>
std::optional<int> crossing(const typename K::Point_3& p, const typename K::Point_3& q,
                            const std::array<typename K::Point_3, 3>& triangle)
{
  bool left = false, right = false, border = false;
  for (int i = 0; i < 3; ++i) {
    const CGAL::Sign turn = CGAL::orientation(p, q, triangle[i], triangle[(i + 1) % 3]);
    left = left || turn == CGAL::POSITIVE;
    right = right || turn == CGAL::NEGATIVE;
    border = border || turn == CGAL::ZERO;
  }
  if (left && right) return 0;
  if (border) return std::nullopt;
  const CGAL::Sign side = CGAL::orientation(triangle[0], triangle[1], triangle[2], p);
  if (left) return side == CGAL::NEGATIVE ? 1 : 0;
  return side == CGAL::POSITIVE ? -1 : 0;
}

// A point as a placed body.
struct Dot {
  explicit Dot(const std::array<kernel::Rational, 3>& x)
      : placed(body, Pose({1, 0, 0, x[0], 0, 1, 0, x[1], 0, 0, 1, x[2]}))
  {}

  static covering::Polyhedron origin()
  {
    covering::Polyhedron origin;
    origin.vertices = {{0, 0, 0}};
    origin.add_polygon({0});
    return origin;
  }

  const Brute_body body{origin()};
  const Placed_body placed;
};

bool is_nested(const Placed_body& a, const Placed_body& b) { return detail::contains(a, b) || detail::contains(b, a); }

// Adds the pairs of edges of one body and faces of the other.
void add_features(const Placed_body& with_edges, const Placed_body& with_faces, int body,
                  std::vector<Feature_pair>& features)
{
  const auto& edges = with_edges.body().edges();
  const covering::Polyhedron& polyhedron = with_faces.body().polyhedron();
  std::vector<Box> edge_boxes, face_boxes;
  for (std::size_t e = 0; e < edges.size(); ++e)
    edge_boxes.emplace_back(with_edges.box(std::array{edges[e].first, edges[e].second}), e);
  for (Index f = 0; f < polyhedron.face_count(); ++f) {
    CGAL::Bbox_3 box;
    for (std::size_t k = 0; k < polyhedron.loop_count(f); ++k) box += with_faces.box(polyhedron.loop(f, k));
    face_boxes.emplace_back(box, f);
  }
  std::vector<std::pair<Index, std::size_t>> candidates;  // face, edge
  for_pairs(edge_boxes, face_boxes, [&](std::size_t e, std::size_t f) {
    const auto& base = with_faces.body().base(Index(f));
    const bool beside = base && decide(with_edges, with_faces, [&]<class K>(K) -> bool {
                          const auto side = [&](Index v) {
                            const auto corner = [&](int i) { return with_faces.template image<K>((*base)[i]); };
                            return CGAL::orientation(corner(0), corner(1), corner(2), with_edges.template image<K>(v));
                          };
                          const CGAL::Sign from = side(edges[e].first);
                          return from != CGAL::ZERO && from == side(edges[e].second);
                        });
    if (!beside) candidates.emplace_back(Index(f), e);
  });
  std::sort(candidates.begin(), candidates.end());
  std::optional<Planar_face> face;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto [f, e] = candidates[i];
    if (i == 0 || candidates[i - 1].first != f) face = detail::placed_face(with_faces, f);
    const auto [from, to] = edges[e];
    const kernel::Contact kind = edge_face(with_edges.image<Exact>(from), with_edges.image<Exact>(to), *face);
    if (kind != kernel::Contact::none) features.push_back({body, from, to, f, kind});
  }
}

}  // namespace

namespace detail {

bool elements_meet(const Placed_body& a, const Element& x, const Placed_body& b, const Element& y)
{
  return decide(a, b, [&]<class K>(K kernel) -> bool {
    return with_shape<K>(a, x, [&](const auto& shape_a) -> bool {
      return with_shape<K>(
          b, y, [&](const auto& shape_b) -> bool { return kernel.do_intersect_3_object()(shape_a, shape_b); });
    });
  });
}

int winding(const Placed_body& solid, const Placed_body& other, Index point)
{
  const CGAL::Bbox_3 origin = other.box(std::array{point});
  for (double s = 0.4375;; s += 0.8125) {
    std::optional<int> sum = 0;
    for (std::size_t i = 0; i < solid.body().elements().size(); ++i) {
      const Element& element = solid.body().elements()[i];
      if (element.dimension < 2) continue;
      // The directions are positive: a triangle below p in some coordinate is never met.
      const CGAL::Bbox_3& box = solid.element_boxes()[i];
      if (box.xmax() < origin.xmin() || box.ymax() < origin.ymin() || box.zmax() < origin.zmin()) continue;
      const auto cross = decide(solid, other, [&]<class K>(K) {
        const auto corner = [&](int i) { return solid.template image<K>(element.corners[i]); };
        const auto p = other.template image<K>(point);
        const typename K::FT t(s);
        const typename K::Point_3 q(p.x() + 1, p.y() + t, p.z() + t * t);
        return crossing<K>(p, q, {corner(0), corner(1), corner(2)});
      });
      if (!cross) {
        sum.reset();
        break;
      }
      *sum += *cross * element.winding;
    }
    if (sum) return *sum;
  }
}

int winding(const Placed_body& solid, const std::array<kernel::Rational, 3>& point)
{
  return winding(solid, Dot(point).placed, 0);
}

bool surfaces_meet(const Placed_body& a, const Placed_body& b)
{
  if (!meet(a.whole_box(), b.whole_box())) return false;
  struct Found {};  // the way out of CGAL's box pairs at the first hit
  try {
    for_pairs(element_boxes(a, b.whole_box()), element_boxes(b, a.whole_box()), [&](std::size_t i, std::size_t j) {
      if (elements_meet(a, a.body().elements()[i], b, b.body().elements()[j])) throw Found();
    });
  } catch (const Found&) {
    return true;
  }
  return false;
}

bool contains(const Placed_body& outer, const Placed_body& inner)
{
  for (const Index point : inner.body().component_points())
    if (meet(outer.whole_box(), inner.box(std::array{point})) && winding(outer, inner, point) != 0) return true;
  return false;
}

void require_closed(const Placed_body& a, const Placed_body& b)
{
  if (!(a.body().is_closed() && b.body().is_closed())) throw std::invalid_argument("an open surface has no solid");
}

Planar_face placed_face(const Placed_body& placed, Index f)
{
  return planar_face(placed.body().polyhedron(), f, [&](Index v) { return placed.image<Exact>(v); });
}

}  // namespace detail

bool collide(const Placed_body& a, const Placed_body& b, Question question)
{
  if (question == Question::solid) detail::require_closed(a, b);
  return detail::surfaces_meet(a, b) || (question == Question::solid && is_nested(a, b));
}

Both_answers collide_both(const Placed_body& a, const Placed_body& b)
{
  detail::require_closed(a, b);
  const bool surface = detail::surfaces_meet(a, b);
  return {surface, surface || is_nested(a, b)};
}

bool collide(const Brute_body& a, const Pose& pose_a, const Brute_body& b, const Pose& pose_b, Question question)
{
  return collide(Placed_body(a, pose_a), Placed_body(b, pose_b), question);
}

int inside(const Placed_body& solid, const std::array<kernel::Rational, 3>& point)
{
  if (!solid.body().is_closed()) throw std::invalid_argument("an open surface has no solid");
  const Dot dot(point);
  if (detail::surfaces_meet(solid, dot.placed)) return 0;
  return detail::winding(solid, dot.placed, 0) != 0 ? 1 : -1;
}

int inside(const Brute_body& body, const std::array<kernel::Rational, 3>& point)
{
  return inside(Placed_body(body, Pose()), point);
}

std::vector<Feature_pair> features(const Placed_body& a, const Placed_body& b)
{
  std::vector<Feature_pair> features;
  add_features(a, b, 0, features);
  add_features(b, a, 1, features);
  std::sort(features.begin(), features.end());
  return features;
}

std::vector<Feature_pair> features(const Brute_body& a, const Pose& pose_a, const Brute_body& b, const Pose& pose_b)
{
  return features(Placed_body(a, pose_a), Placed_body(b, pose_b));
}

}  // namespace tetracone::verify
