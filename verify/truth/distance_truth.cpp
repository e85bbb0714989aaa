#include "verify/truth/distance_truth.h"

#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tetracone::verify {

namespace {

/// Multiplies two simplices by one whole number that makes all coordinates integers, and returns it. Arithmetic on
/// rationals takes most of its time for common divisors, and integers need none.
Rational make_integers(Simplex& a, Simplex& b)
{
  mpz_class common = 1;
  for (const Simplex* simplex : {&a, &b})
    for (const auto& p : *simplex)
      for (int i = 0; i < 3; ++i) common = lcm(common, p[i].get_den());
  const Rational unit(common);
  for (Simplex* simplex : {&a, &b})
    for (auto& p : *simplex) p = {Rational(unit * p[0]), Rational(unit * p[1]), Rational(unit * p[2])};
  return unit;
}

}  // namespace

Rational squared_distance_by_features(const Simplex& of_a, const Simplex& of_b)
{
  Simplex a = of_a, b = of_b;
  const Rational unit = make_integers(a, b);
  const auto meets = [&] {
    const auto with = [](const Simplex& s, auto&& what) -> bool {
      if (s.size() == 1) return what(s[0]);
      if (s.size() == 2) return what(Exact::Segment_3(s[0], s[1]));
      return what(Exact::Triangle_3(s[0], s[1], s[2]));
    };
    return with(a, [&](const auto& x) { return with(b, [&](const auto& y) { return CGAL::do_intersect(x, y); }); });
  };
  if (meets()) return 0;
  std::optional<Rational> least;
  const auto offer = [&](const Rational& square) {
    if (!least || square < *least) least = square;
  };
  const auto edges = [](const Simplex& s) {
    std::vector<Exact::Segment_3> edges;
    for (std::size_t k = 0; s.size() > 1 && k < (s.size() == 2 ? 1 : 3); ++k)
      edges.emplace_back(s[k], s[(k + 1) % s.size()]);
    return edges;
  };
  for (const auto& p : a)
    for (const auto& q : b) offer(CGAL::squared_distance(p, q));
  for (const auto& e : edges(a)) {
    for (const auto& q : b) offer(CGAL::squared_distance(q, e));
    for (const auto& f : edges(b)) offer(CGAL::squared_distance(e, f));
  }
  for (const auto& f : edges(b))
    for (const auto& p : a) offer(CGAL::squared_distance(p, f));
  const auto to_triangle = [&](const Simplex& from, const Simplex& to) {
    if (to.size() != 3) return;
    for (const auto& p : from) offer(CGAL::squared_distance(p, Exact::Triangle_3(to[0], to[1], to[2])));
  };
  to_triangle(a, b);
  to_triangle(b, a);
  return *least / (unit * unit);
}

Rational squared_distance_by_program(const Simplex& a, const Simplex& b)
{
  using Numbers = std::vector<Rational>;
  const std::size_t n = a.size(), m = b.size();
  const auto coordinate = [&](std::size_t k, int i) -> Rational { return k < n ? a[k][i] : Rational(-b[k - n][i]); };
  for (unsigned set = 1; set < 1u << (n + m); ++set) {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < n + m; ++k)
      if (set >> k & 1) chosen.push_back(k);
    if ((set & ((1u << n) - 1)) == 0 || set >> n == 0) continue;
    const std::size_t count = chosen.size(), size = count + 2;
    std::vector<Numbers> rows(size, Numbers(size + 1, Rational(0)));
    for (std::size_t r = 0; r < count; ++r) {
      for (std::size_t c = 0; c < count; ++c)
        for (int i = 0; i < 3; ++i) rows[r][c] += coordinate(chosen[r], i) * coordinate(chosen[c], i);
      const std::size_t body = chosen[r] < n ? 0 : 1;
      rows[r][count + body] = rows[count + body][r] = 1;
    }
    rows[count][size] = rows[count + 1][size] = 1;
    bool is_singular = false;
    for (std::size_t column = 0; column < size && !is_singular; ++column) {
      std::size_t pivot = column;
      while (pivot < size && sgn(rows[pivot][column]) == 0) ++pivot;
      if (pivot == size) {
        is_singular = true;
        continue;
      }
      std::swap(rows[pivot], rows[column]);
      for (std::size_t r = 0; r < size; ++r) {
        if (r == column || sgn(rows[r][column]) == 0) continue;
        const Rational factor = rows[r][column] / rows[column][column];
        for (std::size_t c = column; c <= size; ++c) rows[r][c] -= factor * rows[column][c];
      }
    }
    if (is_singular) continue;
    std::array<Rational, 3> d = {0, 0, 0};
    bool is_least = true;
    for (std::size_t k = 0; k < count; ++k) {
      const Rational weight = rows[k][size] / rows[k][k];
      is_least = is_least && sgn(weight) >= 0;
      for (int i = 0; i < 3; ++i) d[i] += weight * coordinate(chosen[k], i);
    }
    if (!is_least) continue;
    std::array<std::optional<Rational>, 2> along;  // the least of d . a and of d . (-b)
    for (std::size_t k = 0; k < n + m; ++k) {
      const Rational at = d[0] * coordinate(k, 0) + d[1] * coordinate(k, 1) + d[2] * coordinate(k, 2);
      auto& least = along[k < n ? 0 : 1];
      if (!least || at < *least) least = at;
    }
    const Rational square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    if (*along[0] + *along[1] == square) return square;
  }
  throw std::logic_error("a convex program without a least value");
}

Rational squared_distance(const Placed_body& a, const Placed_body& b, Rational (*of)(const Simplex&, const Simplex&))
{
  const auto simplex = [](const Placed_body& placed, const Element& element) {
    Simplex corners;
    for (int k = 0; k <= element.dimension; ++k) corners.push_back(placed.image<Exact>(element.corners[k]));
    return corners;
  };
  // Each rounding of differences, squares and sums has a relative error below 2^-50.
  const auto between = [](const CGAL::Bbox_3& x, const CGAL::Bbox_3& y) {
    double square = 0;
    for (int i = 0; i < 3; ++i) {
      const double gap = std::max({0.0, x.min(i) - y.max(i), y.min(i) - x.max(i)});
      square += gap * gap;
    }
    return square * (1 - 0x1p-48);
  };
  struct Pair {
    double low;
    std::size_t i, j;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < a.body().elements().size(); ++i)
    for (std::size_t j = 0; j < b.body().elements().size(); ++j)
      pairs.push_back({between(a.element_boxes()[i], b.element_boxes()[j]), i, j});
  std::sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) { return x.low < y.low; });
  std::optional<Rational> least;
  double enough = 0;
  for (const Pair& pair : pairs) {
    // An infinite value is no bound, nor is one below the squares that doubles can hold.
    if (least && pair.low > enough && pair.low > 0x1p-900 && pair.low < 0x1p1000) break;
    const Rational square = of(simplex(a, a.body().elements()[pair.i]), simplex(b, b.body().elements()[pair.j]));
    if (!least || square < *least) {
      least = square;
      enough = least->get_d() * (1 + 0x1p-48);
    }
    if (sgn(*least) == 0) break;
  }
  return *least;
}

bool is_nearest_root(double x, const Rational& square)
{
  if (!(x >= 0)) return false;
  constexpr double largest = std::numeric_limits<double>::max();
  if (std::isinf(x)) return square >= Rational(largest) * Rational(largest);
  const Rational here(x), above(std::min(std::nextafter(x, HUGE_VAL), largest)),
      below(x > 0 ? std::nextafter(x, 0.0) : 0.0);
  const Rational high = (here + above) / 2, low = (here + below) / 2;
  return low * low <= square && square <= high * high;
}

}  // namespace tetracone::verify
