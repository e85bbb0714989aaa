#include "tetracone/tetratree/paper/collision.h"

#include "verify/test/support/scenes.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_collision)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
using tetracone::covering::Polyhedron;
namespace verify = tetracone::verify;
namespace scenes = tetracone::verify::scenes;
using scenes::Random;

namespace {

/// Two placed bodies and the truth about them.
struct Case {
  Polyhedron a, b;
  Pose pose_a, pose_b;
  bool closed = true, solid = false, surface = false;
  std::vector<Feature_pair> features{};
};

/// Round bodies of some hundred triangles near one another, apart or not.
std::vector<Case> meshes()
{
  std::vector<Case> cases;
  Random random(4);
  for (int n = 0; n < 60; ++n) {
    const Polyhedron a = scenes::blob(random, 2, 0.6, 1),
                     b = scenes::moved(scenes::blob(random, 2, 0.3, 1), n % 3 == 0 ? 0.125 : 1);
    const Vertex d = scenes::real_vertex(random, 1.2);
    const Pose pose = scenes::random_rotation(random, 5, {Rational(d[0]), Rational(d[1]), Rational(d[2])});
    cases.push_back({a, b, scenes::random_rotation(random), n % 2 == 0 ? scenes::rounded(pose) : pose});
  }
  return cases;
}

/// Cases with the truth: meshes, bodies of small integers that touch in every way, and bodies that are open. Poses are
/// of every kind, and scales go from denormals to the largest doubles.
const std::vector<Case>& cases()
{
  static const std::vector<Case> all = [] {
    std::vector<Case> cases = meshes();
    cases.resize(12);
    Random random(3);
    const auto bodies = scenes::closed_bodies();
    const auto body = [&] { return bodies[scenes::integer(random, 0, int(bodies.size()) - 1)].body; };
    const auto shift = [&] {
      return scenes::translation(scenes::integer(random, -6, 6), scenes::integer(random, -2, 2), 0);
    };
    for (int n = 0; n < 60; ++n) {
      const Pose pose = n % 3 == 0   ? scenes::random_affine(random, 2)
                        : n % 3 == 1 ? scenes::random_rotation(random, 3, {1, Rational(7) / Rational(3), 0})
                                     : scenes::rounded(scenes::random_rotation(random));
      cases.push_back({body(), body(), pose, scenes::composed(pose, shift())});
      if (n % 4 == 0) cases.back().b = cases.back().a;
      if (n % 5 == 0) cases.back().b = scenes::without(cases.back().b, [](Index f) { return f % 3 == 0; });
    }
    for (const int power : {-1072, -1030, -700, -420, -130, 120, 260, 500, 1015}) {
      const double scale = std::ldexp(1.0, power);
      cases.push_back({scenes::moved(body(), scale),
                       scenes::moved(scenes::moved(body(), 1, scenes::grid_vertex(random, 2)), scale),
                       {},
                       {}});
    }
    for (Case& c : cases) {
      const verify::Brute_body body_a(c.a), body_b(c.b);
      const verify::Placed_body placed_a(body_a, c.pose_a), placed_b(body_b, c.pose_b);
      c.surface = verify::collide(placed_a, placed_b, Question::surface);
      c.closed = body_a.is_closed() && body_b.is_closed();
      c.solid = c.closed && verify::collide(placed_a, placed_b, Question::solid);
      c.features = verify::features(placed_a, placed_b);
    }
    return cases;
  }();
  return all;
}

Config random_config(Random& random)
{
  const auto coin = [&] { return scenes::integer(random, 0, 1) == 0; };
  Config config;
  config.depth = scenes::integer(random, -1, 6);
  // Small leaves of deep trees hold the same face many times, and are slow.
  config.leaf_size = config.depth == -1 ? 8
                     : config.depth < 2 ? scenes::integer(random, 0, 4)
                     : config.depth < 4 ? 6
                                        : 16;
  config.on_demand = coin();
  config.far_plane = coin() ? Far_plane::shortened : Far_plane::tightest;
  config.shortening_rounds = coin() ? 10 : 1;
  config.sphere_centre = coin() ? Sphere_centre::centroid : Sphere_centre::improved;
  config.regular_hull = coin();
  config.descent = coin() ? Descent::larger_first : Descent::both;
  config.all_axes = coin();
  config.leaf_boxes = coin();
  config.boxes = coin();
  config.all_pairs_after = coin() ? 0.01 : std::numeric_limits<double>::infinity();
  return config;
}

/// The default, the fastest and that of all pairs, then random ones: by number.
Config config_number(int n, Random& random)
{
  return n == 0 ? Config() : n == 1 ? Config::fastest() : n == 2 ? Config::brute() : random_config(random);
}
constexpr int configs = 24;

/// How many of the answers to a case are wrong.
int wrong_answers(const Case& c, const Config& config_a, const Config& config_b)
{
  Tetra_tree<Adaptive> a(c.a, config_a), b(c.b, config_b);
  Collision<Adaptive> collision(a, b);
  int wrong = collision(c.pose_a, c.pose_b, Question::surface) != c.surface;
  if (c.closed) wrong += collision(c.pose_a, c.pose_b) != c.solid;
  return wrong + (collision.features(c.pose_a, c.pose_b) != c.features);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_answers_of_every_config_are_right)
{
  Random random(16);
  int wrong = 0, solid = 0, surface = 0;
  for (std::size_t n = 0; n < cases().size(); ++n) {
    const Case& c = cases()[n];
    solid += c.solid;
    surface += c.surface;
    for (int k = n % 3; k < configs; k += 3) {
      Config config = config_number(k, random), other = n % 2 == 0 ? config : random_config(random);
      // Where nothing is discarded every pair of leaves is met.
      if (n >= 72) config.depth = other.depth = std::min(config.depth, 2);
      wrong += wrong_answers(c, config, other);
    }
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(surface > 20);
  BOOST_TEST(solid > 40);
  BOOST_TEST(solid < int(cases().size()) - 10);
}

BOOST_AUTO_TEST_CASE(a_body_inside_the_other_is_found_from_either_side)
{
  Tetra_tree<Adaptive> small(scenes::cube(0.5)), large(scenes::cube(2));
  for (const auto& [a, b] : {std::pair(&small, &large), std::pair(&large, &small)}) {
    Collision<Adaptive> collision(*a, *b);
    BOOST_TEST(collision(Pose(), Pose()));
    BOOST_TEST(!collision(Pose(), Pose(), Question::surface));
  }
}

BOOST_AUTO_TEST_CASE(nodes_on_demand_are_made_only_where_a_query_goes)
{
  Random random(22);
  Config config;
  config.depth = 5;
  config.leaf_size = 1;
  config.on_demand = true;
  const Polyhedron body = scenes::blob(random, 3, 0.9, 1);
  Tetra_tree<Adaptive> a(body, config), b(body, config);
  Collision<Adaptive> collision(a, b);
  BOOST_TEST(!collision(Pose(), scenes::translation(9, 0, 0)));
  BOOST_TEST(a.node_count() + b.node_count() == 2u);
  collision(Pose(), scenes::translation(1.9, 0.1, 0.2));
  const std::size_t some = a.node_count();
  config.on_demand = false;
  BOOST_TEST(some > 1u);
  BOOST_TEST(some < (Tetra_tree<Adaptive>(body, config).node_count()) / 2);
}

BOOST_AUTO_TEST_CASE(counts_add_up)
{
  Random random(23);
  for (std::size_t n = 0; n < 60; n += 2) {
    const Case& c = cases()[n];
    const Config config = random_config(random);
    Tetra_tree<Adaptive> a(c.a, config), b(c.b, config);
    Collision<Adaptive> collision(a, b);
    collision.features(c.pose_a, c.pose_b);
    const Query_statistics& counts = collision.counts();
    const bool trees = a.config().depth > 0;
    BOOST_TEST(counts.queries == 1u);
    BOOST_TEST(counts.sphere_tests == counts.pairs_visited + trees);
    BOOST_TEST(counts.discarded_by_sphere <= counts.sphere_tests);
    BOOST_TEST(counts.tetrahedron_tests <= counts.pairs_visited);
    BOOST_TEST(counts.discarded_by_tetrahedron <= counts.tetrahedron_tests);
    BOOST_TEST(counts.discarded_by_hull <= counts.hull_tests);
    BOOST_TEST(counts.leaf_pairs + counts.discarded_by_sphere + counts.discarded_by_tetrahedron <=
               counts.sphere_tests + 1);
    BOOST_TEST(counts.inclusion_tests == 0u);
    if (!config.leaf_boxes) BOOST_TEST(counts.discarded_by_box == 0u);
    if (!config.regular_hull) BOOST_TEST(counts.hull_tests == 0u);
    if (!trees) {
      const auto& edges_a = a.model().covering().edges();
      const auto& edges_b = b.model().covering().edges();
      BOOST_TEST(counts.edge_face_tests + counts.discarded_by_box ==
                 edges_a.size() * c.b.face_count() + edges_b.size() * c.a.face_count());
    }
    collision.clear_counts();
    BOOST_TEST(
        collision.counts().bounding_tests() + collision.counts().primitive_tests() + collision.counts().queries == 0u);
  }
}

BOOST_AUTO_TEST_CASE(every_stage_discards_something_and_the_regular_hull_saves_visits)
{
  const auto counts_with = [](const std::function<void(Config&)>& choose) {
    Config config;
    choose(config);
    Query_statistics sum;
    for (const Case& c : meshes()) {
      Tetra_tree<Adaptive> a(c.a, config), b(c.b, config);
      Collision<Adaptive> collision(a, b);
      collision(c.pose_a, c.pose_b);
      sum += collision.counts();
    }
    return sum;
  };
  const Query_statistics paper = counts_with([](Config&) {}),
                         no_hull = counts_with([](Config&c) { c.regular_hull = false; });
  const Query_statistics boxes = counts_with([](Config& c) { c.leaf_boxes = true; });
  const Query_statistics oriented = counts_with([](Config& c) { c.boxes = true; });
  BOOST_TEST(paper.discarded_by_hull > 0u);
  BOOST_TEST(paper.discarded_by_sphere > 0u);
  BOOST_TEST(paper.discarded_by_tetrahedron > 0u);
  BOOST_TEST(paper.discarded_by_box == 0u);
  BOOST_TEST(boxes.discarded_by_box > 0u);
  BOOST_TEST(oriented.pairs_visited < paper.pairs_visited);
  BOOST_TEST(no_hull.discarded_by_hull == 0u);
  BOOST_TEST(paper.pairs_visited <= no_hull.pairs_visited);
}

BOOST_AUTO_TEST_CASE(elements_of_many_cones_are_tested_once_where_the_share_of_pairs_says_so)
{
  // Origins far outside: every cone that holds anything holds nearly all.
  const Polyhedron body = scenes::moved(scenes::star_prism(), 1, {40, 0, 0});
  Config listing, bounded;
  listing.leaf_size = bounded.leaf_size = 1;
  listing.depth = bounded.depth = 4;
  listing.regular_hull = bounded.regular_hull = listing.spheres = bounded.spheres = false;
  listing.tetrahedra = bounded.tetrahedra = false;
  bounded.all_pairs_after = 1.0 / 32;
  const auto tests = [&](const Config& config) {
    Tetra_tree<Adaptive> a(body, config), b(body, config);
    Collision<Adaptive> collision(a, b);
    BOOST_TEST(!collision(Pose(), Pose::translation(0, 0, 50), Question::surface));
    BOOST_TEST(collision.features(Pose(), Pose()).size() > 0);
    collision.clear_counts();
    collision(Pose(), Pose::translation(0, 0, 50), Question::surface);
    return collision.counts().edge_face_tests;
  };
  const double all_pairs =
      2.0 * double(Tetra_tree<Adaptive>(body).model().covering().edges().size()) * double(body.face_count());
  BOOST_TEST(double(tests(listing)) > 1.5 * all_pairs);
  BOOST_TEST(double(tests(bounded)) <= 1.1 * all_pairs);
}

BOOST_AUTO_TEST_CASE(a_descent_ends_when_comparing_nodes_and_crossing_planes_took_the_share_of_pairs)
{
  const auto counts_in = []<class K>(K, const Polyhedron& body, const Pose& apart, const Config& config) {
    Tetra_tree<K> a(body, config), b(body, config);
    Collision<K> collision(a, b);
    BOOST_TEST(!collision(Pose(), apart, Question::surface));
    return collision.counts();
  };
  const auto counts = std::bind_front(counts_in, Adaptive());
  const auto all_pairs = [](const Polyhedron& body) {
    return 2 * Tetra_tree<Adaptive>(body).model().covering().edges().size() * body.face_count();
  };

  // Bodies of a few faces: the listing compares many pairs of nodes, of which the share pays for none.
  const Polyhedron cube = scenes::unit_cube();
  const Pose near = Pose::translation(1.001, 0.01, 0.02);
  BOOST_TEST(counts(cube, near, Config()).pairs_visited > 10u);
  BOOST_TEST(counts(cube, near, Config::paper()).pairs_visited == 0u);
  BOOST_TEST(counts(cube, near, Config::paper()).edge_face_tests == all_pairs(cube));
  BOOST_TEST(counts_in(Double(), cube, near, Config::paper()).pairs_visited > 0u);

  // Caps of many edges, whose planes the other's sides cross: what is looked at in leaves and of nodes is not all.
  std::vector<std::array<double, 2>> corners;
  for (int k = 0; k < 48; ++k)
    corners.push_back({std::cos(k * std::numbers::pi / 24), std::sin(k * std::numbers::pi / 24)});
  const Polyhedron drum = scenes::prism(corners, 2);
  Config config;
  config.leaf_size = 1;
  config.spheres = config.tetrahedra = config.regular_hull = false;
  config.all_pairs_after = 1;
  const Query_statistics drums = counts(drum, Pose::translation(3, 0, 1), config);
  BOOST_TEST(drums.edge_face_tests > all_pairs(drum));
  const std::uint64_t in_leaves = drums.edge_face_tests - all_pairs(drum);
  BOOST_TEST(double(in_leaves + Collision<Adaptive>::pairs_per_visit * drums.pairs_visited) <
             0.9 * double(all_pairs(drum)));
}

BOOST_AUTO_TEST_SUITE_END()
