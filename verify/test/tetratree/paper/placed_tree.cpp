#include "tetracone/tetratree/paper/placed_tree.h"

#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/rationals.h"
#include "verify/test/support/scenes.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <set>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_placed_tree)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
namespace rationals = tetracone::verify::rationals;
namespace scenes = tetracone::verify::scenes;
using rationals::Vector;
using scenes::Random;

namespace {

using K = Adaptive;
using Exact_motions = std::tuple<Rational_kernel, Adaptive>;

Config config_of(int n)
{
  Config config;
  config.depth = n % 6;
  config.leaf_size = n % 4;
  config.on_demand = n % 2 == 1;
  return config;
}

std::vector<Pose> poses(Random& random)
{
  return {Pose(),
          scenes::random_rotation(random, 5, {Rational(1) / Rational(3), -1, 7}),
          scenes::rounded(scenes::random_rotation(random)),
          scenes::random_affine(random),
          Pose(std::array<double, 12>{-1, 0, 0, 5, 0, 1, 0, 0.1, 0, 0, 1, -0.3}),
          scenes::translation(0x1p30, 0.1, -0x1p-30)};
}

}  // namespace

KERNEL_TEST_CASE(a_solid_contains_a_point_off_its_surface_where_its_winding_number_is_not_zero, K, Exact_motions)
{
  Random random(1);
  int n = 0;
  std::set<bool> seen;
  for (const auto& [name, body] : scenes::closed_bodies()) {
    BOOST_TEST_CONTEXT(name)
    {
      for (const Pose& pose : poses(random)) {
        if (std::is_same_v<K, Rational_kernel> && ++n % 3 != 0) continue;
        Tetra_tree<K> tree(body, config_of(++n));
        Placed_tree<K> placed(tree);
        placed.place(pose);
        const Frame<K> frame(pose);
        int wrong = 0;
        for (int k = 0; k < 25; ++k) {
          // Borders of cones and of the covering's tetrahedra: small integers, O, multiples of vertices.
          Vertex p = k == 0 ? tree.model().lattice().origin : scenes::grid_vertex(random, 4);
          if (k % 3 == 1)
            for (int i = 0; i < 3; ++i) p[i] = body.vertices[k % body.vertices.size()][i] * 0.5;
          const Vector exact = rationals::exactly(p);
          if (rationals::is_on_surface(body, exact)) continue;
          const bool truth = rationals::winding_number(body, exact) != 0;
          wrong += placed.contains(frame(point<K>(p))) != truth;
          seen.insert(truth);
        }
        BOOST_TEST(wrong == 0);
      }
    }
  }
  BOOST_TEST(seen.size() == 2u);
}

BOOST_AUTO_TEST_CASE(voxel_solids_contain_the_points_that_their_cells_contain)
{
  Random random(2);
  for (int n = 0; n < 6; ++n) {
    const scenes::Voxels voxels(random, 3, 0.3 + 0.1 * n);
    Tetra_tree<K> tree(voxels.solid(), config_of(n));
    Placed_tree<K> placed(tree);
    const Pose pose = scenes::random_affine(random);
    placed.place(pose);
    const Frame<K> frame(pose);
    int wrong = 0;
    for (int x = -1; x <= 7; ++x)
      for (int y = -1; y <= 7; ++y)
        for (int z = -1; z <= 7; ++z)
          if (const int where = voxels.where(x, y, z); where != 0)
            wrong += placed.contains(frame(point<K>({x / 2.0, y / 2.0, z / 2.0}))) != (where > 0);
    BOOST_TEST(wrong == 0);
  }
}

BOOST_AUTO_TEST_CASE(a_question_about_a_point_makes_only_the_nodes_of_its_cones)
{
  Random random(3);
  Config config;
  config.depth = 5;
  config.leaf_size = 1;
  config.on_demand = true;
  Tetra_tree<K> tree(scenes::blob(random, 3, 0.8, 1), config);
  Placed_tree<K> placed(tree);
  placed.place(Pose());
  BOOST_TEST(tree.node_count() == 1u);
  BOOST_TEST(placed.contains(point<K>({0.1, 0.2, 0.3})));
  BOOST_TEST(tree.node_count() <= 1u + 8 + 4 * 4);
  const std::size_t made = tree.node_count();
  BOOST_TEST(!placed.contains(point<K>({1, 2, 3})));
  BOOST_TEST(tree.node_count() == made);
}

BOOST_AUTO_TEST_CASE(boxes_and_spheres_hold_the_exact_images)
{
  Random random(4);
  for (const auto& [name, body] : scenes::closed_bodies()) {
    BOOST_TEST_CONTEXT(name)
    {
      Tetra_tree<K> tree(body, config_of(4));
      Placed_tree<K> placed(tree);
      for (const Pose& pose : poses(random)) {
        placed.place(pose);
        std::vector<Vector> images;
        for (const Vertex& v : body.vertices) images.push_back(rationals::image(pose, rationals::exactly(v)));
        const auto holds = [](const Box<double>& box, const Vector& p) {
          for (int k = 0; k < 3; ++k)
            if (p[k] < Rational(box.low[k]) || p[k] > Rational(box.high[k])) return false;
          return true;
        };
        int wrong = 0;
        const auto& covering = tree.model().covering();
        for (Index e = 0; e < covering.edges().size(); ++e)
          for (const Index v : covering.edges()[e]) wrong += !holds(placed.edge_box(e), images[v]);
        for (Index f = 0; f < body.face_count(); ++f)
          for (const Index v : covering.from(f)) wrong += !holds(placed.face_box(f), images[v]);
        for (Index n = 0; n < tree.node_count(); ++n) {
          const Ball<double> ball = placed.sphere(tree.node(n));
          const Vector centre = rationals::exactly(ball.centre);
          for (const Index element : tree.elements(tree.node(n)))
            for (const Index v : covering.triangles()[element].corner) {
              const Vector d = rationals::minus(images[v], centre);
              wrong += rationals::inner(d, d) > Rational(ball.radius) * Rational(ball.radius);
            }
        }
        const auto origin = placed.origin();
        const Vector exact = rationals::image(pose, rationals::exactly(tree.origin()));
        for (int k = 0; k < 3; ++k)
          wrong += abs(Rational(exact[k] - Rational(origin[k]))) > Rational(placed.frame().error());
        BOOST_TEST(wrong == 0);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_reference_plane_faces_the_point_and_has_the_body_behind_it)
{
  Random random(5);
  int found = 0, tried = 0;
  for (const auto& [name, body] : scenes::closed_bodies()) {
    BOOST_TEST_CONTEXT(name)
    {
      for (const Pose& pose : poses(random)) {
        Tetra_tree<K> tree(body, config_of(++tried));
        Placed_tree<K> placed(tree);
        placed.place(pose);
        const auto origin = placed.origin();
        Bound_point<double> far;
        const Vertex d = scenes::real_vertex(random, 1000);
        for (int k = 0; k < 3; ++k) far[k] = origin[k] + d[k];
        const auto plane = placed.reference(far);
        const double slack = projection_slack(placed.frame(), placed.frame());
        found += plane.is_beyond(far, slack);
        BOOST_TEST(!plane.is_beyond(origin, slack));
        for (const Vertex& v : body.vertices) BOOST_TEST(!plane.is_beyond(placed.frame()(v), slack));
      }
    }
  }
  BOOST_TEST(found > tried * 9 / 10);
}

// Planted and seen to fail: child 3 never made, and weights of 1/2 on borders instead of the moved point,
// a_solid_contains_a_point_off_its_surface_where_its_winding_number_is_not_zero and voxel_solids_contain_...

BOOST_AUTO_TEST_SUITE_END()
