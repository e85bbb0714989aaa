#include "tetracone/tetratree/paper/collision.h"

#include "verify/test/support/kernel_test_case.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_collision)

using namespace tetracone::tetratree;
using namespace tetracone::kernel;
using tetracone::covering::Polyhedron;
namespace verify = tetracone::verify;
namespace scenes = tetracone::verify::scenes;
using scenes::Random;

namespace {

using Exact_kernels = std::tuple<Adaptive, Epeck, Rational_kernel>;

/// Two placed bodies and the truth about them.
struct Case {
  std::string name;
  Polyhedron a, b;
  Pose pose_a, pose_b;
  bool solid = false, surface = false;
  std::vector<Feature_pair> features{};
};

using Cases = std::vector<Case>;

void add_truth(Cases& cases, bool with_features)
{
  for (Case& c : cases) {
    const verify::Brute_body body_a(c.a), body_b(c.b);
    const verify::Placed_body placed_a(body_a, c.pose_a), placed_b(body_b, c.pose_b);
    c.surface = verify::collide(placed_a, placed_b, Question::surface);
    c.solid = body_a.is_closed() && body_b.is_closed() && verify::collide(placed_a, placed_b, Question::solid);
    if (with_features) c.features = verify::features(placed_a, placed_b);
  }
}

/// The unit cube and itself shifted by one edge, by two and by three, both turned: they touch in a face, an edge, a
/// corner. With the rotation and the shift rounded to double, or truly rigid, as rationals.
const Cases& touching_cubes()
{
  static const Cases cases = [] {
    Cases cases;
    Random random(1);
    for (int n = 0; n < 100; ++n) {
      const Pose rotation = scenes::random_rotation(random, 9);
      for (const auto& shift : {std::array<int, 3>{1, 0, 0}, {1, 1, 0}, {1, 1, 1}}) {
        const Pose second = scenes::composed(rotation, scenes::translation(shift[0], shift[1], shift[2]));
        cases.push_back(
            {"rounded", scenes::unit_cube(), scenes::unit_cube(), scenes::rounded(rotation), scenes::rounded(second)});
        cases.push_back({"rigid", scenes::unit_cube(), scenes::unit_cube(), rotation, second});
      }
    }
    add_truth(cases, true);
    return cases;
  }();
  return cases;
}

/// Bodies of small integers placed where they stand: contacts of every kind, overlap in planes, nesting.
const Cases& grid_bodies()
{
  static const Cases cases = [] {
    Cases cases;
    Random random(2);
    const auto bodies = scenes::closed_bodies();
    for (int n = 0; n < 240; ++n) {
      Case c{"tetrahedra",
             scenes::random_tetrahedra(random, 1 + n % 3, 2),
             scenes::random_tetrahedra(random, 1, 2),
             {},
             {}};
      c.b = scenes::moved(c.b, 1, scenes::grid_vertex(random, 2));
      cases.push_back(c);
    }
    for (const auto& first : bodies)
      for (const auto& second : bodies) {
        const double scale = std::array{1.0, 0.5, 0.25}[scenes::integer(random, 0, 2)];
        cases.push_back({first.name + ", " + second.name,
                         first.body,
                         scenes::moved(second.body, scale, scenes::grid_vertex(random, 2)),
                         {},
                         {}});
      }
    for (int n = 0; n < 40; ++n)
      cases.push_back({"voxels",
                       scenes::Voxels(random, 3, 0.3).solid(),
                       scenes::moved(scenes::Voxels(random, 2).solid(), 1, scenes::grid_vertex(random, 3)),
                       {},
                       {}});
    add_truth(cases, true);
    return cases;
  }();
  return cases;
}

/// One pair of bodies under poses of every kind.
const Cases& placed_bodies()
{
  static const Cases cases = [] {
    Cases cases;
    Random random(3);
    const auto bodies = scenes::closed_bodies();
    for (int n = 0; n < 260; ++n) {
      const auto& first = bodies[scenes::integer(random, 0, int(bodies.size()) - 1)];
      const auto& second = bodies[scenes::integer(random, 0, int(bodies.size()) - 1)];
      const std::array<Rational, 3> t = {scenes::integer(random, -3, 3),
                                         Rational(scenes::integer(random, -9, 9)) / Rational(3), 0};
      const auto pose = [&](int kind) {
        switch (kind) {
          case 0: return scenes::random_rotation(random, 3, t);
          case 1: return scenes::rounded(scenes::random_rotation(random, 3, t));
          case 2: return scenes::random_affine(random, 2);
          case 3: return Pose(std::array<double, 12>{-1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 0});
          default: return Pose();
        }
      };
      const int kind = n % 5;
      Case c{first.name + ", " + second.name, first.body, second.body, pose(kind), pose(scenes::integer(random, 0, 4))};
      if (n % 4 == 0) {  // the same placed by the same, one shifted along an axis of its own: contacts that are exact
        c.b = c.a;
        c.pose_b = scenes::composed(
            c.pose_a, scenes::translation(scenes::integer(random, -6, 6), scenes::integer(random, -2, 2), 0));
      }
      cases.push_back(c);
    }
    add_truth(cases, true);
    return cases;
  }();
  return cases;
}

/// Round bodies of some hundred triangles near one another, apart or not.
const Cases& meshes()
{
  static const Cases cases = [] {
    Cases cases;
    Random random(4);
    for (int n = 0; n < 60; ++n) {
      const Polyhedron a = scenes::blob(random, 2, 0.6, 1),
                       b = scenes::moved(scenes::blob(random, 2, 0.3, 1), n % 3 == 0 ? 0.125 : 1);
      const Vertex d = scenes::real_vertex(random, 1.2);
      const Pose pose = scenes::random_rotation(random, 5, {Rational(d[0]), Rational(d[1]), Rational(d[2])});
      cases.push_back({"blobs", a, b, scenes::random_rotation(random), n % 2 == 0 ? scenes::rounded(pose) : pose});
    }
    add_truth(cases, true);
    return cases;
  }();
  return cases;
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

// Each choice alone against the default and the fastest, then random ones: by number.
Config config_number(int n, Random& random)
{
  Config config = n % 2 == 0 ? Config() : Config::fastest();
  switch (n / 2) {
    case 0: return config;
    case 1: return Config::brute();
    case 2: config.on_demand = true; return config;
    case 3: config.regular_hull = !config.regular_hull; return config;
    case 4: config.all_axes = !config.all_axes; return config;
    case 5: config.leaf_boxes = !config.leaf_boxes; return config;
    case 6: config.descent = Descent::both; return config;
    case 7:
      config.depth = 2;
      config.leaf_size = 4;
      return config;
    case 8:
      config.leaf_size = 1;
      config.all_pairs_after = 0.01;
      return config;
    default: return random_config(random);
  }
}
constexpr int fixed_configs = 18;

std::vector<Feature_pair> swapped(std::vector<Feature_pair> features)
{
  for (Feature_pair& pair : features) pair.body = 1 - pair.body;
  std::sort(features.begin(), features.end());
  return features;
}

/// How many of the answers to a case are wrong: both questions and the features, asked both ways round.
template <class K>
int wrong_answers(const Case& c, const Config& config_a, const Config& config_b, bool closed = true)
{
  Tetra_tree<K> a(c.a, config_a), b(c.b, config_b);
  Collision<K> forth(a, b), back(b, a);
  int wrong = forth(c.pose_a, c.pose_b, Question::surface) != c.surface;
  wrong += back(c.pose_b, c.pose_a, Question::surface) != c.surface;
  if (closed) {
    wrong += forth(c.pose_a, c.pose_b) != c.solid;
    wrong += back(c.pose_b, c.pose_a) != c.solid;
  }
  wrong += forth.features(c.pose_a, c.pose_b) != c.features;
  wrong += back.features(c.pose_b, c.pose_a) != swapped(c.features);
  return wrong;
}

// Every `stride`-th case, each with one config after the other.
template <class K>
void check_all(const Cases& cases, int stride, int seed)
{
  Random random(seed);
  std::map<std::string, int> wrong;
  for (std::size_t n = 0; n < cases.size(); n += stride) {
    const int k = n % (2 * fixed_configs);
    const Config config = config_number(k, random);
    if (const int count = wrong_answers<K>(cases[n], config, n % 3 == 0 ? random_config(random) : config))
      wrong[cases[n].name + ", config " + std::to_string(k)] += count;
  }
  for (const auto& [name, count] : wrong) BOOST_ERROR(name << ": " << count << " wrong answers");
  BOOST_TEST(wrong.empty());
}

/// Wrong answers to both questions alone, of any kernel.
template <class K>
int wrong_booleans(const Case& c, const Config& config)
{
  Tetra_tree<K> a(c.a, config), b(c.b, config);
  Collision<K> collision(a, b);
  return (collision(c.pose_a, c.pose_b, Question::surface) != c.surface) + (collision(c.pose_a, c.pose_b) != c.solid);
}
template <class K>
int wrong_booleans(const Cases& cases, const Config& config)
{
  int wrong = 0;
  for (const Case& c : cases) wrong += wrong_booleans<K>(c, config);
  return wrong;
}

template <class K>
constexpr int stride_of = std::is_same_v<K, Adaptive> ? 1
                          : std::is_same_v<K, Epeck>  ? 7
                                                      : 19;

}  // namespace

BOOST_AUTO_TEST_CASE(the_cases_hold_answers_of_both_kinds_and_contacts_of_all_kinds)
{
  std::set<Contact> contacts;
  for (const Cases* cases : {&touching_cubes(), &grid_bodies(), &placed_bodies(), &meshes()}) {
    int surface = 0, solid = 0;
    for (const Case& c : *cases) {
      surface += c.surface;
      solid += c.solid;
      for (const Feature_pair& pair : c.features) contacts.insert(pair.kind);
    }
    BOOST_TEST(surface > 20);
    BOOST_TEST(solid < int(cases->size()) - 10);
    BOOST_TEST(solid >= surface);
    if (cases == &grid_bodies()) BOOST_TEST(solid > surface);
  }
  BOOST_TEST(contacts.size() == 6u);
  for (const Case& c : touching_cubes())
    if (c.name == "rigid") BOOST_TEST(c.surface);
}

KERNEL_TEST_CASE(exact_kernels_are_right_on_cubes_that_touch_under_a_hundred_rotations, K, Exact_kernels)
{
  check_all<K>(touching_cubes(), 23, 11);  // features of fractions are slow
}

KERNEL_TEST_CASE(exact_kernels_are_right_on_every_kind_of_contact, K, Exact_kernels)
{
  check_all<K>(grid_bodies(), stride_of<K>, 12);
}

BOOST_AUTO_TEST_CASE(exact_predicates_are_right_on_every_kind_of_contact_where_nothing_is_moved)
{
  check_all<Epick>(grid_bodies(), 3, 13);
}

KERNEL_TEST_CASE(exact_kernels_are_right_under_poses_of_every_kind, K, Exact_kernels)
{
  check_all<K>(placed_bodies(), std::is_same_v<K, Rational_kernel> ? 43 : 23, 14);
}

KERNEL_TEST_CASE(exact_kernels_are_right_on_meshes, K, Exact_kernels)
{
  check_all<K>(meshes(), stride_of<K> * 2 - 1, 15);
}

BOOST_AUTO_TEST_CASE(deep_trees_with_small_leaves_are_right_on_meshes)
{
  Random random(24);
  int wrong = 0;
  for (const Case& c : meshes()) {
    Config config = random_config(random);
    config.depth = scenes::integer(random, 3, 6);
    config.leaf_size = scenes::integer(random, 0, 3);
    wrong += wrong_answers<Adaptive>(c, config, config);
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(each_config_is_right_on_each_of_some_cases)
{
  Random random(16);
  int wrong = 0;
  for (const Cases* cases : {&grid_bodies(), &meshes()})
    for (std::size_t n = 0; n < cases->size(); n += cases->size() / 5)
      for (int k = 0; k < 2 * fixed_configs; ++k) {
        const Config config = config_number(k, random);
        wrong += wrong_answers<Adaptive>((*cases)[n], config, config);
      }
  for (const Cases* cases : {&touching_cubes(), &placed_bodies()})
    for (std::size_t n = 0; n < cases->size(); ++n)
      wrong += wrong_booleans<Adaptive>((*cases)[n], config_number(n % (2 * fixed_configs), random));
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(kernels_that_round_give_some_wrong_answers_on_cubes_that_touch)
{
  const int by_float = wrong_booleans<Float>(touching_cubes(), Config());
  const int by_double = wrong_booleans<Double>(touching_cubes(), Config());
  const int by_epick = wrong_booleans<Epick>(touching_cubes(), Config());
  BOOST_TEST_MESSAGE("wrong of " << 2 * touching_cubes().size() << ": float " << by_float << ", double " << by_double
                                 << ", EPICK " << by_epick);
  BOOST_TEST(by_float > 0);
  BOOST_TEST(by_double > 0);
  BOOST_TEST(by_epick > 0);
  BOOST_TEST(wrong_booleans<Adaptive>(touching_cubes(), Config()) == 0);
}

BOOST_AUTO_TEST_CASE(orders_of_vertices_and_faces_change_no_answer)
{
  Random random(17);
  int wrong = 0;
  for (const Cases* cases : {&grid_bodies(), &placed_bodies()})
    for (std::size_t n = 0; n < cases->size(); n += 7) {
      const Case& c = (*cases)[n];
      Tetra_tree<Adaptive> a(scenes::shuffled(c.a, random), random_config(random)),
          b(scenes::shuffled(c.b, random), random_config(random));
      Collision<Adaptive> collision(a, b);
      wrong +=
          collision(c.pose_a, c.pose_b) != c.solid || collision(c.pose_a, c.pose_b, Question::surface) != c.surface;
      wrong += collision.features(c.pose_a, c.pose_b).size() != c.features.size();
    }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(powers_of_two_change_no_answer_from_denormals_to_the_largest_double)
{
  Random random(18);
  int wrong = 0;
  for (std::size_t n = 0; n < grid_bodies().size(); n += 61)
    for (const int power : {-1072, -1030, -700, -420, -400, -130, 120, 240, 260, 500, 1015}) {
      Case c = grid_bodies()[n];
      const double scale = std::ldexp(1.0, power);
      c.a = scenes::moved(c.a, scale);
      c.b = scenes::moved(c.b, scale);
      // Half the cases scaled back by the pose, where a power of two has an inverse.
      if (n % 2 == 0 && std::abs(power) < 1020) {
        const double back = std::ldexp(1.0, -power / 2 * 2 + (power < 0 ? -100 : 100) * int(n % 4 == 0));
        c.pose_a = c.pose_b = Pose(std::array<double, 12>{back, 0, 0, 0, 0, back, 0, 0, 0, 0, back, 0});
      }
      // Beyond the gates nothing is discarded: every pair of leaves is met.
      Config config = random_config(random);
      config.depth = n % 3;
      wrong += n % 5 == 0 ? wrong_answers<Adaptive>(c, config, config) : wrong_booleans<Adaptive>(c, config);
    }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(translations_far_away_change_no_answer)
{
  Random random(19);
  int wrong = 0;
  for (std::size_t n = 0; n < placed_bodies().size(); n += 11) {
    Case c = placed_bodies()[n];
    const int magnitude = n / 11 % 5;
    const double far = std::array{1e3, 1e12, 1e17, 1e100, 1e300}[magnitude];
    std::array<Rational, 12> shift;
    for (int k = 0; k < 12; ++k) shift[k] = k % 5 == 0 ? 1 : 0;
    shift[3] = far;
    shift[7] = -far / 3;
    shift[11] = far / 7;
    c.pose_a = scenes::composed(Pose(shift), c.pose_a);
    c.pose_b = scenes::composed(Pose(shift), c.pose_b);
    Config config = random_config(random);
    if (magnitude > 1) config.depth = n % 3;  // nothing is discarded that far away: every pair of leaves is met
    wrong += wrong_booleans<Adaptive>(c, config);
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(open_surfaces_are_asked_for_their_surface)
{
  Random random(20);
  Cases cases;
  for (std::size_t n = 0; n < grid_bodies().size(); n += 2) {
    Case c = grid_bodies()[n];
    for (Polyhedron* body : {&c.a, &c.b}) {
      Polyhedron open;
      open.vertices = body->vertices;
      for (Index f = 0; f < body->face_count(); ++f) {
        if (f % 3 == n % 3) continue;
        std::vector<std::vector<Index>> loops;
        for (std::size_t l = 0; l < body->loop_count(f); ++l)
          loops.emplace_back(body->loop(f, l).begin(), body->loop(f, l).end());
        open.add_face(loops);
      }
      *body = open;
    }
    cases.push_back(c);
  }
  add_truth(cases, true);
  int wrong = 0;
  for (const Case& c : cases) wrong += wrong_answers<Adaptive>(c, random_config(random), random_config(random), false);
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(one_body_in_another_in_its_cavity_in_its_tunnel_and_beside_it)
{
  const auto answers = [](const Polyhedron& a, const Polyhedron& b) {
    Tetra_tree<Adaptive> first(a), second(b);
    Collision<Adaptive> collision(first, second), back(second, first);
    const bool solid = collision(Pose(), Pose()), surface = collision(Pose(), Pose(), Question::surface);
    BOOST_TEST(back(Pose(), Pose()) == solid);
    BOOST_TEST(back(Pose(), Pose(), Question::surface) == surface);
    return std::pair(solid, surface);
  };
  using Pair = std::pair<bool, bool>;
  const Polyhedron small = scenes::cube(0.5);
  BOOST_TEST((answers(scenes::cube(3), small) == Pair{true, false}));                         // nested
  BOOST_TEST((answers(scenes::turned(scenes::cube(3)), small) == Pair{true, false}));         // inward: as well
  BOOST_TEST((answers(scenes::cube_with_cavity(), small) == Pair{false, false}));             // in the cavity
  BOOST_TEST((answers(scenes::cube_with_cavity(), scenes::cube(2)) == Pair{true, true}));     // fills the cavity
  BOOST_TEST((answers(scenes::cube_with_cavity(), scenes::cube(2.5)) == Pair{true, false}));  // around the cavity
  BOOST_TEST((answers(scenes::with_cavity(scenes::cube_with_cavity(), scenes::turned(scenes::cube(1))), small) ==
              Pair{true, false}));
  BOOST_TEST((answers(scenes::cube_with_tunnel(), small) == Pair{false, false}));  // in the hole
  BOOST_TEST(
      (answers(scenes::cube_with_tunnel(), scenes::box({-1, -0.5, -9}, {0, 0.5, 9})) == Pair{true, true}));  // touches
                                                                                                             // its wall
  BOOST_TEST((answers(scenes::cube_with_tunnel(), scenes::moved(small, 1, {2, 2, 0})) == Pair{true, false}));
  BOOST_TEST((answers(scenes::cube(1), scenes::moved(scenes::cube(1), 1, {2.5, 0, 0})) == Pair{false, false}));
}

BOOST_AUTO_TEST_CASE(a_face_of_two_parts_puts_one_part_inside)
{
  // One box inside the other body and one outside, joined only by being loops of one face.
  const Polyhedron left = scenes::cube(0.5), right = scenes::moved(left, 1, {9, 0, 0});
  Polyhedron both;
  both.vertices = right.vertices;
  both.vertices.insert(both.vertices.end(), left.vertices.begin(), left.vertices.end());
  for (Index f = 0; f < 5; ++f)
    for (const Index first : {0u, 8u}) {
      std::vector<Index> loop;
      for (const Index v : left.loop(f, 0)) loop.push_back(first + v);
      both.add_polygon(loop);
    }
  both.add_face({{4, 5, 7, 6}, {12, 13, 15, 14}});
  Tetra_tree<Adaptive> a(both), b(scenes::cube(2));
  Collision<Adaptive> collision(a, b);
  BOOST_TEST(collision(Pose(), Pose()));
  BOOST_TEST(!collision(Pose(), Pose(), Question::surface));
}

BOOST_AUTO_TEST_CASE(a_body_collides_with_itself_and_one_tree_may_stand_for_both)
{
  for (const auto& [name, body] : scenes::closed_bodies()) {
    Config config;
    config.on_demand = true;
    Tetra_tree<Adaptive> tree(body, config);
    Collision<Adaptive> collision(tree, tree);
    BOOST_TEST(collision(Pose(), Pose()));
    BOOST_TEST(!collision(Pose(), scenes::translation(100, 0, 0)));
    const Pose far = scenes::translation(3, 5, 7);
    BOOST_TEST(collision(far, far, Question::surface));
  }
}

BOOST_AUTO_TEST_CASE(one_query_object_answers_pose_after_pose)
{
  Random random(21);
  Tetra_tree<Adaptive> a(scenes::cube_with_tunnel()), b(scenes::star_prism(), Config::fastest());
  Collision<Adaptive> collision(a, b);
  const verify::Brute_body body_a(scenes::cube_with_tunnel()), body_b(scenes::star_prism());
  int wrong = 0, hits = 0;
  for (int n = 0; n < 100; ++n) {
    const Pose pose_a = scenes::random_rotation(random),
               pose_b = scenes::random_rotation(random, 5,
                                                {scenes::integer(random, -6, 6), scenes::integer(random, -6, 6), 1});
    const bool truth = verify::collide(body_a, pose_a, body_b, pose_b);
    wrong += collision(pose_a, pose_b) != truth;
    hits += truth;
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(hits > 10);
  BOOST_TEST(hits < 90);
  BOOST_TEST(collision.counts().queries == 100u);
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
  for (std::size_t n = 0; n < grid_bodies().size(); n += 5) {
    const Case& c = grid_bodies()[n];
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
      sum.pairs_visited += collision.counts().pairs_visited;
      sum.discarded_by_hull += collision.counts().discarded_by_hull;
      sum.discarded_by_sphere += collision.counts().discarded_by_sphere;
      sum.discarded_by_tetrahedron += collision.counts().discarded_by_tetrahedron;
      sum.discarded_by_box += collision.counts().discarded_by_box;
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

BOOST_AUTO_TEST_CASE(theorem_2_discards_nothing_of_a_body_whose_origin_is_before_the_plane)
{
  // B: a large box with a spike of a cavity in its first octant, its centroid at 0. The corner of A is in the spike.
  // The bounding tetrahedron of B's first octant has V'1, V'2, V'3 far beyond A's reference plane, but V0 and the
  // spike before it.
  const double base = 1.0 / 64, s = 0.25 + 4 * base;
  const Polyhedron spike =
      scenes::tetrahedron({0.25, 0.25, 0.25}, {2 * base, base, base}, {base, 2 * base, base}, {base, base, 2 * base});
  const Polyhedron b = scenes::with_cavity(scenes::moved(scenes::cube(30), 1, {-s / 8, -s / 8, -s / 8}), spike);
  const Polyhedron a = scenes::box({-1.875, -1.875, -1.875}, {0.125, 0.125, 0.125});
  Config config;
  config.depth = 1;
  config.far_plane = Far_plane::tightest;
  Tetra_tree<Adaptive> tree_a(a, config), tree_b(b, config);
  BOOST_TEST((tree_b.origin() == Bound_point<double>{0, 0, 0}));
  Collision<Adaptive> forth(tree_a, tree_b), back(tree_b, tree_a);
  BOOST_TEST(forth(Pose(), Pose(), Question::surface));
  BOOST_TEST(back(Pose(), Pose(), Question::surface));
}

// Planted, one at a time, each seen to fail here:
// - no child 3 of a cone: exact_kernels_are_right_on_every_kind_of_contact, ..._on_meshes and others;
// - no slack in any bound: exact_kernels_are_right_on_cubes_that_touch_under_a_hundred_rotations and others;
// - Theorem 2 without its question for V0: theorem_2_discards_nothing_of_a_body_whose_origin_is_before_the_plane;
// - weights of 1/2 on borders instead of the moved point: one_body_in_another_in_its_cavity_in_its_tunnel_and_...
// Planted and not seen here but in tetratree_classification and tetratree_tetra_tree: no third test of the
// classification, for an edge and a face are in several leaves, and one is enough.

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
