#include "tetracone/tetratree/paper/tetra_cone.h"

#include "verify/test/support/cones.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_tetra_cone)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using scenes::determinant;

BOOST_AUTO_TEST_CASE(the_first_octant_is_the_papers)
{
  const Tetra_cone cone = Tetra_cone::octant(0);
  BOOST_TEST((cone.ray[0] == Direction{0, 0, lattice_size}));
  BOOST_TEST((cone.ray[1] == Direction{lattice_size, 0, 0}));
  BOOST_TEST((cone.ray[2] == Direction{0, lattice_size, 0}));
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
      const Tetra_cone cone = scenes::random_cone(random, level);
      for (int k = 0; k < 4; ++k) BOOST_TEST((4 * determinant(cone.child(k)) == determinant(cone)));
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
    const Tetra_cone cone = scenes::random_cone(random, 1 + n % max_cone_depth);
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
