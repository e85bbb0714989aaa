#include "tetracone/tetratree/query/bvh8_points.h"
#include "tetracone/tetratree/query/point_order.h"

#include "tetracone/covering/star_faces.h"
#include "verify/test/support/object_cases.h"
#include "verify/truth/distance_truth.h"
#include "verify/truth/nearest_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bvh8_points)

namespace scenes = tetracone::verify::scenes;
namespace verify = tetracone::verify;
namespace kernel = tetracone::kernel;
using namespace tetracone::tetratree;
using kernel::Feature;
using kernel::Rational;
using tetracone::covering::Polyhedron;
using tetracone::covering::Vertex;
using Point = verify::Nearest_truth::Point;

namespace {

Point exact(const Vertex& x) { return {x[0], x[1], x[2]}; }

/// Compares the answers for a point with the truth.
class Judge {
 public:
  explicit Judge(const Polyhedron& body)
      : body_(body), tree_(body, tetracone::covering::star_faces(body)), points_(tree_), truth_(body), brute_(body)
  {}

  bool is_right(const Vertex& x)
  {
    const auto& [square, nearest] = truth_(exact(x));
    const auto [least, most] = points_.bounds(x);
    const Rational low = least;
    if (low < 0 || low * low > square || !(most >= least)) return false;
    if (std::isfinite(most) && Rational(most) * Rational(most) < square) return false;
    if (const auto found = points_.by_enclosures(x)) {
      ++by_enclosures;
      if (nearest.size() != 1 || found->distance != kernel::nearest_root(square)) return false;
      for (int k = 0; k < 3; ++k)
        if (found->point[std::size_t(k)] != kernel::nearest_double((*nearest.begin())[k])) return false;
      if (!is_held(*found, *nearest.begin())) return false;
    }
    return is_right(kernel::Rational_point{x[0], x[1], x[2]});
  }
  bool is_right(const kernel::Rational_point& x)
  {
    const auto& [square, nearest] = truth_(Point(x[0], x[1], x[2]));
    const auto found = points_.exactly(x);
    ties += nearest.size() > 1;
    const Point at(found.point[0], found.point[1], found.point[2]);
    return found.square == square && nearest.contains(at) && found.is_only == (nearest.size() == 1) &&
           truth_.face(found.face).locate(at) != verify::Place::outside;
  }

  /// The square by a convex program.
  bool is_right_by_program(const kernel::Rational_point& x)
  {
    const verify::Brute_body dot(scenes::polygon({{0, 0, 0}}));
    const kernel::Pose moved({1, 0, 0, x[0], 0, 1, 0, x[1], 0, 0, 1, x[2]});
    return points_.exactly(x).square == verify::squared_distance(verify::Placed_body(brute_, kernel::Pose()),
                                                                 verify::Placed_body(dot, moved),
                                                                 verify::squared_distance_by_program);
  }

  const Bvh8& tree() const { return tree_; }
  long by_enclosures = 0, ties = 0;

 private:
  bool is_held(const Surface_point& found, const Point& at) const
  {
    const auto vertex = [&](int k) { return exact(body_.vertices[found.end[std::size_t(k)]]); };
    const auto place = truth_.face(found.face).locate(at);
    switch (found.feature) {
      case Feature::vertex: return place == verify::Place::vertex && vertex(0) == at;
      case Feature::edge:
        return place == verify::Place::edge && verify::Exact::Segment_3(vertex(0), vertex(1)).has_on(at);
      default: return place == verify::Place::face;
    }
  }

  Polyhedron body_;
  Bvh8 tree_;
  Bvh8_points points_;
  verify::Nearest_truth truth_;
  verify::Brute_body brute_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(nearest_points_are_those_of_both_truths)
{
  scenes::Random random(4610);
  long asked = 0, by_enclosures = 0, ties = 0;
  for (const auto& [name, body] : scenes::bodies_of_any_size()) {
    BOOST_TEST_INFO_SCOPE(name);
    Judge judge(body);
    const auto& scale = judge.tree().scale();
    std::vector<Vertex> points;
    for (const Vertex& x : scenes::hard_points(body, judge.tree().model().lattice().origin, random))
      if (scenes::integer(random, 0, 3) == 0) points.push_back(x);
    for (int n = 0; n < 15; ++n) {
      // About the body, in its vicinity, and far from it.
      const double reach = std::array{0.25, 1.0, 0x1p12}[std::size_t(n % 3)] * scale.unit;
      Vertex x = scenes::real_vertex(random, 1);
      for (std::size_t k = 0; k < 3; ++k) x[k] = scale.origin[k] + x[k] * reach;
      if (std::isfinite(x[0] + x[1] + x[2])) points.push_back(x);
    }
    int wrong = 0;
    for (const Vertex& x : points) wrong += !judge.is_right(x);
    for (std::size_t k = 0; k < points.size(); k += 10) {
      kernel::Rational_point x;
      for (std::size_t i = 0; i < 3; ++i) x[i] = Rational(points[k][i]) / 3;
      wrong += !judge.is_right(x);
      if (k % 20 == 0) wrong += !judge.is_right_by_program(x);
    }
    BOOST_TEST(wrong == 0);
    asked += long(points.size());
    by_enclosures += judge.by_enclosures;
    ties += judge.ties;
  }
  BOOST_TEST(by_enclosures > asked / 4);
  BOOST_TEST(by_enclosures < asked);
  BOOST_TEST(ties > 20);
}

BOOST_AUTO_TEST_CASE(random_points_about_a_mesh_are_decided_by_enclosures)
{
  scenes::Random random(4611);
  const Polyhedron body = scenes::blob(random, 3, 0.9, 1);
  Judge judge(body);
  int wrong = 0;
  constexpr int count = 100;
  for (int n = 0; n < count; ++n) wrong += !judge.is_right(scenes::real_vertex(random, n % 2 == 0 ? 1 : 3));
  // Beside a face, as near as doubles can be.
  for (Index f = 0; f < 40; ++f) {
    Vertex x{};
    for (const Index v : body.loop(f, 0))
      for (std::size_t k = 0; k < 3; ++k) x[k] += body.vertices[v][k] / 3;
    wrong += !judge.is_right(x);
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(judge.by_enclosures > count * 9 / 10);
}

BOOST_AUTO_TEST_CASE(distances_whose_squares_underflow_are_compared_exactly)
{
  // A pentagram, which stays a whole face, just below 0; a corner of a tetrahedron is above it, and farther away.
  for (const double corner : {0x1p-538, 0x1p-700, 0x1p-1000})
    for (const double below : {corner / 128, corner, corner * 128}) {
      Polyhedron body;
      for (const double z : {-1.0, -below})
        for (int k = 0; k < 5; ++k) body.vertices.push_back({std::cos(k * 0.8 * M_PI), std::sin(k * 0.8 * M_PI), z});
      body.add_polygon({4, 3, 2, 1, 0});
      body.add_polygon({5, 6, 7, 8, 9});
      for (Index k = 0; k < 5; ++k) body.add_polygon({k, (k + 1) % 5, 5 + (k + 1) % 5, 5 + k});
      const double size = corner * 256;
      body.vertices.insert(body.vertices.end(), {{0, 0, corner}, {size, 0, size}, {0, size, size}, {-size, -size, 1}});
      for (const auto& [a, b, c] : {std::array<Index, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
        body.add_polygon({10 + a, 10 + b, 10 + c});
      Judge judge(body);
      BOOST_TEST(judge.is_right(Vertex{0, 0, 0}));
      BOOST_TEST(judge.is_right(Vertex{0, corner / 4, corner / 2}));
    }
}

BOOST_AUTO_TEST_CASE(the_order_by_cells_has_every_point_once)
{
  scenes::Random random(4612);
  for (const double size : {1.0, 0.0, 0x1p-1074, 0x1p-1010, 0x1.fffffffffffffp1023})
    for (const std::size_t count : {1, 2, 3000}) {
      std::vector<Vertex> points;
      for (std::size_t k = 0; k < count; ++k) points.push_back(kernel::scaled(scenes::real_vertex(random, 1), size));
      points[0] = {-size, size, size};
      points.back() = {size, size, -size};
      const std::vector<std::uint32_t> order = order_by_cells(points);
      std::vector<std::uint32_t> sorted = order;
      std::ranges::sort(sorted);
      std::size_t missed = sorted.size() != count;
      for (std::size_t k = 0; k < count; ++k) missed += sorted[k] != k;
      BOOST_TEST(missed == 0u);
      if (count < 3000 || size != 1) continue;
      // Neighbours in the order are nearer than random points are.
      double gap = 0;
      for (std::size_t k = 1; k < count; ++k)
        for (std::size_t i = 0; i < 3; ++i) gap += std::abs(points[order[k]][i] - points[order[k - 1]][i]);
      BOOST_TEST(gap < 0.5 * double(count));
    }
}

BOOST_AUTO_TEST_SUITE_END()
