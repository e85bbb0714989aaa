#include "tetracone/tetratree/paper/tetra_cone.h"

#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cstdlib>
#include <set>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tetra_cone)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;

namespace {

using Integer = long long;

Integer determinant(const Tetra_cone& cone)
{
  const auto &a = cone.ray[0], &b = cone.ray[1], &c = cone.ray[2];
  const auto minor = [&](int i, int j) { return Integer(b[i]) * c[j] - Integer(b[j]) * c[i]; };
  return a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1);
}

// Coordinates of a direction along the rays, times the determinant.
std::array<Integer, 3> coordinates(const Tetra_cone& cone, const Direction& p)
{
  std::array<Integer, 3> result;
  for (int k = 0; k < 3; ++k) {
    Tetra_cone replaced = cone;
    replaced.ray[k] = p;
    result[k] = determinant(replaced);
  }
  return result;
}

enum class Where { outside, border, inside };

Where where(const Tetra_cone& cone, const Direction& p)
{
  bool border = false;
  for (const Integer c : coordinates(cone, p)) {
    if (c < 0) return Where::outside;
    border = border || c == 0;
  }
  return border ? Where::border : Where::inside;
}

Tetra_cone random_cone(scenes::Random& random, int level)
{
  Tetra_cone cone = Tetra_cone::octant(scenes::integer(random, 0, 7));
  for (; level > 1; --level) cone = cone.child(scenes::integer(random, 0, 3));
  return cone;
}

Direction random_direction(scenes::Random& random, int radius)
{
  return {scenes::integer(random, -radius, radius), scenes::integer(random, -radius, radius),
          scenes::integer(random, -radius, radius)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_first_octant_is_the_papers)
{
  const Tetra_cone cone = Tetra_cone::octant(0);
  BOOST_TEST((cone.ray[0] == Direction{0, 0, lattice_size}));
  BOOST_TEST((cone.ray[1] == Direction{lattice_size, 0, 0}));
  BOOST_TEST((cone.ray[2] == Direction{0, lattice_size, 0}));
}

BOOST_AUTO_TEST_CASE(the_octants_are_positive_and_hold_their_own_directions_only)
{
  for (int k = 0; k < 8; ++k) {
    BOOST_TEST(determinant(Tetra_cone::octant(k)) > 0);
    for (int j = 0; j < 8; ++j) {
      const Direction d{j & 1 ? -1 : 2, j & 2 ? -3 : 1, j & 4 ? -2 : 3};
      BOOST_TEST((where(Tetra_cone::octant(k), d) == Where::inside) == (j == k));
    }
  }
}

BOOST_AUTO_TEST_CASE(children_are_the_papers_positive_and_a_quarter_of_their_parent_each)
{
  scenes::Random random(1);
  const Tetra_cone parent = Tetra_cone::octant(0);
  const auto middle = [](const Direction& a, const Direction& b) {
    return Direction{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  };
  const auto& [v1, v2, v3] = parent.ray;
  BOOST_TEST((parent.child(0).ray == std::array{v1, middle(v1, v2), middle(v3, v1)}));
  BOOST_TEST((parent.child(1).ray == std::array{middle(v1, v2), v2, middle(v2, v3)}));
  BOOST_TEST((parent.child(2).ray == std::array{middle(v3, v1), middle(v2, v3), v3}));
  BOOST_TEST((parent.child(3).ray == std::array{middle(v1, v2), middle(v2, v3), middle(v3, v1)}));
  for (int level = 1; level < max_cone_depth; ++level)
    for (int n = 0; n < 20; ++n) {
      const Tetra_cone cone = random_cone(random, level);
      for (int k = 0; k < 4; ++k) BOOST_TEST(4 * determinant(cone.child(k)) == determinant(cone));
    }
}

BOOST_AUTO_TEST_CASE(children_cover_their_parent_without_overlap_but_for_borders)
{
  scenes::Random random(2);
  std::array<int, 3> seen{};
  for (int n = 0; n < 5000; ++n) {
    const Tetra_cone cone = random_cone(random, scenes::integer(random, 1, 5));
    // In the cone for certain: a sum of its rays. Small sums meet borders of children.
    const std::array<int, 3> c = {scenes::integer(random, 0, 4), scenes::integer(random, 0, 4),
                                  scenes::integer(random, 0, 4)};
    Direction p{0, 0, 0};
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis) p[axis] += c[i] * cone.ray[i][axis];
    int inside = 0, border = 0;
    for (int k = 0; k < 4; ++k) {
      const Where at = where(cone.child(k), p);
      inside += at == Where::inside;
      border += at == Where::border;
    }
    BOOST_TEST((inside == 1 ? border == 0 : inside == 0 && border >= 1));
    ++seen[inside];
    const Direction outside = random_direction(random, 3);
    if (where(cone, outside) == Where::outside)
      for (int k = 0; k < 4; ++k) BOOST_TEST((where(cone.child(k), outside) == Where::outside));
  }
  BOOST_TEST(seen[0] > 500);
  BOOST_TEST(seen[1] > 500);
}

BOOST_AUTO_TEST_CASE(rays_stay_integer_points_of_the_octahedron_down_to_the_deepest_level)
{
  scenes::Random random(3);
  for (int n = 0; n < 1000; ++n)
    for (const Direction& d : random_cone(random, max_cone_depth).ray)
      BOOST_TEST(std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]) == lattice_size);
}

BOOST_AUTO_TEST_CASE(cones_of_a_level_share_their_rays)
{
  // Closed about the origin: every two rays that are a side of one cone are one of exactly one other.
  for (int level = 1; level <= 4; ++level) {
    std::vector<Tetra_cone> cones;
    for (int k = 0; k < 8; ++k) cones.push_back(Tetra_cone::octant(k));
    for (int l = 1; l < level; ++l) {
      std::vector<Tetra_cone> finer;
      for (const Tetra_cone& cone : cones)
        for (int k = 0; k < 4; ++k) finer.push_back(cone.child(k));
      cones = finer;
    }
    std::multiset<std::array<Direction, 2>> sides;
    for (const Tetra_cone& cone : cones)
      for (int i = 0; i < 3; ++i) sides.insert({cone.ray[i], cone.ray[(i + 1) % 3]});
    for (const auto& [a, b] : sides) {
      BOOST_TEST(sides.count({a, b}) == 1u);
      BOOST_TEST(sides.count({b, a}) == 1u);
    }
  }
}

BOOST_AUTO_TEST_CASE(points_of_a_cone_are_its_lattice_points_and_are_placed_exactly)
{
  using K = Rational_kernel;
  scenes::Random random(4);
  const std::vector<Vertex> model = {{1e6, 0.1, -3}, {1e6 + 1, 7, 1}, {1e6, 3, 3}};
  const Cone_lattice lattice = cone_lattice(model);
  const Pose pose = scenes::random_rotation(random, 5, {Rational(1) / Rational(7), 0, 3});
  const Frame<K> frame(pose);
  for (int n = 0; n < 50; ++n) {
    const Tetra_cone cone = random_cone(random, 1 + n % max_cone_depth);
    const Cone_points<K> points(lattice, cone);
    const Cone_points<K> placed = points.placed(frame);
    const auto exact = [&](const Direction& d) {
      rationals::Vector p;
      for (int k = 0; k < 3; ++k) p[k] = Rational(lattice.origin[k]) + Rational(lattice.step) * Rational(d[k]);
      return p;
    };
    const std::array<std::pair<const K::Point_3*, const K::Point_3*>, 4> pairs = {
        {{&points.v0, &placed.v0}, {&points.v1, &placed.v1}, {&points.v2, &placed.v2}, {&points.v3, &placed.v3}}};
    for (int i = 0; i < 4; ++i) {
      const rationals::Vector truth = exact(i == 0 ? Direction{0, 0, 0} : cone.ray[i - 1]),
                              image = rationals::image(pose, truth);
      for (int k = 0; k < 3; ++k) {
        BOOST_TEST(((*pairs[i].first)[k] == truth[k]));
        BOOST_TEST(((*pairs[i].second)[k] == image[k]));
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
