#include "experiments/accuracy/motion_subjects.h"

#include "tetracone/kernel/motion/first_contact.h"
#include "tetracone/kernel/number/products.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tetracone::experiments {
namespace {

using kernel::cross;
using kernel::difference;
using kernel::dot;
using kernel::Moving_kind;
using kernel::Moving_pair;

/// The points at a time.
template <class Number>
std::array<std::array<Number, 3>, 4> points_at(const Moving_pair& pair, Number t)
{
  std::array<std::array<Number, 3>, 4> points;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      points[k][axis] = (1 - t) * Number(pair.points[k].start[axis]) + t * Number(pair.points[k].end[axis]);
  return points;
}

/// True when barycentric coordinates are within [-slack, 1 + slack] and, if `distance` is not negative, the planes or
/// lines are no farther apart than it.
template <class Number>
bool touch_at(const Moving_pair& pair, Number t, Number slack, Number distance)
{
  const auto p = points_at(pair, t);
  const bool face = pair.kind == Moving_kind::vertex_face;
  const auto first = face ? difference(p[2], p[1]) : difference(p[1], p[0]);
  const auto second = face ? difference(p[3], p[1]) : difference(p[3], p[2]);
  const auto between = face ? difference(p[0], p[1]) : difference(p[2], p[0]);
  const auto normal = cross(first, second);
  const Number area = dot(normal, normal);
  if (!(area > 0)) return false;
  if (distance >= 0 && !(std::abs(dot(normal, between)) <= distance * std::sqrt(area))) return false;
  const Number u = dot(cross(between, second), normal) / area;
  const Number v = dot(face ? cross(first, between) : cross(between, first), normal) / area;
  if (!(u >= -slack && v >= -slack)) return false;
  return face ? u + v <= 1 + slack : u <= 1 + slack && v <= 1 + slack;
}

/// A cubic by its coefficients from the constant one up.
template <class Number>
Number value(const std::array<Number, 4>& c, Number t)
{
  return ((c[3] * t + c[2]) * t + c[1]) * t + c[0];
}

/// The ends of [0, 1] and the extrema within, in order.
template <class Number>
std::vector<Number> monotone_pieces(const std::array<Number, 4>& c)
{
  std::vector<Number> times = {0, 1};
  const Number a = 3 * c[3], b = 2 * c[2], discriminant = b * b - 4 * a * c[1];
  if (discriminant >= 0) {
    const Number q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    for (const Number t : {q / a, c[1] / q})
      if (t > 0 && t < 1) times.push_back(t);
  }
  std::sort(times.begin(), times.end());
  return times;
}

template <class Number>
bool by_roots(const Moving_pair& pair, Number slack)
{
  using Vector = std::array<Number, 3>;
  const auto start = points_at(pair, Number(0)), end = points_at(pair, Number(1));
  std::array<Vector, 3> from, way;
  for (std::size_t k = 0; k < 3; ++k) {
    from[k] = difference(start[k + 1], start[0]);
    way[k] = difference(difference(end[k + 1], end[0]), from[k]);
  }
  const auto det = [](const Vector& a, const Vector& b, const Vector& c) { return dot(cross(a, b), c); };
  const std::array<Number, 4> volume = {
      det(from[0], from[1], from[2]),
      det(way[0], from[1], from[2]) + det(from[0], way[1], from[2]) + det(from[0], from[1], way[2]),
      det(way[0], way[1], from[2]) + det(way[0], from[1], way[2]) + det(from[0], way[1], way[2]),
      det(way[0], way[1], way[2])};
  const std::vector<Number> times = monotone_pieces(volume);
  if (slack > 0)
    for (const Number t : times)
      if (touch_at(pair, t, slack, slack)) return true;
  const Number exact_plane = -1;
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    Number lo = times[k], hi = times[k + 1];
    const Number at_lo = value(volume, lo), at_hi = value(volume, hi);
    if (!(at_lo * at_hi <= 0)) continue;
    for (int step = 0; step < 100 && lo < hi; ++step) {
      const Number middle = lo + (hi - lo) / 2;
      if (middle == lo || middle == hi) break;
      ((value(volume, middle) < 0) == (at_lo < 0) ? lo : hi) = middle;
    }
    if (touch_at(pair, at_lo == 0 ? times[k] : hi, slack, exact_plane)) return true;
  }
  return false;
}

bool by_double(const Moving_pair& pair) { return by_roots<double>(pair, 0); }
bool by_float(const Moving_pair& pair) { return by_roots<float>(pair, 0); }
bool by_tolerance(const Moving_pair& pair) { return by_roots<double>(pair, 1e-6); }

/// A part of the domain: from and to of t, u, v.
struct Part {
  std::array<double, 3> lo, hi;
};

/// The difference of the primitives' points at (t, u, v). They are the vertex and the point of the face
/// p1 + u (p2 - p1) + v (p3 - p1), or the points at u and v of the edges.
std::array<double, 3> image(const Moving_pair& pair, double t, double u, double v)
{
  const auto p = points_at(pair, t);
  std::array<double, 3> d;
  for (std::size_t axis = 0; axis < 3; ++axis)
    d[axis] = pair.kind == Moving_kind::vertex_face
                  ? p[0][axis] - (p[1][axis] + u * (p[2][axis] - p[1][axis]) + v * (p[3][axis] - p[1][axis]))
                  : p[0][axis] + u * (p[1][axis] - p[0][axis]) - (p[2][axis] + v * (p[3][axis] - p[2][axis]));
  return d;
}

bool by_inclusion(const Moving_pair& pair)
{
  constexpr double precise_enough = 1e-6;
  constexpr int most_boxes = 1 << 15;
  // Some ten roundings of sums of coordinates and products with numbers of [0, 1].
  std::array<double, 3> rounding = {0, 0, 0};
  for (const auto& p : pair.points)
    for (std::size_t axis = 0; axis < 3; ++axis)
      rounding[axis] = std::max({rounding[axis], 0x1p-47 * std::abs(p.start[axis]), 0x1p-47 * std::abs(p.end[axis])});
  std::vector<Part> parts = {{{0, 0, 0}, {1, 1, 1}}};
  for (int boxes = 0; !parts.empty(); ++boxes) {
    if (boxes == most_boxes) return true;
    const Part part = parts.back();
    parts.pop_back();
    if (pair.kind == Moving_kind::vertex_face && part.lo[1] + part.lo[2] > 1) continue;
    std::array<std::array<double, 3>, 8> corners;
    for (std::size_t k = 0; k < 8; ++k)
      corners[k] = image(pair, k & 1 ? part.hi[0] : part.lo[0], k & 2 ? part.hi[1] : part.lo[1],
                         k & 4 ? part.hi[2] : part.lo[2]);
    double widest = 0;
    bool holds_origin = true;
    for (std::size_t axis = 0; axis < 3 && holds_origin; ++axis) {
      double least = corners[0][axis], most = corners[0][axis];
      for (const auto& c : corners) {
        least = std::min(least, c[axis]);
        most = std::max(most, c[axis]);
      }
      holds_origin = !(least > rounding[axis] || most < -rounding[axis]);
      if (least < -rounding[axis] || most > rounding[axis]) widest = std::max(widest, most - least);
    }
    if (!holds_origin) continue;
    if (!(widest > precise_enough)) return true;
    // The direction that the image is longest in is halved, the earlier half looked at first.
    std::size_t longest = 0;
    double length = -1;
    for (std::size_t d = 0; d < 3; ++d) {
      double reach = 0;
      for (std::size_t k = 0; k < 8; ++k)
        for (std::size_t axis = 0; axis < 3; ++axis)
          reach = std::max(reach, std::abs(corners[k | (1u << d)][axis] - corners[k & ~(1u << d)][axis]));
      const double middle = (part.lo[d] + part.hi[d]) / 2;
      if (reach > length && middle > part.lo[d] && middle < part.hi[d]) {
        longest = d;
        length = reach;
      }
    }
    if (length < 0) return true;
    Part first = part, second = part;
    first.hi[longest] = second.lo[longest] = (part.lo[longest] + part.hi[longest]) / 2;
    parts.push_back(second);
    parts.push_back(first);
  }
  return false;
}

constexpr std::array subjects = {
    Motion_subject{"adaptive", "ours: doubles with bounds, then integers; exact", kernel::meet_in_motion},
    Motion_subject{"double", "roots of the volume, barycentric coordinates", by_double},
    Motion_subject{"float", "the same in single precision", by_float},
    Motion_subject{"tolerance", "the same in double within 1e-6", by_tolerance},
    Motion_subject{"root-parity", "Brochu et al. 2012, in rationals", meet_by_root_parity},
    Motion_subject{"inclusion", "Wang et al. 2021, to 1e-6", by_inclusion},
};

}  // namespace

std::span<const Motion_subject> motion_subjects() { return subjects; }

}  // namespace tetracone::experiments
