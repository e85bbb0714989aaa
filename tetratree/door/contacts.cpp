#include "tetracone/tetratree/door/contacts.h"

#include "tetracone/kernel/contact/corner_point.h"
#include "tetracone/kernel/number/floating_point.h"
#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/contacts_data.h"

#include <CGAL/Interval_nt.h>
#include <CGAL/gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

/// The corners of a piece of two triangles over N.
template <class N, class Number_of>
std::vector<kernel::Number_point<N>> corners(const Contacts_data& data, const tetratree::Found_piece& piece,
                                             const Number_of& number_of)
{
  const auto triangle = [&](const detail::Shared_body& body, const kernel::Pose& pose, Index face) {
    const auto m = entries<N>(pose, number_of);
    const covering::Loop loop = body->polyhedron.loop(face, 0);
    std::array<kernel::Number_point<N>, 3> t;
    for (int k = 0; k < 3; ++k) {
      const kernel::Vertex& v = body->polyhedron.vertices[loop[k]];
      t[k] = pose.is_identity() ? kernel::Number_point<N>{N(v[0]), N(v[1]), N(v[2])} : kernel::image(v, m);
    }
    return t;
  };
  const auto p = triangle(data.a, data.pose_a, piece.face_a), q = triangle(data.b, data.pose_b, piece.face_b);
  std::vector<kernel::Number_point<N>> corners;
  for (int k = 0; k < piece.by_signs.count; ++k)
    corners.push_back(kernel::corner_point(p, q, piece.by_signs.corners[k]));
  return corners;
}

Enclosure enclosure(const Rational_point& x)
{
  Enclosure box;
  for (int k = 0; k < 3; ++k) std::tie(box.lower[k], box.upper[k]) = CGAL::to_interval(x[k]);
  return box;
}

using Interval = CGAL::Interval_nt_advanced;

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

Loops exactly(const Contacts_data& data, std::size_t k)
{
  const tetratree::Found_piece& piece = data.found.pieces[k];
  if (piece.by_signs.count == 0) return data.found.kept[piece.kept];
  return {corners<Rational>(data, piece, [](const kernel::Pose& pose, int i) { return pose.exact(i); })};
}

std::array<double, 3> nearest(const Rational_point& x)
{
  return {kernel::nearest_double(x[0]), kernel::nearest_double(x[1]), kernel::nearest_double(x[2])};
}

}  // namespace

Loops detail::rational_loops(const Contacts_data& contacts, std::size_t k) { return exactly(contacts, k); }

void detail::refuse_contacts()
{
  throw Error("query: contacts by a kernel that rounds; expected an exact one: adaptive, epeck or rational");
}

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
    const CGAL::Protect_FPU_rounding<true> upward;
    const auto found = corners<Interval>(*data_, piece, [](const kernel::Pose& pose, int i) {
      return pose.is_rational() ? Interval(CGAL::to_interval(pose.exact(i))) : Interval(pose[i]);
    });
    if (std::ranges::all_of(found, is_narrow)) {
      std::vector<std::vector<Enclosure>> loops(1);
      for (const auto& x : found)
        loops[0].push_back({{x[0].inf(), x[1].inf(), x[2].inf()}, {x[0].sup(), x[1].sup(), x[2].sup()}});
      return loops;
    }
  }
  std::vector<std::vector<Enclosure>> loops;
  for (const auto& loop : exactly(*data_, k)) {
    loops.emplace_back();
    for (const Rational_point& x : loop) loops.back().push_back(enclosure(x));
  }
  return loops;
}

std::vector<std::vector<std::array<std::string, 3>>> Contacts::exact_loops(std::size_t k) const
{
  std::vector<std::vector<std::array<std::string, 3>>> loops;
  for (const auto& loop : exactly(*data_, k)) {
    loops.emplace_back();
    for (const Rational_point& x : loop)
      loops.back().push_back({kernel::to_string(x[0]), kernel::to_string(x[1]), kernel::to_string(x[2])});
  }
  return loops;
}

std::vector<std::vector<std::array<double, 3>>> Contacts::nearest_loops(std::size_t k) const
{
  std::vector<std::vector<std::array<double, 3>>> loops;
  for (const auto& loop : exactly(*data_, k)) {
    loops.emplace_back();
    for (const Rational_point& x : loop) loops.back().push_back(nearest(x));
  }
  return loops;
}

}  // namespace tetracone
