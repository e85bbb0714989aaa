#include "verify/truth/moving_bodies_truth.h"

#include "tetracone/kernel/number/pose.h"
#include "verify/truth/cgal_truth.h"
#include "verify/truth/distance_truth.h"
#include "verify/truth/motion_truth.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace moving_truth {
namespace {

using covering::Index;
using covering::Polyhedron;
using kernel::Question;

/// Returns k with 2^(k-1) < |x| < 2^(k+1), for a number that is not 0.
long size_of(const Rational& x)
{
  return long(mpz_sizeinbase(x.get_num_mpz_t(), 2)) - long(mpz_sizeinbase(x.get_den_mpz_t(), 2));
}

/// Returns x times 2^doublings.
Rational scaled(const Rational& x, long doublings)
{
  Rational y;
  if (doublings >= 0)
    mpq_mul_2exp(y.get_mpq_t(), x.get_mpq_t(), mp_bitcnt_t(doublings));
  else
    mpq_div_2exp(y.get_mpq_t(), x.get_mpq_t(), mp_bitcnt_t(-doublings));
  return y;
}

/// Multiplies a body's coordinates by 2^-halvings. False, and nothing is done, where a double would lose digits.
bool shrink(Polyhedron& body, int halvings)
{
  std::vector<kernel::Vertex> vertices = body.vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) {
      vertices[v][k] = std::ldexp(body.vertices[v][k], -halvings);
      if (std::ldexp(vertices[v][k], halvings) != body.vertices[v][k]) return false;
    }
  body.vertices = std::move(vertices);
  return true;
}

/// Returns the bodies in other units: lengths of each body, and of space, times powers of two. They meet at the same
/// times. Near 1 fractions have few digits, and boxes of doubles separate what is apart.
Moving_bodies near_unit(const Moving_bodies& bodies)
{
  Moving_bodies c = bodies;
  const auto size_of_body = [](const Polyhedron& body) {
    int size = std::numeric_limits<int>::min();
    for (const kernel::Vertex& v : body.vertices)
      for (const double x : v)
        if (x != 0) size = std::max(size, std::ilogb(x));
    return size == std::numeric_limits<int>::min() ? 0 : size;
  };
  const bool is_rigid = c.is_rigid();
  std::array sizes = {size_of_body(c.a), size_of_body(c.b)};
  // A rigid motion does not scale a body, so both bodies and space are scaled together.
  if (is_rigid) sizes[0] = sizes[1] = std::max(sizes[0], sizes[1]);
  if (!shrink(c.a, sizes[0]) || !shrink(c.b, sizes[1])) return bodies;
  std::optional<long> largest;  // of all entries of linear motions
  for (const auto& [motion, size] : {std::pair(&c.motion_a, sizes[0]), std::pair(&c.motion_b, sizes[1])}) {
    std::optional<long> length;  // of the quaternions, which may have any
    for (std::vector<Rational>& numbers : *motion)
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        Rational& x = numbers[k];
        if (is_rigid ? k >= 4 : k % 4 != 3) x = scaled(x, is_rigid ? -size : size);
        if (x == 0) continue;
        if (!is_rigid) largest = std::max(largest.value_or(size_of(x)), size_of(x));
        if (is_rigid && k < 4) length = std::max(length.value_or(size_of(x)), size_of(x));
      }
    for (std::vector<Rational>& numbers : *motion)
      for (std::size_t k = 0; length && k < 4; ++k) numbers[k] = scaled(numbers[k], -*length);
  }
  for (Motion_ends* motion : {&c.motion_a, &c.motion_b})
    for (std::vector<Rational>& numbers : *motion)
      for (Rational& x : numbers) x = scaled(x, -largest.value_or(0));
  return c;
}

/// A quaternion by its coefficients of 1, i, j, k, polynomials in time.
using Quaternion = std::array<Time_polynomial, 4>;

Time_polynomial sum(const Time_polynomial& p, const Time_polynomial& q, int sign = 1)
{
  Time_polynomial result(std::max(p.size(), q.size()));
  for (std::size_t k = 0; k < p.size(); ++k) result[k] += p[k];
  for (std::size_t k = 0; k < q.size(); ++k) result[k] += sign * q[k];
  return result;
}

Time_polynomial product(const Time_polynomial& p, const Time_polynomial& q)
{
  if (p.empty() || q.empty()) return {};
  Time_polynomial result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) result[i + j] += p[i] * q[j];
  return result;
}

Quaternion product(const Quaternion& p, const Quaternion& q)
{
  Quaternion result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      // i j = k and its cyclic permutations are positive; a unit's square is -1.
      const bool negative = i != 0 && j != 0 && (i == j || (i % 3 + 1) != j);
      result[i ^ j] = sum(result[i ^ j], product(p[i], q[j]), negative ? -1 : 1);
    }
  return result;
}

Time_polynomial between(const Rational& from, const Rational& to) { return {from, Rational(to - from)}; }

Time_polynomial at(const Time_polynomial& p, const Rational& t)
{
  Rational value = 0;
  for (std::size_t k = p.size(); k-- > 0;) value = value * t + p[k];
  return {value};
}

/// Returns the motion's quaternion as a function of time.
Quaternion turn_of(const Motion_ends& ends)
{
  Quaternion q;
  for (std::size_t k = 0; k < 4; ++k) q[k] = between(ends[0][k], ends[1][k]);
  return q;
}

Time_polynomial norm(const Quaternion& q)
{
  Time_polynomial square;
  for (const Time_polynomial& x : q) square = sum(square, product(x, x));
  return square;
}

/// Returns the coordinates of a vertex, times `weight_of(ends)`.
Moving_coordinates image(const Motion_ends& ends, const kernel::Vertex& v)
{
  Moving_coordinates image;
  if (ends[0].size() == 12) {
    for (std::size_t i = 0; i < 3; ++i) {
      image[i] = between(ends[0][4 * i + 3], ends[1][4 * i + 3]);
      for (std::size_t j = 0; j < 3; ++j)
        image[i] = sum(image[i], product(between(ends[0][4 * i + j], ends[1][4 * i + j]), {Rational(v[j])}));
    }
    return image;
  }
  const Quaternion q = turn_of(ends), point = {Time_polynomial(), {Rational(v[0])}, {Rational(v[1])}, {Rational(v[2])}};
  Quaternion conjugate = q;
  for (std::size_t k = 1; k < 4; ++k) conjugate[k] = product(q[k], {-1});
  const Quaternion turned = product(product(q, point), conjugate);
  const Time_polynomial square = norm(q);
  for (std::size_t i = 0; i < 3; ++i)
    image[i] = sum(turned[1 + i], product(square, between(ends[0][4 + i], ends[1][4 + i])));
  return image;
}

Time_polynomial weight_of(const Motion_ends& ends)
{
  return ends[0].size() == 12 ? Time_polynomial{1} : norm(turn_of(ends));
}

kernel::Pose pose_at(const Motion_ends& ends, const Rational& time)
{
  std::array<Rational, 12> entries;
  const Rational weight = at(weight_of(ends), time)[0];
  const auto image_at = [&](const kernel::Vertex& v, std::size_t i) {
    return Rational(at(image(ends, v)[i], time)[0] / weight);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    entries[4 * i + 3] = image_at({0, 0, 0}, i);
    for (std::size_t j = 0; j < 3; ++j) {
      kernel::Vertex unit = {0, 0, 0};
      unit[j] = 1;
      entries[4 * i + j] = image_at(unit, i) - entries[4 * i + 3];
    }
  }
  return kernel::Pose(entries);
}

bool near_unit_collide_at_start(const Moving_bodies& bodies, Question question)
{
  const Brute_body a(bodies.a), b(bodies.b);
  return collide(a, pose_at(bodies.motion_a, 0), b, pose_at(bodies.motion_b, 0), question);
}

/// A body's triangles (of fans), its edges, and the coordinates of its vertices, times the weights of both bodies.
struct Features {
  Features(const Polyhedron& body, const Motion_ends& motion, const Time_polynomial& others_weight)
  {
    for (const kernel::Vertex& v : body.vertices) {
      Moving_coordinates p = image(motion, v);
      for (Time_polynomial& x : p) x = product(x, others_weight);
      points.push_back(std::move(p));
    }
    std::set<std::pair<Index, Index>> seen;
    for (Index f = 0; f < body.face_count(); ++f) {
      const auto loop = body.loop(f, 0);
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Index from = loop[k], to = loop[(k + 1) % loop.size()];
        if (seen.insert(std::minmax(from, to)).second) edges.push_back({from, to});
        if (k >= 2) triangles.push_back({loop[0], loop[k - 1], loop[k]});
      }
    }
  }

  std::vector<Moving_coordinates> points;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::array<Index, 2>> edges;
};

/// A vertex and a triangle, or two edges.
struct Feature_pair {
  kernel::Moving_kind kind;
  std::array<Moving_coordinates, 4> points;

  bool meets(const Time_span& span) const { return truly_meet_in_motion(kind, points, span); }
};

/// Calls is_it(pair) for all pairs in turn until it returns true. True when it did.
template <class Is_it>
bool any_pair(const Features& a, const Features& b, const Is_it& is_it)
{
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Moving_coordinates& p : one->points)
      for (const auto& [q, r, s] : other->triangles)
        if (is_it(Feature_pair{kernel::Moving_kind::vertex_face,
                               {p, other->points[q], other->points[r], other->points[s]}}))
          return true;
  for (const auto& [p, q] : a.edges)
    for (const auto& [r, s] : b.edges)
      if (is_it(Feature_pair{kernel::Moving_kind::edge_edge, {a.points[p], a.points[q], b.points[r], b.points[s]}}))
        return true;
  return false;
}

bool surfaces_meet(const Features& a, const Features& b, const Time_span& span)
{
  return any_pair(a, b, [&](const Feature_pair& pair) { return pair.meets(span); });
}

bool are_bounds(double lo, double hi) { return 0 <= lo && hi <= 1 && (lo == hi || hi == std::nextafter(lo, HUGE_VAL)); }

/// Returns a lower and an upper bound of the root of a number that is not negative, by the integer root of 128 bits of
/// it.
std::array<Rational, 2> root_bounds(const Rational& square)
{
  if (square == 0) return {0, 0};
  const long halvings = (128 - size_of(square)) / 2;
  const Rational whole = scaled(square, 2 * halvings);
  const mpz_class root = sqrt(mpz_class(whole.get_num() / whole.get_den()));
  return {scaled(Rational(root), -halvings), scaled(Rational(root + 1), -halvings)};
}
Rational root_above(const Rational& square) { return root_bounds(square)[1]; }
Rational root_below(const Rational& square) { return root_bounds(square)[0]; }

/// Returns an upper bound of the speed of every point of the body at every time. A rotation by q turns at the rate 2 |q
/// x q'| / |q|^2 = 2 |q0 x q1| / |q|^2. A point at distance r from the axis moves r times as fast.
Rational speed(const Polyhedron& body, const Motion_ends& ends)
{
  const bool is_rigid = ends[0].size() == 7;
  Rational fastest = 0, farthest = 0;
  for (const kernel::Vertex& v : body.vertices) {
    Rational way = 0, square = 0;
    const Moving_coordinates p = image(ends, v);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_rigid && p[i].size() > 1) way += p[i][1] * p[i][1];
      square += Rational(v[i]) * Rational(v[i]);
    }
    fastest = std::max(fastest, way);
    farthest = std::max(farthest, square);
  }
  if (!is_rigid) return root_above(fastest);
  Rational along = 0, first = 0, second = 0, shift = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    along += ends[0][k] * ends[1][k];
    first += ends[0][k] * ends[0][k];
    second += ends[1][k] * ends[1][k];
  }
  for (std::size_t k = 4; k < 7; ++k) shift += (ends[1][k] - ends[0][k]) * (ends[1][k] - ends[0][k]);
  const Rational area = first * second - along * along;
  // The least |q(t)|^2 is at an end or at the foot of the perpendicular from 0.
  Rational least = std::min(first, second);
  const Rational way = first + second - 2 * along;
  if (way > 0 && first - along > 0 && second - along > 0) least = std::min(least, Rational(area / way));
  return root_above(shift) + 2 * root_above(area) / least * root_above(farthest);
}

}  // namespace
}  // namespace moving_truth

Object_case at_start(const Moving_bodies& bodies, const Origin& origin)
{
  return {std::make_shared<const covering::Polyhedron>(bodies.a),
          std::make_shared<const covering::Polyhedron>(bodies.b),
          moving_truth::pose_at(bodies.motion_a, 0),
          moving_truth::pose_at(bodies.motion_b, 0),
          origin,
          {},
          {}};
}

bool truly_collide_at_start(const Moving_bodies& bodies, kernel::Question question)
{
  return moving_truth::near_unit_collide_at_start(moving_truth::near_unit(bodies), question);
}

bool truly_first_by_features(const Moving_bodies& given, kernel::Question question,
                             const std::optional<kernel::Time_bounds>& first)
{
  const Moving_bodies bodies = moving_truth::near_unit(given);
  if (moving_truth::near_unit_collide_at_start(bodies, question)) return first && first->lo == 0 && first->hi == 0;
  const moving_truth::Features a(bodies.a, bodies.motion_a, moving_truth::weight_of(bodies.motion_b)),
      b(bodies.b, bodies.motion_b, moving_truth::weight_of(bodies.motion_a));
  if (!first) return !moving_truth::surfaces_meet(a, b, {});
  const auto [lo, hi] = *first;
  if (!moving_truth::are_bounds(lo, hi) || hi == 0) return false;
  if (lo > 0 && moving_truth::surfaces_meet(a, b, {0, lo, lo != hi})) return false;
  if (lo != hi) return moving_truth::surfaces_meet(a, b, {lo, hi, false});
  // The span ends at `lo`, and nothing meets before it: this tests the one time.
  return moving_truth::surfaces_meet(a, b, {0, lo, true});
}

std::optional<kernel::Time_bounds> true_first_contact(const Moving_bodies& given, kernel::Question question,
                                                      const std::optional<kernel::Time_bounds>& guess)
{
  const Moving_bodies bodies = moving_truth::near_unit(given);
  if (truly_first_by_features(bodies, question, guess)) return guess;
  if (moving_truth::near_unit_collide_at_start(bodies, question)) return kernel::Time_bounds{0, 0};
  const moving_truth::Features a(bodies.a, bodies.motion_a, moving_truth::weight_of(bodies.motion_b)),
      b(bodies.b, bodies.motion_b, moving_truth::weight_of(bodies.motion_a));
  std::vector<moving_truth::Feature_pair> meeting;
  moving_truth::any_pair(a, b, [&](const moving_truth::Feature_pair& pair) {
    if (pair.meets({})) meeting.push_back(pair);
    return false;
  });
  if (meeting.empty()) return std::nullopt;
  const auto meet = [&](double from, double to, bool with_end) {
    return std::ranges::any_of(meeting, [&](const auto& pair) { return pair.meets({from, to, with_end}); });
  };
  // The bits of non-negative doubles are in the order of the doubles.
  auto before = std::bit_cast<std::uint64_t>(0.0), until = std::bit_cast<std::uint64_t>(1.0);
  const auto time = [](std::uint64_t bits) { return std::bit_cast<double>(bits); };
  while (until - before > 1) {
    const std::uint64_t middle = before + (until - before) / 2;
    (meet(time(before), time(middle), true) ? until : before) = middle;
  }
  const double lo = time(before), hi = time(until);
  return kernel::Time_bounds{meet(lo, hi, false) ? lo : hi, hi};
}

Bracket truly_first_by_distances(const Moving_bodies& given, kernel::Question question,
                                 const std::optional<kernel::Time_bounds>& first, int most, double end)
{
  const Moving_bodies bodies = moving_truth::near_unit(given);
  const auto judged = [](bool holds) { return holds ? Bracket::holds : Bracket::violated; };
  if (moving_truth::near_unit_collide_at_start(bodies, question))
    return judged(first && first->lo == 0 && first->hi == 0);
  if (first && (!moving_truth::are_bounds(first->lo, first->hi) || first->hi == 0)) return Bracket::violated;
  const Brute_body a(bodies.a), b(bodies.b);
  const auto square_at = [&](const Rational& time) -> std::optional<Rational> {
    const kernel::Pose of_a = moving_truth::pose_at(bodies.motion_a, time),
                       of_b = moving_truth::pose_at(bodies.motion_b, time);
    if (of_a.determinant_sign() == CGAL::ZERO || of_b.determinant_sign() == CGAL::ZERO) return std::nullopt;
    return squared_distance(Placed_body(a, of_a), Placed_body(b, of_b));
  };
  const Rational fastest =
      moving_truth::speed(bodies.a, bodies.motion_a) + moving_truth::speed(bodies.b, bodies.motion_b);
  const Rational until = first ? Rational(first->lo) - Rational(end) : Rational(1);
  for (Rational time = 0; time < until; --most) {
    if (most == 0) return Bracket::undecided;
    const auto square = square_at(time);
    if (!square) return Bracket::undecided;
    if (*square == 0) return Bracket::violated;
    const Rational gap = moving_truth::root_below(*square);
    if (fastest == 0) break;
    // The step is rounded down to a dyadic number, else its digits would grow.
    const mpz_class units(Rational(gap / fastest * 0x1p60).get_num() / Rational(gap / fastest * 0x1p60).get_den());
    if (units == 0) return Bracket::undecided;
    time += Rational(units) / 0x1p60;
  }
  if (!first) return Bracket::holds;
  const Rational lo(first->lo), hi(first->hi), reach = fastest * (hi - lo);
  const auto square = square_at(lo);
  return square ? judged(*square <= reach * reach) : Bracket::undecided;
}

}  // namespace tetracone::verify
