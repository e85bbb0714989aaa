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

/// Calls what(corner) for the corners of the piece that two triangles share, over N.
template <class N, class Number_of, class What>
void for_corners(const Contacts_data& data, const tetratree::Found_piece& piece, const Number_of& number_of,
                 const What& what)
{
  const auto triangle = [&](const detail::Shared_body& body, const kernel::Pose& pose, Index face) {
    const covering::Loop loop = body->polyhedron.loop(face, 0);
    const auto vertex = [&](int k) { return body->polyhedron.vertices[loop[k]]; };
    std::array<kernel::Number_point<N>, 3> t;
    if (pose.is_identity()) {
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) t[k][i] = N(vertex(k)[i]);
    } else {
      const auto m = entries<N>(pose, number_of);
      for (int k = 0; k < 3; ++k) t[k] = kernel::image(vertex(k), m);
    }
    return t;
  };
  const auto p = triangle(data.a, data.pose_a, piece.face_a), q = triangle(data.b, data.pose_b, piece.face_b);
  for (int k = 0; k < piece.by_signs.count; ++k) what(kernel::corner_point(p, q, piece.by_signs.corners[k]));
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
  Loops loops(1);
  for_corners<Rational>(
      data, piece, [](const kernel::Pose& pose, int i) { return pose.exact(i); },
      [&](const Rational_point& x) { loops[0].push_back(x); });
  return loops;
}

std::array<double, 3> nearest(const Rational_point& x)
{
  return {kernel::nearest_double(x[0]), kernel::nearest_double(x[1]), kernel::nearest_double(x[2])};
}

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
