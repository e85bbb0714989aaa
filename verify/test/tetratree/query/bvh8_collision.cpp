#include "tetracone/tetratree/query/bvh8_collision.h"

#include "tetracone/covering/repair/repair.h"
#include "verify/test/support/keep_environment.h"
#include "verify/test/support/scenes.h"
#include "verify/truth/cgal_truth.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_bvh8_collision)

using namespace tetracone::tetratree;
namespace covering = tetracone::covering;
namespace verify = tetracone::verify;
using namespace tetracone::verify::scenes;
using tetracone::kernel::Question;

namespace {

/// All cuts, numbers of parts and sizes of leaves, by number.
Bvh8_options options_number(std::size_t n)
{
  const auto cuts = std::array{Cuts::tetra_cones, Cuts::through_origin, Cuts::principal, Cuts::least_cost}[n % 4];
  return {cuts, cuts == Cuts::tetra_cones ? 8 : 2 + n % 7, 1 + n % 5};
}

struct Body {
  Body(const Polyhedron& p, const Bvh8_options& options) : tree(p, covering::triangulate_faces(p), options), truth(p) {}
  Bvh8 tree;
  verify::Brute_body truth;
};

Pose any_pose(Random& random, int kind)
{
  const auto half = [&] { return double(integer(random, -8, 8)) / 2; };
  switch (kind) {
    case 0: return translation(half(), half(), half());
    case 1: return random_rotation(random, 3, {Rational(integer(random, -3, 3)), 0, Rational(1) / 3});
    case 2: return rounded(random_rotation(random, 5, {Rational(integer(random, -3, 3)), 1, 0}));
    case 3: return random_affine(random);
    default: return translation(1e-3 * half(), half() * 0.9, real(random, -3, 3));
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(trees_of_any_options_answer_as_all_pairs)
{
  Random random(2);
  std::vector<std::unique_ptr<Body>> all;
  for (const Polyhedron& p : {unit_cube(), cube_with_cavity(), cube_with_tunnel(), star_prism(), cube(0.5),
                              blob(random, 4, 1, 2), turned(cube_with_tunnel()), random_tetrahedra(random, 6, 3),
                              tetrahedron({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2})})
    all.push_back(std::make_unique<Body>(p, options_number(all.size())));
  int yes = 0, no = 0, differ = 0;
  for (const auto& a : all)
    for (const auto& b : all) {
      Bvh8_collision collision(a->tree, b->tree, Coherence::last_frame);
      for (int k = 0; k < 10; ++k) {
        const Pose pose_a = k % 4 == 0 ? any_pose(random, k / 4 % 5) : Pose(), pose_b = any_pose(random, k % 5);
        if (pose_a.determinant_sign() == CGAL::ZERO || pose_b.determinant_sign() == CGAL::ZERO) continue;
        for (const Question question : {Question::surface, Question::solid}) {
          const bool truth = verify::collide(a->truth, pose_a, b->truth, pose_b, question);
          differ += collision(pose_a, pose_b, question) != truth;
          (truth ? yes : no)++;
        }
      }
    }
  BOOST_TEST(differ == 0);
  BOOST_TEST(yes > 200);
  BOOST_TEST(no > 200);
}

BOOST_AUTO_TEST_CASE(a_witness_or_a_direction_of_the_last_pose_saves_the_work)
{
  Bvh8 a(cube_with_tunnel(), covering::triangulate_faces(cube_with_tunnel())), b(triangulated(cube(2)));
  Bvh8_collision last(a, b, Coherence::last_frame);
  BOOST_TEST(last(Pose(), translation(2, 0, 0), Question::surface));
  last.clear_counts();
  BOOST_TEST(last(Pose(), translation(2.001, 0, 0), Question::surface));
  BOOST_TEST(last.counts().box_tests == 0u);
  BOOST_TEST(last.counts().leaf_pairs == 1u);
  BOOST_TEST(!last(Pose(), translation(100, 0, 0), Question::surface));
  BOOST_TEST(last(Pose(), translation(2, 0, 0), Question::surface));

  // A witness that the caller keeps.
  Bvh8_collision of_many(a, b);
  Pair_memory memory;
  const auto ask = [&](double x) { return of_many.relation(Pose(), translation(x, 0, 0), Question::surface, &memory); };
  BOOST_TEST((ask(2) == Relation::surfaces && memory.witness));
  of_many.clear_counts();
  BOOST_TEST((ask(2.001) == Relation::surfaces && memory.witness));
  BOOST_TEST(of_many.counts().box_tests == 0u);
  BOOST_TEST(of_many.counts().leaf_pairs == 1u);
  BOOST_TEST((ask(100) == Relation::apart && !memory.witness));
  BOOST_TEST(of_many.certified_gap() > 0);
}

BOOST_AUTO_TEST_CASE(triangles_with_sides_of_any_size_are_found_in_a_face)
{
  // A triangle in a cube's face, beside the rest of its body, which is larger: as small as doubles get.
  Bvh8 cube(triangulated(box({-1, 1, -1}, {1, 2, 1})));
  int missed = 0, tried = 0;
  for (int exponent = -1074; exponent < 0; ++exponent)
    for (int k = 0; k < (exponent < -480 && exponent > -560 ? 32 : 2); ++k) {
      const double d = std::ldexp(1 + k / 32.0, exponent);
      Polyhedron small;
      small.vertices = {{d, 1, 0}, {-d, 1, 0}, {0, 1, d}, {1, -1, 0}, {-1, -1, 0}, {0, -1, 0.5}, {0, -1, -0.5}};
      for (const auto& [p, q, r] : {std::array<Index, 3>{0, 1, 2}, {3, 4, 5}, {3, 4, 6}}) small.add_polygon({p, q, r});
      Bvh8 tree(small);
      for (const Pose& pose : {Pose(), translation(0.25, 0, 0.25)}) {
        ++tried;
        missed += !Bvh8_collision(tree, cube)(pose, Pose(), Question::surface) +
                  !Bvh8_collision(cube, tree)(Pose(), pose, Question::surface);
      }
    }
  BOOST_TEST(missed == 0);
  BOOST_TEST(tried > 9000);
}

BOOST_AUTO_TEST_CASE(no_tree_is_made_and_no_query_answered_where_floating_point_is_not_sound)
{
  // A denormal apart: under denormals-are-zero these met.
  const Polyhedron left = box({-1, 0, 0}, {0, 1, 1}), right = box({0x1p-1074, 0, 0}, {1, 1, 1});
  using tetracone::kernel::Unsound_floating_point;
  Bvh8 a(left), b(right);
  Bvh8_collision collision(a, b), last(a, b, Coherence::last_frame);
  const auto refused = [](const auto& ask) { return verify::not_refused<Unsound_floating_point>(ask) == 0; };
  BOOST_TEST(refused([&] { Bvh8 tree(left); }));
  BOOST_TEST(refused([&] { a.make_all(); }));
  BOOST_TEST(refused([&] { Bvh8_collision fresh(a, b); }));
  for (const Pose& pose : {Pose(), translation(100, 0, 0)})
    for (Bvh8_collision<>* ask : {&collision, &last}) {
      BOOST_TEST(refused([&] { (*ask)(Pose(), pose); }));
      BOOST_TEST(!(*ask)(Pose(), pose));
    }
}

BOOST_AUTO_TEST_CASE(work_is_counted)
{
  Bvh8 a(cube_with_tunnel()), b(star_prism());
  Bvh8_collision collision(a, b);
  collision(Pose(), translation(100, 0, 0));
  BOOST_TEST(collision.counts().queries == 1u);
  BOOST_TEST(collision.counts().leaf_pairs == 0u);
  collision(Pose(), translation(0.5, 0, 0));
  BOOST_TEST(collision.counts().box_tests > 8u);
  BOOST_TEST(collision.counts().leaf_pairs > 0u);
  collision.clear_counts();
  BOOST_TEST(collision.counts().queries == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
