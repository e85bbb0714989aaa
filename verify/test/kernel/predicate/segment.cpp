#include "tetracone/kernel/predicate/segment.h"

#include "tetracone/kernel/predicate/frame.h"
#include "verify/test/support/kernel_test_case.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_segment)

using namespace tetracone::kernel;

namespace {

using Kernels = std::tuple<Float, Double, Tolerant, Epick, Epeck, Rational_kernel, Adaptive>;
using Exact_motions = std::tuple<Epeck, Rational_kernel, Adaptive>;

using Integer = std::int64_t;
using Grid_point = std::array<Integer, 3>;

Grid_point operator-(const Grid_point& a, const Grid_point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Grid_point cross(const Grid_point& a, const Grid_point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Integer dot(const Grid_point& a, const Grid_point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// --- the reference: what pq shares with ab, as the interval of s of p + s (q-p), clipped by linear conditions

struct Ratio {
  Integer over, under;  // under > 0
  friend bool operator<(const Ratio& a, const Ratio& b) { return a.over * b.under < b.over * a.under; }
};

struct Clipped {
  Ratio low{0, 1}, high{1, 1};
  bool empty = false;

  /// Keeps the s with value + slope * s >= 0.
  void keep(Integer value, Integer slope)
  {
    if (slope == 0) empty = empty || value < 0;
    if (slope > 0) low = std::max(low, Ratio{-value, slope});
    if (slope < 0) high = std::min(high, Ratio{value, -slope});
    empty = empty || high < low;
  }
  /// Keeps the s with value + slope * s = 0.
  void keep_zero(Integer value, Integer slope)
  {
    keep(value, slope);
    keep(-value, -slope);
  }
};

Contact by_clipping(const Grid_point& p, const Grid_point& q, const Grid_point& a, const Grid_point& b)
{
  const Grid_point d = q - p, along = b - a;
  Clipped s;
  const Grid_point off = cross(p - a, along), off_slope = cross(d, along);
  for (int i = 0; i < 3; ++i) s.keep_zero(off[i], off_slope[i]);
  if (a == b)
    for (int i = 0; i < 3; ++i) s.keep_zero((p - a)[i], d[i]);
  s.keep(dot(p - a, along), dot(d, along));
  s.keep(dot(b - p, along), -dot(d, along));
  if (s.empty) return Contact::none;
  if (p == q) return p == a || p == b ? Contact::vertex_vertex : Contact::vertex_edge;
  if (s.low < s.high) return Contact::coplanar_overlap;

  const auto [over, under] = s.low;
  const bool end_of_pq = over == 0 || over == under;
  bool end_of_ab = true, at_b = true;
  for (int i = 0; i < 3; ++i) {
    const Integer y = under * p[i] + over * d[i];
    end_of_ab = end_of_ab && y == under * a[i];
    at_b = at_b && y == under * b[i];
  }
  end_of_ab = end_of_ab || at_b;
  if (end_of_pq && end_of_ab) return Contact::vertex_vertex;
  return end_of_pq || end_of_ab ? Contact::vertex_edge : Contact::edge_edge;
}

// --- samples ---------------------------------------------------------------------------------------------------------

template <class K>
Point<K> on_grid(const Grid_point& g)
{
  return point<K>(Vertex{double(g[0]), double(g[1]), double(g[2])});
}

template <class K>
Contact contact(const Grid_point& p, const Grid_point& q, const Grid_point& a, const Grid_point& b)
{
  return segment_segment<K>(on_grid<K>(p), on_grid<K>(q), on_grid<K>(a), on_grid<K>(b));
}

/// Quadruples of all sorts: on a grid in space, in a random lattice plane, on a random lattice line.
class Samples {
 public:
  explicit Samples(int seed) : random_(seed) {}

  std::array<Grid_point, 4> operator()()
  {
    std::array<Grid_point, 4> points;
    const int dimension = from(0, 5);
    const Grid_point o = any(3), u = any(1), v = any(1);
    for (Grid_point& p : points) {
      if (dimension == 0) {
        p = any(3);
      } else {
        const int i = from(-3, 3), j = dimension == 1 ? 0 : from(-3, 3);
        for (int k = 0; k < 3; ++k) p[k] = o[k] + i * u[k] + j * v[k];
      }
    }
    return points;
  }

 private:
  int from(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  Grid_point any(int radius) { return {from(-radius, radius), from(-radius, radius), from(-radius, radius)}; }

  std::mt19937 random_;
};

}  // namespace

KERNEL_TEST_CASE(a_point_of_the_line_is_located_on_the_segment, K, Kernels)
{
  int wrong = 0;
  for (const Grid_point& d : {Grid_point{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 1, -2}, {-1, 2, 1}})
    for (int p = -2; p <= 2; ++p)
      for (int a = -2; a <= 2; ++a)
        for (int b = -2; b <= 2; ++b) {
          const auto at = [&](int k) { return on_grid<K>({1 + k * d[0], 2 + k * d[1], k * d[2]}); };
          const On_segment truth = p == a                                 ? On_segment::first_end
                                   : p == b                               ? On_segment::second_end
                                   : (a < p && p < b) || (b < p && p < a) ? On_segment::inside
                                                                          : On_segment::outside;
          wrong += locate_on_segment<K>(at(p), at(a), at(b)) != truth;
        }
  BOOST_TEST(wrong == 0);
}

KERNEL_TEST_CASE(each_kind_by_hand, K, Kernels)
{
  const auto is = [](Contact expected, const Grid_point& p, const Grid_point& q, const Grid_point& a,
                     const Grid_point& b) {
    BOOST_TEST(to_string(contact<K>(p, q, a, b)) == to_string(expected));
    BOOST_TEST(to_string(by_clipping(p, q, a, b)) == to_string(expected));
  };
  is(Contact::edge_edge, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0});
  is(Contact::none, {-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1});              // skew
  is(Contact::none, {-1, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {1, 1, 0});              // parallel
  is(Contact::none, {-1, 0, 0}, {1, 0, 0}, {2, -1, 0}, {2, 1, 0});              // the lines cross beyond one
  is(Contact::vertex_edge, {-1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 1});        // a T
  is(Contact::vertex_vertex, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0});       // a corner
  is(Contact::vertex_vertex, {-1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0});      // end to end
  is(Contact::none, {-2, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {2, 0, 0});              // apart on one line
  is(Contact::coplanar_overlap, {-1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {2, 0, 0});   // a part
  is(Contact::coplanar_overlap, {-2, 0, 0}, {2, 0, 0}, {-1, 0, 0}, {1, 0, 0});  // one in the other
  is(Contact::coplanar_overlap, {-1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0});  // the same
  is(Contact::vertex_vertex, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3});       // points
  is(Contact::none, {1, 2, 3}, {1, 2, 3}, {1, 2, 2}, {1, 2, 2});
  is(Contact::vertex_edge, {0, 0, 0}, {0, 0, 0}, {-1, -1, -1}, {1, 1, 1});  // a point inside a segment
  is(Contact::vertex_vertex, {1, 1, 1}, {1, 1, 1}, {-1, -1, -1}, {1, 1, 1});
  is(Contact::none, {2, 2, 2}, {2, 2, 2}, {-1, -1, -1}, {1, 1, 1});  // beyond it on its line
  is(Contact::none, {0, 0, 1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0});    // off its line
}

KERNEL_TEST_CASE(all_segments_of_a_small_grid_meet_as_the_reference_says, K, Kernels)
{
  // Every quadruple of the 3x3 grid, flat and in an oblique plane.
  std::map<Contact, int> seen;
  int wrong = 0;
  for (const auto& [u, v] : {std::array<Grid_point, 2>{{{1, 0, 0}, {0, 1, 0}}}, {{{1, 0, 1}, {-1, 2, 0}}}})
    for (int n = 0; n < 9 * 9 * 9 * 9; ++n) {
      std::array<Grid_point, 4> g;
      for (int k = 0, rest = n; k < 4; ++k, rest /= 9)
        for (int i = 0; i < 3; ++i) g[k][i] = rest % 3 * u[i] + rest / 3 % 3 * v[i];
      const Contact truth = by_clipping(g[0], g[1], g[2], g[3]);
      wrong += contact<K>(g[0], g[1], g[2], g[3]) != truth;
      ++seen[truth];
    }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(seen.size() == 5u);
}

BOOST_AUTO_TEST_CASE(a_million_random_segments_meet_as_the_reference_says)
{
  Samples samples(1);
  std::map<Contact, int> seen;
  int wrong = 0;
  for (int n = 0; n < 1'200'000; ++n) {
    const auto [p, q, a, b] = samples();
    const Contact truth = by_clipping(p, q, a, b);
    if (contact<Double>(p, q, a, b) != truth) ++wrong;
    ++seen[truth];
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(seen.size() == 5u);
  for (const auto& [kind, count] : seen) {
    BOOST_TEST(count > 1'000);
    BOOST_TEST_MESSAGE(to_string(kind) << ": " << count);
  }
}

KERNEL_TEST_CASE(no_order_of_ends_or_segments_changes_the_kind, K, Kernels)
{
  Samples samples(2);
  int wrong = 0;
  for (int n = 0; n < 3'000; ++n) {
    const auto [p, q, a, b] = samples();
    const Contact truth = by_clipping(p, q, a, b);
    wrong += by_clipping(b, a, q, p) != truth;  // the reference's own symmetry
    for (const Contact found :
         {contact<K>(p, q, a, b), contact<K>(q, p, a, b), contact<K>(p, q, b, a), contact<K>(q, p, b, a),
          contact<K>(a, b, p, q), contact<K>(b, a, p, q), contact<K>(a, b, q, p), contact<K>(b, a, q, p)})
      wrong += found != truth;
  }
  BOOST_TEST(wrong == 0);
}

KERNEL_TEST_CASE(a_rotation_of_fractions_changes_no_kind, K, Exact_motions)
{
  // Both under one rigid motion: first as one frame, then as two that are equal, so that no shortcut of one frame
  // applies.
  const std::array<Rational, 3> t = {Rational(1) / 3, 5, Rational(-2) / 7};
  const Pose one = Pose::from_quaternion(3, -1, 2, 1, t), other = Pose::from_quaternion(3, -1, 2, 1, t);
  const Frame<K> f(one), g(other);
  Samples samples(3);
  int wrong = 0;
  for (int n = 0; n < 1'500; ++n) {
    const auto [p, q, a, b] = samples();
    const Contact truth = by_clipping(p, q, a, b);
    const auto P = on_grid<K>(p), Q = on_grid<K>(q), A = on_grid<K>(a), B = on_grid<K>(b);
    wrong += segment_segment<K>(f(P), f(Q), f(A), f(B)) != truth || segment_segment<K>(f(P), f(Q), g(A), g(B)) != truth;
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(every_kind_has_its_own_word)
{
  std::vector<std::string_view> words;
  for (int k = 0; k <= int(Contact::coplanar_overlap); ++k) words.push_back(to_string(Contact(k)));
  std::sort(words.begin(), words.end());
  BOOST_TEST((std::unique(words.begin(), words.end()) == words.end()));
}

// Errors planted in the header by hand, each seen to fail in a_million, all_segments, no_order and a_rotation, and all
// but the first in each_kind_by_hand too:
//   one of the two line tests dropped; axis sought in the triangles of pq only; overlap asked of the ends of pq only;
//   equal segments taken for an end in common.

BOOST_AUTO_TEST_SUITE_END()
