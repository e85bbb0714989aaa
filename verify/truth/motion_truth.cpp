#include "verify/truth/motion_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

using kernel::Moving_kind;
using kernel::Moving_pair;
using kernel::Rational;
using Integer = mpz_class;

/// Coefficients from the constant one up, the last one not zero; empty: zero.
using Polynomial = std::vector<Integer>;

void trim(Polynomial& p)
{
  while (!p.empty() && sgn(p.back()) == 0) p.pop_back();
}

Polynomial operator*(const Polynomial& p, const Polynomial& q)
{
  if (p.empty() || q.empty()) return {};
  Polynomial product(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) product[i + j] += p[i] * q[j];
  return product;
}

/// p + factor q.
Polynomial plus(const Polynomial& p, const Polynomial& q, int factor = 1)
{
  Polynomial sum(std::max(p.size(), q.size()));
  for (std::size_t k = 0; k < p.size(); ++k) sum[k] += p[k];
  for (std::size_t k = 0; k < q.size(); ++k) sum[k] += factor * q[k];
  trim(sum);
  return sum;
}

/// Returns p divided by the common divisor of its coefficients.
Polynomial primitive(Polynomial p)
{
  Integer divisor = 0;
  for (const Integer& c : p) divisor = gcd(divisor, c);
  if (divisor > 1)
    for (Integer& c : p) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), divisor.get_mpz_t());
  return p;
}

/// Returns the remainder of p divided by q, times a positive number. Requires that q is not zero.
Polynomial rest(Polynomial p, const Polynomial& q)
{
  const Integer factor = abs(q.back());
  while (p.size() >= q.size()) {
    const Integer leading = sgn(q.back()) * p.back();
    const std::size_t shift = p.size() - q.size();
    for (Integer& c : p) c *= factor;
    for (std::size_t j = 0; j < q.size(); ++j) p[shift + j] -= leading * q[j];
    trim(p);
  }
  return primitive(std::move(p));
}

Polynomial common_divisor(Polynomial p, Polynomial q)
{
  while (!q.empty()) {
    Polynomial next = rest(p, q);
    p = std::exchange(q, std::move(next));
  }
  return p;
}

int sign_at(const Polynomial& p, int x)
{
  if (p.empty() || x == 0) return p.empty() ? 0 : sgn(p[0]);
  Integer sum = 0;
  for (const Integer& c : p) sum += c;
  return sgn(sum);
}

Polynomial without_roots_at_ends(Polynomial f)
{
  while (f.size() > 1 && sign_at(f, 0) == 0) f.erase(f.begin());
  while (f.size() > 1 && sign_at(f, 1) == 0) {
    for (std::size_t k = f.size() - 1; k > 0; --k) f[k - 1] += f[k];
    f.erase(f.begin());  // the rest over x - 1, zero
  }
  return f;
}

/// Returns the sum of the signs of g over the distinct roots of f in (0, 1). Requires f(0) and f(1) not zero.
int tarski_query(const Polynomial& f, const Polynomial& g)
{
  Polynomial derivative;
  for (std::size_t k = 1; k < f.size(); ++k) derivative.push_back(f[k] * static_cast<unsigned long>(k));
  Polynomial last = f, next = rest(derivative * g, f);
  // f' g may be reduced modulo f. Where its degree is not below that of f, the sequence of f and f' g begins with f, f'
  // g, -f. That is one change of sign at either end.
  int changes = 0;
  std::array<int, 2> signs = {sign_at(f, 0), sign_at(f, 1)};
  while (!next.empty()) {
    for (int x = 0; x < 2; ++x) {
      const int sign = sign_at(next, x);
      if (sign == 0) continue;
      if (sign != signs[x]) changes += x == 0 ? 1 : -1;
      signs[x] = sign;
    }
    Polynomial negative = rest(last, next);
    for (Integer& c : negative) c = -c;
    last = std::exchange(next, std::move(negative));
  }
  return changes;
}

/// The condition zero = 0, positive > 0 (a polynomial that is nowhere negative), and others[k] >= 0 for all k.
struct Condition {
  Polynomial zero, positive;
  std::vector<Polynomial> others;
};

/// Returns 2^n times the number of roots of f in (0, 1) where the n polynomials from index k on are >= 0. Each root
/// counts with the sign of `weight`.
int weighted_count(const Polynomial& f, const std::vector<Polynomial>& others, std::size_t k, const Polynomial& weight)
{
  if (k == others.size()) return tarski_query(f, weight);
  // 1 where g >= 0, else 0: (2 + sign g - sign g^2) / 2.
  const Polynomial &g = others[k], once = rest(weight * g, f), twice = rest(once * g, f);
  return 2 * weighted_count(f, others, k + 1, weight) + weighted_count(f, others, k + 1, once) -
         weighted_count(f, others, k + 1, twice);
}

/// True when the condition holds at a root of `candidates` in (0, 1).
bool holds_at_root(const Polynomial& candidates, const Condition& condition)
{
  const Polynomial f = without_roots_at_ends(primitive(common_divisor(candidates, condition.zero)));
  if (f.size() < 2) return false;
  const int roots = tarski_query(f, {1});
  if (roots == 0) return false;
  const Polynomial positive = rest(condition.positive, f);
  const int not_flat = tarski_query(f, positive);
  if (not_flat == 0) return false;
  // Conditions that hold at every root need no further test.
  std::vector<Polynomial> in_question;
  for (const Polynomial& other : condition.others) {
    const Polynomial g = rest(other, f);
    const int holds = weighted_count(f, {g}, 0, {1}) / 2;
    if (holds == 0) return false;
    if (holds < roots) in_question.push_back(g);
  }
  return weighted_count(f, in_question, 0, not_flat < roots ? positive : Polynomial{1}) != 0;
}

bool holds_at_end(const Condition& condition, int x)
{
  return sign_at(condition.zero, x) == 0 && sign_at(condition.positive, x) > 0 &&
         std::ranges::all_of(condition.others, [x](const Polynomial& g) { return sign_at(g, x) >= 0; });
}

using Moving_vector = std::array<Polynomial, 3>;

Moving_vector difference(const Moving_vector& p, const Moving_vector& q)
{
  return {plus(p[0], q[0], -1), plus(p[1], q[1], -1), plus(p[2], q[2], -1)};
}

Polynomial dot(const Moving_vector& p, const Moving_vector& q)
{
  return plus(plus(p[0] * q[0], p[1] * q[1]), p[2] * q[2]);
}

Moving_vector cross(const Moving_vector& p, const Moving_vector& q)
{
  const auto part = [&](int i, int j) { return plus(p[i] * q[j], p[j] * q[i], -1); };
  return {part(1, 2), part(2, 0), part(0, 1)};
}

/// The condition that p is on the closed segment from a to b.
Condition on_segment(const Moving_vector& p, const Moving_vector& a, const Moving_vector& b)
{
  const Moving_vector to_a = difference(a, p), to_b = difference(b, p), area = cross(to_a, to_b);
  return {dot(area, area), {1}, {plus({}, dot(to_a, to_b), -1)}};
}

/// Returns conditions of which at least one holds where the primitives share a point.
std::vector<Condition> contact(Moving_kind kind, const std::array<Moving_vector, 4>& p)
{
  if (kind == Moving_kind::vertex_face) {
    const Moving_vector normal = cross(difference(p[2], p[1]), difference(p[3], p[1]));
    const auto part = [&](int i, int j) { return dot(cross(difference(p[i], p[0]), difference(p[j], p[0])), normal); };
    return {{dot(normal, difference(p[0], p[1])), dot(normal, normal), {part(1, 2), part(2, 3), part(3, 1)}},
            on_segment(p[0], p[1], p[2]),
            on_segment(p[0], p[2], p[3]),
            on_segment(p[0], p[3], p[1])};
  }
  const Moving_vector first = difference(p[1], p[0]), second = difference(p[3], p[2]), between = difference(p[2], p[0]);
  const Moving_vector normal = cross(first, second);
  const Polynomial whole = dot(normal, normal), on_first = dot(cross(between, second), normal),
                   on_second = dot(cross(between, first), normal);
  return {{dot(normal, between), whole, {on_first, plus(whole, on_first, -1), on_second, plus(whole, on_second, -1)}},
          on_segment(p[0], p[2], p[3]),
          on_segment(p[1], p[2], p[3]),
          on_segment(p[2], p[0], p[1]),
          on_segment(p[3], p[0], p[1])};
}

/// Returns the points over a span of time, rewritten to run from 0 to 1, with integer coefficients. Each axis is scaled
/// by itself, which does not change contact.
std::array<Moving_vector, 4> over_span(const std::array<Moving_coordinates, 4>& points, const Rational& from,
                                       const Rational& to)
{
  std::array<Moving_vector, 4> whole;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::array<Time_polynomial, 4> parts;
    Integer denominators = 1, numerators = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      // Horner's scheme evaluates at from + (to - from) t.
      const Time_polynomial& p = points[k][axis];
      for (std::size_t c = p.size(); c-- > 0;) {
        parts[k].push_back(0);
        for (std::size_t i = parts[k].size() - 1; i > 0; --i)
          parts[k][i] = parts[k][i] * from + parts[k][i - 1] * (to - from);
        parts[k][0] = parts[k][0] * from + p[c];
      }
      for (const Rational& x : parts[k]) denominators = lcm(denominators, x.get_den());
    }
    for (Time_polynomial& part : parts)
      for (Rational& x : part) {
        x *= denominators;
        numerators = gcd(numerators, x.get_num());
      }
    for (std::size_t k = 0; k < 4; ++k) {
      for (const Rational& x : parts[k])
        whole[k][axis].push_back(numerators == 0 ? 0 : Integer(x.get_num() / numerators));
      trim(whole[k][axis]);
    }
  }
  return whole;
}

std::array<Moving_coordinates, 4> coordinates_of(const Moving_pair& pair)
{
  std::array<Moving_coordinates, 4> points;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Rational start = pair.points[k].start[axis];
      points[k][axis] = {start, Rational(pair.points[k].end[axis]) - start};
    }
  return points;
}

/// True when all coefficients of p in Bernstein's basis over [0, 1] have one sign; then p has no root there.
bool keeps_one_sign(const Polynomial& p)
{
  const std::size_t degree = p.size() - 1;
  int first = 0;
  for (std::size_t k = 0; k <= degree; ++k) {
    Rational sum = 0;
    for (std::size_t j = 0; j <= k; ++j) {
      Integer of_k, of_degree;
      mpz_bin_uiui(of_k.get_mpz_t(), k, j);
      mpz_bin_uiui(of_degree.get_mpz_t(), degree, j);
      sum += Rational(p[j] * of_k) / of_degree;
    }
    if (k == 0) first = sgn(sum);
    if (sgn(sum) != first || first == 0) return false;
  }
  return true;
}

/// Returns six times the volume of the four points' tetrahedron, which is zero when they are in one plane.
Polynomial volume(const std::array<Moving_vector, 4>& p)
{
  return dot(cross(difference(p[1], p[0]), difference(p[2], p[0])), difference(p[3], p[0]));
}

}  // namespace

bool truly_meet_in_motion(kernel::Moving_kind kind, const std::array<Moving_coordinates, 4>& coordinates,
                          const Time_span& span)
{
  const std::array<Moving_vector, 4> points = over_span(coordinates, span.from, span.to);
  const Polynomial coplanar = volume(points);
  if (!coplanar.empty() && keeps_one_sign(coplanar)) return false;
  const std::vector<Condition> conditions = contact(kind, points);
  const auto at_end = [&](int x) {
    return std::ranges::any_of(conditions, [x](const Condition& c) { return holds_at_end(c, x); });
  };
  if (at_end(0) || (span.with_end && at_end(1))) return true;
  const auto at_root_of = [&](const Polynomial& f) {
    return !f.empty() && std::ranges::any_of(conditions, [&](const Condition& c) { return holds_at_root(f, c); });
  };
  // Contact is closed. Its first time is an end of the span or a root of the volume. Where the volume is zero, it may
  // be a root of another polynomial.
  if (!coplanar.empty()) return at_root_of(coplanar);
  for (const Condition& condition : conditions) {
    if (at_root_of(condition.zero) || at_root_of(condition.positive)) return true;
    for (const Polynomial& other : condition.others)
      if (at_root_of(other)) return true;
  }
  return false;
}

bool truly_meet_in_motion(const Moving_pair& pair, const Time_span& span)
{
  return truly_meet_in_motion(pair.kind, coordinates_of(pair), span);
}

bool truly_meet_at(const Moving_pair& pair, const Rational& time)
{
  const std::vector<Condition> conditions = contact(pair.kind, over_span(coordinates_of(pair), time, time));
  return std::ranges::any_of(conditions, [](const Condition& c) { return holds_at_end(c, 0); });
}

bool truly_first(const Moving_pair& pair, const std::optional<kernel::Time_bounds>& bounds, bool meets)
{
  if (!bounds || !meets) return !bounds && !meets;
  const auto [lo, hi] = *bounds;
  if (!(0 <= lo && lo <= hi && hi <= 1)) return false;
  if (lo == hi) return truly_meet_at(pair, lo) && (lo == 0 || !truly_meet_in_motion(pair, {0, lo, false}));
  return hi == std::nextafter(lo, HUGE_VAL) &&
         (lo == 0 ? !truly_meet_at(pair, 0) : !truly_meet_in_motion(pair, {0, lo})) &&
         truly_meet_in_motion(pair, {lo, hi, false});
}

}  // namespace tetracone::verify
