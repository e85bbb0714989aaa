#include "experiments/accuracy/motion_subjects.h"

#include "tetracone/kernel/number/number.h"
#include "tetracone/kernel/number/products.h"

#include <array>
#include <cstddef>

namespace tetracone::experiments {
namespace {

using kernel::cross;
using kernel::determinant;
using kernel::difference;
using kernel::dot;
using kernel::Moving_kind;
using kernel::Moving_pair;
using kernel::Rational;
using Corner = std::array<Rational, 3>;

bool origin_on_segment(const Corner& a, const Corner& b)
{
  const Corner area = cross(a, b);
  return sgn(dot(area, area)) == 0 && sgn(dot(a, b)) <= 0;
}

/// The result for a ray from the origin and a piece of the boundary; `unlucky`: another ray is needed.
enum class Crossing { even, odd, at_origin, unlucky };

Crossing operator+(Crossing x, Crossing y)
{
  if (x == Crossing::at_origin || y == Crossing::at_origin) return Crossing::at_origin;
  if (x == Crossing::unlucky || y == Crossing::unlucky) return Crossing::unlucky;
  return x == y ? Crossing::even : Crossing::odd;
}

Crossing crossing(const Corner& ray, const Corner& a, const Corner& b, const Corner& c)
{
  const int side = sgn(determinant(a, b, c));
  if (side == 0) {
    const Corner normal = cross(difference(b, a), difference(c, a));
    if (origin_on_segment(a, b) || origin_on_segment(b, c) || origin_on_segment(c, a)) return Crossing::at_origin;
    const bool flat = sgn(dot(normal, normal)) == 0;
    const bool within = !flat && sgn(dot(cross(a, b), normal)) > 0 && sgn(dot(cross(b, c), normal)) > 0 &&
                        sgn(dot(cross(c, a), normal)) > 0;
    if (within) return Crossing::at_origin;
    // The plane of the triangle holds the origin, and the ray leaves it there.
    return flat || sgn(dot(normal, ray)) != 0 ? Crossing::even : Crossing::unlucky;
  }
  const int ab = sgn(determinant(ray, a, b)), bc = sgn(determinant(ray, b, c)), ca = sgn(determinant(ray, c, a));
  if (ab == 0 || bc == 0 || ca == 0) return Crossing::unlucky;
  return ab == side && bc == side && ca == side ? Crossing::odd : Crossing::even;
}

/// A bilinear patch with corners a, b, c, d in order around it. The patch and the triangles of one diagonal bound a
/// part of the corners' tetrahedron. With alpha_k the barycentric coordinate of corner k, that part is where alpha_a
/// alpha_c > alpha_b alpha_d; with the other diagonal, where it is less.
Crossing crossing(const Corner& ray, const Corner& a, const Corner& b, const Corner& c, const Corner& d)
{
  Rational of_a = determinant(b, c, d), of_b = -determinant(a, c, d), of_c = determinant(a, b, d),
           of_d = -determinant(a, b, c);
  const Rational whole = of_a + of_b + of_c + of_d;
  int side = 0;
  if (sgn(whole) != 0) {
    const int sign = sgn(whole);
    const bool inside =
        sign * sgn(of_a) >= 0 && sign * sgn(of_b) >= 0 && sign * sgn(of_c) >= 0 && sign * sgn(of_d) >= 0;
    const int difference = sgn(Rational(of_a * of_c - of_b * of_d));
    if (inside && difference == 0) return Crossing::at_origin;
    if (inside) side = difference;
  }
  const Crossing along_ac = crossing(ray, a, b, c) + crossing(ray, a, c, d);
  if (along_ac != Crossing::at_origin) return along_ac + (side > 0 ? Crossing::odd : Crossing::even);
  const Crossing along_bd = crossing(ray, a, b, d) + crossing(ray, b, c, d);
  return along_bd + (side < 0 ? Crossing::odd : Crossing::even);
}

/// Corner differences at both ends of the time.
struct Differences {
  const Moving_pair& pair;

  Corner operator()(std::size_t time, std::size_t i, std::size_t j) const
  {
    const auto at = [&](std::size_t k, std::size_t axis) {
      return Rational(time == 0 ? pair.points[k].start[axis] : pair.points[k].end[axis]);
    };
    Corner d;
    for (std::size_t axis = 0; axis < 3; ++axis) d[axis] = at(i, axis) - at(j, axis);
    return d;
  }
};

Crossing boundary(const Moving_pair& pair, const Corner& ray)
{
  const Differences d{pair};
  Crossing sum = Crossing::even;
  if (pair.kind == Moving_kind::vertex_face) {
    for (const std::size_t t : {0, 1}) sum = sum + crossing(ray, d(t, 0, 1), d(t, 0, 2), d(t, 0, 3));
    for (const auto& [i, j] : {std::array<std::size_t, 2>{1, 2}, {2, 3}, {3, 1}})
      sum = sum + crossing(ray, d(0, 0, i), d(1, 0, i), d(1, 0, j), d(0, 0, j));
    return sum;
  }
  for (const std::size_t t : {0, 1}) sum = sum + crossing(ray, d(t, 0, 2), d(t, 1, 2), d(t, 1, 3), d(t, 0, 3));
  for (const std::size_t end : {0, 1})
    sum = sum + crossing(ray, d(0, end, 2), d(1, end, 2), d(1, end, 3), d(0, end, 3));
  for (const std::size_t end : {2, 3})
    sum = sum + crossing(ray, d(0, 0, end), d(1, 0, end), d(1, 1, end), d(0, 1, end));
  return sum;
}

}  // namespace

bool meet_by_root_parity(const Moving_pair& pair)
{
  // Rays along a curve that no plane holds: each triangle is unlucky for few of them.
  for (int k = 1;; ++k) {
    const Crossing sum = boundary(pair, {Rational(1 + k), Rational(k * k + 3), Rational(k * k * k) / 7});
    if (sum != Crossing::unlucky) return sum != Crossing::even;
  }
}

}  // namespace tetracone::experiments
