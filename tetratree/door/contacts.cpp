#include "tetracone/tetratree/door/contacts.h"

#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/contact/rational_map.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/interval.h"
#include "tetracone/kernel/number/nearest_root.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/contacts_data.h"

#include <CGAL/gmpxx.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace tetracone {
namespace {

using detail::Contacts_data;
using kernel::Rational;
using kernel::Rational_point;
using Loops = std::vector<std::vector<Rational_point>>;

template <class N, class Number_of>
std::array<N, 12> entries(const kernel::Pose& pose, const Number_of& number_of)
{
  std::array<N, 12> m;
  for (int k = 0; k < 12; ++k) m[k] = number_of(pose, k);
  return m;
}

/// A vertex of triangle A or B, by its number there.
struct Triangle_vertex {
  bool is_of_b;
  int number;
};

/// Returns the vertex that a corner of a piece is; nothing where it is only on edges or in faces.
std::optional<Triangle_vertex> vertex_of(const kernel::Triangle_contact::Corner& corner)
{
  if (std::popcount(corner.on_p) == 2) return Triangle_vertex{false, int(kernel::corner_of(corner.on_p))};
  if (std::popcount(corner.on_q) == 2) return Triangle_vertex{true, int(kernel::corner_of(corner.on_q))};
  return std::nullopt;
}

/// Calls what(corner) for the corners of the piece that two triangles share, over N. Vertices that no corner needs are
/// not placed.
template <class N, class Number_of, class What>
void for_corners(const Contacts_data& data, const tetratree::Found_piece& piece, const Number_of& number_of,
                 const What& what)
{
  using Point = kernel::Number_point<N>;
  const auto placed = [&](bool is_of_b, int first, int count) {
    const covering::Polyhedron& body = (is_of_b ? data.b : data.a)->polyhedron;
    const kernel::Pose& pose = is_of_b ? data.pose_b : data.pose_a;
    const covering::Loop loop = body.loop(is_of_b ? piece.face_b : piece.face_a, 0);
    std::array<Point, 3> points;
    std::optional<std::array<N, 12>> m;
    if (!pose.is_identity()) m = entries<N>(pose, number_of);
    for (int k = first; k < first + count; ++k) {
      const kernel::Vertex& vertex = body.vertices[loop[k]];
      if (m)
        points[k] = kernel::image(vertex, *m);
      else
        for (int i = 0; i < 3; ++i) points[k][i] = N(vertex[i]);
    }
    return points;
  };
  std::optional<std::array<std::array<Point, 3>, 2>> triangles;
  for (int k = 0; k < piece.by_signs.count; ++k) {
    const auto& corner = piece.by_signs.corners[k];
    if (const auto vertex = vertex_of(corner)) {
      what(placed(vertex->is_of_b, vertex->number, 1)[vertex->number]);
    } else {
      if (!triangles) triangles = {placed(false, 0, 3), placed(true, 0, 3)};
      what(kernel::corner_point((*triangles)[0], (*triangles)[1], corner));
    }
  }
}

/// The corners of a piece of two triangles, where all are vertices of bodies that are not moved; else nothing.
std::optional<std::vector<std::array<double, 3>>> unmoved_corners(const Contacts_data& data,
                                                                  const tetratree::Found_piece& piece)
{
  if (piece.by_signs.count == 0) return std::nullopt;
  std::vector<std::array<double, 3>> corners;
  for (int k = 0; k < piece.by_signs.count; ++k) {
    const auto vertex = vertex_of(piece.by_signs.corners[k]);
    if (!vertex || !(vertex->is_of_b ? data.pose_b : data.pose_a).is_identity()) return std::nullopt;
    const covering::Polyhedron& body = (vertex->is_of_b ? data.b : data.a)->polyhedron;
    const covering::Loop loop = body.loop(vertex->is_of_b ? piece.face_b : piece.face_a, 0);
    const kernel::Vertex& x = body.vertices[loop[vertex->number]];
    corners.push_back({x[0] + 0.0, x[1] + 0.0, x[2] + 0.0});  // -0.0 is 0, as in rationals
  }
  return corners;
}

Enclosure enclosure(const Rational_point& x)
{
  Enclosure box;
  for (int k = 0; k < 3; ++k) std::tie(box.lower[k], box.upper[k]) = CGAL::to_interval(x[k]);
  return box;
}

using kernel::Interval;

bool is_narrow(const kernel::Number_point<Interval>& x)
{
  double largest = 0, widest = 0;
  for (const Interval& i : x) {
    if (!(i.inf() >= -std::numeric_limits<double>::max() && i.sup() <= std::numeric_limits<double>::max()))
      return false;
    largest = kernel::maximum(largest, std::abs(i.inf()), std::abs(i.sup()));
    widest = kernel::maximum(widest, i.sup() - i.inf());
  }
  return widest <= 0x1p-41 * largest;
}

/// Returns the unit vector along the image of a face's normal n under the inverse transpose of M. Where det M < 0, the
/// placed loops turn the other way as seen from outside, and the image of n still points outward.
Enclosure placed_normal(const covering::Polyhedron& polyhedron, Index face, const kernel::Pose& pose)
{
  const Rational_point n = detail::exact_normal(polyhedron, face);
  const kernel::Rational_map map(pose);
  Rational_point along = {0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational_point column = kernel::cross(map.column(int(k + 1) % 3), map.column(int(k + 2) % 3));
    for (std::size_t i = 0; i < 3; ++i) along[i] += sgn(map.determinant()) * n[k] * column[i];
  }
  const Rational square = kernel::dot(along, along);
  Enclosure unit{};
  if (sgn(square) == 0) return unit;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] = kernel::enclosed_root_sum(std::array{Rational(along[i] * along[i] / square)});
    unit.lower[i] = sgn(along[i]) < 0 ? -high : low;
    unit.upper[i] = sgn(along[i]) < 0 ? -low : high;
  }
  return unit;
}

Loops exactly(const Contacts_data& data, std::size_t k)
{
  const tetratree::Found_piece& piece = data.found.pieces[k];
  if (piece.by_signs.count == 0) return data.found.kept[piece.kept];
  Loops loops(1);
  for_corners<Rational>(
      data, piece, [](const kernel::Pose& pose, int i) { return pose.exact(i); },
      [&](const Rational_point& x) { loops[0].push_back(x); });
  return loops;
}

/// Returns what(x) for each point x of the loops.
template <class What>
auto each_point(const Loops& loops, const What& what)
{
  std::vector<std::vector<decltype(what(loops[0][0]))>> all;
  for (const auto& loop : loops) {
    all.emplace_back();
    for (const Rational_point& x : loop) all.back().push_back(what(x));
  }
  return all;
}

double nearest(const Rational& x)
{
  const double about = x.get_d();
  return std::isfinite(about) && x == Rational(about) ? about : kernel::nearest_double(x);
}

std::array<double, 3> nearest(const Rational_point& x) { return {nearest(x[0]), nearest(x[1]), nearest(x[2])}; }

}  // namespace

Loops detail::rational_loops(const Contacts_data& contacts, std::size_t k) { return exactly(contacts, k); }

std::size_t Contacts::size() const { return data_->found.pieces.size(); }

Contact_piece Contacts::operator[](std::size_t k) const
{
  const tetratree::Found_piece& piece = data_->found.pieces[k];
  return {piece.face_a, piece.face_b, piece.kind, piece.in_a, piece.in_b};
}

std::vector<std::vector<Enclosure>> Contacts::loops(std::size_t k) const
{
  const tetratree::Found_piece& piece = data_->found.pieces[k];
  if (piece.by_signs.count > 0) {
    std::vector<std::vector<Enclosure>> loops(1);
    loops[0].reserve(piece.by_signs.count);
    bool are_narrow = true;
    const CGAL::Protect_FPU_rounding<true> upward;
    for_corners<Interval>(
        *data_, piece,
        [](const kernel::Pose& pose, int i) {
          return pose.is_rational() ? Interval(CGAL::to_interval(pose.exact(i))) : Interval(pose[i]);
        },
        [&](const kernel::Number_point<Interval>& x) {
          are_narrow = are_narrow && is_narrow(x);
          loops[0].push_back({{x[0].inf(), x[1].inf(), x[2].inf()}, {x[0].sup(), x[1].sup(), x[2].sup()}});
        });
    if (are_narrow) return loops;
  }
  return each_point(exactly(*data_, k), enclosure);
}

std::array<Enclosure, 2> contact_normals(const Contacts& contacts, std::size_t k)
{
  const detail::Contacts_data& data = contacts.data();
  const tetratree::Found_piece& piece = data.found.pieces[k];
  return {placed_normal(data.a->polyhedron, piece.face_a, data.pose_a),
          placed_normal(data.b->polyhedron, piece.face_b, data.pose_b)};
}

std::vector<std::vector<std::array<std::string, 3>>> Contacts::exact_loops(std::size_t k) const
{
  return each_point(exactly(*data_, k), [](const Rational_point& x) {
    return std::array{kernel::to_string(x[0]), kernel::to_string(x[1]), kernel::to_string(x[2])};
  });
}

std::vector<std::vector<std::array<double, 3>>> Contacts::nearest_loops(std::size_t k) const
{
  if (auto corners = unmoved_corners(*data_, data_->found.pieces[k])) return {std::move(*corners)};
  return each_point(exactly(*data_, k), [](const Rational_point& x) { return nearest(x); });
}

}  // namespace tetracone
